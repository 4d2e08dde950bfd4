/** A figure with its heading, its controls, what went wrong with it, its files and its data table. */

import { h, setText } from "../page/dom.js";
import { createDataTables, createExports } from "../page/exports.js";

/**
 * @typedef {import('../page/exports.js').Published & {exportAs: (format: 'png' | 'svg' | 'csv') => Promise<Blob>, table: () => HTMLTableElement,
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
 * @param {() => string[]} options.presets that it shows
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
  presets,
  save,
}) {
  const exports = createExports({
    what: `“${title}”`,
    name: filename,
    make: (kind) => Promise.all(figures().map((figure) => figure.exportAs(kind))),
    print: { figures, call, behind: () => ({ presets: presets() }) },
    save,
  });
  const heading = h("h2", {}, title);
  const problem = h("p", { class: "row-error", role: "alert" });
  const note = h("p", { class: "hint" });
  const tables = createDataTables("As a table", {
    [`${title}, table`]: () => figures().map((figure) => figure.table()),
  });
  const area = h("div", { class: "figure-row" }, ...hosts);
  const element = h(
    "section",
    { class: `column sheet ${name}`, "aria-label": title },
    h("div", { class: "heading" }, heading, exports),
    h("div", { class: "sheet-controls" }, ...controls),
    problem,
    area,
    note,
    tables.element,
  );
  parent.append(element);
  return {
    element,
    fill: tables.fill,
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
