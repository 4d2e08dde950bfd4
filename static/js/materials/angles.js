/** R over the angle at wavelengths of choice: Shirley's figure of copper, for any material. */

import { createTyped } from "../controls/typed.js";
import { angleAxis, pointsAt } from "../curves/reading.js";
import { wavelengthColor, wavelengthDash, wavelengthProperty } from "../media/wavelength.js";
import { inDegrees, inUnit, plain } from "../numbers/format.js";
import { createChanged } from "../page/changed.js";
import { h } from "../page/dom.js";
import { createPlot } from "../plot/plot.js";
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
  const { parse } = wavelengths();
  const typed = createTyped({
    attributes: { class: "box nm", id: "nm" },
    id: "nm-error",
    parse: (text) => (text === "" ? null : parse(text)),
    onChange: (nm) => actions.set({ nm }),
    words: (text, why) => `“${text}”: ${why}.`,
  });
  const frame = h("div.frame");
  const panel = createPanel(context, {
    title: "Over the angle, at wavelengths",
    name: "angles",
    controls: [
      h(
        "span.nm-row",
        h("label", { for: "nm" }, "at λ ="),
        typed.box,
        h("span.unit", "nm"),
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
      typed.wrong,
    ],
    frames: [h("div.plot-host", frame)],
    figures: () => [plot],
    what: () => "R-theta",
    call: "rgb=false",
  });
  const plot = createAnglePlot(context, frame, {
    name: "Reflectance over the angle at several wavelengths",
    names: 6,
  });
  const changed = createChanged();
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
      typed.update(shown.map((/** @type {number} */ v) => plain(v, 8)).join(", "));
      if (answer?.material.id !== state.preset) return;
      if (changed(answer, state.angle)) {
        source = answer;
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
