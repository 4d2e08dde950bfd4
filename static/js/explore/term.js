/** A number's name or a letter, which is explained where it is tapped. */

import { h } from "../page/dom.js";

/**
 * @param {string} name
 * @param {Node | string} heading what stands there
 * @param {(words: string) => void} say
 * @param {Record<string, string>} [attributes]
 */
export function createTerm(name, heading, say, attributes = {}) {
  const about = typeof heading === "string" ? heading : heading.textContent;
  return h(
    "button.term",
    {
      type: "button",
      "aria-label": `${about}, explained`,
      onclick: async (/** @type {Event} */ event) => {
        const at = /** @type {HTMLElement} */ (event.currentTarget);
        (await import("./meanings.js")).explain(name, at, say);
      },
      ...attributes,
    },
    heading,
  );
}
