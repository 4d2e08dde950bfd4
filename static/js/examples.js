/**
 * Figures and claims of the sources, one click each, as data. What a source claimed is told in our
 * words; what is measured is fetched from the server when the example is shown.
 */

/**
 * A measured figure inside a sentence.
 * @typedef {object} Figure
 * @property {'errors' | 'sweep' | 'split' | 'solved'} of `errors` is the table's, `sweep` the largest along
 *   the curve that the figure beside it shows, `split` the largest |Rs - R| of the curves, `solved` the
 *   model's own parameter that the server works out here
 * @property {string} [model]
 * @property {string} [metric]
 * @property {number} [n] of another member of the family
 * @property {[number, number]} [within] stretch of the sweep, both ends included
 *
 * @typedef {string | Figure} Piece
 *
 * @typedef {object} Example
 * @property {string} id
 * @property {string} title
 * @property {string} source
 * @property {string} claim
 * @property {Piece[]} measured
 * @property {Record<string, any>} state what differs from the view's defaults
 */

/** @param {string} model @param {string} metric @param {number} [n] @returns {Figure} */
const error = (model, metric, n) => ({ of: "errors", model, metric, ...(n && { n }) });

/** @param {string} model @param {string} metric @param {[number, number]} within @returns {Figure} */
const along = (model, metric, within) => ({ of: "sweep", model, metric, within });

