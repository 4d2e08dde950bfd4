/** The panel of the Compare view: media, indices, models and their parameters. */

import { createChoices } from "../controls/panel.js";
import { createParameters } from "../controls/parameters.js";
import { createTyped } from "../controls/typed.js";
import { createPanel } from "../controls/view-panel.js";
import { h } from "../page/dom.js";
import { createChooser } from "./chooser.js";
import { against, compareFields } from "./fields.js";

/** The ranges of d'Eon's conductor comparison; "more" goes beyond them. @type {Record<string, RowManner>} */
const MANNERS = {
  n_i: { label: "incident index", range: [1, 2], wide: [0.1, 10] },
  n_t: { label: "second index", range: [0.1, 5], wide: [0.1, 10] },
  k_t: { label: "extinction", range: [0, 5], wide: [0, 20] },
};

/** @param {ViewContext} context */
export function createControls({ catalog, presets, state, actions, describeMedia }) {
  const family = /** @type {Field} */ (compareFields(catalog).family);
  const { models } = catalog;
  const members = createTyped({
    attributes: {
      class: "box family",
      placeholder: "such as 1.33, 2.42",
      id: "compare-family",
    },
    id: "compare-family-error",
    parse(text) {
      const list = text
        .replace(/[\s;]+/g, ",")
        .replace(/,+/g, ",")
        .replace(/^,|,$/g, "");
      return list === "" ? Object.freeze([]) : family.parse(list);
    },
    onChange: (values) => actions.set({ family: values }),
  });
  const familyBox = h(
    "div.family-row",
    h("label", { for: "compare-family" }, "also at ", h("var.symbol", "n"), " ="),
    members.box,
    members.wrong,
  );
  const choices = createChoices(actions, {
    polarized: [
      "Polarization",
      { off: "R", on: ["R, s and p", "Rs and Rp where a model has them"] },
    ],
    angle: ["Angles", { deg: "degrees", rad: "radians" }],
  });
  const chooser = createChooser({
    models,
    chosen: () => against(state()),
    onChange: (ids) => actions.set({ models: Object.freeze(ids) }),
  });
  const parameters = createParameters({ models, state, actions, prefix: "compare-" });
  const panel = createPanel({
    catalog,
    presets,
    state,
    actions,
    prefix: "compare-",
    manners: MANNERS,
    describeMedia,
    choices: [
      familyBox,
      chooser.element,
      parameters.element,
      choices.elements.polarized,
      choices.elements.angle,
    ],
  });

  return {
    element: panel.element,
    stop() {
      panel.stop();
      parameters.stop();
    },
    /**
     * @param {State} now
     * @param {ReadonlyMap<string, string>} reasons why a model is outside its domain here
     * @param {ReadonlyMap<string, number>} solved what parameters left to the server came out as
     */
    update(now, reasons, solved) {
      panel.update(now);
      members.update(now.family.join(", "));
      parameters.update(now, against(now), solved);
      chooser.update(against(now), reasons, now.k_t);
      choices.update(now);
    },
  };
}
