/** One interface in the words of optics, of artists and of engines, each with what is lost. */

import { createSelect } from "../controls/select.js";
import { createTyped } from "../controls/typed.js";
import { atWavelength } from "../media/media.js";
import { evaluate } from "../numbers/expression.js";
import { plain } from "../numbers/format.js";
import { createChanged } from "../page/changed.js";
import { h, symbol } from "../page/dom.js";
import { html, nothing, render } from "../page/lit.js";
import { sayProblem } from "../page/trouble.js";
import { declared } from "../state/state.js";
import {
  asResults,
  BETWEEN,
  filled,
  knobsOf,
  printValue,
  rangeOf,
  SOURCES,
  texts,
  typedValue,
} from "./conversions.js";
import { colored } from "./metal-color.js";

/** @typedef {import('./conversions.js').Result} Result */
/** @typedef {import('./conversions.js').Knob} Knob */

/** Symbols of values that are not their names; what has none is named by its form. @type {Record<string, string>} */
const SYMBOLS = { F0: "F_0", F0_srgb: "F_0", F82: "F_{82}" };
const NAMED = ["n_i", "n_t", "k_t", "r", "g", "G", "tint"];
const DESCRIBED = "convert-problem";
const COLUMNS = ["form", "value", "status", "why", "use"];
const KNOB_COLUMNS = ["knob", "what to type", "status", "why"];

/** @param {string} name @param {any} value */
function valued(name, value) {
  const words = printValue(name === "n_i" && Array.isArray(value) ? value[0] : value);
  const own = NAMED.includes(name) ? name : SYMBOLS[name];
  const hex = name === "hex" && typeof value === "string";
  return html`<span class="conversion">${own ? symbol(own) : nothing}${
    hex ? html`<i class="swatch" aria-hidden="true" style="background: ${value}"></i>` : nothing
  } ${words}</span>`;
}

/** A name that a narrow line breaks behind its underscores. @param {string} name */
const breaking = (name) =>
  name.split(/(?<=_)/u).map((part, at) => (at ? html`<wbr>${part}` : part));

/** One engine's knob: what to type, and how far it can be turned. @param {Knob} knob */
function knobLine({ title, inputs, status, why, reference, measured }) {
  const run = measured.length ? `Measured in ${measured.join(", ")}` : "Not run";
  return html`<tr data-status=${status}>
    <th scope="row">${breaking(title)}</th>
    <td class="converted">${inputs.map(
      (input) =>
        html`<span class="conversion">${breaking(input.label)} ${typedValue(input.value)}</span>`,
    )}</td>
    <td class="status-cell"><span class="status">${status}</span></td>
    <td class="why">${why}
      <details class="knob"><summary>range and source</summary>
        <ul>${inputs.map(
          (input) => html`<li>${input.label}: ${rangeOf(input)}; outside, ${input.clamps}.</li>`,
        )}<li>${run}. ${reference}.</li></ul>
      </details></td>
  </tr>`;
}

