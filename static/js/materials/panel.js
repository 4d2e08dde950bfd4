/** A figure with its heading, its controls, what went wrong with it, its files and its data table. */

import { h, setText } from "../dom.js";
import { createExports } from "../exports.js";

/**
 * @typedef {import('../exports.js').Published & {exportAs: (format: 'png' | 'svg' | 'csv') => Promise<Blob>, table: () => HTMLTableElement,
 *   theme: () => void, destroy: () => void}} Figure
 * @typedef {ReturnType<typeof createPanel>} Panel
 */

/**
 * @param {object} options
 * @param {HTMLElement} options.parent in the document, because plots read colours and sizes from it
 * @param {string} options.title
 * @param {string} options.name of its class
 * @param {(Node | null)[]} [options.controls]
 * @param {HTMLElement[]} options.hosts of the plots, one below or beside the other
 * @param {() => Figure[]} options.figures
 * @param {() => string} options.filename without ending
 * @param {string} options.call a part of the REST call that it shows
 * @param {(name: string, blob: Blob) => void} options.save
 */
export function createPanel({
  parent,
  title,
  name,
  controls = [],
  hosts,
  figures,
  filename,
  call,
  save,
}) {
  const exports = createExports({
    what: `“${title}”`,
    name: filename,
    make: (kind) => Promise.all(figures().map((figure) => figure.exportAs(kind))),
    print: { figures, call },
    save,
  });
  const heading = h("h2", {}, title);
  const problem = h("p", { class: "row-error", role: "alert" });
  const note = h("p", { class: "hint" });
  const tables = h("div", {
    class: "plot-table",
    tabindex: "0",
    role: "region",
    "aria-label": `${title}, table`,
  });
  const dataTable = h("details", { class: "definitions" }, h("summary", {}, "As a table"), tables);
  const area = h("div", { class: "figure-row" }, ...hosts);
  const element = h(
    "section",
    { class: `column sheet ${name}`, "aria-label": title },
    h("div", { class: "heading" }, heading, exports),
    h("div", { class: "sheet-controls" }, ...controls),
    problem,
    area,
    note,
    dataTable,
  );
  parent.append(element);
  function fill() {
    if (dataTable.open) tables.replaceChildren(...figures().map((f) => f.table()));
  }
  dataTable.addEventListener("toggle", fill);
  return {
    element,
    fill,
    /** @param {Node | string} text */
    note: (text) => note.replaceChildren(text),
    /** @param {{lines: string[], title: string} | undefined} what */
    problem: (what) => setText(problem, what ? what.lines.join(" ") || what.title : ""),
    /** @param {boolean} hidden */
    hide(hidden) {
      element.hidden = hidden;
    },
  };
}
