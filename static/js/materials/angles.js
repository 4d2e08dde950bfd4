/** R over the angle at wavelengths of choice: Shirley's figure of copper, for any material. */

import { angleAxis, pointsAt } from "../curves/reading.js";
import { wavelengthColor, wavelengthDash, wavelengthProperty } from "../media/wavelength.js";
import { inDegrees, inUnit, plain } from "../numbers/format.js";
import { h } from "../page/dom.js";
import { createPlot } from "../plot/plot.js";
import { createBox } from "./box.js";
import { SHIRLEY_NM, wavelengths } from "./fields.js";
import { createPanel } from "./panel.js";

/** What an answer's angles are on that axis. @param {{theta_i_deg: number[]}} answer @param {State} state */
export const anglesOf = ({ theta_i_deg }, { angle }) => theta_i_deg.map((d) => inUnit(d, angle));

/**
 * A plot over the angle of incidence, which is read where the page's angle is and sets it.
 * @param {import('./panel.js').FigureContext} context
 * @param {HTMLElement} frame
 * @param {{name: string, names?: number}} options
 */
export function createAnglePlot({ actions, now }, frame, options) {
  const plot = createPlot(frame, {
    ...options,
    x: angleAxis({ angle: "deg" }),
    y: { title: "reflectance", range: [0, 1] },
    onPick(x, { settled }) {
      const deg = inDegrees(x, now().angle);
      actions.set({ theta_i_deg: Number(deg.toFixed(2)) }, { history: "replace" });
      if (settled) actions.settle();
    },
  });
  return {
    ...plot,
    /** @param {readonly Trace[]} traces */
    mark(traces) {
      const { theta_i_deg, angle } = now();
      const at = inUnit(theta_i_deg, angle);
      plot.marker(at, pointsAt(traces, at));
    },
  };
}

/** @param {import('./panel.js').FigureContext} context */
export function createAngles(context) {
  const { actions } = context;
  const box = createBox({
    id: "nm",
    parse: wavelengths().parse,
    onValue: (nm) => actions.set({ nm }),
  });
  const frame = h("div", { class: "frame" });
  const panel = createPanel(context, {
    title: "Over the angle, at wavelengths",
    name: "angles",
    controls: [
      h(
        "span",
        { class: "nm-row" },
        h("label", { for: "nm" }, "at λ ="),
        box.input,
        h("span", { class: "unit" }, "nm"),
        h(
          "button",
          {
            type: "button",
            class: "quiet",
            title: "the wavelengths of Shirley's figure of copper",
            onclick: () => actions.set({ nm: null }),
          },
          "400 … 800",
        ),
      ),
      box.error,
    ],
    frames: [h("div", { class: "plot-host" }, frame)],
    figures: () => [plot],
    what: () => "R-theta",
    call: "rgb=false",
  });
  const plot = createAnglePlot(context, frame, {
    name: "Reflectance over the angle at several wavelengths",
    names: 6,
  });
  let drawn = "";
  /** @type {any} */
  let source = null;
  /** @type {Trace[]} */
  let traces = [];

  function colors() {
    const dark = document.documentElement.dataset.theme === "dark";
    for (const { wavelength_nm: nm } of source?.wavelengths ?? [])
      panel.element.style.setProperty(wavelengthProperty(nm), wavelengthColor(nm, dark));
  }

  return {
    ...panel,
    /** @param {State} state @param {any} answer */
    update(state, answer) {
      const shown =
        state.nm ??
        answer?.wavelengths.map((/** @type {any} */ w) => w.wavelength_nm) ??
        SHIRLEY_NM;
      box.update(shown.map((/** @type {number} */ v) => plain(v, 8)).join(", "));
      if (answer?.material.id !== state.preset) return;
      if (answer !== source || drawn !== state.angle) {
        source = answer;
        drawn = state.angle;
        const x = anglesOf(answer, state);
        traces = answer.wavelengths.map(
          (/** @type {any} */ { wavelength_nm, R }, /** @type {number} */ index) => ({
            id: `R_${wavelength_nm}nm`,
            label: `${plain(wavelength_nm)} nm`,
            x,
            y: R,
            color: wavelengthProperty(wavelength_nm),
            dash: wavelengthDash(index),
            width: 2.1,
          }),
        );
        colors();
        plot.axes({
          name: `Reflectance of ${answer.material.name} over the angle of incidence at ${traces.length} wavelengths`,
          x: angleAxis(state),
        });
        void plot.draw(traces);
        panel.filled("");
      }
      plot.mark(traces);
    },
    theme() {
      colors();
      panel.theme();
    },
  };
}
