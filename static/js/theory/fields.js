/** The state that the Theory view adds to the one all views share. */

import { coatFields } from "../coat/fields.js";
import { choice, number, optional } from "../state/state.js";
import { text } from "../state/text.js";
import { KEYS } from "./answer-key.js";
import { thinFields } from "./film-lesson.js";
import { decode } from "./mystery-code.js";
import { STEPS } from "./steps.js";
import { TRAPS } from "./trap-cards.js";

/**
 * @typedef {import('./lesson.js').Lesson} Lesson
 */

export const SECTIONS = [
  { id: "path", title: "First path" },
  { id: "formulas", title: "Formulas" },
  { id: "claims", title: "Claims, measured" },
  { id: "traps", title: "Traps" },
  { id: "mystery", title: "Mystery material" },
  { id: "worksheets", title: "Worksheets" },
];

/** What a reader has moved; null is the lesson's own value. */
export const TOUCHED = ["own_i", "own_n", "own_k", "own_deg", "own_pol", "own_of"];
/** Nothing is moved. @type {State} */
export const UNTOUCHED = Object.freeze(Object.fromEntries(TOUCHED.map((key) => [key, null])));

/** @param {string[]} options */
const oneOf = (options) =>
  text((given) => options.includes(given), `allowed is one of ${options.join(", ")}`);

/** @param {Catalog} catalog @returns {Record<string, Field>} */
export function theoryFields({ parameters, materials }) {
  /** @param {string} name */
  const own = (name) => {
    const declared = parameters.find((p) => p.name === name);
    return number({ minimum: 0, maximum: 100, ...declared, default: null });
  };
  return {
    section: choice(
      "path",
      SECTIONS.map((s) => s.id),
    ),
    step: choice(
      /** @type {Lesson} */ (STEPS[0]).id,
      STEPS.map((s) => s.id),
    ),
    trap: choice(
      /** @type {Lesson} */ (TRAPS[0]).id,
      TRAPS.map((s) => s.id),
    ),
    formula: text((given) => /^[a-z]+\.[a-z0-9_]+$/.test(given), "it is no id of a formula"),
    word: text((given) => given.length <= 80, "it is too long"),
    claim: text((given) => /^[a-z0-9-]+$/.test(given), "it is no id of a claim"),
    verdict: text((given) => given.length <= 40, "it is no verdict"),
    by: text((given) => given.length <= 80, "it is no source"),
    mystery: text((given) => decode(given) !== null, "it is no code of a mystery material"),
    own_i: own("n_i"),
    own_n: own("n_t"),
    own_k: own("k_t"),
    own_deg: own("theta_i_deg"),
    own_pol: oneOf(["s", "p", "unpolarized"]),
    own_of: oneOf(materials.map((m) => m.id)),
    sheet: optional(Object.keys(KEYS)),
    answers: choice("closed", ["closed", "open"]),
    ...coatFields(parameters),
    ...thinFields(),
  };
}
