/** Text with mathematics in it: `the share $R$ is …`, `the **normal**`. */

import { h } from "./dom.js";

/**
 * @param {string} latex
 * @returns {HTMLElement} the formula within a line
 */
export function math(latex) {
  const element = h("span.math");
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
    return part.split(/\*\*([^*]+)\*\*/).map((word, i) => (i % 2 ? h("dfn", word) : word));
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
  const element = h("div.formula", {
    tabindex: "0",
    role: "group",
    "aria-label": `Formula of ${name}`,
  });
  for (const part of latex.split(/,\\quad\s*/)) {
    const line = h("div.equation");
    void typeset(part, line);
    element.append(line);
  }
  return element;
}

const FOLDER = "vendor/katex-0.19.1/";
/** @type {Promise<void> | null} */
let loading = null;

export function loadKatex() {
  loading ??= new Promise((resolve, reject) => {
    document.head.append(h("link", { rel: "stylesheet", href: `${FOLDER}katex.min.css` }));
    const script = h("script", { src: `${FOLDER}katex.min.js` });
    script.addEventListener("load", () => resolve());
    script.addEventListener("error", () => {
      loading = null;
      reject(new Error("KaTeX could not be loaded"));
    });
    document.head.append(script);
  });
  return loading;
}

/**
 * Typeset a formula; where that fails, its LaTeX stands instead.
 * @param {string} latex
 * @param {HTMLElement} element
 * @param {{inline?: boolean}} [how] within a line of text, or on lines of its own
 */
export async function typeset(latex, element, { inline = false } = {}) {
  element.textContent = latex;
  try {
    await loadKatex();
    katex.render(latex, element, { displayMode: !inline, throwOnError: false });
  } catch {
    element.textContent = latex;
  }
}
