/** What the panel of lookup tables asks the server for. */

import { parameterQuery } from "../models/parameters.js";
import { mediaQuery, path } from "../server/questions.js";

/**
 * @param {State} state
 * @param {Catalog} catalog
 * @param {string} model
 * @param {"/lut" | "/lut/errors"} route
 * @param {string[]} [more]
 */
export function lutPath(state, catalog, model, route, more = []) {
  return path(route, [
    model === "exact" ? "" : `model=${model}`,
    ...mediaQuery(state, catalog),
    ...parameterQuery(state, catalog.models, [model]),
    ...more,
  ]);
}

/**
 * The table in RGB of a material whose spectrum is known, for the exact curve.
 * @param {State} state
 * @param {Catalog} catalog
 * @param {string} model
 * @param {string[]} [more]
 */
export function rgbLutPath({ material, n_i }, { materials }, model, more = []) {
  const known = materials.find((m) => m.id === material)?.n_range_nm;
  return model === "exact" && known
    ? path("/lut", [`material=${material}`, `n_i=${n_i}`, "channels=3", ...more])
    : null;
}
