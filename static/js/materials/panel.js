/** A figure with its heading, its controls, what went wrong with it, its files and its data table. */

import { createDataTables, createExports, h, setText } from "../page/dom.js";

/**
 * @typedef {Published & {exportAs: (format: 'png' | 'svg' | 'csv') => Promise<Blob>, table: () => HTMLTableElement,
 *   theme: () => void, destroy: () => void}} Figure
 * @typedef {Pick<ViewContext, 'catalog' | 'actions' | 'save' | 'describeMedia'> & {parent: HTMLElement, now: () => State}} FigureContext
 *   where the figures stand, in the document because plots read colors and sizes from it, and the state with the
 *   preset that is shown
 */

/** What went wrong, in one line. @param {{title: string, lines: string[]} | undefined} problem */
export const told = (problem) => (problem ? problem.lines.join(" ") || problem.title : "");

/**
 * @param {FigureContext} context
 * @param {object} options
 * @param {string} options.title
 * @param {string} options.name of its class
 * @param {(Node | null)[]} [options.controls]
 * @param {HTMLElement[]} options.frames of the plots, one below or beside the other
 * @param {() => Figure[]} options.figures
 * @param {() => string} options.what is in the file, which is named by it and the preset
 * @param {string} options.call a part of the REST call that it shows
 * @param {() => string[]} [options.presets] that it shows
 */
export function createPanel(
  { parent, now, save },
  { title, name, controls = [], frames, figures, what, call, presets = () => [now().preset] },
) {
  const exports = createExports({
    what: `“${title}”`,
    name: () => `${now().preset}-${what()}`,
    make: (kind) => Promise.all(figures().map((figure) => figure.exportAs(kind))),
    print: { figures, call, behind: () => ({ presets: presets() }) },
    save,
  });
  const problem = h("p.row-error", { role: "alert" });
  const note = h("p.hint");
  const tables = createDataTables("As a table", {
    [`${title}, table`]: () => figures().map((figure) => figure.table()),
  });
  const element = h(
    "section",
    { class: `column sheet ${name}`, "aria-label": title },
    h("div.heading", h("h2", title), exports),
    h("div.sheet-controls", ...controls),
    problem,
    h("div.figure-row", ...frames),
    note,
    tables.element,
  );
  parent.append(element);
  return {
    element,
    /** The curves have changed. @param {string} text */
    filled(text) {
      tables.fill();
      setText(note, text);
    },
    /** @param {{lines: string[], title: string} | undefined} what */
    problem: (what) => setText(problem, told(what)),
    theme: () => figures().forEach((figure) => void figure.theme()),
    destroy: () => figures().forEach((figure) => void figure.destroy()),
  };
}