/** @param {ViewContext} context */
export function createConvert({ catalog, state, actions }) {
  /** @type {Result[]} */
  let results = [];
  const from = createSelect(
    "What is given",
    (value) => actions.set({ from: value, given: filled(value, results) }),
    Object.fromEntries(Object.entries(SOURCES).map(([value, { label }]) => [value, label])),
  );
  const boxes = [0, 1, 2].map(() =>
    createTyped({
      attributes: { class: "box given", "aria-describedby": DESCRIBED },
      parse: String,
      onChange() {
        const many = SOURCES[state().from]?.inputs.length;
        const written = boxes.slice(0, many).map(({ box }) => box.value.trim());
        actions.set({ given: written.join(BETWEEN) });
      },
    }),
  );
  const { minimum, maximum } = declared(catalog.parameters, "n_i");
  const seen = createTyped({
    attributes: {
      class: "box bound",
      "aria-label": "Index of the other medium that F0 is seen from",
      "aria-describedby": DESCRIBED,
    },
    parse(text) {
      const value = text === "" ? null : evaluate(text);
      if (value === null || (value >= minimum && value <= maximum)) return value;
      throw new Error(`allowed is ${plain(minimum)} to ${plain(maximum)}`);
    },
    onChange: (value) => actions.set({ seen_from: value }),
  });
  const element = h("section.column.convert", { "aria-label": "Conversions" });

  /** @param {Result} result @param {boolean} own whether the media are what is given */
  function line({ form, title, values, status, why }, own) {
    const { n_t, k_t = 0 } = values;
    const usable =
      !own &&
      (form === "nk" || form === "ior") &&
      typeof n_t === "number" &&
      typeof k_t === "number";
    const use = () =>
      actions.set({
        n_t: Math.max(minimum, Number(n_t.toPrecision(12))),
        k_t: Number(k_t.toPrecision(12)),
        material: null,
      });
    return html`<tr data-status=${status}>
      <th scope="row">${title}</th>
      <td class="converted">${Object.entries(values)
        .filter(([name]) => form !== "f0_hex" || name === "hex")
        .map(([name, value]) => valued(name, value))}</td>
      <td class="status-cell"><span class="status">${status}</span></td>
      <td class="why">${why}</td>
      <td class="use">${
        usable
          ? html`<button
              type="button"
              class="quiet"
              aria-label="Use ${title} as the second medium"
              @click=${use}
            >use</button>`
          : nothing
      }</td>
    </tr>`;
  }

  /** The boxes of what is given. @param {State} now @param {boolean} wrong */
  function given(now, wrong) {
    const { label = "", inputs = [] } = SOURCES[now.from] ?? {};
    const values = texts(now);
    return inputs.map((input, i) => {
      const { box, update } = /** @type {(typeof boxes)[0]} */ (boxes[i]);
      box.placeholder = input.hint;
      box.ariaLabel = `${label}, ${input.name}`;
      box.ariaInvalid = wrong ? "true" : null;
      update(values[i] ?? "");
      const name = input.symbol ? symbol(input.symbol) : inputs.length > 1 ? input.name : nothing;
      return html`<label class="given-label"><span class="given-name">${name}</span>${box}</label>`;
    });
  }

  /** @type {ReturnType<typeof line>[]} */
  let lines = [];
  /** @type {ReturnType<typeof knobLine>[]} */
  let knobs = [];
  let color = "000000";
  const changed = createChanged();
  return {
    element,
    /**
     * @param {State} now
     * @param {any} answer
     * @param {import('../page/trouble.js').Problem | undefined} problem
     * @param {import('./metal-color.js').Detail | undefined} detail the material that is converted
     */
    update(now, answer, problem, detail) {
      if (answer && changed(answer, now.from)) {
        results = asResults(answer);
        lines = answer.results.map((/** @type {Result} */ result) =>
          line(result, now.from === "media"),
        );
        knobs = knobsOf(answer).map(knobLine);
      }
      from.update(now.from);
      seen.update(plain(now.seen_from ?? answer?.seen_from ?? 1));
      const [first = ""] = texts(now);
      color = /^#?([0-9a-f]{6})$/i.exec(first)?.[1]?.toLowerCase() ?? color;
      render(
        html`<div class="heading"><h2>Conversions</h2><span class="at-nm">${now.from === "media" ? atWavelength(catalog.materials, now) : ""}</span></div>
          <div class="convert-from">
            ${from.element}${given(now, problem !== undefined)}
            ${
              now.from === "hex"
                ? html`<input
                    type="color"
                    class="color"
                    aria-label="Color of the picture"
                    .value="#${color}"
                    @change=${(/** @type {any} */ event) => actions.set({ given: event.target.value })}
                  />`
                : nothing
            }
            <label class="given-label seen"><span>also seen from <var class="symbol">n</var> =</span>${seen.box}</label>
          </div>
          <p class="row-error" id=${DESCRIBED} role="alert">${sayProblem(problem)}</p>
          ${colored(now, catalog, detail)}
          <table class="conversions" ?data-stale=${problem !== undefined}>
            <caption class="hidden">The same surface in other words</caption>
            <thead class="hidden">
              <tr>${COLUMNS.map((text) => html`<th scope="col">${text}</th>`)}</tr>
            </thead>
            <tbody>${lines}</tbody>
          </table>
          <h3>What to type in engines</h3>
          <table class="conversions knobs" ?data-stale=${problem !== undefined}>
            <caption class="hidden">The same surface as the knobs of engines</caption>
            <thead class="hidden">
              <tr>${KNOB_COLUMNS.map((text) => html`<th scope="col">${text}</th>`)}</tr>
            </thead>
            <tbody>${knobs}</tbody>
          </table>`,
        element,
      );
    },
  };
}
