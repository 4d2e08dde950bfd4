/** Preview: a scene rendered with one model on the left and another on the right, and how far they are apart. */

import { createExamples } from "../controls/examples.js";
import { createChoices, createRow } from "../controls/panel.js";
import { plain, significant } from "../numbers/format.js";
import { createChanged } from "../page/changed.js";
import { copying, h } from "../page/dom.js";
import { html, render } from "../page/lit.js";
import { loadStyles } from "../page/style.js";
import { createProblems, createTrouble } from "../page/trouble.js";
import { createControls } from "../preview/controls.js";
import { amplification, verdictOf } from "../preview/difference.js";
import { EXAMPLES, isShown } from "../preview/examples.js";
import {
  BOUNDS,
  isFilmed,
  isShortcut,
  NONE,
  previewFields,
  putRight,
  SEEN,
  SHORTCUT,
  sided,
} from "../preview/fields.js";
import { lightOf, queries } from "../preview/queries.js";
import { createSides } from "../preview/sides.js";
import { createStage } from "../preview/stage.js";
import { createTakeaway } from "../preview/takeaway.js";

export { later, queries, restCalls } from "../preview/queries.js";
export const fields = previewFields;

/** @typedef {import('../preview/difference.js').Difference} Difference */

await loadStyles("preview");

const FIGURES = /** @type {const} */ ([
  ["steps", "mean", "mean, 8-bit steps"],
  ["steps", "largest", "largest, 8-bit steps"],
  ["colors", "mean", "mean ΔE₀₀"],
  ["colors", "largest", "largest ΔE₀₀"],
]);
/** What the server says of the film itself, not that it has no time or is not there. */
const OF_FILM = /^(?:layers|models|thickness_nm) = /u;
const OF_SHORTCUT = /^models = (\w+)/u;
const NO_WEBGL = html`<p class="no-webgl" role="status"><b>This browser draws no WebGL2 here.</b>
  The scene needs it, with textures of floating-point numbers: try another browser, or allow
  hardware acceleration. The Compare view shows the same curves and their errors.</p>`;

/** @param {number} x */
const short = (x) => (x === 0 ? "0" : x < 0.1 ? significant(x, 2) : plain(x, 3));

