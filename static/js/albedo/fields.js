/** The state that the Albedo view adds to the one all views share. */

import { coatFields } from "../coat/fields.js";
import { choice, declared, LinkError, list, number } from "../state/state.js";
import { text } from "../state/text.js";
import { COLUMNS } from "./claims.js";

const METAL_FITS = ["deon_2019_rational", "deon_2019_rg", "dunkle_1963"];

/**
 * What the figures of the albedo run over, the range where their fits are at home (for metals over n_i),
 * and the fits shown when none was chosen.
 * @typedef {{label: string, title: string, over: 'eta' | 'n_t' | 'k_t', range: [number, number],
 *   fits: readonly string[]}} Surface
 * @type {Record<string, Surface>}
 */
export const SURFACES = {
  outside: {
    label: "n, clear medium from outside",
    title: "Albedo from outside",
    over: "eta",
    range: [1, 3],
    fits: ["deon_2019_log"],
  },
  inside: {
    label: "n, clear medium from inside",
    title: "Albedo from inside",
    over: "eta",
    range: [0.5, 1],
    fits: ["egan_hilgeman_1973", "kulla_conty_2017_internal"],
  },
  "metal-n": {
    label: "n, metal at one k",
    title: "Albedo of metals over n",
    over: "n_t",
    range: [0.1, 4],
    fits: METAL_FITS,
  },
  "metal-k": {
    label: "k, metal at one n",
    title: "Albedo of metals over k",
    over: "k_t",
    range: [0, 8],
    fits: METAL_FITS,
  },
};

/** @param {State} state @returns {Surface} the figure that it shows */
export const surfaceOf = ({ surface }) => /** @type {Surface} */ (SURFACES[surface]);

/** The indices that stay as they are in it. @param {State} state @returns {string[]} */
export function held(state) {
  const { over } = surfaceOf(state);
  return over === "eta" ? [] : ["n_i", over === "n_t" ? "k_t" : "n_t"];
}

/** Where the conductor fits are at home, over n_i. */
const MAP = /** @type {const} */ ({ n: [0.1, 4], k: [0, 8] });
/** Where the figures of metals start when the interface at hand is none. */
const FIRST_K = 3;

const FIT_ID = /^[a-z0-9_]+$/;

/** Ids that the server judges; null leaves the choice to the page. @type {Field} */
const FIT_IDS = {
  default: null,
  parse(text) {
    if (text === "none") return Object.freeze([]);
    const ids = text.split(",");
    const strange = ids.find((id) => !FIT_ID.test(id));
    if (strange !== undefined) throw new LinkError(`“${strange}” is no id of a fit`);
    return Object.freeze([...new Set(ids)]);
  },
  print: (value) => (value === null ? "" : value.join(",") || "none"),
};

/** @param {Catalog} catalog @returns {Record<string, Field>} */
export function albedoFields({ parameters }) {
  /** @param {string} name */
  const end = (name) => number({ ...declared(parameters, name), default: null });
  // The relative index reaches further than either; the server knows how far.
  const swept = { default: null, minimum: 0, maximum: 1e5 };
  return {
    surface: choice("outside", Object.keys(SURFACES)),
    fits: FIT_IDS,
    lights: list(["s", "p", "flatland"], ["s", "p"]),
    albedo_error: choice("signed", ["signed", "relative"]),
    sweep_low: number(swept),
    sweep_high: number(swept),
    map_fit: text((id) => FIT_ID.test(id), "it is no id of a fit"),
    map_show: choice("error", ["error", "value", "exact"]),
    map_n_low: end("n_t"),
    map_n_high: end("n_t"),
    map_k_low: end("k_t"),
    map_k_high: end("k_t"),
    ...coatFields(parameters),
    claims_by: choice(
      "holds",
      COLUMNS.map((c) => c.name),
    ),
    claims_order: choice("up", ["up", "down"]),
  };
}

/** @param {State} state @returns {readonly string[]} */
export const chosenFits = (state) => state.fits ?? surfaceOf(state).fits;

/** @param {string} surface */
export const isMetal = (surface) => surface === "metal-n" || surface === "metal-k";

/** A rounded product. @param {number} a @param {number} b */
const times = (a, b) => Number((a * b).toPrecision(12));

/** The ends of the abscissa: those set, else where the fits are at home. @param {State} state @returns {[number, number]} */
export function sweepRange(state) {
  const { over, range } = surfaceOf(state);
  const unit = over === "eta" ? 1 : state.n_i;
  return [state.sweep_low ?? times(range[0], unit), state.sweep_high ?? times(range[1], unit)];
}

/** @param {State} state @returns {{n: [number, number], k: [number, number]}} */
export function mapRange({ n_i, map_n_low, map_n_high, map_k_low, map_k_high }) {
  return {
    n: [map_n_low ?? times(MAP.n[0], n_i), map_n_high ?? times(MAP.n[1], n_i)],
    k: [map_k_low ?? times(MAP.k[0], n_i), map_k_high ?? times(MAP.k[1], n_i)],
  };
}

/** The fit of the map: the one named, else the first of those on the plot that are for metals. @param {State} state @returns {string} */
export function mapFit(state) {
  const own = isMetal(state.surface) ? chosenFits(state)[0] : undefined;
  return state.map_fit ?? own ?? METAL_FITS[0];
}

/**
 * Whether the interface is met from the side that the figure shows; the other side is the same
 * surface, whose relative index is the reciprocal.
 * @param {State} state
 */
export function facing({ surface, n_i, n_t }) {
  return surface === "inside" ? n_t <= n_i : n_t >= n_i;
}

/** Where the interface of all views stands on the abscissa; null where it is none of the figure's. @param {State} state @returns {number | null} */
export function place(state) {
  const { n_i, n_t, k_t } = state;
  const { over } = surfaceOf(state);
  if (over !== "eta") return state[over];
  if (k_t > 0) return null;
  return facing(state) ? n_t / n_i : n_i / n_t;
}

/**
 * What the state becomes when the reader goes to a place on the abscissa.
 * @param {State} state
 * @param {number} x
 * @returns {State}
 */
export function gone(state, x) {
  const { over } = surfaceOf(state);
  if (over !== "eta") return { [over]: x, material: null };
  return { n_t: times(state.n_i, facing(state) ? x : 1 / x), k_t: 0, material: null };
}

/** What the state becomes when another figure is chosen. @param {State} state @param {string} surface @returns {State} */
export function turned(state, surface) {
  return {
    surface,
    ...(surface !== state.surface && { sweep_low: null, sweep_high: null }),
    ...(isMetal(surface) && state.k_t === 0 && { k_t: FIRST_K, material: null }),
  };
}
