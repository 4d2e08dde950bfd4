/** KaTeX, loaded when the first formula is to be seen. */

import { h } from "./dom.js";

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