/** @param {ViewContext} given */
export function createView(given) {
  const { element, catalog, actions, say } = given;
  /** By how much a difference is amplified unless that is set. */
  let automatic = BOUNDS.gain.default;
  /** @returns {State} */
  const state = () => {
    const now = sided(given.state());
    return { ...now, gain: now.gain ?? automatic };
  };
  const context = { ...given, state };
  const sides = createSides(catalog);
  const controls = createControls(context);
  const examples = createExamples({
    examples: EXAMPLES,
    name: "preview-examples",
    label: "Examples",
    onShow: ({ state: shown }) => actions.set({ ...shown, ...putRight(state(), shown.right) }),
    isShown,
  });
  const stage = createStage({ ...context, onMeasured: show });
  const takeaway = createTakeaway(context);
  const problems = createProblems(["film", "through"]);
  /** The shortcut that the server does not know. */
  let unknown = "";
  /** Models in place of shortcuts for films. @param {(id: string) => boolean} goes */
  const without = (goes) => {
    const { left, right } = given.state();
    return { ...(goes(left) && { left: "exact" }), ...(goes(right ?? "") && { right: null }) };
  };
  const ofFilm = createTrouble("Take the film away", () =>
    actions.set({ layers: "", ...without(isShortcut) }),
  );
  const ofShortcut = createTrouble("Show a model in its place", () =>
    actions.set(without((id) => id === unknown)),
  );
  const choices = createChoices(actions, {
    see: ["What is shown", Object.fromEntries(SEEN.map((word) => [word, word]))],
  });
  choices.elements.see.classList.add("unnamed");
  const gain = createRow({
    parameter: { name: "gain", symbol: "g", ...BOUNDS.gain },
    prefix: "preview-",
    preset: BOUNDS.gain.default,
    label: "amplified",
    range: [1, 20],
    wide: [1, 200],
    steps: { step: 1, fine: 0.1, page: 5 },
    onChange: (value, moving) =>
      actions.set({ gain: value }, { history: moving ? "replace" : "push" }),
    onSettle: actions.settle,
  });

  /** @type {{id: string, title: string}[]} for films, once the server has told them */
  let shortcuts = [];
  /** @type {Difference | null} of the picture at hand, once it is measured */
  let measured = null;
  /** @type {Difference | null} the last that was */
  let last = null;
  const work = h("section.column.picture", { "aria-label": "Picture" });
  element.append(controls.element, work, takeaway.element);

  function draw() {
    const { see, left, right, gain: factor } = state();
    const most = plain(255 / factor, 3);
    const toggle = () => {
      stage.flicker.toggle();
      draw();
    };
    const copied = () => JSON.stringify({ left, right, ...measured }, null, 2);
    render(
      html`${examples.element}
        <div class="picture-bar">
          ${choices.elements.see}
          <span class="flicker-controls" ?hidden=${see !== "flicker"}>
            <button type="button" class="quiet" @click=${toggle}>${stage.flicker.on() ? "pause" : "play"}</button>
            <button type="button" class="quiet" @click=${stage.flicker.swap}>other side</button>
          </span>
          <button type="button" class="quiet" aria-label="Save the picture as PNG"
            @click=${() => stage.export(`fresnel-preview-${left}-${right}.png`)}>PNG</button>
        </div>
        ${ofFilm.element}${ofShortcut.element}
        ${stage.works ? stage.element : NO_WEBGL}
        <p class="reason" role="status" ?hidden=${see !== "difference"}>${amplified(factor)}
          <button type="button" class="quiet" aria-pressed=${given.state().gain === null}
            ?hidden=${given.state().gain === null}
            @click=${() => actions.set({ gain: null })}>amplify by itself</button></p>
        <div class="amplified" ?hidden=${see !== "difference"}>
          ${gain.element}
          <figure class="legend" aria-label="Legend of the difference">
            <div class="legend-bar"></div>
            <div class="legend-marks">
              <span class="low">−${most}</span>
              <span class="middle">0, the same</span>
              <span class="high">+${most}</span>
            </div>
            <figcaption>right minus left in 8-bit steps of sRGB, the channel that differs most</figcaption>
          </figure>
        </div>
        <section class="differences" aria-label="How far the sides are apart"
          ?hidden=${!stage.works} ?data-stale=${!measured}>
          <dl>
            ${FIGURES.map(([of, which, title]) => html`<div><dt>${title}</dt><dd data-difference="${of}.${which}">${last && short(last[of][which])}</dd></div>`)}
          </dl>
          <p class="verdict-line">${last && `The difference is ${verdictOf(last.colors.largest)}.`}</p>
          <div class="counted">
            <p class="reason">${last && `Over the ${last.pixels.toLocaleString("en")} pixels of a smaller picture that show the surface.`}
              Smooth surfaces only: a rough one mixes many angles, and is out of this picture's scope.</p>
            <button type="button" class="quiet" aria-label="Copy the differences as JSON, in full precision"
              ?disabled=${!measured}
              @click=${copying(copied, say, "The differences were copied.", "The browser refused to copy.")}>copy</button>
          </div>
        </section>`,
      work,
    );
  }

  /** What is done to the difference, in words. @param {number} factor */
  function amplified(factor) {
    if (!last) return "";
    if (last.steps.largest === 0) return "Both sides are the same in every 8-bit step.";
    const own = given.state().gain === null ? ", so that something shows" : "";
    return factor === 1
      ? "The difference is shown as it is."
      : `The difference is amplified ${plain(factor, 3)} times${own}.`;
  }

  /** @param {Difference | null} difference */
  function show(difference) {
    measured = difference;
    last = difference ?? last;
    const factor = amplification(last?.steps.largest ?? 0);
    const changes = difference !== null && factor !== automatic;
    if (changes) automatic = factor;
    draw();
    // The picture is drawn anew with it.
    if (changes && state().see === "difference" && given.state().gain === null)
      actions.set({}, { history: "none" });
  }

  /** @param {State} now @param {'left' | 'right'} side */
  function label(now, side) {
    const id = now[side];
    const named = isShortcut(id)
      ? shortcuts.find((m) => `${SHORTCUT}${m.id}` === id)
      : catalog.models.find((m) => m.id === id);
    const film = id === "exact" ? ", film" : ", no film";
    const filmed = isFilmed(now) && !isShortcut(id) ? film : "";
    const title =
      id === NONE ? "no reflection" : named && named.title.replace(/\s*\(.*\)$/, "") + filmed;
    /** @type {Record<string, string>} */
    const by = { pixel: "", vertex: ", per vertex", texture: `, ${now.texels} texels` };
    return (title ?? id) + by[now[`${side}_by`]];
  }

  const changed = createChanged();
  let drawn = false;
  /** @type {Record<string, any>} */
  let answered = {};

  /** Say what is wrong with the film in place of a picture, or above the last good one. */
  function sayTrouble() {
    const problem = Object.keys(queries(state(), catalog))
      .map((name) => problems.of(name, answered))
      .find(Boolean);
    const [, named] = OF_SHORTCUT.exec(problem?.lines[0] ?? "") ?? [];
    unknown = `${SHORTCUT}${named}`;
    ofFilm.update(named ? undefined : problem, true);
    ofShortcut.update(named ? problem : undefined, true);
    stage.element.hidden = problem !== undefined && !drawn;
  }

  return {
    /** @param {State} next @param {Record<string, any>} answers @param {boolean} moving */
    update(next, answers, moving) {
      const now = state();
      answered = answers;
      if (!moving) {
        takeaway.update(answers);
        sayTrouble();
      }
      // Code and tables arrive later, and change nothing in the picture.
      const parts = Object.keys(queries(now, catalog)).map((name) => answers[name]);
      shortcuts = answers.shortcuts?.models ?? shortcuts;
      if (!changed(next, moving, shortcuts, ...parts)) return;
      sides.take(answers);
      /** @param {'left' | 'right'} side */
      const reason = (side) => sides.reason(now, side) || lightOf(now, catalog, side);
      const reasons = { left: reason("left"), right: reason("right") };
      const filmed = isFilmed(now);
      const warnings = (filmed && answers.film?.warnings) || [];
      controls.update(now, reasons, filmed ? shortcuts : [], warnings);
      examples.update(now);
      choices.update(now);
      gain.update(now.gain);
      draw();
      if (!stage.works) return;
      let complete = false;
      stage.feed((renderer, force) => {
        complete = sides.fill(renderer, state(), force);
      });
      // Half of a new state would be a picture of nothing: the last good one stays. While something
      // moves, what is known follows it.
      if (complete || (moving && drawn)) {
        drawn = true;
        show(null);
        stage.update(
          sides.scene(now),
          { left: label(now, "left"), right: label(now, "right") },
          moving,
        );
      }
    },

    /** @param {State} next */
    sentence(next) {
      const now = sided(next);
      if (!last) return "";
      const { steps, colors } = last;
      return `${label(now, "left")} against ${label(now, "right")}: up to ${short(steps.largest)} of 255 steps apart, mean CIEDE2000 ${short(colors.mean)}.`;
    },

    /** @param {string} name @param {import('../page/trouble.js').Problem} problem @returns {boolean} whether it is said here */
    problem(name, problem) {
      if (!OF_FILM.test(problem.lines[0] ?? "") || !problems.add(name, problem, answered))
        return takeaway.problem(name, problem);
      sayTrouble();
      return true;
    },
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
