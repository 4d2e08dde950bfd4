/** R over the angle at wavelengths of choice: Shirley's figure of copper, for any material. */

import { locate, read } from "../curves/reading.js";
import { axesOf } from "../curves/traces.js";
import { wavelengthColor, wavelengthDash, wavelengthProperty } from "../media/wavelength-color.js";
import { inDegrees, inUnit, plain } from "../numbers/format.js";
import { h, setText } from "../page/dom.js";
import { createPlot } from "../plot/plot.js";
import { LinkError } from "../state/state.js";
import { SHIRLEY_NM, wavelengths } from "./fields.js";
import { createPanel } from "./panel.js";

/** The angle's axis as Explore shows it. @param {State} state */
export function angleAxis({ angle }) {
  return axesOf({ angle, show: [], polarization: "unpolarized", models: [], marks: false }).x;
}

/**
 * @param {object} options
 * @param {HTMLElement} options.parent in the document
 * @param {Actions} options.actions
 * @param {(name: string, blob: Blob) => void} options.save
 */
export function createAngles({ parent, actions, save }) {
  const field = wavelengths();
  const wrong = h("p", { class: "row-error", id: "nm-error", role: "alert" });
  const box = h("input", {
    class: "box nm",
    type: "text",
    id: "nm",
    autocomplete: "off",
    spellcheck: "false",
    "aria-describedby": "nm-error",
  });
  box.addEventListener("change", () => {
    const text = box.value.trim();
    try {
      setText(wrong, "");
      actions.set({ nm: text === "" ? null : field.parse(text) });
    } catch (problem) {
      if (!(problem instanceof LinkError)) throw problem;
      setText(wrong, `“${text}”: ${problem.message}.`);
    }
  });
  const host = h("div", { class: "frame" });
  /** @type {State | null} */
  let now = null;
  const panel = createPanel({
    parent,
    title: "Over the angle, at wavelengths",
    name: "angles",
    controls: [
      h(
        "span",
        { class: "nm-row" },
        h("label", { for: "nm" }, "at λ ="),
        box,
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
      wrong,
    ],
    hosts: [h("div", { class: "plot-host" }, host)],
    figures: () => [plot],
    filename: () => `${now?.preset ?? "material"}-R-theta`,
    call: "rgb=false",
    presets: () => (now ? [now.preset] : []),
    save,
  });
  const plot = createPlot(host, {
    name: "Reflectance over the angle at several wavelengths",
    x: angleAxis({ angle: "deg" }),
    y: { title: "reflectance", range: [0, 1] },
    names: 6,
    onPick(x, { settled }) {
      const deg = inDegrees(x, now?.angle ?? "deg");
      actions.set({ theta_i_deg: Number(deg.toFixed(2)) }, { history: "replace" });
      if (settled) actions.settle();
    },
  });
  let drawn = "";
  /** @type {any} */
  let source = null;
  /** @type {Trace[]} */
  let traces = [];

  function colors() {
    const dark = document.documentElement.dataset.theme === "dark";
    for (const { wavelength_nm } of source?.wavelengths ?? [])
      panel.element.style.setProperty(
        wavelengthProperty(wavelength_nm),
        wavelengthColor(wavelength_nm, dark),
      );
  }

  return {
    panel,
    /** @param {State} state @param {any} answer */
    update(state, answer) {
      now = state;
      if (document.activeElement !== box) {
        const shown =
          state.nm ??
          (answer ? answer.wavelengths.map((/** @type {any} */ w) => w.wavelength_nm) : SHIRLEY_NM);
        box.value = shown.map((/** @type {number} */ v) => plain(v, 8)).join(", ");
      }
      if (answer?.material.id !== state.preset) return;
      if (answer !== source || drawn !== state.angle) {
        source = answer;
        drawn = state.angle;
        const x = answer.theta_i_deg.map((/** @type {number} */ d) => inUnit(d, state.angle));
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
        panel.fill();
      }
      const at = inUnit(state.theta_i_deg, state.angle);
      plot.marker(
        at,
        traces.map((t) => ({ id: t.id, y: read(t.y, locate(t.x, at)) })),
      );
    },
    theme() {
      colors();
      plot.theme();
    },
    destroy: () => plot.destroy(),
  };
}
