/** Lessons one after the other: the text, a picture to touch, things to try, where to go on. */

import { createCoat } from "../coat/coat.js";
import { landmarksOf, sameMedia } from "../curves/reading.js";
import { percent, plain } from "../numbers/format.js";
import { h } from "../page/dom.js";
import { addressOf, clicked, pageLink } from "../page/links.js";
import { html, nothing, render } from "../page/lit.js";
import { pieces } from "../page/prose.js";
import { UNTOUCHED } from "./fields.js";
import { createFilmPicture } from "./film-picture.js";
import { settingOf } from "./lesson.js";
import { createPlanes } from "./planes.js";
import { createRows } from "./rows.js";
import { createStage } from "./stage.js";

/**
 * @typedef {import('./lesson.js').Lesson} Lesson
 * @typedef {import('./lesson.js').Scene} Scene
 * @typedef {import('./lesson.js').Try} Try
 */

/** What the lines of a color picture are, by the models beside the spectrum. @type {Record<string, string>} */
const KEYS = {
  schlick:
    "Red, green and blue: exact from the spectrum, and Schlick from F0 (dashed). Above 1 lies what is redder than sRGB can show.",
  "exact,f82_tint":
    "Exact from the spectrum; Fresnel from averaged n and k (dotted); F82-tint from two colors (dashed).",
};

/** What a lesson says, typeset once. @param {Lesson} lesson */
function prepared({ code, text, tries = [] }) {
  return {
    body: html`${code ? html`<pre class="trap-code"><code>${code}</code></pre>` : nothing}
      ${text.map((paragraph) => html`<p>${pieces(paragraph)}</p>`)}`,
    tries: tries.map(({ say, reply }) => ({ say: pieces(say), reply: pieces(reply) })),
  };
}

/**
 * @param {object} options
 * @param {Lesson[]} options.lessons
 * @param {'step' | 'trap'} options.key of the state
 * @param {string} options.title
 * @param {string} options.intro
 * @param {ViewContext} options.context
 */
