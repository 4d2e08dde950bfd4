/** The wavelength of the light, shown where a named medium's indices vary with it. */

import { isDispersive, knownRange, WAVELENGTH } from "../media/media.js";
import { inMicrometers, stretch } from "../media/wavelength.js";
import { clamp, plain } from "../numbers/format.js";
import { h, setText } from "../page/dom.js";
import { createRow } from "./panel.js";

/** @param {WavelengthOptions} options */
export function createWavelength({ materials, actions, prefix = "" }) {
  /** @type {[number, number] | null} */
  let range = null;
  const row = createRow({
    parameter: WAVELENGTH,
    prefix,
    preset: null,
    label: "wavelength, nm",
    range: [380, 780],
    wide: [200, 2500],
    steps: { step: 5, fine: 0.5, page: 50 },
    onChange(value, moving) {
      // Out of range a slider stops at the end of what is known; the box is told so.
      const known = value === null || !moving || !range ? value : clamp(value, ...range);
      actions.set({ wavelength_nm: known }, { history: moving ? "replace" : "push" });
    },
    onSettle: actions.settle,
  });
  const note = h("p.reason");
  const wrong = h("p.row-error", { role: "alert" });
  const element = h("div.wavelength", { hidden: true }, row.element, wrong, note);
  let shown = "";
  return {
    element,
    stop: () => row.stop(),
    /** @param {State} state */
    update(state) {
      const { incident, material, wavelength_nm } = state;
      const now = JSON.stringify([incident, material, wavelength_nm]);
      if (now === shown) return;
      shown = now;
      range = knownRange(materials, state);
      element.hidden = range === null;
      if (!range) return;
      row.update(wavelength_nm);
      const known = range[0] <= range[1] ? `known ${stretch(range)}` : "not known of both media";
      const asked = inMicrometers(wavelength_nm);
      const outside =
        wavelength_nm !== null && (wavelength_nm < range[0] || wavelength_nm > range[1]);
      setText(
        wrong,
        outside
          ? `λ = ${plain(wavelength_nm, 8)}\u00a0nm: ${known}${asked ? `; ${asked}` : "."}`
          : "",
      );
      const own = [material, incident]
        .map((id) => materials.find((m) => m.id === id))
        .find(isDispersive);
      setText(
        note,
        outside ? "" : wavelength_nm === null ? `${own?.wavelength_nm}\u00a0nm; ${known}` : known,
      );
    },
  };
}
