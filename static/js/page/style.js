/** Style sheets of views that load when they are first shown. */

import { h } from "./dom.js";

/** @param {string} href @returns {Promise<void>} when the rules hold, or cannot be had */
export function loadStyle(href) {
  return new Promise((resolve) => {
    const link = h("link", {
      rel: "stylesheet",
      href,
      onload: () => resolve(),
      onerror: () => resolve(),
    });
    document.head.append(link);
  });
}