export function createLessons({ lessons, key, title, intro, context }) {
  const { catalog, state, actions, say } = context;
  const section = key === "step" ? "path" : "traps";
  /** @type {Set<Try>} */
  const achieved = new Set();
  const stage = createStage({
    catalog,
    name: "Reflectance against the angle of incidence",
    actions,
  });
  const coat = createCoat(context, `${key}-`);
  /** Made for the lesson that has it. @type {ReturnType<typeof createFilmPicture> | null} */
  let films = null;
  /** @type {ReturnType<typeof createPlanes> | null} */
  let planes = null;
  const element = h("div", { class: `lessons ${section}` });

  let shown = lessonOf(state());
  let said = prepared(shown);
  /** @type {ReturnType<typeof createRows> | null} */
  let rows = null;
  /** @type {HTMLElement[]} where to go on from here */
  let links = [];
  /** What follows the picture. @type {unknown} */
  let live = "";

  /** @param {State} now @returns {Lesson} */
  function lessonOf(now) {
    return /** @type {Lesson} */ (lessons.find((l) => l.id === now[key]) ?? lessons[0]);
  }

  /** @param {string} words @param {State} to another place of this view */
  const inside = (words, to) =>
    pageLink(words, "theory", to, () => {
      actions.set({ ...UNTOUCHED, ...to });
      window.scrollTo(0, 0);
    });

  /** @param {Lesson | undefined} lesson */
  function go(lesson) {
    if (!lesson) return;
    actions.set({ ...UNTOUCHED, [key]: lesson.id });
    element.querySelector(".lesson-text")?.scrollIntoView({ block: "nearest" });
    element.querySelector("h3")?.focus({ preventScroll: true });
  }

  /** @param {Lesson} lesson */
  function build(lesson) {
    const { formula, more = [], models = [], picture } = lesson;
    shown = lesson;
    said = prepared(lesson);
    live = "";
    links = [
      ...(formula ? [inside("The formula in full", { section: "formulas", formula })] : []),
      ...more.map(([words, view, to]) =>
        view === "theory" ? inside(words, to) : pageLink(words, view, to),
      ),
    ];
    rows?.stop();
    rows = lesson.rows
      ? createRows({
          rows: lesson.rows,
          presets: settingOf(UNTOUCHED, lesson),
          polarized: lesson.polarized ?? false,
          catalog,
          actions,
          prefix: `${key}-`,
        })
      : null;
    if (picture === "films") films ??= createFilmPicture(context);
    if (films) films.element.hidden = picture !== "films";
    if (lesson.planes) planes ??= createPlanes();
    if (planes) planes.element.hidden = !lesson.planes;
    stage.element.hidden = picture === "coat" || picture === "films";
    stage.element.dataset.picture = picture ?? "surface";
    coat.element.hidden = picture !== "coat";
    stage.explain(KEYS[models.join()] ?? "");
    draw(settingOf(state(), lesson));
  }

  /** @param {Scene} scene */
  function judge(scene) {
    for (const trial of shown.tries ?? []) {
      if (achieved.has(trial) || !trial.done(scene)) continue;
      achieved.add(trial);
      say(`Found. ${trial.reply}`);
    }
  }

  /** @param {string} id of a medium of the lesson @param {Scene['setting']} setting */
  function medium(id, setting) {
    const found = catalog.materials.find((m) => m.id === id);
    if (!found) return nothing;
    const colors = shown.picture === "colors";
    const on = colors ? setting.of === id : setting.n_t === found.n_absolute;
    const k = shown.rows?.own_k ? found.k : null;
    const take = () => actions.set(colors ? { own_of: id } : { own_n: found.n_absolute, own_k: k });
    return html`<button type="button" class="medium" aria-pressed=${on}
      @click=${take}>${found.name.replace(/\s*\(.*\)$/, "")}</button>`;
  }

  /** @param {Lesson} lesson */
  function item(lesson) {
    const { tries = [] } = lesson;
    return html`<li><a href=${addressOf("theory", { section, [key]: lesson.id })}
      aria-current=${lesson === shown ? "step" : nothing} ?data-done=${tries.every((one) => achieved.has(one))}
      @click=${clicked(() => go(lesson))}>${lesson.title}</a></li>`;
  }

  /** @param {Try} trial @param {number} index */
  function task(trial, index) {
    const done = achieved.has(trial);
    const words = said.tries[index];
    return html`<li class="try" ?data-done=${done}><span>${words?.say}</span><span class="reply"
      ?hidden=${!done}>${done ? words?.reply : nothing}</span></li>`;
  }

  /** @param {Scene['setting']} setting */
  function draw(setting) {
    const at = lessons.indexOf(shown);
    const { media = [], tries = [], picture } = shown;
    render(
      html`<nav class="lesson-nav" aria-label=${title}>
          <h2>${title}</h2>
          <p class="hint">${intro}</p>
          <ol class="lesson-list" data-numbered=${key === "step"}>${lessons.map(item)}</ol>
        </nav>
        <article class="lesson-text">
          <p class="lesson-count" ?hidden=${key !== "step"}>Step ${at + 1} of ${lessons.length}</p>
          <h3 tabindex="-1" class="lesson-title">${shown.title}</h3>
          <div class="prose">${said.body}</div>
        </article>
        <section class="lesson-picture" aria-label="Picture">
          <div class="lesson-media" role="group" aria-label="Media" ?hidden=${media.length === 0}>
            ${media.map((id) => medium(id, setting))}
          </div>
          ${stage.element} ${coat.element} ${films?.element} ${planes?.element}
          <p class="lesson-live" ?hidden=${picture === "coat" || picture === "films"}>${live}</p>
          <div>${rows?.element}</div>
        </section>
        <section class="lesson-after" aria-label="Try it">
          <h4 class="try-heading">Try it</h4>
          <ul class="tries">${tries.map(task)}</ul>
          <p class="lesson-more">${links}</p>
          <p class="lesson-walk">
            <button type="button" class="quiet" ?disabled=${at === 0}
              @click=${() => go(lessons[at - 1])}>← back</button>
            <button type="button" class="forward" ?disabled=${at === lessons.length - 1}
              @click=${() => go(lessons[at + 1])}>next →</button>
          </p>
        </section>`,
      element,
    );
  }

  /** What is to be said of a metal's color. @param {any} detail */
  function colorOf({ name, display, constants }) {
    const rgb = display.F0.map((/** @type {number} */ c) => c.toFixed(2)).join(", ");
    return html`<span class="swatch" style="--swatch: ${display.hex}" aria-hidden="true"></span>${name}: reflects straight on ${rgb} as linear red, green and blue; ${percent(constants.F0)} at ${plain(constants.wavelength_nm)} nm.`;
  }

  // A plot reads its colors and sizes from the page: it has to stand there before it is drawn.
  build(shown);

  return {
    element,
    /** @param {State} now @param {Record<string, any>} answers @param {boolean} moving */
    update(now, answers, moving) {
      const lesson = lessonOf(now);
      const { picture } = lesson;
      const setting = settingOf(now, lesson);
      if (lesson !== shown) build(lesson);
      const own = picture === "coat" || picture === "films";
      const reading = own ? null : stage.update(lesson, setting, answers, moving);
      if (picture === "coat") coat.update(now, answers.coat, undefined);
      if (picture === "films") films?.update(now, setting.deg, answers);
      if (lesson.planes && reading) planes?.update(reading);
      const scene = { setting, reading, answers, state: now };
      const answered = reading !== null && sameMedia(reading.interface, setting);
      rows?.update(setting, reading ? landmarksOf(reading.interface) : []);
      if (picture === "colors" && answers.detail?.id === setting.of) live = colorOf(answers.detail);
      else if (lesson.live && reading && (answered || moving))
        live = lesson.live({ ...scene, reading });
      const touched = Object.keys(UNTOUCHED).some((name) => now[name] !== null);
      // What is swept past in a gesture is not found.
      const fair = picture ? touched || own : answered && touched;
      if (fair && !moving) judge(scene);
      draw(setting);
    },
    sentence: () => element.querySelector(".lesson-live:not([hidden])")?.textContent ?? "",
    theme: () => stage.theme(),
    stop() {
      rows?.stop();
      coat.stop();
    },
    destroy() {
      stage.destroy();
      coat.destroy();
      films?.destroy();
    },
  };
}
