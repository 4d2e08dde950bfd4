/** What the Albedo view asks the server for. */

import { coatPath } from "../coat/fields.js";
import { mediaQuery, path } from "../server/questions.js";
import { chosenFits, isMetal, mapFit, mapRange, sweepRange } from "./fields.js";

/** Steps of a hundredth at least over each of the ranges. */
const STEPS = { dielectric: 401, metal: 401 };
const MAP_CELLS = { n: 118, k: 121 };
/** A cell's colour needs no more. */
const MAP_DIGITS = 6;

/** The indices that stay as they are in a sweep. @param {State} state @returns {string[]} */
export function held({ surface }) {
  return isMetal(surface) ? ["n_i", surface === "metal-n" ? "k_t" : "n_t"] : [];
}

/** @param {State} state @param {Catalog} catalog */
export function sweepPath(state, catalog) {
  const metal = isMetal(state.surface);
  const over = { "metal-n": "n_t", "metal-k": "k_t" }[/** @type {string} */ (state.surface)];
  const [low, high] = sweepRange(state);
  const fits = chosenFits(state);
  return path("/albedo/sweep", [
    `over=${over ?? "eta"}`,
    `minimum=${low}`,
    `maximum=${high}`,
    `steps=${metal ? STEPS.metal : STEPS.dielectric}`,
    fits.length > 0 && `fits=${fits.join(",")}`,
    state.lights.includes("flatland") && "flatland=true",
    ...mediaQuery(state, catalog, held(state)),
  ]);
}

/** @param {State} state @param {Catalog} catalog */
export function herePath(state, catalog) {
  return path("/albedo", mediaQuery(state, catalog, ["n_i", "n_t", "k_t"]));
}

/** @param {State} state @param {Catalog} catalog */
export function mapPath(state, catalog) {
  const { n, k } = mapRange(state);
  return path("/albedo/map", [
    state.map_show !== "exact" && `fit=${mapFit(state)}`,
    state.map_show === "value" && "show=value",
    `n_minimum=${n[0]}`,
    `n_maximum=${n[1]}`,
    `n_steps=${MAP_CELLS.n}`,
    `k_minimum=${k[0]}`,
    `k_maximum=${k[1]}`,
    `k_steps=${MAP_CELLS.k}`,
    `digits=${MAP_DIGITS}`,
    ...mediaQuery(state, catalog, ["n_i"]),
  ]);
}

/**
 * Paths by name, in the order of their importance. The map does not follow a gesture: it is asked
 * for when things stand still.
 * @param {State} state
 * @param {Catalog} catalog
 * @param {boolean} [moving]
 * @returns {Record<string, string>}
 */
export function queries(state, catalog, moving = false) {
  return {
    sweep: sweepPath(state, catalog),
    here: herePath(state, catalog),
    coat: coatPath(state),
    fits: "/albedo/fits",
    ...(!moving && { map: mapPath(state, catalog) }),
  };
}

/** @param {State} state @param {Catalog} catalog @returns {string[]} */
export function restCalls(state, catalog) {
  const { sweep, here, map, coat } = queries(state, catalog);
  return [sweep, here, map, coat].filter((p) => p !== undefined);
}
