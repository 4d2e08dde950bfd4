/** The state that the Atlas view adds to the one all views share, and what it asks for. */

import { choice, number, path } from "../state/state.js";
import { text } from "../state/text.js";

/** What an error is measured by, over all angles and wavelengths. @type {Record<string, string>} */
export const METRICS = {
  max_abs: "largest error",
  rms: "RMS error",
  albedo_error: "error of the albedo",
  delta_e: "color difference ΔE, from RGB",
};

/** What errors count as small, unless another is typed. @type {Record<string, number>} */
const WITHIN = { max_abs: 0.01, rms: 0.01, albedo_error: 0.01, delta_e: 1 };

/** @type {Record<string, string>} */
export const KINDS = { clear: "clear", absorbing: "absorbing", metal: "metal" };

/** What materials stand at along the figure: its title, and the least and largest that is drawn. */
export const ABSCISSAS = {
  F0: { word: "F₀", title: "reflectance along the normal F_0", range: [0.01, 1] },
  n: { word: "n", title: "index n", range: [0.05, 10] },
  k: { word: "k", title: "extinction k", range: [1e-3, 10] },
};

const LONGEST_SEARCH = 100;
const LONGEST_ID = 1000;
/** What an error may be allowed. */
export const BOUNDS = { minimum: 1e-12, maximum: 100 };
/** Four digits of errors are kept; n and k are shown with fewer. */
const DIGITS = 5;

/** @param {Catalog} catalog @returns {Record<string, Field>} */
export function atlasFields({ models }) {
  return {
    atlas_model: choice(
      "schlick",
      models.map((m) => m.id),
    ),
    atlas_metric: choice("max_abs", Object.keys(METRICS)),
    atlas_within: number({ default: null, ...BOUNDS }),
    atlas_kind: choice("all", ["all", ...Object.keys(KINDS)]),
    atlas_band: choice("visible", ["visible", "elsewhere"]),
    atlas_shelf: text((id) => id.length <= LONGEST_SEARCH, "it is no shelf", ""),
    atlas_find: text((given) => given.length <= LONGEST_SEARCH, "it is too long", ""),
    atlas_x: choice("F0", Object.keys(ABSCISSAS)),
    atlas_at: text((id) => id.length <= LONGEST_ID, "it is no material", null),
  };
}

/** What size of the error counts as small. @param {State} state @returns {number} */
export const within = ({ atlas_within, atlas_metric }) => atlas_within ?? WITHIN[atlas_metric] ?? 1;

/** Whether a model makes a color of three numbers. @param {Catalog} catalog @param {string} id */
export function hasColor({ models }, id) {
  return id === "exact" || models.find((m) => m.id === id)?.takes_color === true;
}

/** @param {State} state */
function asked(state) {
  const find = state.atlas_find.trim();
  return [
    `model=${state.atlas_model}`,
    state.atlas_metric !== "max_abs" && `metric=${state.atlas_metric}`,
    state.atlas_within !== null && `within=${state.atlas_within}`,
    state.atlas_kind !== "all" && `kind=${state.atlas_kind}`,
    state.atlas_band !== "visible" && `band=${state.atlas_band}`,
    state.atlas_shelf !== "" && `shelf=${encodeURIComponent(state.atlas_shelf)}`,
    find !== "" && `q=${encodeURIComponent(find)}`,
  ];
}

/** Where the materials of the figure are as CSV. @param {State} state */
export const csvPath = (state) => path("/atlas", [...asked(state), "format=csv"]);

/** @param {State} state @returns {Record<string, string>} */
export function queries(state) {
  /** @type {Record<string, string>} */
  const wanted = { atlas: path("/atlas", [...asked(state), `digits=${DIGITS}`]) };
  if (state.atlas_at !== null) {
    const material = encodeURIComponent(state.atlas_at);
    wanted.material = path("/atlas/material", [`material=${material}`, `digits=${DIGITS}`]);
  }
  return wanted;
}

/** @param {State} state @returns {string[]} */
export const restCalls = (state) => Object.values(queries(state));
