/** The preset under something: its colors from a medium, from a coat on it or through a pane, and what engines make of the coat. */

import { createChoices } from "../controls/panel.js";
import { createTyped } from "../controls/typed.js";
import { evaluate } from "../numbers/expression.js";
import { clamp, plain } from "../numbers/format.js";
import { encoded } from "../numbers/srgb.js";
import { createChanged } from "../page/changed.js";
import { h, symbol } from "../page/dom.js";
import { html, nothing, render } from "../page/lit.js";
import { told } from "./panel.js";

/** What may be in front. @type {Record<string, readonly [label: string, note: string]>} */
export const COVERS = {
  medium: ["a medium", "it fills the space in front, as water does"],
  coat: ["a coat", "a clear layer on the material, air before it"],
  pane: ["a pane", "a clear plate with air on both sides"],
};
/** Indices that a cover may have. */
export const COVER_N = { minimum: 1, maximum: 4 };

/** What the rows of colors are of, by cover. @type {Record<string, Record<string, string>>} */
const ROWS = {
  medium: { air: "in air", below: "seen from the medium" },
  coat: { air: "in air", below: "seen from the coat", whole: "coat and material together" },
  pane: { air: "in air", whole: "pane and material together" },
};
const COLORS = /** @type {const} */ ([
  ["F0", "F_0"],
  ["F82", "F_{82}"],
  ["F82_tint", "tint"],
]);

/** @param {number[]} rgb */
const numbers = (rgb) => rgb.map((x) => plain(x, 4)).join(", ");

/** @param {number[]} rgb linear */
const css = (rgb) => `rgb(${rgb.map((x) => Math.round(255 * encoded(clamp(x, 0, 1)))).join(" ")})`;

/** @param {any} answer @param {string} name @param {string} title */
function colorsRow(answer, name, title) {
  return html`<tr><th scope="row">${title}</th>${COLORS.map(
    ([color]) => html`<td><i class="swatch" aria-hidden="true"
      style="background: ${css(answer[name][color])}"></i>${numbers(answer[name][color])}</td>`,
  )}</tr>`;
}

/** @param {any} shortcut */
function shortcutRow({ title, validity, measured, F0, F0_error, error }) {
  const source = measured.length ? `Measured in ${measured.join(", ")}.` : "Not run.";
  return html`<tr><th scope="row">${title}<details class="knob"><summary>what it does</summary>
      <p>${validity} ${source}</p></details></th>
    <td>${numbers(F0)}</td>
    <td>${F0_error.map((/** @type {number} */ x) => plain(x, 2)).join(", ")}</td>
    <td>${plain(error.max_abs, 2)} at ${plain(error.at_deg)}°, ${error.channel}</td>
    <td>${plain(error.delta_e, 2)} at ${plain(error.delta_e_at_deg)}°</td></tr>`;
}

/** @param {any} answer */
function sentence({ cover, largest_angle_deg: largest }) {
  if (cover === "medium") return "Angles are those in the medium.";
  if (cover === "pane") return "Both faces of the pane, and all that goes to and fro, are in.";
  if (largest === null) return "A coat of index 1 is none.";
  return `Light from air reaches the material below ${plain(largest, 3)}° at all angles: what it does at 82° is not seen.`;
}

/** @param {Pick<ViewContext, 'actions'> & {parent: HTMLElement}} context */
export function createCovered({ parent, actions }) {
  const choices = createChoices(actions, { cover: ["In front", COVERS] });
  const index = createTyped({
    attributes: { class: "box bound", "aria-label": "Index of what is in front" },
    id: "cover-n-error",
    parse(text) {
      const value = evaluate(text);
      if (value >= COVER_N.minimum && value <= COVER_N.maximum) return value;
      throw new Error(`allowed is ${plain(COVER_N.minimum)} to ${plain(COVER_N.maximum)}`);
    },
    onChange: (value) => actions.set({ cover_n: value }),
  });
  const problem = h("p.row-error", { role: "alert" });
  const body = h("div.take-body");
  const element = h(
    "section.column.sheet.covered",
    { "aria-label": "Under something" },
    h("div.heading", h("h2", "Under something")),
    h(
      "div.sheet-controls",
      choices.elements.cover,
      h("label.given-label", h("span", "its index "), symbol("n"), index.box),
    ),
    index.wrong,
    problem,
    body,
  );
  parent.append(element);
  const changed = createChanged();

  /** @param {any} answer */
  function draw(answer) {
    const { cover, shortcuts, gamut } = answer;
    render(
      html`<p class="hint">${sentence(answer)} Linear sRGB from the spectrum, ${gamut}.</p>
        <div class="rival-scroll" tabindex="0" role="region" aria-label="Colors under it">
        <table class="rivals"><caption class="hidden">Colors under it</caption>
          <thead><tr><th scope="col">the material</th>${COLORS.map(
            ([, tex]) => html`<th scope="col">${tex === "tint" ? tex : symbol(tex)}</th>`,
          )}</tr></thead>
          <tbody>${Object.entries(ROWS[cover] ?? {}).map(([name, title]) => colorsRow(answer, name, title))}</tbody>
        </table></div>
        ${
          shortcuts.length
            ? html`<h3>What engines make of the coat</h3>
        <div class="rival-scroll" tabindex="0" role="region" aria-label="Shortcuts for a coat">
        <table class="rivals"><caption class="hidden">Shortcuts for a coat</caption>
          <thead><tr>${[
            "engine",
            "F0 that it takes below",
            "off by",
            "largest error of the whole",
            "ΔE",
          ].map((words) => html`<th scope="col">${words}</th>`)}</tr></thead>
          <tbody>${shortcuts.map(shortcutRow)}</tbody>
        </table></div>`
            : nothing
        }`,
      body,
    );
  }

  return {
    /** @param {State} state @param {any} answer */
    update(state, answer) {
      choices.update(state);
      index.update(plain(state.cover_n));
      if (answer && changed(answer)) draw(answer);
    },
    /** @param {{title: string, lines: string[]} | undefined} what */
    problem(what) {
      problem.textContent = told(what);
      body.hidden = Boolean(what);
    },
  };
}
