/** Lessons one after the other: the text, a picture to touch, things to try, where to go on. */

import { createCoat } from "../coat/coat.js";
import { landmarksOf } from "../curves/reading.js";
import { percent, plain } from "../numbers/format.js";
import { h, setText } from "../page/dom.js";
import { pageLink } from "../page/links.js";
import { pieces } from "../page/prose.js";
import { UNTOUCHED } from "./fields.js";
import { settingOf } from "./lesson.js";
import { createRows } from "./rows.js";
import { createStage } from "./stage.js";

/**
 * @typedef {import('./lesson.js').Lesson} Lesson
 * @typedef {import('./lesson.js').Scene} Scene
 */

/** What the lines of a color picture are, by the models beside the spectrum. @type {Record<string, string>} */
const KEYS = {
  schlick:
    "Red, green and blue: exact from the spectrum, and Schlick from F0 (dashed). Above 1 lies what is redder than sRGB can show.",
  "exact,f82_tint":
    "Exact from the spectrum; Fresnel from averaged n and k (dotted); F82-tint from two colors (dashed).",
};

/**
 * @param {object} options
 * @param {Lesson[]} options.lessons
 * @param {'step' | 'trap'} options.key of the state
 * @param {string} options.title
 * @param {string} options.intro
 * @param {ViewContext} options.context
 */
