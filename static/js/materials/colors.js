/**
 * What a renderer makes of the material: Schlick from one index beside Schlick from an RGB color, both
 * against the spectrum integrated at every angle.
 */

import { locate, read } from "../curves/reading.js";
import { inDegrees, inUnit, plain, significant } from "../numbers/format.js";
import { h } from "../page/dom.js";
import { createPlot } from "../plot/plot.js";
import { angleAxis } from "./angles.js";
import { createPanel } from "./panel.js";
import { presetOf } from "./queries.js";

const CHANNELS = /** @type {const} */ ([
  ["red", "R", "--red"],
  ["green", "G", "--green"],
  ["blue", "B", "--blue"],
]);
/** @type {Record<string, string>} */
const TITLES = {
  schlick: "Schlick from RGB F₀",
  f82_tint: "F82-tint",
  exact: "exact from n, k averaged",
};

/**
 * @param {object} options
 * @param {HTMLElement} options.parent in the document
 * @param {Catalog} options.catalog
 * @param {Actions} options.actions
 * @param {(name: string, blob: Blob) => void} options.save
 */
export function createColors({ parent, catalog, actions, save }) {
  /** @type {State | null} */
  let now = null;
  const headings = [h("h3", {}), h("h3", {})];
  const frames = [h("div", { class: "frame" }), h("div", { class: "frame" })];
  const errors = h("tbody", {});
  const errorTable = h(
    "table",
    { class: "rivals color-errors" },
    h("caption", { class: "hidden" }, "Largest errors against the spectrum"),
    h(
      "thead",
      {},
      h(
        "tr",
        {},
        ...["largest error against the spectrum", "red", "green", "blue"].map((t) =>
          h("th", { scope: "col" }, t),
        ),
      ),
    ),
    errors,
  );
  const panel = createPanel({
    parent,
    title: "Two Schlicks against the spectrum",
    name: "two-schlicks",
    hosts: frames.map((frame, i) =>
      h("div", { class: "half" }, headings[i], h("div", { class: "plot-host" }, frame)),
    ),
    figures: () => plots.filter((_, i) => traces[i]?.length),
    filename: () => `${now?.preset ?? "material"}-schlick`,
    call: "curves?models=",
    presets: () => (now ? [now.preset] : []),
    save,
  });
  panel.element.append(
    h(
      "div",
      { class: "rival-scroll", tabindex: "0", role: "region", "aria-label": "Largest errors" },
      errorTable,
    ),
  );
  /** @param {number} x @param {{settled: boolean}} how */
  const onPick = (x, { settled }) => {
    const deg = inDegrees(x, now?.angle ?? "deg");
    actions.set({ theta_i_deg: Number(deg.toFixed(2)) }, { history: "replace" });
    if (settled) actions.settle();
  };
  const plots = frames.map((frame) =>
    createPlot(frame, {
      name: "Reflectance",
      x: angleAxis({ angle: "deg" }),
      y: { title: "reflectance", range: [0, 1] },
      onPick,
    }),
  );
  /** @type {unknown[]} */
  let drawn = [];
  /** @type {Trace[][]} */
  let traces = [[], []];

  /** @param {any} colors @param {string} model @param {number[]} x @param {{dash: string, width: number, of: string, bare: boolean}} how @returns {Trace[]} */
  function channels(colors, model, x, { dash, width, of, bare }) {
    const found = colors?.rgb?.curves.find((/** @type {any} */ c) => c.model === model);
    if (!found) return [];
    return CHANNELS.map(([key, letter, color]) => ({
      id: `${model}.R_${key}`,
      label: of ? `${letter}, ${of}` : letter,
      bare,
      x,
      y: found[`R_${key}`],
      color,
      dash,
      width,
    }));
  }

  return {
    panel,
    /** @param {State} state @param {Record<string, any>} answers */
    update(state, answers) {
      now = state;
      const preset = presetOf(catalog, state.preset);
      const spectral = preset?.kind === "spectrum";
      const colors =
        spectral && answers.colors?.material.id === state.preset ? answers.colors : null;
      const index = answers.index?.interface.n_t === preset?.n ? answers.index : null;
      if (!preset || !index || (spectral && !colors)) return;
      const sources = [index, colors, state.angle];
      if (sources.some((s, i) => s !== drawn[i])) {
        drawn = sources;
        draw(state, preset, index, colors);
      }
      const at = inUnit(state.theta_i_deg, state.angle);
      plots.forEach((plot, i) => {
        plot.marker(
          at,
          (traces[i] ?? []).map((t) => ({ id: t.id, y: read(t.y, locate(t.x, at)) })),
        );
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
    /** @param {{theta_i_deg: number[]}} answer */
    const xOf = (answer) => answer.theta_i_deg.map((d) => inUnit(d, state.angle));
    /** @param {string} model */
    const curve = (model) =>
      index.curves.find((/** @type {any} */ c) => c.model === model && c.quantity === "R")
        ?.values ?? [];
    const x = xOf(index);
    const truth = colors
      ? channels(colors, "spectral", xOf(colors), {
          dash: "solid",
          width: 2.2,
          of: "",
          bare: false,
        })
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
    traces = [
      [...truth, single],
      colors
        ? [
            ...truth,
            ...channels(colors, "schlick", xOf(colors), {
              dash: "dash",
              width: 2.2,
              of: "Schlick",
              bare: true,
            }),
          ]
        : [],
    ];
    const at = preset.wavelength_nm ? ` at ${plain(preset.wavelength_nm)} nm` : "";
    headings[0]?.replaceChildren(`One float: n = ${plain(preset.n, 6)}${at}`);
    headings[1]?.replaceChildren("Three: F₀ in R, G and B");
    const half = frames[1]?.closest(".half");
    if (half instanceof HTMLElement) half.hidden = !colors;
    const names = [
      `Schlick from n = ${plain(preset.n, 6)} against ${colors ? "the spectrum's R, G and B" : "exact"}: ${preset.name}`,
      `Schlick from RGB F0 against the spectrum's R, G and B: ${preset.name}`,
    ];
    const least = Math.min(1, ...traces.flat().flatMap((t) => t.y.filter((v) => v !== null)));
    const most = Math.max(1, ...traces.flat().flatMap((t) => t.y.filter((v) => v !== null)));
    const range = [Math.min(0, Math.floor(10 * least) / 10), Math.ceil(10 * most - 1e-6) / 10];
    plots.forEach((plot, i) => {
      plot.axes({
        name: names[i] ?? "",
        x: angleAxis(state),
        y: { title: "reflectance", range, labels: 24 },
      });
      if (traces[i]?.length) void plot.draw(traces[i] ?? []);
    });
    panel.fill();
    errorTable.hidden = !colors;
    if (colors)
      errors.replaceChildren(
        ...Object.entries(TITLES).flatMap(([model, title]) => {
          const found = colors.rgb.curves.find((/** @type {any} */ c) => c.model === model);
          if (!found?.errors) return [];
          return [
            h(
              "tr",
              {},
              h("th", { scope: "row" }, title),
              ...CHANNELS.map(([key]) => {
                const { error_at_max, max_abs_at_deg } = found.errors[key];
                return h(
                  "td",
                  {},
                  error_at_max === null
                    ? "undefined"
                    : `${significant(error_at_max, 2)} at ${max_abs_at_deg.toFixed(0)}°`,
                );
              }),
            ),
          ];
        }),
      );
    const policy = colors
      ? ` F₀ is ${colors.rgb.gamut}, ${colors.rgb.illuminant}; no curve is clamped.`
      : "";
    panel.note(
      colors
        ? `Solid: the spectrum, integrated at every angle, as R, G and B. Dashed: what a shader makes of one index, left, or of a color, right.${policy}`
        : "A single index reflects all wavelengths alike: one float says all that is known.",
    );
  }
}
