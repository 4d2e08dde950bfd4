/** Lookup tables to take away, and how large one has to be: only its size and depth make errors. */

import { createChoices } from "../controls/panel.js";
import { createSelect } from "../controls/select.js";
import { plain } from "../numbers/format.js";
import { createChanged } from "../page/changed.js";
import { h, setText } from "../page/dom.js";
import { html, render } from "../page/lit.js";
import { loadStyles } from "../page/style.js";
import { sayProblem } from "../page/trouble.js";
import { createPlot } from "../plot/plot.js";
import { codeOf, DEPTHS, lutPath, pickedSize, rgbLutPath, SIZES, titlesOf } from "./fields.js";

await loadStyles("tables");

const LOOKS = [
  { color: "--R", dash: "dot" },
  { color: "--R", dash: "dash" },
  { color: "--R", dash: "solid" },
];
const SUPERSCRIPT = "⁰¹²³⁴⁵⁶⁷⁸⁹";
/** The errors' decades. */
const DECADES = [0, -1, -2, -3, -4, -5, -6, -7, -8];
const Y_TICKS = {
  values: DECADES,
  text: DECADES.map((power) => (power === 0 ? "1" : `10⁻${SUPERSCRIPT[-power]}`)),
};

/** @param {number | null | undefined} error @returns {number | null} its place on the axis */
const decades = (error) => (error ? Math.log10(error) : null);
/** @param {number} value */
const scientific = (value) =>
  value >= 0.001 ? plain(value, 3) : value.toExponential(2).replace("-", "−");

/**
 * @param {object} options
 * @param {HTMLElement} options.parent in the document, because plots read colors and sizes from it
 * @param {Catalog} options.catalog
 * @param {Actions} options.actions
 */
export function createTables({ parent, catalog, actions }) {
  const { models } = catalog;
  const model = createSelect("Model that is tabulated", (code) => actions.set({ code }));
  const size = createSelect(
    "Texels of the table",
    (value) => actions.set({ table_size: value }),
    Object.fromEntries(SIZES.map((n) => [n, `${n} texels`])),
  );
  const choices = createChoices(actions, {
    bits: ["Depth", Object.fromEntries(DEPTHS.map(({ bits, label }) => [bits, label]))],
  });
  const host = h("div.table-plot");
  const element = h("section.column.tables", { "aria-label": "Lookup table" });
  const verdict = h("p.table-verdict", { role: "status" });

  /** @param {string} wrong @param {{label: string, path: string}[]} files */
  function show(wrong, files) {
    for (const part of [host, verdict]) part.hidden = wrong !== "";
    render(
      html`<div class="heading"><h2>Lookup table</h2></div>
        <div class="table-controls">${model.element}${size.element}${choices.elements.bits}</div>
        <p class="row-error" role="status">${wrong}</p>
        ${host}${verdict}
        <p class="table-files" ?hidden=${wrong !== ""}>${files.map(
          ({ label, path }) => html`<a class="quiet" href="api/v1${path}" download="">${label}</a>`,
        )}</p>
        <p class="hint">R over cos θᵢ. Read it at (cos θᵢ (N − 1) + ½) / N with linear filtering: the ends are the centers of the outer texels.</p>`,
      element,
    );
  }
  show("", []);
  parent.append(element);

  const plot = createPlot(host, {
    name: "Largest interpolation error against the table's size",
    x: {
      title: "texels N",
      short: "N",
      column: "texels",
      scale: "log",
      range: [2, 4096],
      ticks: { values: SIZES, text: SIZES.map(String) },
      steps: { step: 1, fine: 1, page: 1 },
    },
    y: { title: "largest error", range: [-8, 0], ticks: Y_TICKS },
    filename: "fresnel-table-error",
    onPick(x, { settled }) {
      if (settled) actions.set({ table_size: pickedSize(x, texels) });
    },
  });

  /** @param {State} now @param {string} id @param {string[]} formats that hold the curve */
  function filesOf(now, id, formats) {
    const parts = [`size=${now.table_size}`, `bits=${now.bits}`];
    const color = rgbLutPath(now, catalog, id, [`size=${now.table_size}`, "format=exr"]);
    return [
      ...formats.map((f) => ({
        label: f.toUpperCase(),
        path: lutPath(now, catalog, id, "/lut", [...parts, `format=${f}`]),
      })),
      ...(color ? [{ label: "RGB as EXR", path: color }] : []),
    ];
  }

  const changed = createChanged();
  /** @type {ReturnType<typeof filesOf>} */
  let files = [];
  let texels = 0;
  return {
    element,
    /**
     * @param {State} now
     * @param {readonly string[]} offered ids of the models to choose among
     * @param {any} answer of /lut/errors
     * @param {import('../page/trouble.js').Problem | undefined} problem
     */
    update(now, offered, answer, problem) {
      const id = codeOf(now, offered);
      model.update(id, titlesOf(models, offered));
      size.update(now.table_size);
      texels = Number(now.table_size);
      choices.update(now);
      const depth = DEPTHS.find((d) => d.bits === now.bits);
      if (answer && depth && !problem) {
        draw(answer);
        /** @param {string} name */
        const errorOf = (name) => answer.max_abs[name][answer.sizes.indexOf(texels)];
        plot.marker(
          texels,
          DEPTHS.map((d) => ({ id: d.depth, y: decades(errorOf(d.depth)) })),
        );
        const error = errorOf(depth.depth);
        setText(
          verdict,
          error === null
            ? "Integers hold 0 to 1, and this curve goes beyond: take floats."
            : `${now.table_size} texels, ${depth.label}: at no angle off by more than ${scientific(error)}.`,
        );
        files = filesOf(now, id, error === null ? [] : depth.formats);
      }
      show(sayProblem(problem), files);
    },
    theme: () => plot.theme(),
    destroy: () => plot.destroy(),
  };

  /** @param {any} answer */
  function draw({ sizes, max_abs }) {
    if (!changed(max_abs)) return;
    void plot.draw(
      DEPTHS.map(({ depth, label }, i) => ({
        id: depth,
        label,
        x: sizes,
        y: max_abs[depth].map(decades),
        width: 2,
        .../** @type {{color: string, dash: string}} */ (LOOKS[i]),
      })),
    );
  }
}
