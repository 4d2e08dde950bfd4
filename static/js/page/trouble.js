/** What went wrong with one figure, said where it stands, and the way back. */

import { h, setText } from "./dom.js";

/** @typedef {{title: string, lines: string[]}} Problem */

/**
 * @param {string} label of the way back
 * @param {() => void} onBack
 */
export function createTrouble(label, onBack) {
  const words = h("p", { class: "row-error" });
  const back = h("button", { type: "button", class: "quiet", onclick: onBack }, label);
  const element = h("div", { class: "trouble", role: "alert" }, words, back);
  back.hidden = true;
  return {
    element,
    /** @param {Problem | undefined} problem @param {boolean} offered whether there is anything to go back from */
    update(problem, offered) {
      const text = problem
        ? (problem.lines.length ? problem.lines : [problem.title]).join(" · ")
        : "";
      setText(words, text);
      back.hidden = !problem || !offered;
    },
  };
}
