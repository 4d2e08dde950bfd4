/** Lookup tables to take away, and how large one has to be: only its size and depth make errors. */

import { createChoice } from "../controls/panel.js";
import { plain } from "../numbers/format.js";
import { h, setText } from "../page/dom.js";
import { loadStyle } from "../page/style.js";
import { createPlot } from "../plot/plot.js";
import { createModelChoice } from "./choice.js";
import { codeOf, DEPTHS, lutPath, pickedSize, rgbLutPath, SIZES } from "./fields.js";

await loadStyle("css/tables.css");

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

/** @param {number} value */
const scientific = (value) =>
  value >= 0.001 ? plain(value, 3) : value.toExponential(2).replace("-", "−");

/**
 * @param {object} options
 * @param {HTMLElement} options.parent in the document, because plots read colours and sizes from it
 * @param {Catalog} options.catalog
 * @param {Pick<Actions, 'set'>} options.actions
 */
export function createTables({ parent, catalog, actions }) {
  const model = createModelChoice({
    models: catalog.models,
    label: "Model that is tabulated",
    actions,
  });
  const size = h(
    "select",
    {
      class: "preset",
      "aria-label": "Texels of the table",
      onchange: () => actions.set({ table_size: size.value }),
    },
    ...SIZES.map((n) => h("option", { value: String(n) }, `${n} texels`)),
  );
  const bits = createChoice({
    legend: "Depth",
    items: DEPTHS.map((d) => ({ value: d.bits, label: d.label })),
    onChange: ([value]) => actions.set({ bits: value }),
  });
  const verdict = h("p", { class: "table-verdict", role: "status" });
  const wrong = h("p", { class: "row-error", role: "status" });
  const files = h("p", { class: "table-files" });
  const host = h("div", { class: "table-plot" });
  const element = h(
    "section",
    { class: "column tables", "aria-label": "Lookup table" },
    h("div", { class: "heading" }, h("h2", {}, "Lookup table")),
    h(
      "div",
      { class: "table-controls" },
      h("span", { class: "picker" }, model.element),
      h("span", { class: "picker" }, size),
      bits.element,
    ),
    wrong,
    host,
    verdict,
    files,
    h(
      "p",
      { class: "hint" },
      "R over cos θᵢ. Read it at (cos θᵢ (N − 1) + ½) / N with linear filtering: the ends are the centers of the outer texels.",
    ),
  );
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
      if (settled) actions.set({ table_size: pickedSize(x, Number(size.value)) });
    },
  });

  /** @param {string} label @param {string} path */
  const file = (label, path) =>
    h("a", { class: "quiet", href: `api/v1${path}`, download: "" }, label);

  /** @type {any} */
  let drawn = null;
  return {
    element,
    /**
     * @param {State} now
     * @param {readonly string[]} offered ids of the models to choose among
     * @param {any} answer of /lut/errors
     * @param {{title: string, lines: string[]} | undefined} problem
     */
    update(now, offered, answer, problem) {
      const id = codeOf(now, offered);
      model.update(now, offered);
      size.value = now.table_size;
      bits.update([now.bits]);
      setText(wrong, problem ? problem.lines.join(" · ") || problem.title : "");
      for (const part of [host, verdict, files]) part.hidden = problem !== undefined;
      if (!answer || problem) return;
      if (answer !== drawn) {
        drawn = answer;
        void plot.draw(
          DEPTHS.map(({ depth, label }, i) => ({
            id: depth,
            label,
            x: answer.sizes,
            y: answer.max_abs[depth].map((/** @type {number | null} */ e) =>
              e === null || e === 0 ? null : Math.log10(e),
            ),
            width: 2,
            .../** @type {{color: string, dash: string}} */ (LOOKS[i]),
          })),
        );
      }
      const at = answer.sizes.indexOf(Number(now.table_size));
      plot.marker(
        Number(now.table_size),
        DEPTHS.map(({ depth }) => {
          const error = answer.max_abs[depth][at];
          return { id: depth, y: error ? Math.log10(error) : null };
        }),
      );
      const depth = DEPTHS.find((d) => d.bits === now.bits);
      if (!depth) return;
      const error = answer.max_abs[depth.depth][at];
      setText(
        verdict,
        error === null
          ? "Integers hold 0 to 1, and this curve goes beyond: take floats."
          : `${now.table_size} texels, ${depth.label}: at no angle off by more than ${scientific(error)}.`,
      );
      const parts = [`size=${now.table_size}`, `bits=${now.bits}`];
      const color = rgbLutPath(now, catalog, id, [`size=${now.table_size}`, "format=exr"]);
      files.replaceChildren(
        ...(error === null
          ? []
          : depth.formats.map((f) =>
              file(f.toUpperCase(), lutPath(now, catalog, id, "/lut", [...parts, `format=${f}`])),
            )),
        ...(color ? [file("RGB as EXR", color)] : []),
      );
    },
    theme: () => plot.theme(),
    destroy: () => plot.destroy(),
  };
}
