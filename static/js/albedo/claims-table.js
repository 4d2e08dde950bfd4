/** The table of claims: sortable; a fit's name brings it onto the plot. */

import { sample } from "../models/look.js";
import { h } from "../page/dom.js";
import { copyText, flash } from "../page/exports.js";
import { COLUMNS, homeOf, rowsOf, sortedClaims } from "./claims.js";
import { fitStyle } from "./style.js";

/**
 * @typedef {import('./answers.js').Fit} Fit
 * @typedef {import('./claims.js').Row} Row
 */

/**
 * @param {object} options
 * @param {(by: string, order: 'up' | 'down') => void} options.onSort
 * @param {(id: string, surface: string) => void} options.onPick
 * @param {(text: string) => void} options.say
 */
export function createClaims({ onSort, onPick, say }) {
  let by = "holds";
  let order = /** @type {'up' | 'down'} */ ("up");
  /** @type {readonly Fit[]} */
  let fits = [];
  const headings = COLUMNS.map((column) => {
    const button = h(
      "button",
      {
        type: "button",
        class: "sort-by",
        title: column.note || null,
        onclick: () => onSort(column.name, by === column.name && order === "up" ? "down" : "up"),
      },
      column.heading,
    );
    return { column, button, th: h("th", { scope: "col" }, button) };
  });
  const body = h("tbody", {});
  const table = h(
    "table",
    { class: "claims" },
    h("caption", { class: "hidden" }, "Largest errors of the fits, claimed and measured"),
    h("thead", {}, h("tr", {}, ...headings.map((c) => c.th))),
    body,
  );
  const copy = h("button", { type: "button", class: "quiet" }, "copy");
  copy.setAttribute("aria-label", "Copy the table of claims");
  copy.addEventListener("click", async () => {
    const lines = sortedClaims(rowsOf(fits), by, order).map((row) =>
      COLUMNS.map((c) => (c.name === "claimed" ? (c.value(row) ?? "") : c.print(row))).join("\t"),
    );
    const heading = COLUMNS.map((c) => c.heading).join("\t");
    const done = await copyText(`${[heading, ...lines].join("\n")}\n`);
    flash(copy, done);
    say(done ? `${lines.length} rows copied` : "Copying is not allowed here");
  });
  const element = h(
    "div",
    { class: "claims-scroll", tabindex: "0", role: "region", "aria-label": "Table of claims" },
    table,
  );

  /** @param {Row} row @param {readonly string[]} chosen @param {string} surface */
  function line(row, chosen, surface) {
    const home = homeOf(row.claim.domain);
    const shown = chosen.includes(row.fit.id) && surface === home;
    const holds = row.claim.holds;
    return h(
      "tr",
      { "data-holds": holds === null ? "unclaimed" : holds ? "yes" : "no" },
      h(
        "th",
        { scope: "row" },
        h(
          "button",
          {
            type: "button",
            class: "pick-fit",
            "aria-pressed": String(shown),
            onclick: () => onPick(row.fit.id, home),
          },
          sample(fitStyle(fits, row.fit.id)),
          h("span", {}, row.fit.title),
        ),
      ),
      ...COLUMNS.slice(1).map((column) => h("td", { class: column.name }, column.print(row))),
    );
  }

  let look = "";
  return {
    element,
    copy,
    /** @param {readonly Fit[]} next @param {{by: string, order: 'up' | 'down', chosen: readonly string[], surface: string}} shown */
    update(next, shown) {
      const wanted = JSON.stringify(shown);
      if (next === fits && wanted === look) return;
      fits = next;
      look = wanted;
      ({ by, order } = shown);
      const focused = body.contains(document.activeElement)
        ? [...body.querySelectorAll("button")].indexOf(/** @type {any} */ (document.activeElement))
        : -1;
      body.replaceChildren(
        ...sortedClaims(rowsOf(fits), by, order).map((r) => line(r, shown.chosen, shown.surface)),
      );
      if (focused >= 0) body.querySelectorAll("button")[focused]?.focus();
      for (const { column, th, button } of headings) {
        const on = column.name === by;
        if (on) th.setAttribute("aria-sort", order === "up" ? "ascending" : "descending");
        else th.removeAttribute("aria-sort");
        button.dataset.order = on ? order : "";
      }
    },
  };
}
