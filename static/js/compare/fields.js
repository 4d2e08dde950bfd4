/** The state that the Compare view adds to the one all views share. */

import { COLUMNS } from "../errors/metrics.js";
import { EXAMPLES } from "../models/examples.js";
import { parameterFields } from "../server/questions.js";
import { choice, LinkError, list, number } from "../state/state.js";
import { snippetFields, tableFields } from "../takeaway/fields.js";
import { SOURCES } from "./conversions.js";

/** What stands against the exact curve when nothing was chosen. */
const FIRST_MODELS = ["schlick", "spherical_gaussian", "generalized_schlick"];
const MOST_FAMILY = 6;

/** Ids with a default; an empty list is written "none". @param {string[]} options @returns {Field} */
function chosen(options) {
  const field = list(options);
  return {
    default: Object.freeze(FIRST_MODELS.filter((id) => options.includes(id))),
    parse: (text) => (text === "none" ? Object.freeze([]) : field.parse(text)),
    print: (value) => (value.length ? field.print(value) : "none"),
  };
}

/** Several indices. @param {{minimum: number, maximum: number}} bounds @returns {Field} */
function numbers({ minimum, maximum }) {
  const one = number({ default: null, minimum, maximum });
  return {
    default: Object.freeze([]),
    parse(text) {
      const values = [...new Set(text.split(",").map((part) => one.parse(part.trim())))];
      if (values.length > MOST_FAMILY) throw new LinkError(`at most ${MOST_FAMILY} indices`);
      return Object.freeze(values);
    },
    print: (value) => value.join(","),
  };
}

/** One of some words or none. @param {string[]} options @returns {Field} */
function maybe(options) {
  return {
    default: null,
    parse(text) {
      if (!options.includes(text)) throw new LinkError(`allowed is one of ${options.join(", ")}`);
      return text;
    },
    print: (value) => value ?? "",
  };
}

/** What a reader wrote into a box. @returns {Field} */
function words() {
  return {
    default: null,
    parse(text) {
      if (text.length > 80) throw new LinkError("it is too long");
      return text;
    },
    print: (value) => value ?? "",
  };
}

/** Sweeps and maps of the error over the media. */
export const FIGURES = ["n", "k", "theta-n", "n-k"];
/** Figures of an error at each angle, in place of a metric of all angles. @param {string} over */
export const isPointwise = (over) => over === "theta-n";
/** Figures of one model, in place of a curve for each. @param {string} over */
export const isMap = (over) => over === "theta-n" || over === "n-k";

/** @param {Catalog} catalog @returns {Record<string, Field>} */
export function compareFields({ models, parameters }) {
  const ids = models.map((m) => m.id).filter((id) => id !== "exact");
  const n = parameters.find((p) => p.name === "n_t") ?? { minimum: 1e-3, maximum: 100 };
  const k = parameters.find((p) => p.name === "k_t") ?? { minimum: 0, maximum: 100 };
  return {
    against: chosen(ids),
    error: choice("signed", ["signed", "relative"]),
    family: numbers(n),
    example: maybe(EXAMPLES.map((e) => e.id)),
    sort: choice(
      "rms",
      COLUMNS.map((c) => c.name),
    ),
    order: choice("up", ["up", "down"]),
    over: choice("n", FIGURES),
    metric: choice("max_abs", ["max_abs", "rms", "cosine_weighted_mean", "max_relative"]),
    point: choice("error", ["error", "absolute", "relative"]),
    focus: maybe(ids),
    n_low: number({ ...n, default: null }),
    n_high: number({ ...n, default: null }),
    k_low: number({ ...k, default: null }),
    k_high: number({ ...k, default: null }),
    budget: number({ default: 0.02, minimum: 1e-9, maximum: 1 }),
    within: choice("max_abs", ["max_abs", "rms", "cosine_weighted_mean", "max_relative"]),
    from: choice("media", Object.keys(SOURCES)),
    given: words(),
    seen_from: number({ default: null, minimum: 1e-3, maximum: 100 }),
    ...snippetFields(models),
    ...tableFields(),
    ...parameterFields(models),
  };
}

/** Models whose code is offered: those on the screen. @param {State} state @returns {string[]} */
export const withCode = ({ against }) => [...against, "exact"];

/** The model whose map is shown. @param {State} state @returns {string} */
export function focused({ focus, against }) {
  return focus !== null && against.includes(focus) ? focus : (against[0] ?? "schlick");
}

/**
 * The ranges of n and k in the figures: those set, else where the media at hand are at home.
 * @param {State} state
 * @returns {{n: [number, number], k: [number, number]}}
 */
export function ranges({ n_i, n_t, k_t, over, n_low, n_high, k_low, k_high }) {
  const metal = k_t > 0 || over === "n-k" || over === "k";
  const inside = !metal && n_t < n_i;
  const far = Math.max(3.05, Math.ceil((n_t / n_i) * 1.1)) * n_i;
  const automatic = metal ? [0.1, 5] : inside ? [0.3 * n_i, n_i] : [1.05 * n_i, far];
  const n = /** @type {[number, number]} */ ([
    n_low ?? Number(automatic[0]?.toPrecision(6)),
    n_high ?? Number(automatic[1]?.toPrecision(6)),
  ]);
  const k = /** @type {[number, number]} */ ([k_low ?? 0, k_high ?? Math.max(5, Math.ceil(k_t))]);
  return { n: n[0] < n[1] ? n : [n[1], n[0]], k: k[0] < k[1] ? k : [k[1], k[0]] };
}
