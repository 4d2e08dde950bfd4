/** The panel beside a view: the media, their three indices, and below them the view's own choices. */

import { createInterface } from "../media/media.js";
import { h } from "../page/dom.js";
import { createSheet } from "./panel.js";

/** @param {Parameters<typeof createInterface>[0] & {choices: Node[]}} options */
export function createPanel({ choices, ...options }) {
  const { rows, media } = createInterface(options);
  const body = h(
    "div.panel-body",
    h("div.heading", h("h2", "Media")),
    media.element,
    h("div.rows", ...rows.map((r) => r.row.element)),
    h("div.choices", ...choices),
  );
  const sheet = createSheet({ pages: rows, body, first: "n_t" });
  return {
    element: sheet.element,
    stop() {
      media.stop();
      for (const { row } of rows) row.stop();
    },
    /** @param {State} now */
    update(now) {
      media.update(now);
      /** @type {Record<string, {value: number, label: string}[]>} */
      const marks = {
        n_i: [{ value: now.n_t, label: "equal to n_t" }],
        n_t: [{ value: now.n_i, label: "equal to n_i" }],
      };
      for (const { name, row } of rows) row.update(now[name], marks[name]);
      sheet.update();
    },
  };
}

/**
 * What stands above folds: their heading, and a button that takes the choice back.
 * @param {string} title
 * @param {string} label of the button
 * @param {(ids: string[]) => void} onChange
 */
export function createClear(title, label, onChange) {
  const clear = h(
    "button.quiet",
    { type: "button", "aria-label": label, onclick: () => onChange([]) },
    "clear",
  );
  return {
    element: h("div.heading", h("h2", title), clear),
    /** @param {readonly string[]} ids that are chosen */
    update(ids) {
      clear.hidden = ids.length === 0;
    },
  };
}
