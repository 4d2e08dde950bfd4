/** Formula, source and validity of models. */

import { h } from "../page/dom.js";

/**
 * @param {HTMLElement} list
 * @param {Model[]} models
 * @param {(latex: string, element: HTMLElement) => Promise<void>} typeset
 */
export async function fillDefinitions(list, models, typeset) {
  const entries = models.map((model) => {
    const formula = h("div", {
      class: "formula",
      tabindex: "0",
      role: "group",
      "aria-label": `Formula of ${model.title}`,
    });
    return {
      model,
      formula,
      block: h(
        "section",
        {},
        h("h3", {}, model.title),
        formula,
        h("p", {}, model.validity),
        h("p", { class: "source" }, model.reference),
      ),
    };
  });
  list.replaceChildren(...entries.map((e) => e.block));
  for (const { model, formula } of entries) await typeset(model.latex, formula);
}
