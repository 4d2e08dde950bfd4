/** Parts of tables as templates: headings to sort by, numbers that are copied, and what copies all of them. */

import { six } from "../numbers/format.js";
import { copying, h } from "./dom.js";
import { html, nothing } from "./lit.js";

/**
 * @typedef {'up' | 'down'} Order
 * @typedef {{by: string, order: Order}} Sorting
 */

/**
 * @param {{name: string, heading: string, note: string}} column
 * @param {Sorting} sorting
 * @param {(by: string, order: Order) => void} onSort
 * @param {string} [className] of its button
 */
export function heading({ name, heading, note }, { by, order }, onSort, className = "sort") {
  const on = by === name;
  const sorted = on && (order === "up" ? "ascending" : "descending");
  return html`<th scope="col" aria-sort=${sorted || nothing}><button
    type="button"
    class=${className}
    title=${note || nothing}
    data-order=${on ? order : ""}
    @click=${() => onSort(name, on && order === "up" ? "down" : "up")}
  >${heading}</button></th>`;
}

/**
 * @param {string} label
 * @param {() => (string | number)[][]} cells with the headings in the first row
 * @param {(text: string) => void} say
 */
export function createCopy(label, cells, say) {
  const text = () =>
    `${cells()
      .map((row) => row.join("\t"))
      .join("\n")}\n`;
  const said = () => `${cells().length - 1} rows copied`;
  const onclick = (/** @type {Event} */ event) => copying(text, say, said())(event);
  return h("button.quiet", { type: "button", "aria-label": label, onclick }, "copy");
}

/** A number with six digits on a button, which copies all of them. @param {string} name @param {number | null} value @param {(text: string) => void} say */
export const copied = (name, value, say) =>
  html`<button
    type="button"
    class="number"
    aria-label="${name}: ${six(value)}, copy"
    ?data-none=${value === null}
    @click=${copying(() => String(value ?? "none"), say, `${name} copied`)}
  >${six(value)}</button>`;
