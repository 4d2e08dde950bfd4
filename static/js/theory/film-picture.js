/** A soap film and gold leaf: drawn to scale, with their colors over thickness and angle. */

import { createChoices } from "../controls/panel.js";
import { createDrawing } from "../layers/drawing.js";
import { thicknessText } from "../layers/layers.js";
import { brightening, createMap } from "../layers/map.js";
import { angle, percent } from "../numbers/format.js";
import { h, setText } from "../page/dom.js";
import { FILMS } from "./film-lesson.js";

/** @param {ViewContext} context */
export function createFilmPicture({ actions, state }) {
  /** @param {State} patch @param {boolean} [settled] */
  const set = (patch, settled = false) =>
    actions.set(patch, { history: settled ? "push" : "replace" });
  const choices = createChoices(actions, {
    thin_film: ["Film", { soap: "soap film", gold: "gold leaf, from behind" }],
  });
  const drawing = createDrawing((_, nm) => set({ thin_nm: nm }), actions.settle);
  const map = createMap(
    "Thickness and angle on the map of colors",
    (thin_nm, own_deg, settled) => set({ thin_nm, own_deg }, settled),
    actions.settle,
  );
  const swatch = h("i");
  const said = h("span");
  const element = h(
    "div.film-lesson",
    choices.elements.thin_film,
    drawing.element,
    h("div.film-swatch", swatch, said),
    map.element,
  );

  return {
    element,
    /** @param {State} now @param {number} deg @param {Record<string, any>} answers */
    update(now, deg, answers) {
      const film = FILMS[/** @type {keyof typeof FILMS} */ (now.thin_film)];
      choices.update(now);
      const { map: found, snell, here } = answers;
      const media = { n_i: 1, n_t: 1, k_t: 0, theta_i_deg: deg, angle: state().angle };
      const shown = { ...media, layers: `${film.medium}:${now.thin_nm}`, film_layer: 1 };
      drawing.update(shown, snell?.layers, snell, snell ?? null);
      const [colors] = found?.colors ?? [];
      if (colors && found.media.layers[0]?.medium === film.medium) {
        const factor =
          film.quantity === "T" ? null : brightening(colors.linear_srgb, found.theta_i_deg);
        map.update(shown, now.thin_nm, found, colors, factor);
      }
      const [color] = here?.colors ?? [];
      if (!color || !snell) return;
      swatch.style.background = color.hex[0][0];
      setText(
        said,
        `${thicknessText(now.thin_nm)} of ${film.name} at ${angle(deg, now.angle, 1)}: of yellow light ${percent(snell.R)} is reflected and ${percent(snell.T)} passes; ${film.side} it is ${color.hex[0][0]}.`,
      );
    },
    destroy: drawing.destroy,
  };
}
