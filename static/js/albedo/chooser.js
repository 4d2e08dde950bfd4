/** Which fits stand against the exact albedo: in folds by where they are at home. */

import { createFold } from "../controls/panel.js";
import { createClear } from "../controls/view-panel.js";
import { createChanged } from "../page/changed.js";
import { h } from "../page/dom.js";
import { homeOf } from "./answers.js";
import { isMetal } from "./fields.js";
import { fitStyle } from "./style.js";

/** @typedef {import('./answers.js').Fit} Fit */

const HOMES = /** @type {const} */ ({
  outside: "From outside",
  inside: "From inside",
  "metal-n": "Metals",
});

/**
 * @param {object} options
 * @param {() => readonly string[]} options.chosen
 * @param {(ids: string[]) => void} options.onChange
 */
export function createChooser({ chosen, onChange }) {
  const groups = h("div.fit-groups");
  const clear = createClear("Fits", "Clear the fits", onChange);
  const element = h("div.chooser", clear.element, groups);
  /** @type {{home: string, fold: ReturnType<typeof createFold>}[]} */
  let made = [];
  const others = createChanged();
  const moved = createChanged();

  /** @param {readonly Fit[]} fits */
  function build(fits) {
    made = Object.entries(HOMES).map(([home, legend]) => {
      const entries = fits
        .filter(({ domains }) => domains.some((domain) => homeOf(domain) === home))
        .map(({ id, title, note, reference }) => ({
          id,
          title,
          note: `${note}\n${reference}`,
          style: fitStyle(id),
        }));
      return { home, fold: createFold({ legend, entries, chosen, onChange }) };
    });
    groups.replaceChildren(...made.map((m) => m.fold.element));
  }

  return {
    element,
    /** @param {readonly Fit[]} fits @param {readonly string[]} ids @param {string} surface */
    update(fits, ids, surface) {
      if (others(fits)) build(fits);
      clear.update(ids);
      const elsewhere = moved(surface);
      const shown = isMetal(surface) ? "metal-n" : surface;
      for (const { home, fold } of made) {
        fold.update(ids);
        if (elsewhere) fold.element.open = home === shown;
      }
    },
  };
}
