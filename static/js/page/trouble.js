/** What went wrong with one figure, said where it stands, and the way back. */

import { h, setText } from "./dom.js";
import { loadStyles } from "./style.js";

/** @typedef {{title: string, lines: string[]}} Problem */

/** @param {Problem | undefined} problem */
export function sayProblem(problem) {
  return problem ? problem.lines.join(" · ") || problem.title : "";
}

/**
 * What went wrong with the questions of a view, until they are answered.
 * @param {readonly string[]} told those whose problems the view tells itself, by their names
 */
export function createProblems(told) {
  /** @type {Map<string, {problem: Problem, answer: unknown}>} with the answer that there was already */
  const known = new Map();
  return {
    /** @param {string} name @param {Problem} problem @param {Record<string, any>} answers @returns {boolean} whether the view tells it */
    add(name, problem, answers) {
      if (told.includes(name)) known.set(name, { problem, answer: answers[name] });
      return told.includes(name);
    },
    /** @param {string} name @param {Record<string, any>} answers @returns {Problem | undefined} unless it was answered since */
    of(name, answers) {
      const found = known.get(name);
      return found && found.answer === answers[name] ? found.problem : undefined;
    },
  };
}

/**
 * @param {string} label of the way back
 * @param {() => void} onBack
 */
export function createTrouble(label, onBack) {
  void loadStyles("trouble");
  const words = h("p.row-error");
  const back = h("button.quiet", { type: "button", onclick: onBack }, label);
  const element = h("div.trouble", { role: "alert" }, words, back);
  back.hidden = true;
  return {
    element,
    /** @param {Problem | undefined} problem @param {boolean} offered whether there is anything to go back from */
    update(problem, offered) {
      setText(words, sayProblem(problem));
      back.hidden = !problem || !offered;
    },
  };
}
