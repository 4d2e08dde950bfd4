/** What the Theory view asks the server for. */

import { coatPath } from "../coat/fields.js";
import { path } from "../state/state.js";
import { KEYS } from "./answer-key.js";
import { lessonQueries } from "./lesson.js";
import { STEPS } from "./steps.js";
import { TRAPS } from "./trap-cards.js";

/**
 * @typedef {import('./lesson.js').Lesson} Lesson
 */

/** The numbers of a curve that the reader has moved. */
const OWN = { n_i: "own_i", n_t: "own_n", k_t: "own_k" };

/** The formula that is shown before one was chosen. */
export const FIRST_FORMULA = "model.exact";
/** The material to guess before one was sent. */
export const FIRST_MYSTERY = "qy2f0x";

/** What a guess starts from. @type {Lesson} */
export const GUESS = {
  id: "guess",
  title: "Mystery material",
  text: [],
  at: { n_t: 1.2, k_t: 0, deg: 60 },
  rows: { own_n: [0.05, 5], own_k: [0, 8], own_deg: [0, 90] },
  quantities: [],
};

/** By its code: n and k are neither in what is asked nor in the answer. @param {State} state @param {number} [clues] */
export function mysteryPath({ mystery }, clues = 0) {
  return path(`/mystery/${mystery ?? FIRST_MYSTERY}`, [clues > 0 && `clues=${clues}`]);
}

/** @param {State} state */
function formulaCurve({ formula, ...state }) {
  const given = Object.entries(OWN)
    .filter(([, own]) => state[own] !== null)
    .map(([name, own]) => `${name}=${state[own]}`);
  return `/formulas/${formula ?? FIRST_FORMULA}/curve${given.length ? `?${given.join("&")}` : ""}`;
}

/** @param {State} state @param {Lesson[]} lessons @param {string} id @returns {Record<string, string>} */
function ofLesson(state, lessons, id) {
  const lesson = lessons.find((l) => l.id === id);
  if (!lesson) return {};
  if (lesson.picture === "coat") return { coat: coatPath(state) };
  return lessonQueries(state, lesson);
}

/**
 * Paths by name, in the order of their importance.
 * @param {State} state
 * @returns {Record<string, string>}
 */
export function queries(state) {
  switch (state.section) {
    case "path":
      return ofLesson(state, STEPS, state.step);
    case "traps":
      return ofLesson(state, TRAPS, state.trap);
    case "formulas":
      return { curve: formulaCurve(state), formulas: "/formulas" };
    case "claims":
      return { claims: "/claims" };
    case "mystery":
      return { ...lessonQueries(state, GUESS), hidden: mysteryPath(state) };
    case "worksheets":
      return (state.answers === "open" && KEYS[state.sheet]?.asks) || {};
    default:
      return {};
  }
}

/** The calls that give what is on the screen. @param {State} state */
export const restCalls = (state) => Object.values(queries(state));
