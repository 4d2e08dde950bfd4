/**
 * What a renderer makes of the material: Schlick from one index beside Schlick from an RGB color, both
 * against the spectrum integrated at every angle.
 */

import { angleAxis } from "../curves/reading.js";
import { plain, significant } from "../numbers/format.js";
import { createChanged } from "../page/changed.js";
import { h } from "../page/dom.js";
import { html, render } from "../page/lit.js";
import { anglesOf, createAnglePlot } from "./angles.js";
import { createPanel } from "./panel.js";
import { presetOf } from "./queries.js";

const CHANNELS = /** @type {const} */ ([
  ["red", "R", "--red"],
  ["green", "G", "--green"],
  ["blue", "B", "--blue"],
]);
const HEADINGS = ["largest error against the spectrum", "red", "green", "blue"];
/** @type {Record<string, string>} */
const TITLES = {
  schlick: "Schlick from RGB F₀",
  f82_tint: "F82-tint",
  exact: "exact from n, k averaged",
};

/** The curves of a model in R, G and B. @param {any} colors @param {string} model */
const curvesOf = (colors, model) =>
  colors.rgb.curves.find((/** @type {any} */ c) => c.model === model);

/** @param {any} colors @param {string} model @param {number[]} x @param {Partial<Trace> & {of?: string, bare?: boolean}} look @returns {Trace[]} */
function channels(colors, model, x, { of, ...look }) {
  const found = curvesOf(colors, model);
  if (!found) return [];
  return CHANNELS.map(([key, letter, color]) => ({
    id: `${model}.R_${key}`,
    label: of ? `${letter}, ${of}` : letter,
    x,
    y: found[`R_${key}`],
    color,
    width: 2.2,
    ...look,
  }));
}

/** @param {any} colors @param {string} model @param {string} title */
function errorRow(colors, model, title) {
  const found = curvesOf(colors, model);
  if (!found?.errors) return null;
  const cells = CHANNELS.map(([key]) => {
    const { error_at_max, max_abs_at_deg } = found.errors[key];
    if (error_at_max === null) return "undefined";
    return `${significant(error_at_max, 2)} at\u00a0${max_abs_at_deg.toFixed(0)}°`;
  });
  return html`<tr><th scope="row">${title}</th>${cells.map((cell) => html`<td>${cell}</td>`)}</tr>`;
}

/** @param {any} colors null where one index is all that is known */
const errorTable = (
  colors,
) => html`<div class="rival-scroll" tabindex="0" role="region" aria-label="Largest errors">
  <table class="rivals color-errors" ?hidden=${!colors}>
    <caption class="hidden">Largest errors against the spectrum</caption>
    <thead><tr>${HEADINGS.map((words) => html`<th scope="col">${words}</th>`)}</tr></thead>
    <tbody>${colors && Object.entries(TITLES).map(([model, title]) => errorRow(colors, model, title))}</tbody>
  </table>
</div>`;

/** @param {import('./panel.js').FigureContext} context */
export function createColors(context) {
  const headings = [h("h3"), h("h3", "Three: F₀ in R, G and B")];
  const frames = headings.map(() => h("div.frame"));
  const halves = frames.map((frame, i) => h("div.half", headings[i], h("div.plot-host", frame)));
  const panel = createPanel(context, {
    title: "Two Schlicks against the spectrum",
    name: "two-schlicks",
    frames: halves,
    figures: () => plots.filter((_, i) => traces[i]?.length),
    what: () => "schlick",
    call: "curves?models=",
  });
  const plots = frames.map((frame) => createAnglePlot(context, frame, { name: "Reflectance" }));
  const changed = createChanged();
  /** @type {Trace[][]} */
  let traces = [[], []];
  render(errorTable(null), panel.element);

  return {
    ...panel,
    /** @param {State} state @param {Record<string, any>} answers */
    update(state, answers) {
      const preset = presetOf(context.catalog, state.preset);
      const spectral = preset?.kind === "spectrum";
      const colors =
        spectral && answers.colors?.material.id === state.preset ? answers.colors : null;
      const index = answers.index?.interface.n_t === preset?.n_absolute ? answers.index : null;
      if (!preset || !index || (spectral && !colors)) return;
      if (changed(index, colors, state.angle)) draw(state, preset, index, colors);
      plots.forEach((plot, i) => {
        plot.mark(traces[i] ?? []);
      });
    },
    theme() {
      for (const plot of plots) plot.theme();
    },
    destroy() {
      for (const plot of plots) plot.destroy();
    },
  };

  /** @param {State} state @param {Material} preset @param {any} index @param {any} colors */
  function draw(state, preset, index, colors) {
    const x = anglesOf(index, state);
    const colored = colors && anglesOf(colors, state);
    /** @param {string} model */
    const curve = (model) =>
      index.curves.find((/** @type {any} */ c) => c.model === model && c.quantity === "R")
        ?.values ?? [];
    /** @type {Trace[]} */
    const truth = colors
      ? channels(colors, "spectral", colored, { dash: "solid" })
      : [
          {
            id: "exact",
            label: "exact",
            x,
            y: curve("exact"),
            color: "--R",
            dash: "solid",
            width: 2.6,
          },
        ];
    const single = {
      id: "schlick",
      label: "Schlick",
      x,
      y: curve("schlick"),
      color: "--model-1",
      dash: "dash",
      width: 2.2,
    };
    const three =
      colors && channels(colors, "schlick", colored, { dash: "dash", of: "Schlick", bare: true });
    traces = [[...truth, single], colors ? [...truth, ...three] : []];
    const n = `n = ${plain(preset.n, 6)}`;
    const at = preset.wavelength_nm ? ` at ${plain(preset.wavelength_nm)} nm` : "";
    const absolute = ` in air, ${plain(preset.n_absolute, 6)} in vacuum,`;
    const medium = preset.n_absolute === preset.n ? "" : absolute;
    headings[0]?.replaceChildren(`One float: ${n}${medium}${at}`);
    halves[1]?.toggleAttribute("hidden", !colors);
    const names = [
      `Schlick from ${n} against ${colors ? "the spectrum's R, G and B" : "exact"}: ${preset.name}`,
      `Schlick from RGB F0 against the spectrum's R, G and B: ${preset.name}`,
    ];
    const values = traces.flat().flatMap((t) => t.y.filter((v) => v !== null));
    const least = Math.min(0, Math.floor(10 * Math.min(1, ...values)) / 10);
    const most = Math.ceil(10 * Math.max(1, ...values) - 1e-6) / 10;
    plots.forEach((plot, i) => {
      plot.axes({
        name: names[i] ?? "",
        x: angleAxis(state),
        y: { title: "reflectance", range: [least, most], labels: 24 },
      });
      if (traces[i]?.length) void plot.draw(traces[i] ?? []);
    });
    render(errorTable(colors), panel.element);
    panel.filled(
      colors
        ? `Solid: the spectrum, integrated at every angle, as R, G and B. Dashed: what a shader makes of one index, left, or of a color, right. F₀ is ${colors.rgb.gamut}, ${colors.rgb.illuminant}; no curve is clamped.`
        : "A single index reflects all wavelengths alike: one float says all that is known.",
    );
  }
}
