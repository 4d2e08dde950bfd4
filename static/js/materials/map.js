/** Reflectance over angle and wavelength. */

import { createChoices } from "../controls/panel.js";
import { angleAxis } from "../curves/reading.js";
import { inDegrees, inUnit, significant } from "../numbers/format.js";
import { createChanged } from "../page/changed.js";
import { h } from "../page/dom.js";
import { createHeatmap } from "../plot/heatmap.js";
import { anglesOf } from "./angles.js";
import { createPanel } from "./panel.js";

const NAMES = /** @type {Record<string, string>} */ ({ R: "R", Rs: "Rₛ", Rp: "Rₚ" });

/** @param {string} title @returns {MapValues} */
const scale = (title) => ({
  title,
  kind: "size",
  print: (v) => significant(v, 4),
  range: [0, 1],
});

/** @param {import('./panel.js').FigureContext} context */
export function createMap(context) {
  const { actions, now } = context;
  const choices = createChoices(actions, {
    map_of: ["Polarization", { R: "unpolarized", Rs: "s", Rp: "p" }],
  });
  const frame = h("div.frame");
  const panel = createPanel(context, {
    title: "Over angle and wavelength",
    name: "lambda-map",
    controls: [choices.elements.map_of],
    frames: [h("div.plot-host", frame)],
    figures: () => [map],
    what: () => "theta-lambda",
    call: "/map",
  });
  const map = createHeatmap(frame, {
    name: "Reflectance over angle and wavelength",
    x: angleAxis({ angle: "deg" }),
    y: { title: "wavelength λ (nm)", range: [380, 780] },
    z: scale("R"),
    onPick(x, y) {
      const theta_i_deg = Number(inDegrees(x, now().angle).toFixed(4));
      actions.set({ theta_i_deg, at_nm: y });
    },
  });
  const changed = createChanged();
  return {
    ...panel,
    /** @param {State} state @param {any} answer @param {number | null} at */
    update(state, answer, at) {
      choices.update(state);
      if (answer?.material.id !== state.preset || answer.quantity !== state.map_of) return;
      if (changed(answer, state.angle)) {
        const sign = NAMES[answer.quantity] ?? "R";
        const wavelengths = /** @type {number[]} */ (answer.wavelength_nm);
        void map.draw(
          { x: anglesOf(answer, state), y: wavelengths, z: answer.values },
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
            z: scale(sign),
          },
        );
        panel.filled("Click to go to an angle and a wavelength.");
      }
      map.marker(inUnit(state.theta_i_deg, state.angle), at ?? Number.NaN);
    },
  };
}
