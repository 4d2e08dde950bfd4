/**
 * Figures of the sources, one click each, as data. What a source claims of them and what is measured
 * is told by the server's claims, each of which names its example.
 */

/**
 * @typedef {object} Example
 * @property {string} id
 * @property {string} title
 * @property {string} source
 * @property {Record<string, any>} state what differs from the view's defaults
 */

/** @type {Example[]} */
export const EXAMPLES = [
  {
    id: "shirley-glass",
    title: "Glass, exact and Schlick",
    source: "Shirley",
    state: { n_t: 1.5, models: ["schlick"] },
  },
  {
    id: "lagarde-conductor-k0",
    title: "Conductor formula at k = 0",
    source: "Lagarde",
    state: { n_t: 1.5, models: ["pharr_humphreys"], over: "k" },
  },
  {
    id: "lagarde-conductor-k",
    title: "Conductor formula at k > 0",
    source: "Lagarde",
    state: { n_t: 1.5, k_t: 3, models: ["pharr_humphreys"], over: "k" },
  },
  {
    id: "lagarde-lazanyi",
    title: "A dip for metals, α = 7.7",
    source: "Lagarde after Lazányi",
    state: {
      n_t: 1.5,
      k_t: 5,
      models: ["schlick", "lazanyi2005"],
      "lazanyi2005.alpha": 7.7,
      over: "k",
    },
  },
  {
    id: "lagarde-error-term",
    title: "What a metal's dip takes away",
    source: "Lagarde after Lazányi",
    state: {
      n_t: 1.5,
      k_t: 5,
      models: ["schlick", "lazanyi2005"],
      "lazanyi2005.a": 3,
      "lazanyi2005.alpha": 7,
      error: "taken",
      over: "k",
    },
  },
  {
    id: "lagarde-sp-dielectric",
    title: "s and p, a dielectric",
    source: "Lagarde",
    state: { n_t: 1.5, models: [], polarized: "on" },
  },
  {
    id: "lagarde-sp-metal",
    title: "s and p, a metal",
    source: "Lagarde",
    state: { n_t: 1.5, k_t: 5, models: [], polarized: "on", over: "k" },
  },
  {
    id: "lagarde-water-air",
    title: "Water to air",
    source: "Lagarde",
    state: { n_i: 1.33, n_t: 1, models: ["schlick", "schlick_tir"] },
  },
  {
    id: "lagarde-range",
    title: "Schlick over n",
    source: "Lagarde",
    state: {
      n_t: 1.4,
      family: [2.2],
      models: ["schlick"],
      error: "relative",
      over: "n",
      metric: "max_relative",
      n_low: 1.2,
      n_high: 3.2,
    },
  },
  {
    id: "wloka-family",
    title: "A family of curves over n",
    source: "Wloka",
    state: { n_t: 1.52, family: [1.31, 2.417, 3.5], models: [] },
  },
  {
    id: "wloka-water-diamond",
    title: "Water and diamond, 1 − cos",
    source: "Wloka",
    state: { n_t: 1.333333, family: [2.417], models: ["schlick", "one_minus_cos"] },
  },
  {
    id: "deon-conductor",
    title: "Conductor comparison",
    source: "d'Eon",
    state: {
      n_t: 1.5,
      k_t: 2,
      models: ["schlick", "pharr_humphreys", "complex_dielectric"],
      over: "k",
    },
  },
];

/** What an example sets back to its default unless it says otherwise. */
const OWN = [
  "incident",
  "material",
  "n_i",
  "n_t",
  "k_t",
  "models",
  "error",
  "polarized",
  "family",
  "over",
  "metric",
  "focus",
  "n_low",
  "n_high",
  "k_low",
  "k_high",
];

/**
 * @param {Example} example
 * @param {Record<string, any>} presets the state's defaults
 * @returns {Record<string, any>} the whole of the state that the example stands for
 */
export function stateOf(example, presets) {
  const names = new Set([...OWN, ...Object.keys(presets).filter((key) => key.includes("."))]);
  return {
    ...Object.fromEntries([...names].map((key) => [key, presets[key] ?? null])),
    ...example.state,
    example: example.id,
  };
}

/** Whether the page still shows the example. @param {Record<string, any>} wanted @param {Record<string, any>} state */
export function shows(wanted, state) {
  // Which figure stands beside the curves is the reader's to choose.
  const free = new Set(["over", "metric", "focus", "error"]);
  return Object.entries(wanted).every(
    ([key, value]) => free.has(key) || String(value ?? "") === String(state[key] ?? ""),
  );
}
