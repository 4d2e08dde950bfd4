/** One of few (radio buttons) or any of some (check boxes), drawn as a row of words. */

import { h } from "../page/dom.js";

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
    /** @param {string[]} values @param {Map<string, string>} [reasons] why an item does not apply here */
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
