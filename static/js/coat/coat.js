/** Glossy paint: a diffuse body under a clear coat, and where the light goes that falls on it. */

import { createChoices, createRow } from "../controls/panel.js";
import { evaluateAngle } from "../numbers/expression.js";
import { angle, inDegrees, percent, plain } from "../numbers/format.js";
import { createChanged } from "../page/changed.js";
import { createExports, h } from "../page/dom.js";
import { html, render } from "../page/lit.js";
import { copied } from "../page/tables.js";
import { createTrouble } from "../page/trouble.js";
import { declared } from "../state/state.js";
import { createDrawing } from "./drawing.js";

/** @typedef {import('./fields.js').Coat} Coat */

const PARTS = /** @type {const} */ ([
  ["surface", "off the surface", "reflected by the coat without reaching the body"],
  ["body", "out of the body", "scattered by the body and let out again"],
  ["absorbed", "absorbed", "lost in the body"],
]);
const SMALL_STEPS = { step: 0.01, fine: 0.001, page: 0.1 };

/** The index of a coat that is the surface at hand. @param {State} state */
const indexOf = ({ n_i, n_t }) => Number((n_t / n_i).toPrecision(12));

/** @param {ViewContext} context @param {string} [prefix] of ids */
export function createCoat({ catalog, presets, state, actions, save, say }, prefix = "albedo-") {
  /** @param {string} name @param {Omit<RowOptions["parameter"], "name">} parameter @param {Pick<RowOptions, "label" | "range" | "steps" | "writing">} manner */
  const row = (name, parameter, manner) =>
    createRow({
      parameter: { ...parameter, name },
      prefix,
      preset: presets[name],
      onChange: (value, moving) =>
        actions.set({ [name]: value }, { history: moving ? "replace" : "push" }),
      onSettle: actions.settle,
      ...manner,
    });
  const index = row(
    "coat_n",
    { ...declared(catalog.parameters, "n_t"), symbol: "n" },
    { label: "index of the coat", range: [1, 3], steps: SMALL_STEPS },
  );
  const albedo = row(
    "coat_body",
    { symbol: "ρ", minimum: 0, maximum: 1 },
    { label: "albedo of the body", range: [0, 1], steps: SMALL_STEPS },
  );
  const ray = row(
    "coat_theta",
    { symbol: "\\theta_i", minimum: 0, maximum: 90 },
    {
      label: "angle of the ray",
      range: [0, 90],
      steps: { step: 0.5, fine: 0.05, page: 5 },
      writing: {
        print: (v) => `${plain(v)}°`,
        end: (v) => `${plain(v)}°`,
        parse(text) {
          const { value, unit } = evaluateAngle(text, "deg");
          return inDegrees(value, unit);
        },
        allowed: () => "0° to 90°",
      },
    },
  );
  const choices = createChoices(actions, {
    coat_light: ["Light", { diffuse: "from everywhere", ray: "a ray" }],
  });
  const same = h(
    "button.quiet.same-media",
    { type: "button", onclick: () => actions.set({ coat_n: indexOf(state()) }) },
    "take n from the media",
  );
  const drawing = createDrawing();
  const exports = createExports({
    what: "the picture of the paint",
    name: () => "fresnel-coat",
    make: drawing.make,
    save,
  });
  const trouble = createTrouble("Back to the usual paint", () => {
    const { coat_n, coat_body, coat_theta } = presets;
    actions.set({ coat_n, coat_body, coat_theta });
  });
  const element = h("section.column.coat", { "aria-label": "Glossy paint" });
  const changed = createChanged();

  /** @param {Coat | undefined} coat */
  const parts = (coat) => html`<div class="heading">
      <h2>Glossy paint: a body under a coat</h2>
      ${exports}
    </div>
    <div class="coat-parts">
      <div class="coat-picture">
        ${drawing.element}
        <div class="energy-bar" aria-hidden="true">${PARTS.map(
          ([name]) =>
            html`<div class="energy ${name}" style="--share: ${coat?.[name] ?? 0}"></div>`,
        )}</div>
        <dl class="energies">${PARTS.map(
          ([name, words, note]) => html`<div>
            <dt title=${note}><i class="swatch ${name}"></i>${words}</dt>
            <dd><span class="share">${coat && percent(coat[name])}</span>${
              coat && copied(name, coat[name], say)
            }</dd>
          </div>`,
        )}</dl>
        <p class="coat-says">${
          coat &&
          `The coat throws ${percent(coat.internal)} of what the body sends up back to it, so that a body of albedo ${plain(coat.body_albedo, 4)} lets out ${percent(coat.body)} of the light in place of ${percent(coat.body_albedo)}.`
        }</p>
        ${trouble.element}
      </div>
      <div class="coat-rows">${choices.elements.coat_light}${ray.element}${index.element}${same}${albedo.element}</div>
    </div>`;

  /** What readers hear of the picture. @param {Coat} coat */
  function label(coat) {
    const { theta_i_deg: theta, interface: media } = coat;
    const lit = theta === null ? "diffuse light" : `a ray at ${angle(theta, "deg", 1)}`;
    const shares = PARTS.map(([name, words]) => `${percent(coat[name])} ${words}`);
    return `Of ${lit} on paint with a coat of n = ${plain(media.n_t, 4)}: ${shares.join(", ")}`;
  }
  render(parts(undefined), element);

  return {
    element,
    stop() {
      for (const one of [index, albedo, ray]) one.stop();
    },
    /** @param {State} now @param {Coat | undefined} answer @param {import('../page/trouble.js').Problem | undefined} problem */
    update(now, answer, problem) {
      choices.update(now);
      const here = { value: now.n_t / now.n_i, label: "the media at hand" };
      index.update(now.coat_n, now.k_t === 0 ? [here] : []);
      albedo.update(now.coat_body);
      ray.update(now.coat_theta);
      ray.element.hidden = now.coat_light !== "ray";
      same.hidden = now.k_t > 0 || now.coat_n === indexOf(now);
      trouble.update(problem, true);
      if (!answer || !changed(answer)) return;
      render(parts(answer), element);
      drawing.update(answer, label(answer));
    },
    destroy: drawing.destroy,
  };
}
