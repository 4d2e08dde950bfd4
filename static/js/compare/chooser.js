/** Which models stand against the exact curve: three folds, and a search over all of them. */

import { createFold } from "../controls/panel.js";
import { createClear } from "../controls/view-panel.js";
import { forMedium, modelStyle } from "../models/look.js";
import { h, setText } from "../page/dom.js";

/** Whether a model is kept to show a mistake. @param {Model} model */
const isTrap = ({ trap }) => trap === true;

/** @type {{legend: string, open: boolean, holds: (model: Model) => boolean}[]} */
const GROUPS = [
  { legend: "Approximations", open: true, holds: (m) => m.kind !== "exact" && !isTrap(m) },
  { legend: "Traps", open: false, holds: isTrap },
  { legend: "Exact forms", open: false, holds: (m) => m.kind === "exact" && !isTrap(m) },
];

/** @param {Model} model @param {string} text typed into the search box */
export function matches(model, text) {
  const where = `${model.id} ${model.title} ${model.reference} ${model.validity}`.toLowerCase();
  return text
    .toLowerCase()
    .split(/\s+/)
    .every((word) => where.includes(word));
}

/**
 * @param {object} options
 * @param {Model[]} options.models
 * @param {() => readonly string[]} options.chosen
 * @param {(ids: string[]) => void} options.onChange
 */
export function createChooser({ models, chosen, onChange }) {
  const search = h("input.box.search", {
    type: "search",
    placeholder: "search models, authors, engines",
    "aria-label": "Search the models",
    autocomplete: "off",
    spellcheck: "false",
    oninput: filter,
    onkeydown(/** @type {KeyboardEvent} */ event) {
      if (event.key !== "Escape" || search.value === "") return;
      search.value = "";
      filter();
    },
  });
  const none = h("p.reason");
  const groups = GROUPS.map(({ legend, open, holds }) => {
    const members = models.filter((m) => m.id !== "exact" && holds(m));
    const entries = members.map((m) => ({
      id: m.id,
      title: m.title.replace(/\s*\(trap\)/, ""),
      note: `${m.validity}\n${m.reference}`,
      style: modelStyle(models, m.id),
    }));
    return { members, open, fold: createFold({ legend, entries, open, chosen, onChange }) };
  });

  function filter() {
    const text = search.value.trim();
    let found = 0;
    for (const { members, open, fold } of groups) {
      const hits = members.map((model) => text === "" || matches(model, text));
      fold.labels.forEach((label, i) => {
        label.hidden = !hits[i];
      });
      const any = hits.includes(true);
      found += Number(any);
      fold.element.hidden = !any;
      if (text !== "") fold.element.open = true;
      else if (!fold.ids.some((id) => chosen().includes(id))) fold.element.open = open;
    }
    setText(none, found === 0 ? `No match for “${text}”.` : "");
  }

  const clear = createClear("Models", "clear the choice of models", onChange);
  const element = h(
    "div.chooser",
    clear.element,
    search,
    none,
    ...groups.map((g) => g.fold.element),
  );
  let revealed = false;

  return {
    element,
    /** @param {readonly string[]} ids @param {ReadonlyMap<string, string>} reasons @param {number} k_t of the second medium */
    update(ids, reasons, k_t) {
      clear.update(ids);
      for (const { fold } of groups)
        if (fold.update(ids, reasons, forMedium(models, k_t)) > 0 && !revealed)
          fold.element.open = true;
      revealed = true;
    },
  };
}
