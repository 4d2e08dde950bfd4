/** Preview: a scene rendered with one model on the left and another on the right, and how far they are apart. */

import { createChoice } from "../controls/panel.js";
import { createRow } from "../controls/row.js";
import { plain, significant } from "../numbers/format.js";
import { h, setText } from "../page/dom.js";
import { copyText, flash } from "../page/exports.js";
import { loadStyle } from "../page/style.js";
import { createControls } from "../preview/controls.js";
import { createExamples } from "../preview/examples.js";
import { BOUNDS, isEven, isOpaque, isPaint, NONE, previewFields } from "../preview/fields.js";
import { coatPaths, queries, sidePaths } from "../preview/queries.js";
import { BODY, HOW } from "../preview/shader.js";
import { createSides } from "../preview/sides.js";
import { createStage } from "../preview/stage.js";
import { createTakeaway } from "../preview/takeaway.js";

export { later, queries, restCalls } from "../preview/queries.js";
export const fields = previewFields;

/**
 * @typedef {import('../preview/difference.js').Difference} Difference
 */

await loadStyle("css/preview.css");

/** @param {number} x */
const short = (x) => (x === 0 ? "0" : x < 0.1 ? significant(x, 2) : plain(x, 3));

/** @param {ViewContext} context */
export function createView({
  element,
  catalog,
  presets,
  state,
  actions,
  say,
  save,
  describeMedia,
}) {
  const sides = createSides(catalog);
  const controls = createControls({ catalog, presets, state, actions, describeMedia });
  const examples = createExamples({ onShow: actions.set });
  const stage = createStage({ state, actions, save, onMeasured: showDifference });
  const takeaway = createTakeaway({ catalog, state, actions, say, save });

  const see = createChoice({
    legend: "What is shown",
    items: [
      { value: "split", label: "split" },
      { value: "flicker", label: "flicker" },
      { value: "difference", label: "difference" },
      { value: "left", label: "left" },
      { value: "right", label: "right" },
    ],
    onChange: ([value]) => actions.set({ see: value }),
  });
  see.element.classList.add("unnamed");
  const png = h(
    "button",
    {
      type: "button",
      class: "quiet",
      "aria-label": "Save the picture as PNG",
      onclick: () => stage.export(`fresnel-preview-${state().left}-${state().right}.png`),
    },
    "PNG",
  );
  const running = h(
    "button",
    { type: "button", class: "quiet", onclick: () => showFlicker(stage.flicker.toggle()) },
    "pause",
  );
  const other = h(
    "button",
    { type: "button", class: "quiet", onclick: stage.flicker.swap },
    "other side",
  );
  const flicker = h("span", { class: "flicker-controls" }, running, other);

  const gain = createRow({
    parameter: { name: "gain", symbol: "g", ...BOUNDS.gain },
    prefix: "preview-",
    preset: BOUNDS.gain.default,
    label: "amplified",
    range: [1, 20],
    steps: { step: 1, fine: 0.1, page: 5 },
    onChange: (value, moving) =>
      actions.set({ gain: value }, { history: moving ? "replace" : "push" }),
    onSettle: actions.settle,
  });
  const marks = ["low", "middle", "high"].map((name) => h("span", { class: name }));
  const legend = h(
    "figure",
    { class: "legend", "aria-label": "Legend of the difference" },
    h("div", { class: "legend-bar" }),
    h("div", { class: "legend-marks" }, ...marks),
    h("figcaption", {}, "right minus left in 8-bit steps of sRGB, the channel that differs most"),
  );
  const amplified = h("div", { class: "amplified" }, gain.element, legend);

  const numbers = Object.fromEntries(
    ["steps.mean", "steps.largest", "colors.mean", "colors.largest"].map((name) => [
      name,
      h("dd", { "data-difference": name }),
    ]),
  );
  const counted = h("p", { class: "reason" });
  /** @type {Difference | null} the last that was measured */
  let last = null;
  const copy = h(
    "button",
    {
      type: "button",
      class: "quiet",
      "aria-label": "Copy the differences as JSON, in full precision",
      disabled: true,
      onclick: async () => {
        const { left, right } = state();
        const done = await copyText(JSON.stringify({ left, right, ...last }, null, 2));
        flash(copy, done);
        say(done ? "The differences were copied." : "The browser refused to copy.");
      },
    },
    "copy",
  );
  const measured = h(
    "section",
    { class: "differences", "aria-label": "How far the sides are apart" },
    h(
      "dl",
      {},
      .../** @type {const} */ ([
        ["steps.mean", "mean, 8-bit steps"],
        ["steps.largest", "largest, 8-bit steps"],
        ["colors.mean", "mean ΔE₀₀"],
        ["colors.largest", "largest ΔE₀₀"],
      ]).map(([name, title]) => h("div", {}, h("dt", {}, title), numbers[name] ?? null)),
    ),
    h("div", { class: "counted" }, counted, copy),
  );

  const fallback = h(
    "p",
    { class: "no-webgl", role: "status" },
    h("b", {}, "This browser draws no WebGL2 here."),
    " The scene needs it, with textures of floating-point numbers: try another browser, or allow " +
      "hardware acceleration. The Compare view shows the same curves and their errors.",
  );
  const work = h(
    "section",
    { class: "column picture", "aria-label": "Picture" },
    examples.element,
    h("div", { class: "picture-bar" }, see.element, flicker, png),
    stage.works ? stage.element : fallback,
    amplified,
    measured,
  );
  measured.hidden = !stage.works;
  element.append(controls.element, work, takeaway.element);
  showFlicker(stage.flicker.on());

  /** @param {boolean} on */
  function showFlicker(on) {
    setText(running, on ? "pause" : "play");
  }

  /** @param {Difference | null} difference */
  function showDifference(difference) {
    last = difference;
    copy.disabled = difference === null;
    measured.toggleAttribute("data-stale", difference === null);
    if (!difference) return;
    for (const [name, place] of Object.entries(numbers)) {
      const [of, which] = name.split(".");
      const figures = difference[/** @type {'steps' | 'colors'} */ (of)];
      setText(place, short(figures[/** @type {'mean' | 'largest'} */ (which)]));
    }
    setText(
      counted,
      `over the ${difference.pixels.toLocaleString("en")} pixels of a smaller picture that show the surface`,
    );
  }

  /** @param {string} id */
  function titleOf(id) {
    return id === NONE
      ? "no reflection"
      : (catalog.models.find((m) => m.id === id)?.title.replace(/\s*\(.*\)$/, "") ?? id);
  }

  /** @param {State} now @param {'left' | 'right'} side */
  function label(now, side) {
    /** @type {Record<string, string>} */
    const by = { pixel: "", vertex: ", per vertex", texture: `, ${now.texels} texels` };
    return titleOf(now[side]) + by[now[`${side}_by`]];
  }

  /** @param {State} now @param {'left' | 'right'} side */
  function reasonOf(now, side) {
    const [path] = Object.values(sidePaths(now, catalog, side));
    const reason = sides
      .answer(path)
      ?.curves?.find((/** @type {Curve} */ c) => c.model === now[side])?.reason;
    return reason ? `Outside its domain: ${reason}` : "";
  }

  /** The last that was known of the paint, by channel. @type {any[]} */
  let coats = [];
  let drawn = false;
  /** What the picture was last made of. @type {unknown[]} */
  let made = [];

  /** @param {State} now */
  function sceneOf(now) {
    /** @param {'left' | 'right'} side @returns {import('../preview/shader.js').Variant} */
    const variant = (side) => ({
      how: HOW[/** @type {keyof typeof HOW} */ (now[`${side}_by`])],
      body: isOpaque(now) ? BODY.opaque : isPaint(now) ? BODY.paint : BODY.clear,
      water: now.scene === "water",
      even: isEven(now),
      holes: sides.hasHoles(side),
    });
    const external = coats[0]?.external ?? 0;
    return {
      sides: { left: variant("left"), right: variant("right") },
      eta: now.n_i / now.n_t,
      external,
      escape: coats.length ? coats.map((coat) => coat.body / (1 - external) ** 2) : [0, 0, 0],
    };
  }

  return {
    /** @param {State} now @param {Record<string, any>} answers @param {boolean} moving */
    update(now, answers, moving) {
      if (!moving) takeaway.update(answers);
      // Code and tables arrive later, and change nothing in the picture.
      const parts = [now, moving, ...Object.keys(queries(now, catalog)).map((k) => answers[k])];
      if (parts.length === made.length && parts.every((part, i) => part === made[i])) return;
      made = parts;
      sides.take(answers);
      controls.update(now, { left: reasonOf(now, "left"), right: reasonOf(now, "right") });
      examples.update(now);
      see.update([now.see]);
      flicker.hidden = now.see !== "flicker";
      amplified.hidden = now.see !== "difference";
      gain.update(now.gain);
      const most = plain(255 / now.gain, 3);
      marks.forEach((mark, i) => {
        setText(mark, [`−${most}`, "0, the same", `+${most}`][i] ?? "");
      });
      if (!stage.works) return;
      let complete = false;
      stage.feed((renderer, force) => {
        complete = sides.fill(renderer, state(), force);
      });
      const paths = Object.values(coatPaths(now, catalog));
      const fresh = paths.map((path) => sides.answer(path));
      if (!fresh.includes(null)) coats = fresh;
      else complete = false;
      // Half of a new state would be a picture of nothing: the last good one stays. While something
      // moves, what is known follows it.
      if (complete || (moving && drawn)) {
        drawn = true;
        showDifference(null);
        stage.update(
          sceneOf(now),
          { left: label(now, "left"), right: label(now, "right") },
          moving,
        );
      }
    },

    /** @param {State} now */
    sentence(now) {
      const place = numbers["steps.largest"]?.textContent;
      return place
        ? `${label(now, "left")} against ${label(now, "right")}: up to ${place} of 255 steps apart, mean CIEDE2000 ${numbers["colors.mean"]?.textContent}.`
        : "";
    },

    problem: takeaway.problem,
    theme: takeaway.theme,
    deactivate() {
      stage.stop();
      controls.stop();
      gain.stop();
    },
    destroy() {
      stage.destroy();
      takeaway.destroy();
      controls.stop();
      gain.stop();
    },
  };
}