/** @type {Example[]} */
export const EXAMPLES = [
  {
    id: "shirley-glass",
    title: "Glass, exact and Schlick",
    source: "Shirley",
    claim: "For n = 1.5 Schlick's polynomial lies close to Fresnel's equations and costs far less.",
    measured: [
      "It is ",
      error("schlick", "max_abs"),
      " off at most, at ",
      error("schlick", "max_abs_at_deg"),
      "; ",
      error("schlick", "rms"),
      " in the mean square; relative to R up to ",
      error("schlick", "max_relative"),
      ".",
    ],
    state: { n_t: 1.5, against: ["schlick"] },
  },
  {
    id: "lagarde-conductor-k0",
    title: "Conductor formula at k = 0",
    source: "Lagarde",
    claim: "Without absorption the air-conductor approximation is not good.",
    measured: [
      "At n = 1.5 it is ",
      error("pharr_humphreys", "max_abs"),
      " off at ",
      error("pharr_humphreys", "max_abs_at_deg"),
      ", ",
      error("pharr_humphreys", "max_relative"),
      " of R.",
    ],
    state: { n_t: 1.5, against: ["pharr_humphreys"], over: "k" },
  },
  {
    id: "lagarde-conductor-k",
    title: "Conductor formula at k > 0",
    source: "Lagarde",
    claim: "With absorption the same approximation is great.",
    measured: [
      "At n = 1.5, k = 3 it is ",
      error("pharr_humphreys", "max_abs"),
      " off at most; for k from 2 to 5 never more than ",
      along("pharr_humphreys", "max_abs", [2, 5]),
      ", but still ",
      along("pharr_humphreys", "max_abs", [0.5, 0.5]),
      " at k = 0.5.",
    ],
    state: { n_t: 1.5, k_t: 3, against: ["pharr_humphreys"], over: "k" },
  },
  {
    id: "lagarde-lazanyi",
    title: "A dip for metals, α = 7.7",
    source: "Lagarde after Lazányi",
    claim:
      "For n = 1.5, k = 5 the compensated polynomial with α = 7.7 follows the dip that Schlick misses.",
    measured: [
      "Schlick is ",
      error("schlick", "max_abs"),
      " off at ",
      error("schlick", "max_abs_at_deg"),
      "; with the compensation ",
      error("lazanyi2005", "max_abs"),
      " remain at ",
      error("lazanyi2005", "max_abs_at_deg"),
      ", and the RMS goes from ",
      error("schlick", "rms"),
      " to ",
      error("lazanyi2005", "rms"),
      ". Solved here, α is ",
      { of: "solved", model: "lazanyi2005", metric: "alpha" },
      ".",
    ],
    state: {
      n_t: 1.5,
      k_t: 5,
      against: ["schlick", "lazanyi2005"],
      "lazanyi2005.alpha": 7.7,
      over: "k",
    },
  },
  {
    id: "lagarde-water-air",
    title: "Water to air",
    source: "Lagarde",
    claim:
      "From inside water Schlick knows no total internal reflection; with the transmitted angle the curve is right again.",
    measured: [
      "Schlick is ",
      error("schlick", "max_abs"),
      " off at ",
      error("schlick", "max_abs_at_deg"),
      "; with the transmitted angle ",
      error("schlick_tir", "max_abs"),
      " at most.",
    ],
    state: { n_i: 1.33, n_t: 1, against: ["schlick", "schlick_tir"] },
  },
  {
    id: "lagarde-range",
    title: "Schlick over n",
    source: "Lagarde",
    claim:
      "Seen from air Schlick is accurate for 1.4 < n < 2.2 alone; outside the relative error grows, though water at 1.33 is still fine.",
    measured: [
      "Relative to R it is off by up to ",
      along("schlick", "max_relative", [1.4, 2.2]),
      " inside that range, by ",
      along("schlick", "max_relative", [1.33, 1.33]),
      " for water, ",
      along("schlick", "max_relative", [1.2, 1.2]),
      " at n = 1.2 and ",
      along("schlick", "max_relative", [3, 3]),
      " at n = 3.",
    ],
    state: {
      n_t: 1.4,
      family: [2.2],
      against: ["schlick"],
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
    claim:
      "Ice, crown glass, diamond, gallium phosphide: the denser, the more it reflects, up to about 80 degrees, where the curves cross.",
    measured: [
      "At normal incidence R is ",
      { of: "errors", metric: "F0", n: 1.31 },
      ", ",
      { of: "errors", metric: "F0" },
      ", ",
      { of: "errors", metric: "F0", n: 2.417 },
      " and ",
      { of: "errors", metric: "F0", n: 3.5 },
      ".",
    ],
    state: { n_t: 1.52, family: [1.31, 2.417, 3.5], against: [] },
  },
  {
    id: "wloka-water-diamond",
    title: "Water and diamond, 1 − cos",
    source: "Wloka",
    claim:
      "Schlick costs less accuracy than leaving out polarization does; 1 − cos θ is visually unacceptable.",
    measured: [
      "For water and diamond Schlick is ",
      error("schlick", "max_abs"),
      " and ",
      error("schlick", "max_abs", 2.417),
      " off, 1 − cos θ ",
      error("one_minus_cos", "max_abs"),
      " and ",
      error("one_minus_cos", "max_abs", 2.417),
      ". Leaving out polarization costs up to ",
      { of: "split" },
      " for water.",
    ],
    state: { n_t: 1.333333, family: [2.417], against: ["schlick", "one_minus_cos"] },
  },
  {
    id: "deon-conductor",
    title: "Conductor comparison",
    source: "d'Eon",
    claim:
      "Schlick and Pharr's form approximate a metal, the latter better with larger k; a complex index put into the dielectric formula is a misunderstanding.",
    measured: [
      "At n = 1.5, k = 2 Schlick is ",
      error("schlick", "max_abs"),
      " off, Pharr's form ",
      error("pharr_humphreys", "max_abs"),
      ", the complex dielectric ",
      error("complex_dielectric", "max_abs"),
      ". Pharr's form is ",
      along("pharr_humphreys", "max_abs", [0.5, 0.5]),
      " off at k = 0.5, ",
      along("pharr_humphreys", "max_abs", [2, 2]),
      " at 2 and ",
      along("pharr_humphreys", "max_abs", [5, 5]),
      " at 5.",
    ],
    state: {
      n_t: 1.5,
      k_t: 2,
      against: ["schlick", "pharr_humphreys", "complex_dielectric"],
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
  "against",
  "error",
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
