/** What the Compare view asks the server for. */

import { mediaQuery, parameterQuery, path } from "../server/questions.js";
import { codeOf, lutPath, snippetPath } from "../takeaway/fields.js";
import { convertPath } from "./conversions.js";
import { focused, isMap, isPointwise, ranges, withCode } from "./fields.js";

/** Enough for a smooth line, and steps of 0.01 over two units of n. */
const SWEEP_STEPS = 201;
/** Cells of a map; a degree is two cells. */
const MAP_CELLS = { theta: 181, n: 121, wide: 121, k: 101 };
/** A cell's color needs no more. */
const MAP_DIGITS = 4;

/** @type {Record<string, readonly string[]>} */
const HELD = {
  n: ["n_i", "k_t"],
  k: ["n_i", "n_t"],
  "theta-n": ["n_i", "k_t"],
  "n-k": ["n_i"],
};

/** The indices that stay as they are in the figure over the media. @param {State} state */
export const held = ({ over }) => HELD[over] ?? [];

/** @param {State} state @param {Catalog} catalog @param {number} [n] of another member of the family */
function curvesPath(state, catalog, n) {
  const here = n === undefined ? state : { ...state, n_t: n };
  return path("/curves", [
    ...mediaQuery(here, catalog),
    state.against.length ? `models=exact,${state.against.join(",")}` : "",
    ...parameterQuery(state, catalog.models, state.against),
    "landmarks=true",
  ]);
}

/** @param {State} state @param {Catalog} catalog */
function errorsPath(state, catalog) {
  return path("/errors", [
    ...mediaQuery(state, catalog),
    `models=${state.against.join(",")}`,
    ...parameterQuery(state, catalog.models, state.against),
    "samples=2", // the errors over the angle are in the curves already
  ]);
}

/** A line or a map shows one channel, so three values of a parameter have none. @param {State} state @param {string} model */
export function hasTriple(state, model) {
  return Object.entries(state).some(
    ([name, value]) => name.startsWith(`${model}.`) && Array.isArray(value),
  );
}

/** @param {State} state @param {Catalog} catalog @param {string} model */
export function sweepPath(state, catalog, model) {
  const over = state.over === "k" ? "k_t" : "n_t";
  const [low, high] = ranges(state)[over === "k_t" ? "k" : "n"];
  return path("/errors/sweep", [
    `model=${model}`,
    `over=${over}`,
    `minimum=${low}`,
    `maximum=${high}`,
    `steps=${SWEEP_STEPS}`,
    ...mediaQuery(state, catalog, held(state)),
    ...parameterQuery(state, catalog.models, [model]),
  ]);
}

/** @param {State} state @param {Catalog} catalog */
export function mapPath(state, catalog) {
  const model = focused(state);
  const { n, k } = ranges(state);
  const pointwise = isPointwise(state.over);
  /** @param {string} axis @param {string} name @param {[number, number]} ends @param {number} steps */
  const spread = (axis, name, [low, high], steps) => [
    `${axis}=${name}`,
    `${axis}_minimum=${low}`,
    `${axis}_maximum=${high}`,
    `${axis}_steps=${steps}`,
  ];
  return path("/errors/map", [
    `model=${model}`,
    ...(pointwise
      ? [
          ...spread("x", "theta_i_deg", [0, 90], MAP_CELLS.theta),
          ...spread("y", "n_t", n, MAP_CELLS.n),
        ]
      : [...spread("x", "n_t", n, MAP_CELLS.wide), ...spread("y", "k_t", k, MAP_CELLS.k)]),
    `metric=${pointwise ? state.point : state.metric}`,
    `digits=${MAP_DIGITS}`,
    ...mediaQuery(state, catalog, held(state)),
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
  if (!moving && isMap(state.over) && !hasTriple(state, focused(state)))
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
  /** @type {Record<string, string>} */
  const wanted = {};
  if (state.example) wanted.claims = `/claims?example=${state.example}`;
  if (state.against.length) wanted.errors = errorsPath(state, catalog);
  if (!isMap(state.over)) {
    for (const id of state.against.filter((/** @type {string} */ one) => !hasTriple(state, one)))
      wanted[`sweep:${id}`] = sweepPath(state, catalog, id);
  }
  wanted.convert = convertPath(state);
  wanted.recommend = recommendPath(state, catalog);
  const offered = withCode(state);
  wanted.shader = snippetPath(state, offered);
  wanted.lut = lutPath(state, catalog, codeOf(state, offered), "/lut/errors");
  return wanted;
}

/** @param {State} state @param {Catalog} catalog @returns {string[]} */
export function restCalls(state, catalog) {
  const { curves, map } = queries(state, catalog);
  const { errors, recommend, convert } = later(state, catalog);
  const sweep =
    state.against.length && !isMap(state.over) ? sweepPath(state, catalog, focused(state)) : null;
  return [curves, errors, map ?? sweep, recommend, convert].filter(
    (p) => p !== undefined && p !== null,
  );
}
