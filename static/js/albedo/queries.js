/** What the Albedo view asks the server for. */

import { coatPath } from "../coat/fields.js";
import { mediaQuery, path } from "../state/state.js";
import { chosenFits, held, mapFit, mapRange, surfaceOf, sweepRange } from "./fields.js";

/** Steps of a hundredth at least over each of the ranges. */
const STEPS = 401;
/** What a cell's color needs, and no more. */
const MAP_DIGITS = 6;

/** @param {State} state @param {Catalog} catalog */
function sweepPath(state, catalog) {
  const [low, high] = sweepRange(state);
  const fits = chosenFits(state);
  return path("/albedo/sweep", [
    `over=${surfaceOf(state).over}`,
    `minimum=${low}`,
    `maximum=${high}`,
    `steps=${STEPS}`,
    fits.length > 0 && `fits=${fits.join(",")}`,
    state.lights.includes("flatland") && "flatland=true",
    ...mediaQuery(state, catalog, held(state)),
  ]);
}

/** @param {State} state @param {Catalog} catalog */
function mapPath(state, catalog) {
  const { n, k } = mapRange(state);
  return path("/albedo/map", [
    state.map_show !== "exact" && `fit=${mapFit(state)}`,
    state.map_show === "value" && "show=value",
    `n_minimum=${n[0]}&n_maximum=${n[1]}&n_steps=118`,
    `k_minimum=${k[0]}&k_maximum=${k[1]}&k_steps=121`,
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
    here: path("/albedo", mediaQuery(state, catalog)),
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
