/** Text with mathematics in it: `the share $R$ is …`, `the **normal**`. */

import { h } from "./dom.js";
import { typeset } from "./typeset.js";

/**
 * @param {string} latex
 * @returns {HTMLElement} the formula within a line
 */
export function math(latex) {
  const element = h("span", { class: "math" });
  void typeset(latex, element, { inline: true });
  return element;
}

/**
 * The pieces of a text: `$…$` is typeset, `**…**` is a word that is explained here.
 * @param {string} text
 * @returns {(string | HTMLElement)[]}
 */
export function pieces(text) {
  return text.split(/\$([^$]+)\$/).flatMap((part, index) => {
    if (index % 2) return [math(part)];
    return part.split(/\*\*([^*]+)\*\*/).map((word, i) => (i % 2 ? h("dfn", {}, word) : word));
  });
}

const GREEK = /^(eta|kappa|mu|theta)/;

/** A text in which indices and Greek letters are written as such. @param {string} text */
export function words(text) {
  return text
    .replace(/<=/g, "≤")
    .replace(/>=/g, "≥")
    .split(/\b([A-Za-z]_[a-z0-9]+|[A-Za-z]\^\d|eta|kappa|mu|theta_[it])\b/)
    .map((part, index) => (index % 2 ? math(GREEK.test(part) ? `\\${part}` : part) : part));
}

/**
 * A formula on lines of its own. Long ones break between their equations, which KaTeX does not do.
 * @param {string} latex
 * @param {string} name what readers hear of it
 */
export function display(latex, name) {
  const element = h("div", {
    class: "formula",
    tabindex: "0",
    role: "group",
    "aria-label": `Formula of ${name}`,
  });
  for (const part of latex.split(/,\\quad\s*/)) {
    const line = h("div", { class: "equation" });
    void typeset(part, line);
    element.append(line);
  }
  return element;
}
