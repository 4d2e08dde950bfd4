/** Style sheets that load when what they style is first shown. */

import { h } from "./dom.js";

/** @type {Map<string, Promise<void>>} */
const asked = new Map();

/** @param {string} name @returns {Promise<void>} */
function load(name) {
  return new Promise((resolve) => {
    const link = h("link", {
      rel: "stylesheet",
      href: `css/${name}.css`,
      onload: () => resolve(),
      onerror: () => resolve(),
    });
    document.head.append(link);
  });
}

/** Ask for style sheets, each once. @param {readonly string[]} names @returns {Promise<unknown>} when their rules hold, or cannot be had */
export function loadStyles(...names) {
  for (const name of names) if (!asked.has(name)) asked.set(name, load(name));
  return Promise.all(names.map((name) => asked.get(name)));
}
