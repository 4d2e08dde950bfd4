/** Which fits stand against the exact albedo: in groups by where they are at home. */

import { sample } from "../models/look.js";
import { h, setText } from "../page/dom.js";
import { familiesOf } from "./answers.js";
import { fitStyle } from "./style.js";

/**
 * @typedef {import('./answers.js').Fit} Fit
 * @typedef {import('./answers.js').Family} Family
 */

/** @type {{family: Family, legend: string}[]} */
const GROUPS = [
  { family: "outside", legend: "From outside" },
  { family: "inside", legend: "From inside" },
  { family: "metal", legend: "Metals" },
];

/**
 * @param {object} options
 * @param {() => readonly string[]} options.chosen
 * @param {(ids: string[]) => void} options.onChange
 */
export function createChooser({ chosen, onChange }) {
  const groups = h("div", { class: "fit-groups" });
  const clear = h(
    "button",
    { type: "button", class: "quiet", onclick: () => onChange([]) },
    "clear",
  );
  clear.setAttribute("aria-label", "Clear the fits");
  const element = h(
    "div",
    { class: "chooser" },
    h("div", { class: "heading" }, h("h2", {}, "Fits"), clear),
    groups,
  );
  /** @type {readonly Fit[] | null} */
  let known = null;
  /** @type {{box: HTMLDetailsElement, family: Family, count: HTMLElement, items: {id: string, input: HTMLInputElement}[]}[]} */
  let made = [];
  let opened = "";

  /** @param {readonly Fit[]} fits */
  function build(fits) {
    known = fits;
    made = GROUPS.map(({ family, legend }) => {
      const items = fits
        .filter((fit) => familiesOf(fit).includes(family))
        .map((fit) => {
          const input = h("input", {
            type: "checkbox",
            value: fit.id,
            onchange: () => {
              const others = chosen().filter((id) => id !== fit.id);
              onChange(input.checked ? [...others, fit.id] : others);
            },
          });
          const label = h(
            "label",
            { title: `${fit.note}\n${fit.reference}` },
            input,
            h("span", { class: "overlay-name" }, sample(fitStyle(fits, fit.id)), fit.title),
          );
          return { id: fit.id, input, label };
        });
      const count = h("span", { class: "count" });
      const box = h(
        "details",
        { class: "forms" },
        h("summary", {}, legend, count),
        h(
          "fieldset",
          { class: "choice several listed" },
          h("legend", {}, legend),
          h("div", { class: "options" }, ...items.map((i) => i.label)),
        ),
      );
      return { box, family, count, items };
    });
    groups.replaceChildren(...made.map((m) => m.box));
  }

  return {
    element,
    /** @param {readonly Fit[]} fits @param {readonly string[]} ids @param {string} surface */
    update(fits, ids, surface) {
      if (fits !== known) build(fits);
      const home = surface.startsWith("metal") ? "metal" : surface;
      clear.hidden = ids.length === 0;
      for (const { box, family, count, items } of made) {
        let on = 0;
        for (const { id, input } of items) {
          input.checked = ids.includes(id);
          if (input.checked) on += 1;
        }
        setText(count, on ? ` ${on} of ${items.length}` : ` ${items.length}`);
        if (opened !== surface) box.open = family === home;
      }
      opened = surface;
    },
  };
}
