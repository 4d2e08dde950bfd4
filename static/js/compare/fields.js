/** The state that the Compare view adds to the one all views share. */

import { COLUMNS, METRICS } from "../errors/metrics.js";
import { EXAMPLES } from "../models/examples.js";
import { choice, declared, LinkError, modelFields, number, optional } from "../state/state.js";
import { text } from "../state/text.js";
import { snippetFields, tableFields } from "../takeaway/fields.js";
import { SOURCES } from "./conversions.js";

/** What stands against the exact curve when nothing was chosen. */
const FIRST_MODELS = ["schlick", "spherical_gaussian", "generalized_schlick"];
/** The same of a metal. */
const FIRST_OF_METALS = ["f82_tint", "schlick", "lazanyi2005"];

/** What stands against the exact curve here. @param {State} state @returns {readonly string[]} */
export const against = ({ models, k_t }) => models ?? (k_t > 0 ? FIRST_OF_METALS : FIRST_MODELS);

const MOST_FAMILY = 6;
/** What an error may be allowed. */
export const BUDGET = { minimum: 1e-9, maximum: 1 };

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

/**
 * Figures of the error over the media: what runs along their axes, a map where there are two, and the
 * indices that stay as they are.
 * @type {Record<string, {label: string, x: string, y?: string, held: readonly string[]}>}
 */
export const FIGURES = {
  n: { label: "n", x: "n_t", held: ["n_i", "k_t"] },
  k: { label: "k", x: "k_t", held: ["n_i", "n_t"] },
  "theta-n": { label: "θ × n", x: "theta_i_deg", y: "n_t", held: ["n_i", "k_t"] },
  "n-k": { label: "n × k", x: "n_t", y: "k_t", held: ["n_i"] },
};

/** The figure that a state shows. @param {State} state */
export function figureOf({ over }) {
  const { x = "n_t", y, held = [] } = FIGURES[over] ?? {};
  // At each angle there is an error; elsewhere it is measured over all of them.
  return { x, y, held, isMap: y !== undefined, pointwise: x === "theta_i_deg" };
}

/** @param {Catalog} catalog @returns {Record<string, Field>} */
export function compareFields({ models, parameters }) {
  const ids = models.map((m) => m.id).filter((id) => id !== "exact");
  const metric = choice("max_abs", Object.keys(METRICS));
  /** @param {string} name */
  const end = (name) => number({ ...declared(parameters, name), default: null });
  return {
    error: choice("signed", ["signed", "relative", "taken"]),
    polarized: choice("off", ["off", "on"]),
    family: numbers(declared(parameters, "n_t")),
    example: optional(EXAMPLES.map((e) => e.id)),
    sort: choice(
      "rms",
      COLUMNS.map((c) => c.name),
    ),
    order: choice("up", ["up", "down"]),
    over: choice("n", Object.keys(FIGURES)),
    metric,
    point: choice("error", ["error", "absolute", "relative"]),
    focus: optional(ids),
    n_low: end("n_t"),
    n_high: end("n_t"),
    k_low: end("k_t"),
    k_high: end("k_t"),
    budget: number({ default: 0.02, ...BUDGET }),
    within: metric,
    from: choice("media", Object.keys(SOURCES)),
    given: text((given) => given.length <= 80, "it is too long"),
    seen_from: end("n_i"),
    ...snippetFields(models),
    ...tableFields(),
    ...modelFields(models),
  };
}

/** Models whose code is offered: those on the screen. @param {State} state @returns {string[]} */
export const withCode = (state) => [...against(state), "exact"];

/** How the error is shown: what is taken from Schlick's curve wants that curve. @param {State} state @returns {string} */
export const errorShown = (state) =>
  state.error === "taken" && !against(state).includes("schlick") ? "signed" : state.error;

/** What the state becomes when the error is shown in another way. @param {State} state @param {string | undefined} error @returns {State} */
export function showingError(state, error) {
  const now = { error };
  if (errorShown({ ...state, ...now }) === error) return now;
  return { ...now, models: Object.freeze(["schlick", ...against(state)]) };
}

/** The model whose map is shown. @param {State} state @returns {string} */
export function focused(state) {
  const { focus } = state;
  const all = against(state);
  return focus !== null && all.includes(focus) ? focus : (all[0] ?? "schlick");
}

/**
 * The ranges of n and k in the figures: those set, else where the media at hand are at home.
 * @param {State} state
 * @returns {{n_t: [number, number], k_t: [number, number]}}
 */
export function ranges({ n_i, n_t, k_t, over, n_low, n_high, k_low, k_high }) {
  const metal = k_t > 0 || over === "n-k" || over === "k";
  const inside = !metal && n_t < n_i;
  const far = Math.max(3.05, Math.ceil((n_t / n_i) * 1.1)) * n_i;
  const automatic = metal ? [0.1, 5] : inside ? [0.3 * n_i, n_i] : [1.05 * n_i, far];
  /** @param {number} a @param {number} b @returns {[number, number]} */
  const ascending = (a, b) => (a < b ? [a, b] : [b, a]);
  const [low = 0, high = 1] = automatic.map((end) => Number(end.toPrecision(6)));
  return {
    n_t: ascending(n_low ?? low, n_high ?? high),
    k_t: ascending(k_low ?? 0, k_high ?? Math.max(5, Math.ceil(k_t))),
  };
}