export function createLessons({ lessons, key, title, intro, context }) {
  const { catalog, presets, state, actions, say, save } = context;
  const section = key === "step" ? "path" : "traps";
  /** @type {Set<string>} */
  const achieved = new Set();

  /** @param {string} words @param {State} to another place of this view */
  const inside = (words, to) =>
    pageLink(words, "theory", to, () => {
      actions.set({ ...UNTOUCHED, ...to });
      window.scrollTo(0, 0);
    });

  /** @param {Lesson} lesson @param {boolean} [focus] */
  function go(lesson, focus = false) {
    actions.set({ ...UNTOUCHED, [key]: lesson.id });
    if (!focus) return;
    text.scrollIntoView({ block: "nearest" });
    heading.focus({ preventScroll: true });
  }

  const list = h("ol", { class: "lesson-list", "data-numbered": String(key === "step") });
  const items = lessons.map((lesson) => {
    const link = pageLink(lesson.title, "theory", { section, [key]: lesson.id }, () =>
      go(lesson, true),
    );
    list.append(h("li", {}, link));
    return { lesson, link };
  });

  const heading = h("h3", { tabindex: "-1", class: "lesson-title" });
  const count = h("p", { class: "lesson-count" });
  const body = h("div", { class: "prose" });
  const tries = h("ul", { class: "tries" });
  const more = h("p", { class: "lesson-more" });
  const back = h("button", { type: "button", class: "quiet" }, "← back");
  const next = h("button", { type: "button", class: "forward" }, "next →");
  const walk = h("p", { class: "lesson-walk" }, back, next);
  const text = h("article", { class: "lesson-text" }, count, heading, body);
  const after = h(
    "section",
    { class: "lesson-after", "aria-label": "Try it" },
    h("h4", { class: "try-heading" }, "Try it"),
    tries,
    more,
    walk,
  );
  const live = h("p", { class: "lesson-live" });
  const choices = h("div", { class: "lesson-media", role: "group", "aria-label": "Media" });
  const rowsPlace = h("div", {});
  const stage = createStage({
    catalog,
    name: "Reflectance against the angle of incidence",
    onTheta: (deg, history) => actions.set({ own_deg: deg }, { history }),
    onSettle: actions.settle,
  });
  const coat = createCoat({ presets, state, actions, save, say, prefix: `${key}-` });
  const picture = h(
    "section",
    { class: "lesson-picture", "aria-label": "Picture" },
    choices,
    stage.element,
    coat.element,
    live,
    rowsPlace,
  );
  const element = h(
    "div",
    { class: `lessons ${section}` },
    h(
      "nav",
      { class: "lesson-nav", "aria-label": title },
      h("h2", {}, title),
      h("p", { class: "hint" }, intro),
      list,
    ),
    text,
    picture,
    after,
  );

  /** @type {Lesson | null} */
  let shown = null;
  /** @type {ReturnType<typeof createRows> | null} */
  let rows = null;
  /** @type {{id: string, button: HTMLElement}[]} */
  let media = [];
  /** @type {{trial: import('./lesson.js').Try, item: HTMLElement, reply: HTMLElement}[]} */
  let trials = [];

  back.addEventListener("click", () => walkBy(-1));
  next.addEventListener("click", () => walkBy(1));
  /** @param {number} by */
  function walkBy(by) {
    const at = (shown ? lessons.indexOf(shown) : 0) + by;
    const there = lessons[at];
    if (there) go(there, true);
  }

  /** @param {Lesson} lesson */
  function build(lesson) {
    shown = lesson;
    const at = lessons.indexOf(lesson);
    for (const { lesson: one, link } of items) {
      if (one === lesson) link.setAttribute("aria-current", "step");
      else link.removeAttribute("aria-current");
    }
    setText(count, key === "step" ? `Step ${at + 1} of ${lessons.length}` : "");
    count.hidden = key !== "step";
    setText(heading, lesson.title);
    body.replaceChildren(
      ...(lesson.code ? [h("pre", { class: "trap-code" }, h("code", {}, lesson.code))] : []),
      ...lesson.text.map((paragraph) => h("p", {}, ...pieces(paragraph))),
    );
    trials = (lesson.tries ?? []).map((trial) => {
      const reply = h("span", { class: "reply", hidden: true });
      const item = h("li", { class: "try" }, h("span", {}, ...pieces(trial.say)), reply);
      return { trial, item, reply };
    });
    tries.replaceChildren(...trials.map(({ item }) => item));
    const links = [
      ...(lesson.formula
        ? [inside("The formula in full", { section: "formulas", formula: lesson.formula })]
        : []),
      ...(lesson.more ?? []).map(([words, view, to]) =>
        view === "theory" ? inside(words, to) : pageLink(words, view, to),
      ),
    ];
    more.replaceChildren(...links);
    back.disabled = at === 0;
    next.disabled = at === lessons.length - 1;
    media = (lesson.media ?? []).flatMap((id) => {
      const found = catalog.materials.find((m) => m.id === id);
      if (!found) return [];
      const patch = () =>
        lesson.picture === "colors" ? { own_of: id } : { own_n: found.n, own_k: null };
      const button = h(
        "button",
        { type: "button", class: "medium", onclick: () => actions.set(patch()) },
        found.name.replace(/\s*\(.*\)$/, ""),
      );
      return [{ id, button }];
    });
    choices.replaceChildren(...media.map((m) => m.button));
    choices.hidden = media.length === 0;
    rows?.stop();
    rows = lesson.rows
      ? createRows({
          rows: lesson.rows,
          presets: settingOf(/** @type {State} */ (UNTOUCHED), lesson),
          polarized: lesson.polarized ?? false,
          catalog,
          actions,
          prefix: `${key}-`,
        })
      : null;
    rowsPlace.replaceChildren(...(rows ? [rows.element] : []));
    stage.element.hidden = lesson.picture === "coat";
    stage.element.dataset.picture = lesson.picture;
    coat.element.hidden = lesson.picture !== "coat";
    live.hidden = lesson.picture === "coat";
    stage.explain(KEYS[(lesson.models ?? []).join()] ?? "");
  }

  /** @param {Scene} scene @param {boolean} settled */
  function judge(scene, settled) {
    trials.forEach(({ trial, item, reply }, i) => {
      const id = `${shown?.id}.${i}`;
      if (!achieved.has(id)) {
        // What is swept past in a gesture is not found.
        if (!settled || !trial.done(scene)) return;
        achieved.add(id);
        say(`Found. ${trial.reply}`);
      }
      if (!reply.hidden) return;
      item.dataset.done = "";
      reply.replaceChildren(...pieces(trial.reply));
      reply.hidden = false;
    });
    for (const { lesson, link } of items) {
      const all = (lesson.tries ?? []).every((_, i) => achieved.has(`${lesson.id}.${i}`));
      link.toggleAttribute("data-done", all);
    }
  }

  return {
    element,
    /** @param {State} now @returns {Lesson} */
    lesson: (now) => /** @type {Lesson} */ (lessons.find((l) => l.id === now[key]) ?? lessons[0]),
    /** @param {State} now @param {Record<string, any>} answers @param {boolean} moving */
    update(now, answers, moving) {
      const lesson = this.lesson(now);
      if (lesson !== shown) build(lesson);
      const setting = settingOf(now, lesson);
      const reading =
        lesson.picture === "coat" ? null : stage.update(lesson, setting, answers, moving);
      if (lesson.picture === "coat") coat.update(now, answers.coat, undefined);
      const scene = { setting, reading, answers, state: now };
      const answered =
        reading !== null &&
        reading.interface.n_i === setting.n_i &&
        reading.interface.n_t === setting.n_t &&
        reading.interface.k_t === setting.k_t;
      rows?.update(setting, reading ? landmarksOf(reading.interface) : []);
      for (const { id, button } of media) {
        const found = catalog.materials.find((m) => m.id === id);
        const on = lesson.picture === "colors" ? setting.of === id : setting.n_t === found?.n;
        button.setAttribute("aria-pressed", String(on));
      }
      if (lesson.picture === "colors" && answers.detail?.id === setting.of) {
        const { name, display, constants } = answers.detail;
        live.replaceChildren(
          h("span", { class: "swatch", style: `--swatch: ${display.hex}`, "aria-hidden": "true" }),
          `${name}: reflects straight on ${display.F0.map((/** @type {number} */ c) => c.toFixed(2)).join(", ")} as linear red, green and blue; ${percent(constants.F0)} at ${plain(constants.wavelength_nm)} nm.`,
        );
      } else if (lesson.live && (answered || moving)) setText(live, lesson.live(scene));
      const touched = Object.keys(UNTOUCHED).some((name) => now[name] !== null);
      if (lesson.picture === "surface" ? answered && touched : touched || lesson.picture === "coat")
        judge(scene, !moving);
      else judge(scene, false);
    },
    /** @param {State} now */
    sentence(now) {
      return shown === this.lesson(now) && !live.hidden ? (live.textContent ?? "") : "";
    },
    theme: () => stage.theme(),
    stop() {
      rows?.stop();
      coat.stop();
    },
    destroy() {
      stage.destroy();
      coat.destroy();
    },
  };
}
