/** The panel of the Albedo view: the figure, the media, what is drawn, the fits. */

import { createInterface } from "../controls/media.js";
import { createChoice, createSheet } from "../controls/panel.js";
import { h } from "../page/dom.js";
import { createChooser } from "./chooser.js";
import { chosenFits, isMetal } from "./fields.js";

/** @type {Record<string, {label: string, range: [number, number], wide: [number, number]}>} */
const MANNERS = {
  n_i: { label: "incident index", range: [1, 2], wide: [0.1, 10] },
  n_t: { label: "second index", range: [0.1, 4], wide: [0.01, 20] },
  k_t: { label: "extinction", range: [0, 8], wide: [0, 20] },
};
/** Where the figures of metals start when the interface at hand is none. */
const FIRST_K = 3;

/**
 * @param {object} options
 * @param {Catalog} options.catalog
 * @param {State} options.presets
 * @param {() => State} options.state
 * @param {Actions} options.actions
 * @param {() => Promise<void>} options.describeMedia
 */
export function createControls({ catalog, presets, state, actions, describeMedia }) {
  const { rows, media } = createInterface({
    catalog,
    presets,
    state,
    actions,
    prefix: "albedo-",
    manners: MANNERS,
    describeMedia,
  });

  const surface = createChoice({
    legend: "Albedo over",
    listed: true,
    items: [
      { value: "outside", label: "n, clear medium from outside" },
      { value: "inside", label: "n, clear medium from inside" },
      { value: "metal-n", label: "n, metal at one k" },
      { value: "metal-k", label: "k, metal at one n" },
    ],
    onChange([value]) {
      const first = isMetal(value ?? "") && state().k_t === 0;
      actions.set({
        surface: value,
        fits: null,
        sweep_low: null,
        sweep_high: null,
        ...(first && { k_t: FIRST_K, material: null }),
      });
    },
  });
  const lights = createChoice({
    legend: "Exact, besides unpolarized",
    several: true,
    items: [
      { value: "s", label: "s" },
      { value: "p", label: "p" },
      { value: "flatland", label: "flatland", note: "in two dimensions" },
    ],
    onChange: (values) => actions.set({ lights: Object.freeze(values) }),
  });
  const chooser = createChooser({
    chosen: () => chosenFits(state()),
    onChange: (ids) => actions.set({ fits: Object.freeze(ids) }),
  });

  const body = h(
    "div",
    { class: "panel-body" },
    h("div", { class: "heading" }, h("h2", {}, "Media")),
    media.element,
    h("div", { class: "rows" }, ...rows.map((r) => r.row.element)),
    h("div", { class: "choices" }, surface.element, lights.element, chooser.element),
  );
  const sheet = createSheet({ pages: rows, body, first: "n_t" });

  return {
    element: sheet.element,
    stop() {
      media.stop();
      for (const { row } of rows) row.stop();
    },
    /** @param {State} now @param {readonly import('./answers.js').Fit[]} fits */
    update(now, fits) {
      media.update(now);
      /** @type {Record<string, {value: number, label: string}[]>} */
      const marks = {
        n_i: [{ value: now.n_t, label: "equal to n_t" }],
        n_t: [{ value: now.n_i, label: "equal to n_i" }],
      };
      for (const { name, row } of rows) row.update(now[name], marks[name] ?? []);
      sheet.update();
      surface.update([now.surface]);
      lights.update([...now.lights]);
      if (fits.length) chooser.update(fits, chosenFits(now), now.surface);
    },
  };
}
