/** The panel of the Albedo view: the figure, the media, what is drawn, the fits. */

import { createChoice } from "../controls/panel.js";
import { createPanel } from "../controls/view-panel.js";
import { createChooser } from "./chooser.js";
import { chosenFits, SURFACES, turned } from "./fields.js";

/** @type {Record<string, RowManner>} */
const MANNERS = {
  n_i: { label: "incident index", range: [1, 2], wide: [0.1, 10] },
  n_t: { label: "second index", range: [0.1, 4], wide: [0.01, 20] },
  k_t: { label: "extinction", range: [0, 8], wide: [0, 20] },
};

/** @param {ViewContext} context */
export function createControls({ catalog, presets, state, actions, describeMedia }) {
  const surface = createChoice({
    legend: "Albedo over",
    listed: true,
    items: Object.entries(SURFACES).map(([value, { label }]) => ({ value, label })),
    onChange: ([value = "outside"]) => actions.set({ ...turned(state(), value), fits: null }),
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

  const panel = createPanel({
    catalog,
    presets,
    state,
    actions,
    prefix: "albedo-",
    manners: MANNERS,
    describeMedia,
    choices: [surface.element, lights.element, chooser.element],
  });

  return {
    element: panel.element,
    stop: panel.stop,
    /** @param {State} now @param {readonly import('./answers.js').Fit[]} fits */
    update(now, fits) {
      panel.update(now);
      surface.update([now.surface]);
      lights.update(now.lights);
      if (fits.length) chooser.update(fits, chosenFits(now), now.surface);
    },
  };
}
