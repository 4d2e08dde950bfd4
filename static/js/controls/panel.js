/** One of few (radio buttons) or any of some (check boxes), drawn as a row of words. */

import { h, setText, symbol } from "../page/dom.js";

let groups = 0;

/**
 * @param {object} options
 * @param {string} options.legend
 * @param {{value: string, label: string, note?: string, content?: Node}[]} options.items
 * @param {boolean} [options.several]
 * @param {boolean} [options.listed] one below the other
 * @param {(values: string[]) => void} options.onChange
 */
export function createChoice({ legend, items, several = false, listed = false, onChange }) {
  groups += 1;
  const name = `choice-${groups}`;
  const inputs = items.map((item) =>
    h("input", {
      type: several ? "checkbox" : "radio",
      name,
      value: item.value,
      onchange: () => onChange(inputs.filter((i) => i.checked).map((i) => i.value)),
    }),
  );
  const labels = items.map((item, i) =>
    h("label", { title: item.note }, inputs[i], h("span", {}, item.content ?? item.label)),
  );
  const element = h(
    "fieldset",
    { class: ["choice", several && "several", listed && "listed"].filter(Boolean).join(" ") },
    h("legend", {}, legend),
    h("div", { class: "options" }, ...labels),
  );
  return {
    element,
    /** @param {readonly string[]} values @param {ReadonlyMap<string, string>} [reasons] why an item does not apply here */
    update(values, reasons) {
      inputs.forEach((input, i) => {
        input.checked = values.includes(input.value);
        const reason = reasons?.get(input.value);
        const label = /** @type {HTMLElement} */ (labels[i]);
        if ((label.dataset.reason ?? "") !== (reason ?? "")) {
          if (reason) label.dataset.reason = reason;
          else delete label.dataset.reason;
        }
      });
    },
  };
}

/**
 * Choices that stand for fields of the state: one of few words each.
 * @template {string} Name
 * @param {Pick<Actions, 'set'>} actions
 * @param {Record<Name, readonly [legend: string, words: Record<string, string | readonly [label: string, note: string]>]>} fields
 *   by the field's name the choice's own, and the word, or the word and what it means, for each value
 */
export function createChoices(actions, fields) {
  const names = /** @type {Name[]} */ (Object.keys(fields));
  const made = names.map((name) => {
    const [legend, words] = fields[name];
    const items = Object.entries(words).map(([value, word]) =>
      typeof word === "string" ? { value, label: word } : { value, label: word[0], note: word[1] },
    );
    const choice = createChoice({
      legend,
      items,
      onChange: ([value]) => actions.set({ [name]: value }),
    });
    return { name, choice };
  });
  return {
    elements: /** @type {Record<Name, HTMLElement>} */ (
      /** @type {unknown} */ (
        Object.fromEntries(made.map(({ name, choice }) => [name, choice.element]))
      )
    ),
    /** @param {State} state */
    update(state) {
      for (const { name, choice } of made) choice.update([state[name]]);
    },
  };
}

/**
 * @typedef {{name: string, symbol: string, row: {element: HTMLElement}, print: () => string}} Page
 * @param {object} options
 * @param {Page[]} options.pages
 * @param {HTMLElement} options.body
 * @param {string} options.first the page shown first
 */
export function createSheet({ pages, body, first }) {
  const strip = h("div", { class: "strip", role: "group", "aria-label": "Which value to move" });
  const entries = pages.map((page) => {
    const value = h("b", {});
    const button = h(
      "button",
      { type: "button", "aria-pressed": "false", onclick: () => choose(page.name) },
      symbol(page.symbol),
      value,
    );
    strip.append(button);
    return { page, button, value };
  });
  const opener = h("button", { type: "button", class: "opener", "aria-expanded": "false" }, "all");
  strip.append(opener);
  const element = h(
    "section",
    { class: "panel", "aria-label": "Controls", "data-sheet": "closed" },
    strip,
    body,
  );
  opener.addEventListener("click", () => {
    const open = element.dataset.sheet !== "open";
    element.dataset.sheet = open ? "open" : "closed";
    opener.setAttribute("aria-expanded", String(open));
    opener.textContent = open ? "close" : "all";
  });

  /** @param {string} name */
  function choose(name) {
    for (const { page, button } of entries) {
      const on = page.name === name;
      button.setAttribute("aria-pressed", String(on));
      page.row.element.toggleAttribute("data-chosen", on);
    }
  }
  choose(first);

  return {
    element,
    update() {
      for (const { page, value } of entries) setText(value, page.print());
    },
  };
}
