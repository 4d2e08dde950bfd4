/** The words PNG, SVG, CSV beside a figure. */

import { h } from "../dom.js";

/**
 * @param {object} options
 * @param {string} options.what such as "curves"
 * @param {() => string} options.name of the file, without ending
 * @param {(format: 'png' | 'svg' | 'csv') => Promise<Blob>} options.make
 * @param {(name: string, blob: Blob) => void} options.save
 */
export function createExports({ what, name, make, save }) {
  return h(
    "p",
    { class: "exports" },
    .../** @type {const} */ (["png", "svg", "csv"]).map((kind) =>
      h(
        "button",
        {
          type: "button",
          class: "quiet",
          "aria-label": `Save the ${what} as ${kind.toUpperCase()}`,
          onclick: async () => save(`${name()}.${kind}`, await make(kind)),
        },
        kind.toUpperCase(),
      ),
    ),
  );
}
