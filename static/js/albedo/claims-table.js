/** The table of claims: sortable; a fit's name brings it onto the plot. */

import { sampled } from "../models/sampled.js";
import { createChanged } from "../page/changed.js";
import { h } from "../page/dom.js";
import { html, render } from "../page/lit.js";
import { createCopy, heading } from "../page/tables.js";
import { homeOf } from "./answers.js";
import { COLUMNS, rowsOf, sortedClaims } from "./claims.js";
import { fitStyle } from "./style.js";

/**
 * @typedef {import('./answers.js').Fit} Fit
 * @typedef {import('./claims.js').Row} Row
 * @typedef {import('../page/tables.js').Sorting & {chosen: readonly string[], surface: string}} Shown
 */

/**
 * @param {object} options
 * @param {(by: string, order: 'up' | 'down') => void} options.onSort
 * @param {(id: string, surface: string) => void} options.onPick
 * @param {(text: string) => void} options.say
 */
export function createClaims({ onSort, onPick, say }) {
  /** @type {Row[]} */
  let rows = [];
  const changed = createChanged();
  const copy = createCopy(
    "Copy the table of claims",
    () => [
      COLUMNS.map((c) => c.heading),
      ...rows.map((row) =>
        COLUMNS.map((c) => (c.name === "claimed" ? (c.value(row) ?? "") : c.print(row))),
      ),
    ],
    say,
  );
  const element = h("div", {
    class: "claims-scroll",
    tabindex: "0",
    role: "region",
    "aria-label": "Table of claims",
  });

  /** @param {Row} row @param {readonly Fit[]} fits @param {Shown} shown */
  function line(row, fits, { chosen, surface }) {
    const { id, title } = row.fit;
    const { holds, domain } = row.claim;
    const home = homeOf(domain);
    return html`<tr data-holds=${holds === null ? "unclaimed" : holds ? "yes" : "no"}>
      <th scope="row"><button
        type="button"
        class="pick-fit"
        aria-pressed=${chosen.includes(id) && surface === home}
        @click=${() => onPick(id, home)}
      >${sampled(fitStyle(fits, id))}<span>${title}</span></button></th>
      ${COLUMNS.slice(1).map((c) => html`<td class=${c.name}>${c.print(row)}</td>`)}
    </tr>`;
  }

  return {
    element,
    copy,
    /** @param {readonly Fit[]} fits @param {Shown} shown */
    update(fits, shown) {
      if (!changed(fits, JSON.stringify(shown))) return;
      rows = sortedClaims(rowsOf(fits), shown.by, shown.order);
      render(
        html`<table class="claims">
          <caption class="hidden">Largest errors of the fits, claimed and measured</caption>
          <thead><tr>${COLUMNS.map((c) => heading(c, shown, onSort, "sort-by"))}</tr></thead>
          <tbody>${rows.map((row) => line(row, fits, shown))}</tbody>
        </table>`,
        element,
      );
    },
  };
}
