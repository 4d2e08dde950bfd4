/** A fold of curves to choose among: how many of them are on stands in its line. */

import { sample } from "../models/look.js";
import { h, setText } from "../page/dom.js";
import { createChoice } from "./panel.js";

/**
 * @typedef {{id: string, title: string, note: string, style: {color: string, dash: string}}} Entry
 * @param {object} options
 * @param {string} options.legend
 * @param {readonly Entry[]} options.entries
 * @param {boolean} [options.open]
 * @param {() => readonly string[]} options.chosen those of all folds, in the order in which they were chosen
 * @param {(ids: string[]) => void} options.onChange
 */
export function createFold({ legend, entries, open = false, chosen, onChange }) {
  const ids = entries.map(({ id }) => id);
  const group = createChoice({
    legend,
    several: true,
    listed: true,
    items: entries.map(({ id, title, note, style }) => ({
      value: id,
      label: title,
      note,
      content: h("span.overlay-name", sample(style), title),
    })),
    onChange(picked) {
      const kept = chosen().filter((id) => picked.includes(id) || !ids.includes(id));
      onChange([...kept, ...picked.filter((id) => !kept.includes(id))]);
    },
  });
  const count = h("span.count");
  const element = h("details.forms", { open }, h("summary", legend, count), group.element);
  return {
    element,
    ids,
    labels: group.element.querySelectorAll("label"),
    /** @param {readonly string[]} on @param {ReadonlyMap<string, string>} [reasons] why one does not apply here */
    update(on, reasons) {
      group.update(on, reasons);
      const many = ids.filter((id) => on.includes(id)).length;
      setText(count, many ? ` ${many} of ${ids.length}` : ` ${ids.length}`);
      return many;
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
