/** What can be taken away of a figure: PNG, SVG and CSV at once, and a picture made to fit a paper or a slide. */

import { h } from "./dom.js";

/**
 * @typedef {'png' | 'svg' | 'csv'} Format
 * @typedef {import("../publish/caption.js").Behind} Behind
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

/** @param {string} text @returns {Promise<boolean>} whether it was copied */
export async function copyText(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const area = document.createElement("textarea");
    area.value = text;
    area.className = "hidden";
    document.body.append(area);
    area.select();
    const done = document.execCommand("copy");
    area.remove();
    return done;
  }
}

/**
 * Show on a button for a moment that it did its work.
 * @param {HTMLElement} button
 * @param {boolean} done
 */
export function flash(button, done) {
  button.dataset.flash = done ? "copied" : "not copied";
  setTimeout(() => delete button.dataset.flash, 1200);
}

/**
 * What a button does that copies: it shows whether it was allowed to, and says it aloud.
 * @param {() => string} text
 * @param {(words: string) => void} say
 * @param {string} done what is said then
 * @param {string} [refused]
 * @returns {(event: Event) => Promise<void>}
 */
export function copying(text, say, done, refused = "Copying is not allowed here") {
  return async (event) => {
    const button = /** @type {HTMLElement} */ (event.currentTarget);
    const copied = await copyText(text());
    flash(button, copied);
    say(copied ? done : refused);
  };
}

/**
 * @param {string} summary
 * @param {Record<string, () => HTMLElement[]>} named what makes the tables, by the name of each place; none keeps what is there
 */
export function createDataTables(summary, named) {
  const places = Object.entries(named).map(([name, make]) => ({
    make,
    host: h("div", { class: "plot-table", tabindex: "0", role: "region", "aria-label": name }),
  }));
  const element = h(
    "details",
    { class: "definitions" },
    h("summary", {}, summary),
    ...places.map((place) => place.host),
  );
  function fill() {
    if (!element.open) return;
    for (const { make, host } of places) {
      const tables = make();
      if (tables.length) host.replaceChildren(...tables);
    }
  }
  element.addEventListener("toggle", fill);
  return { element, fill };
}
