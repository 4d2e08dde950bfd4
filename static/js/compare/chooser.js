/** Which models stand against the exact curve: three groups, and a search over all of them. */

import { modelStyle, sample } from "../models/look.js";
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
  const search = h("input", {
    type: "search",
    class: "box search",
    placeholder: "search models, authors, engines",
    "aria-label": "Search the models",
    autocomplete: "off",
    spellcheck: "false",
  });
  const none = h("p", { class: "reason" });
  const groups = GROUPS.map(({ legend, open, holds }) => {
    const items = models.filter((m) => m.id !== "exact" && holds(m)).map(item);
    const count = h("span", { class: "count" });
    const box = h(
      "details",
      { class: "forms", open },
      h("summary", {}, legend, count),
      h(
        "fieldset",
        { class: "choice several listed" },
        h("legend", {}, legend),
        h("div", { class: "options" }, ...items.map((i) => i.label)),
      ),
    );
    return { box, items, count, open };
  });

  /** @param {Model} model */
  function item(model) {
    const input = h("input", {
      type: "checkbox",
      value: model.id,
      onchange: () => {
        const others = chosen().filter((id) => id !== model.id);
        onChange(input.checked ? [...others, model.id] : others);
      },
    });
    const label = h(
      "label",
      { title: `${model.validity}\n${model.reference}` },
      input,
      h(
        "span",
        { class: "overlay-name" },
        sample(modelStyle(models, model.id)),
        model.title.replace(/\s*\(trap\)/, ""),
      ),
    );
    return { model, input, label };
  }

  function filter() {
    const text = search.value.trim();
    let found = 0;
    for (const { box, items, open } of groups) {
      const hits = items.filter(({ model, label }) => {
        const hit = text === "" || matches(model, text);
        label.hidden = !hit;
        return hit;
      });
      found += hits.length;
      box.hidden = hits.length === 0;
      if (text !== "") box.open = true;
      else if (!items.some((i) => i.input.checked)) box.open = open;
    }
    setText(none, found === 0 ? `No model speaks of “${text}”.` : "");
  }
  search.addEventListener("input", filter);
  search.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || search.value === "") return;
    search.value = "";
    filter();
  });

  const clear = h(
    "button",
    { type: "button", class: "quiet", onclick: () => onChange([]) },
    "clear",
  );
  clear.setAttribute("aria-label", "clear the choice of models");
  const element = h(
    "div",
    { class: "chooser" },
    h("div", { class: "heading" }, h("h2", {}, "Models"), clear),
    search,
    none,
    ...groups.map((g) => g.box),
  );
  let revealed = false;

  return {
    element,
    /** @param {readonly string[]} ids @param {ReadonlyMap<string, string>} reasons */
    update(ids, reasons) {
      clear.hidden = ids.length === 0;
      for (const { items, count, box } of groups) {
        let on = 0;
        for (const { model, input, label } of items) {
          input.checked = ids.includes(model.id);
          if (input.checked) on += 1;
          const reason = reasons.get(model.id) ?? "";
          if ((label.dataset.reason ?? "") === reason) continue;
          if (reason) label.dataset.reason = reason;
          else delete label.dataset.reason;
        }
        setText(count, on ? ` ${on} of ${items.length}` : ` ${items.length}`);
        if (!revealed && on > 0) box.open = true;
      }
      revealed = true;
    },
  };
}
