/** Which of the models at hand is taken away: its code and its table are of the same one. */

import { h } from "../page/dom.js";
import { codeOf } from "./fields.js";

/**
 * @param {object} options
 * @param {Model[]} options.models
 * @param {string} options.label
 * @param {Pick<Actions, 'set'>} options.actions
 */
export function createModelChoice({ models, label, actions }) {
  const titles = new Map(models.map((m) => [m.id, m.title]));
  const select = h("select", {
    class: "preset",
    "aria-label": label,
    onchange: () => actions.set({ code: select.value }),
  });
  return {
    element: select,
    /** @param {State} now @param {readonly string[]} offered ids of the models to choose among */
    update(now, offered) {
      const ids = offered.join();
      if (select.dataset.ids !== ids) {
        select.dataset.ids = ids;
        select.replaceChildren(
          ...offered.map((id) => h("option", { value: id }, titles.get(id) ?? id)),
        );
      }
      select.value = codeOf(now, offered);
    },
  };
}
