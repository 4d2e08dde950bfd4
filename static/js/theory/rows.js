/** The sliders of a lesson: what can be moved, between which ends. */

import {
  ANGLE_STEPS,
  angleWriting,
  createChoice,
  createRow,
  INDEX_STEPS,
} from "../controls/panel.js";
import { h } from "../page/dom.js";

/**
 * @typedef {import('./lesson.js').RowName} RowName
 * @typedef {import('./lesson.js').Setting} Setting
 */

/** Which declared parameter a row moves, where its value stands in a setting, and its name. */
const ROWS = /** @type {const} */ ({
  own_deg: { parameter: "theta_i_deg", value: "deg", label: "angle of incidence" },
  own_i: { parameter: "n_i", value: "n_i", label: "incident index" },
  own_n: { parameter: "n_t", value: "n_t", label: "second index" },
  own_k: { parameter: "k_t", value: "k_t", label: "extinction" },
});
const writing = angleWriting(() => "0° to 90°");

/**
 * A row whose value is the lesson's own until the reader moves it.
 * @param {string} name of the state's field
 * @param {Actions} actions
 * @param {Omit<RowOptions, 'onChange' | 'onSettle'>} options
 */
export function createOwnRow(name, actions, options) {
  return createRow({
    ...options,
    onChange: (value, moving) =>
      actions.set(
        { [name]: value === options.preset ? null : value },
        { history: moving ? "replace" : "push" },
      ),
    onSettle: actions.settle,
  });
}

/**
 * @param {object} options
 * @param {Partial<Record<RowName, [number, number]>>} options.rows
 * @param {Setting} options.presets the values that a double click goes back to
 * @param {boolean} [options.polarized]
 * @param {Catalog} options.catalog
 * @param {Actions} options.actions
 * @param {string} options.prefix of ids
 */
export function createRows({ rows, presets, polarized = false, catalog, actions, prefix }) {
  const made = Object.entries(rows).map(([name, range]) => {
    const { parameter, value, label } = ROWS[/** @type {RowName} */ (name)];
    const declared = catalog.parameters.find((p) => p.name === parameter);
    if (!declared) throw new Error(`the server declares no ${parameter}`);
    const preset = /** @type {number} */ (presets[value]);
    const row = createOwnRow(name, actions, {
      ...{ parameter: declared, prefix, preset, label, range },
      ...(value === "deg" ? { steps: ANGLE_STEPS, writing } : { steps: INDEX_STEPS }),
    });
    return { row, value };
  });
  const polarization = polarized
    ? createChoice({
        legend: "Polarization",
        items: ["s", "p", "unpolarized"].map((value) => ({ value, label: value })),
        onChange: ([value]) =>
          actions.set({ own_pol: value === presets.polarization ? null : value }),
      })
    : null;

  return {
    element: h(
      "div.rows.lesson-rows",
      ...made.map(({ row }) => row.element),
      polarization?.element,
    ),
    /** @param {Setting} setting @param {{deg: number, label: string}[]} landmarks */
    update(setting, landmarks) {
      for (const { row, value } of made) {
        const marks =
          value === "deg" ? landmarks.map((l) => ({ value: l.deg, label: l.label })) : [];
        row.update(/** @type {number} */ (setting[value]), marks);
      }
      polarization?.update([setting.polarization]);
    },
    stop() {
      for (const { row } of made) row.stop();
    },
  };
}
