/** What the curves are: formula, source and validity of each model shown, typeset on demand. */

import { h } from "../page/dom.js";

/**
 * @param {Model[]} models
 * @param {(latex: string, element: HTMLElement) => Promise<void>} typeset
 * @param {() => Promise<void>} [describe] completes the models
 * @param {HTMLDetailsElement} [element] the fold that they stand in
 */
export function createDefinitions(
  models,
  typeset,
  describe,
  element = h("details.definitions", h("summary", "Formulas and sources of these curves")),
) {
  const list = h("div.definition-list");
  element.append(list);
  /** @type {string[]} */
  let wanted = [];
  let shown = "";

  async function fill() {
    if (!element.open || shown === wanted.join()) return;
    shown = wanted.join();
    await describe?.();
    await fillDefinitions(
      list,
      models.filter((m) => wanted.includes(m.id)),
      typeset,
    );
  }

  element.addEventListener("toggle", fill);
  return {
    element,
    /** @param {readonly string[]} ids */
    update(ids) {
      wanted = ["exact", ...ids];
      void fill();
    },
  };
}

/**
 * @param {HTMLElement} list
 * @param {Model[]} models
 * @param {(latex: string, element: HTMLElement) => Promise<void>} typeset
 */
async function fillDefinitions(list, models, typeset) {
  const entries = models.map((model) => {
    const formula = h("div.formula", {
      tabindex: "0",
      role: "group",
      "aria-label": `Formula of ${model.title}`,
    });
    return {
      model,
      formula,
      block: h(
        "section",
        h("h3", model.title),
        formula,
        h("p", model.validity),
        h("p.source", model.reference),
      ),
    };
  });
  list.replaceChildren(...entries.map((e) => e.block));
  for (const { model, formula } of entries) await typeset(model.latex, formula);
}
