/** The table of claims: sortable; a fit's name brings it onto the plot. */

import { sampled } from "../models/sampled.js";
import { createChanged } from "../page/changed.js";
import { h } from "../page/dom.js";
import { html, render } from "../page/lit.js";
import { createCopy, heading } from "../page/tables.js";
import { homeOf } from "./answers.js";
import { COLUMNS, rowsOf, sortedClaims } from "./claims.js";
import { chosenFits, turned } from "./fields.js";
import { fitStyle } from "./style.js";

/**
 * @typedef {import('./answers.js').Fit} Fit
 * @typedef {import('./claims.js').Row} Row
 */

/** @param {ViewContext} context */
export function createClaims({ state, actions, say }) {
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
  /** Bring a fit onto the plot of its figure, or take it away. @param {string} id @param {string} surface */
  function pick(id, surface) {
    const chosen = state().surface === surface ? chosenFits(state()) : [];
    const others = chosen.filter((other) => other !== id);
    const fits = chosen.includes(id) ? others : [...others, id];
    actions.set({ ...turned(state(), surface), fits: Object.freeze(fits) });
  }
  /** @param {string} by @param {string} order */
  const sort = (by, order) => actions.set({ claims_by: by, claims_order: order });
  const element = h("div.claims-scroll", {
    tabindex: "0",
    role: "region",
    "aria-label": "Table of claims",
  });

  /** @param {Row} row @param {State} now */
  function line(row, now) {
    const { id, title } = row.fit;
    const { holds, domain } = row.claim;
    const home = homeOf(domain);
    return html`<tr data-holds=${holds === null ? "unclaimed" : holds ? "yes" : "no"}>
      <th scope="row"><button
        type="button"
        class="pick-fit"
        aria-pressed=${chosenFits(now).includes(id) && now.surface === home}
        @click=${() => pick(id, home)}
      >${sampled(fitStyle(id))}<span>${title}</span></button></th>
      ${COLUMNS.slice(1).map((c) => html`<td class=${c.name}>${c.print(row)}</td>`)}
    </tr>`;
  }

  return {
    element,
    copy,
    /** @param {readonly Fit[]} fits @param {State} now */
    update(fits, now) {
      const { claims_by: by, claims_order: order, surface } = now;
      if (!changed(fits, by, order, surface, chosenFits(now))) return;
      rows = sortedClaims(rowsOf(fits), by, order);
      const headings = COLUMNS.map((c) => heading(c, { by, order }, sort, "sort-by"));
      render(
        html`<table class="claims">
          <caption class="hidden">Largest errors of the fits, claimed and measured</caption>
          <thead><tr>${headings}</tr></thead>
          <tbody>${rows.map((row) => line(row, now))}</tbody>
        </table>`,
        element,
      );
    },
  };
}
