/** The panel of the Compare view: media, indices, models and their parameters. */

import { createInterface } from "../controls/media.js";
import { createChoice, createSheet } from "../controls/panel.js";
import { createParameters } from "../controls/parameters.js";
import { h, setText } from "../page/dom.js";
import { createChooser } from "./chooser.js";

/**
 * @typedef {import('../controls/media.js').Manner} Manner
 */

/** The ranges of d'Eon's conductor comparison; "more" goes beyond them. @type {Record<string, Manner>} */
const MANNERS = {
  n_i: { label: "incident index", range: [1, 2], wide: [0.1, 10] },
  n_t: { label: "second index", range: [0.1, 5], wide: [0.1, 10] },
  k_t: { label: "extinction", range: [0, 5], wide: [0, 20] },
};

/**
 * @param {object} options
 * @param {Catalog} options.catalog
 * @param {State} options.presets
 * @param {() => State} options.state
 * @param {Actions} options.actions
 * @param {Field} options.family
 * @param {() => Promise<void>} options.describeMedia
 */
export function createControls({ catalog, presets, state, actions, family, describeMedia }) {
  const { rows, media } = createInterface({
    catalog,
    presets,
    state,
    actions,
    prefix: "compare-",
    manners: MANNERS,
    describeMedia,
  });

  const members = h("input", {
    class: "box family",
    type: "text",
    autocomplete: "off",
    spellcheck: "false",
    placeholder: "such as 1.33, 2.42",
    id: "compare-family",
    "aria-describedby": "compare-family-error",
  });
  const wrong = h("p", { class: "row-error", id: "compare-family-error", role: "alert" });
  members.addEventListener("change", () => {
    try {
      const text = members.value
        .replace(/[\s;]+/g, ",")
        .replace(/,+/g, ",")
        .replace(/^,|,$/g, "");
      const values = text === "" ? Object.freeze([]) : family.parse(text);
      setText(wrong, "");
      members.removeAttribute("aria-invalid");
      actions.set({ family: values });
    } catch (problem) {
      setText(wrong, `“${members.value}”: ${problem instanceof Error ? problem.message : problem}`);
      members.setAttribute("aria-invalid", "true");
    }
  });
  const familyBox = h(
    "div",
    { class: "family-row" },
    h("label", { for: "compare-family" }, "also at ", h("var", { class: "symbol" }, "n"), " ="),
    members,
    wrong,
  );

  const angles = createChoice({
    legend: "Angles",
    items: [
      { value: "deg", label: "degrees" },
      { value: "rad", label: "radians" },
    ],
    onChange: ([value]) => actions.set({ angle: value }),
  });

  const chooser = createChooser({
    models: catalog.models,
    chosen: () => state().against,
    onChange: (ids) => actions.set({ against: Object.freeze(ids) }),
  });
  const parameters = createParameters({
    models: catalog.models,
    state,
    actions,
    prefix: "compare-",
  });

  const body = h(
    "div",
    { class: "panel-body" },
    h("div", { class: "heading" }, h("h2", {}, "Media")),
    media.element,
    h("div", { class: "rows" }, ...rows.map((r) => r.row.element)),
    h("div", { class: "choices" }, familyBox, chooser.element, parameters.element, angles.element),
  );
  const sheet = createSheet({ pages: rows, body, first: "n_t" });

  return {
    element: sheet.element,
    stop() {
      media.stop();
      for (const { row } of rows) row.stop();
      parameters.stop();
    },
    /**
     * @param {State} now
     * @param {ReadonlyMap<string, string>} reasons why a model is outside its domain here
     * @param {ReadonlyMap<string, number>} solved what parameters left to the server came out as
     */
    update(now, reasons, solved) {
      media.update(now);
      /** @type {Record<string, {value: number, label: string}[]>} */
      const marks = {
        n_i: [{ value: now.n_t, label: "equal to n_t" }],
        n_t: [{ value: now.n_i, label: "equal to n_i" }],
      };
      for (const { name, row } of rows) row.update(now[name], marks[name] ?? []);
      sheet.update();
      if (document.activeElement !== members) members.value = now.family.join(", ");
      parameters.update(now, now.against, solved);
      chooser.update(now.against, reasons);
      angles.update([now.angle]);
    },
  };
}
