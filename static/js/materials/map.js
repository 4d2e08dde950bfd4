/** Reflectance over angle and wavelength. */

import { createChoice } from "../controls/panel.js";
import { inDegrees, inUnit, significant } from "../numbers/format.js";
import { h } from "../page/dom.js";
import { createHeatmap } from "../plot/heatmap.js";
import { angleAxis } from "./angles.js";
import { createPanel } from "./panel.js";

const NAMES = /** @type {Record<string, string>} */ ({ R: "R", Rs: "Rₛ", Rp: "Rₚ" });

/**
 * @param {object} options
 * @param {HTMLElement} options.parent in the document
 * @param {Pick<Actions, 'set'>} options.actions
 * @param {(name: string, blob: Blob) => void} options.save
 */
export function createMap({ parent, actions, save }) {
  const quantity = createChoice({
    legend: "Polarization",
    items: [
      { value: "R", label: "unpolarized" },
      { value: "Rs", label: "s" },
      { value: "Rp", label: "p" },
    ],
    onChange: ([value]) => actions.set({ map_of: value }),
  });
  const host = h("div", { class: "frame" });
  /** @type {State | null} */
  let now = null;
  const panel = createPanel({
    parent,
    title: "Over angle and wavelength",
    name: "lambda-map",
    controls: [quantity.element],
    hosts: [h("div", { class: "plot-host" }, host)],
    figures: () => [map],
    filename: () => `${now?.preset ?? "material"}-theta-lambda`,
    call: "/map",
    presets: () => (now ? [now.preset] : []),
    save,
  });
  const map = createHeatmap(host, {
    name: "Reflectance over angle and wavelength",
    x: angleAxis({ angle: "deg" }),
    y: { title: "wavelength λ (nm)", range: [380, 780] },
    z: { title: "R", kind: "size", print: (v) => significant(v, 4), range: [0, 1] },
    onPick(x, y) {
      actions.set({
        theta_i_deg: Number(inDegrees(x, now?.angle ?? "deg").toFixed(4)),
        at_nm: y,
      });
    },
  });
  let drawn = "";
  /** @type {unknown} */
  let source = null;
  return {
    panel,
    /** @param {State} state @param {any} answer @param {number | null} at */
    update(state, answer, at) {
      now = state;
      quantity.update([state.map_of]);
      if (answer?.material.id !== state.preset || answer.quantity !== state.map_of) return;
      if (answer !== source || drawn !== state.angle) {
        source = answer;
        drawn = state.angle;
        const sign = NAMES[answer.quantity] ?? "R";
        const wavelengths = /** @type {number[]} */ (answer.wavelength_nm);
        void map.draw(
          {
            x: answer.theta_i_deg.map((/** @type {number} */ d) => inUnit(d, state.angle)),
            y: wavelengths,
            z: answer.values,
          },
          {
            name: `${sign} of ${answer.material.name} over angle and wavelength`,
            x: { ...angleAxis(state), short: "θᵢ" },
            y: {
              title: "wavelength λ (nm)",
              short: "λ",
              column: "wavelength_nm",
              unit: " nm",
              range: [wavelengths[0] ?? 380, wavelengths.at(-1) ?? 780],
            },
            z: { title: sign, kind: "size", print: (v) => significant(v, 4), range: [0, 1] },
          },
        );
        panel.fill();
        panel.note("Click to go to an angle and a wavelength.");
      }
      map.marker(inUnit(state.theta_i_deg, state.angle), at ?? Number.NaN);
    },
    theme: () => map.theme(),
    destroy: () => map.destroy(),
  };
}
