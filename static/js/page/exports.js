/** What can be taken away of a figure: PNG, SVG and CSV at once, and a picture made to fit a paper or a slide. */

import { h } from "./dom.js";

/**
 * @typedef {'png' | 'svg' | 'csv'} Format
 * @typedef {import("../plot/publication.js").Publication} Publication
 * @typedef {import("../publish/media.js").Behind} Behind
 * @typedef {object} Published a figure that can be drawn for a publication
 * @property {(format: 'png' | 'svg', publication: Publication) => Promise<Blob>} exportAs
 * @property {() => {name: string, ids: readonly string[]}} about its title, and what is drawn in it
 * @property {number} [beside] px of its width that are not the plot's, such as a key's
 */

/**
 * Save one file, or several that are told apart by their numbers.
 * @param {(name: string, blob: Blob) => void} save
 * @param {readonly Blob[]} blobs
 * @param {(part: string) => string} name with what tells the part
 */
export function saveEach(save, blobs, name) {
  blobs.forEach((blob, i) => {
    save(name(blobs.length > 1 ? `-${i + 1}` : ""), blob);
  });
}

/**
 * @param {object} options
 * @param {string} options.what such as "the curves"
 * @param {() => string} options.name of the file, without ending
 * @param {(format: Format) => Promise<Blob | Blob[]>} options.make
 * @param {(name: string, blob: Blob) => void} options.save
 * @param {{figures: () => Published[], call: string, behind: () => Behind}} [options.print]
 *   what can be set up for a publication, a part of the REST call on the page that it shows, and where
 *   its indices are from
 */
export function createExports({ what, name, make, save, print }) {
  /** @param {Format} kind */
  async function take(kind) {
    saveEach(save, [await make(kind)].flat(), (part) => `${name()}${part}.${kind}`);
  }
  return h(
    "p",
    { class: "exports" },
    .../** @type {const} */ (["png", "svg", "csv"]).map((kind) =>
      h(
        "button",
        {
          type: "button",
          class: "quiet",
          "aria-label": `Save ${what} as ${kind.toUpperCase()}`,
          onclick: () => take(kind),
        },
        kind.toUpperCase(),
      ),
    ),
    print &&
      h(
        "button",
        {
          type: "button",
          class: "quiet",
          "aria-label": `For print… (${what.replace(/^the /u, "")})`,
          onclick: async () => {
            const { publish } = await import("../publish/dialog.js");
            const { figures, call, behind } = print;
            publish({ figures: figures(), call, behind: behind(), name: name(), save });
          },
        },
        "For print…",
      ),
  );
}
