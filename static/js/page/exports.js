/** What can be taken away: a figure as PNG, SVG and CSV or made for print, text by copying, curves as tables. */

import { h } from "./dom.js";

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

/** @param {ExportsOptions} options */
export function createExports({ what, name, make, save, print }) {
  /** @param {'png' | 'svg' | 'csv'} kind */
  async function take(kind) {
    saveEach(save, [await make(kind)].flat(), (part) => `${name()}${part}.${kind}`);
  }
  return h(
    "p.exports",
    .../** @type {const} */ (["png", "svg", "csv"]).map((kind) =>
      h(
        "button.quiet",
        {
          type: "button",
          "aria-label": `Save ${what} as ${kind.toUpperCase()}`,
          onclick: () => take(kind),
        },
        kind.toUpperCase(),
      ),
    ),
    print &&
      h(
        "button.quiet",
        {
          type: "button",
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
    host: h("div.plot-table", { tabindex: "0", role: "region", "aria-label": name }),
  }));
  const element = h(
    "details.definitions",
    h("summary", summary),
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
