/** The state that the Albedo view adds to the one all views share. */

import { coatFields } from "../coat/fields.js";
import { choice, LinkError, list, number } from "../state/state.js";

/**
 * @typedef {'outside' | 'inside' | 'metal-n' | 'metal-k'} Surface
 */

/** @type {Surface[]} */
export const SURFACES = ["outside", "inside", "metal-n", "metal-k"];
export const LIGHTS = ["s", "p", "flatland"];

/** What stands against the exact albedo when nothing was chosen. @type {Record<Surface, readonly string[]>} */
const FIRST_FITS = {
  outside: ["deon_2019_log"],
  inside: ["egan_hilgeman_1973", "kulla_conty_2017_internal"],
  "metal-n": ["deon_2019_rational", "deon_2019_rg", "dunkle_1963"],
  "metal-k": ["deon_2019_rational", "deon_2019_rg", "dunkle_1963"],
};

/** Ranges of the relative index, of n_t and of k_t over n_i. @type {Record<Surface, [number, number]>} */
const RANGES = {
  outside: [1, 3],
  inside: [0.5, 1],
  "metal-n": [0.1, 4],
  "metal-k": [0, 8],
};
/** Where the conductor fits are at home, over n_i. */
const MAP = { n: [0.1, 4], k: [0, 8] };

/** Ids that the server judges; null leaves the choice to the page. @returns {Field} */
function fitIds() {
  return {
    default: null,
    parse(text) {
      if (text === "none") return Object.freeze([]);
      const ids = text.split(",");
      const strange = ids.find((id) => !/^[a-z0-9_]+$/.test(id));
      if (strange !== undefined) throw new LinkError(`“${strange}” is no id of a fit`);
      return Object.freeze([...new Set(ids)]);
    },
    print: (value) => (value === null ? "" : value.length ? value.join(",") : "none"),
  };
}

/** One id or none. @returns {Field} */
function fitId() {
  return {
    default: null,
    parse(text) {
      if (!/^[a-z0-9_]+$/.test(text)) throw new LinkError("it is no id of a fit");
      return text;
    },
    print: (value) => value ?? "",
  };
}

/** Any of some words, some of them unless the link says otherwise. @param {string[]} options @param {string[]} preset @returns {Field} */
function some(options, preset) {
  const field = list(options);
  return {
    default: Object.freeze(preset),
    parse: (text) => (text === "none" ? Object.freeze([]) : field.parse(text)),
    print: (value) => (value.length ? field.print(value) : "none"),
  };
}

/** @param {Catalog} catalog @returns {Record<string, Field>} */
export function albedoFields({ parameters }) {
  const n = parameters.find((p) => p.name === "n_t") ?? { minimum: 1e-3, maximum: 100 };
  const k = parameters.find((p) => p.name === "k_t") ?? { minimum: 0, maximum: 100 };
  // The relative index reaches further than either; the server knows how far.
  const swept = { default: null, minimum: 0, maximum: 1e5 };
  return {
    surface: choice("outside", SURFACES),
    fits: fitIds(),
    lights: some(LIGHTS, ["s", "p"]),
    albedo_error: choice("signed", ["signed", "relative"]),
    sweep_low: number(swept),
    sweep_high: number(swept),
    map_fit: fitId(),
    map_show: choice("error", ["error", "value", "exact"]),
    map_n_low: number({ ...n, default: null }),
    map_n_high: number({ ...n, default: null }),
    map_k_low: number({ ...k, default: null }),
    map_k_high: number({ ...k, default: null }),
    ...coatFields(parameters),
    claims_by: choice("holds", ["fit", "holds", "claimed", "measured", "domain", "source"]),
    claims_order: choice("up", ["up", "down"]),
  };
}

/** @param {State} state @returns {readonly string[]} */
export function chosenFits({ fits, surface }) {
  return fits ?? FIRST_FITS[/** @type {Surface} */ (surface)];
}

/** @param {string} surface */
export const isMetal = (surface) => surface === "metal-n" || surface === "metal-k";

/** A rounded product. @param {number} a @param {number} b */
const times = (a, b) => Number((a * b).toPrecision(12));

/** The ends of the abscissa: those set, else where the fits are at home. @param {State} state @returns {[number, number]} */
export function sweepRange({ surface, n_i, sweep_low, sweep_high }) {
  const [low, high] = RANGES[/** @type {Surface} */ (surface)];
  const unit = isMetal(surface) ? n_i : 1;
  return [sweep_low ?? times(low, unit), sweep_high ?? times(high, unit)];
}

/** @param {State} state @returns {{n: [number, number], k: [number, number]}} */
export function mapRange({ n_i, map_n_low, map_n_high, map_k_low, map_k_high }) {
  const [n0 = 0, n1 = 1] = MAP.n;
  const [k0 = 0, k1 = 1] = MAP.k;
  return {
    n: [map_n_low ?? times(n0, n_i), map_n_high ?? times(n1, n_i)],
    k: [map_k_low ?? times(k0, n_i), map_k_high ?? times(k1, n_i)],
  };
}

/** The fit of the map: the one named, else the first of those on the plot that are for metals. @param {State} state @returns {string} */
export function mapFit(state) {
  if (state.map_fit !== null) return state.map_fit;
  const first = /** @type {string} */ (FIRST_FITS["metal-n"][0]);
  return isMetal(state.surface) ? (chosenFits(state)[0] ?? first) : first;
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
  const { surface, n_i, n_t, k_t } = state;
  if (surface === "metal-n") return n_t;
  if (surface === "metal-k") return k_t;
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
  const { surface, n_i } = state;
  if (surface === "metal-k") return { k_t: x, material: null };
  if (surface === "metal-n") return { n_t: x, material: null };
  const n_t = times(n_i, facing(state) ? x : 1 / x);
  return { n_t, k_t: 0, material: null };
}
