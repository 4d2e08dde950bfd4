/** What the Compare view asks the server for. */

import { bandPaths } from "../media/media.js";
import { mediaQuery, parameterQuery, path } from "../state/state.js";
import { codeOf, lutPath, snippetPath } from "../takeaway/fields.js";
import { convertPath } from "./conversions.js";
import { against, figureOf, focused, ranges, withCode } from "./fields.js";
import { colorPath } from "./metal-color.js";

/** Without films, which other views may have put on the surface. @param {State} state @returns {State} */
export const bare = (state) => ({ ...state, layers: "" });

/** Enough for a smooth line, and steps of 0.01 over two units of n. */
const SWEEP_STEPS = 201;
/** Cells of a map along what stands on its axes; a degree is two cells. @type {Record<string, number>} */
const MAP_CELLS = { theta_i_deg: 181, n_t: 121, k_t: 101 };
/** A cell's color needs no more. */
const MAP_DIGITS = 4;

/** @param {string} route @param {State} state @param {Catalog} catalog @param {string} models @param {string} end of the query */
const ofModels = (route, state, catalog, models, end) =>
  path(route, [
    ...mediaQuery(state, catalog),
    models,
    ...parameterQuery(state, catalog.models, against(state)),
    end,
  ]);

/** @param {State} state @param {Catalog} catalog @param {number} [n_t] of another member of the family */
function curvesPath(state, catalog, n_t = state.n_t) {
  const ids = against(state);
  const models = ids.length ? `models=exact,${ids.join(",")}` : "";
  const end = state.polarized === "on" ? "landmarks=true&polarized=true" : "landmarks=true";
  return ofModels("/curves", { ...state, n_t }, catalog, models, end);
}

/** The errors over the angle are in the curves already. @param {State} state @param {Catalog} catalog */
const errorsPath = (state, catalog) =>
  ofModels("/errors", state, catalog, `models=${against(state).join(",")}`, "samples=2");

/** A line or a map shows one channel, so three values of a parameter have none. @param {State} state @param {string} model */
export function hasTriple(state, model) {
  return Object.entries(state).some(
    ([name, value]) => name.startsWith(`${model}.`) && Array.isArray(value),
  );
}

/** Along what a figure is drawn, and from where to where. @param {State} state @param {string} name */
function along(state, name) {
  return name === "theta_i_deg" ? [0, 90] : ranges(state)[/** @type {"n_t" | "k_t"} */ (name)];
}

/** @param {State} state @param {Catalog} catalog @param {string} model */
export function sweepPath(state, catalog, model) {
  const { x, held } = figureOf(state);
  const [low, high] = along(state, x);
  return path("/errors/sweep", [
    `model=${model}`,
    `over=${x}`,
    `minimum=${low}`,
    `maximum=${high}`,
    `steps=${SWEEP_STEPS}`,
    ...mediaQuery(state, catalog, held),
    ...parameterQuery(state, catalog.models, [model]),
  ]);
}

/** @param {State} state @param {Catalog} catalog */
export function mapPath(state, catalog) {
  const model = focused(state);
  const { x, y = "", held, pointwise } = figureOf(state);
  return path("/errors/map", [
    `model=${model}`,
    ...Object.entries({ x, y }).flatMap(([axis, name]) => {
      const [low, high] = along(state, name);
      return [
        `${axis}=${name}`,
        `${axis}_minimum=${low}`,
        `${axis}_maximum=${high}`,
        `${axis}_steps=${MAP_CELLS[name]}`,
      ];
    }),
    `metric=${pointwise ? state.point : state.metric}`,
    `digits=${MAP_DIGITS}`,
    ...mediaQuery(state, catalog, held),
    ...parameterQuery(state, catalog.models, [model]),
  ]);
}

/** @param {State} state @param {Catalog} catalog */
export function recommendPath(state, catalog) {
  return path("/recommend", [
    ...mediaQuery(state, catalog),
    `max_error=${state.budget}`,
    `metric=${state.within}`,
  ]);
}

/**
 * Paths by name, in the order of their importance. While something moves only the curves are asked
 * for, and the map as soon as it stands still.
 * @param {State} state
 * @param {Catalog} catalog
 * @param {boolean} [moving]
 * @returns {Record<string, string>}
 */
export function queries(state, catalog, moving = false) {
  /** @type {Record<string, string>} */
  const wanted = { curves: curvesPath(state, catalog) };
  for (const n of state.family) wanted[`curves@${n}`] = curvesPath(state, catalog, n);
  if (!moving && figureOf(state).isMap && !hasTriple(state, focused(state)))
    wanted.map = mapPath(state, catalog);
  return wanted;
}

/**
 * What takes the server longer: the errors over the hemisphere, the sweeps, and which model will do.
 * @param {State} state
 * @param {Catalog} catalog
 * @returns {Record<string, string>}
 */
export function later(state, catalog) {
  const { example } = state;
  const models = against(state);
  const swept = figureOf(state).isMap
    ? []
    : models.filter((/** @type {string} */ id) => !hasTriple(state, id));
  const offered = withCode(state);
  const color = colorPath(state, catalog);
  return {
    ...bandPaths(state, catalog),
    ...(example && { claims: `/claims?example=${example}` }),
    ...(models.length && { errors: errorsPath(state, catalog) }),
    ...Object.fromEntries(
      swept.map((/** @type {string} */ id) => [`sweep:${id}`, sweepPath(state, catalog, id)]),
    ),
    ...(color && { color }),
    convert: convertPath(state),
    recommend: recommendPath(state, catalog),
    shader: snippetPath(state, offered),
    lut: lutPath(bare(state), catalog, codeOf(state, offered), "/lut/errors"),
  };
}

/** @param {State} state @param {Catalog} catalog @returns {string[]} */
export function restCalls(state, catalog) {
  const { curves, map } = queries(state, catalog);
  const { errors, recommend, convert } = later(state, catalog);
  const swept = against(state).length && !figureOf(state).isMap;
  const figure = map ?? (swept ? sweepPath(state, catalog, focused(state)) : undefined);
  return [curves, errors, figure, recommend, convert].filter((p) => p !== undefined);
}
