/** A pane as solar software shortens it: incidence-angle modifiers beside the exact one, and how far they are off. */

import { angleAxis } from "../curves/reading.js";
import { angle, inUnit, percent, plain } from "../numbers/format.js";
import { createChanged } from "../page/changed.js";
import { createDataTables, createExports, h } from "../page/dom.js";
import { html, render } from "../page/lit.js";
import { createPlot } from "../plot/plot.js";

/**
 * @typedef {{id: string, title: string, reference: string, values: number[], max_abs: number, max_abs_at_deg: number, max_abs_to_60: number, diffuse: number}} Modifier
 * @typedef {{n: number, thickness_mm: number, absorption_per_m: number, theta_i_deg: number[], modifier: number[], diffuse: number, modifiers: Modifier[]}} PaneCurves
 */

const EXACT = { id: "exact", label: "exact", color: "--R", dash: "solid", width: 2.6 };
/** In the order of the answer. */
const LOOKS = [
  { color: "--model-1", dash: "dash" },
  { color: "--model-2", dash: "dashdot" },
  { color: "--model-3", dash: "dot" },
  { color: "--model-4", dash: "longdash" },
];

/** @param {PaneCurves} found @param {string} unit @returns {Trace[]} */
function tracesOf(found, unit) {
  const x = found.theta_i_deg.map((deg) => inUnit(deg, /** @type {any} */ (unit)));
  const others = found.modifiers.map(({ id, title, values }, i) => ({
    id,
    label: title,
    ...LOOKS[i % LOOKS.length],
    width: 1.8,
    x,
    y: values,
  }));
  return /** @type {any} */ ([{ ...EXACT, x, y: found.modifier }, ...others]);
}

/** @param {ViewContext} context */
export function createModifiers({ element: parent, save }) {
  const host = h("div.plot-host");
  const said = h("p.reason");
  const table = h("div.claims-scroll");
  const tables = createDataTables("The modifiers as a table", {
    "Table of the modifiers": () => (drawn ? [plot.table()] : []),
  });
  const exports = createExports({
    what: "the modifiers",
    name: () => "fresnel-pane-modifiers",
    make: (format) => plot.exportAs(format),
    save,
  });
  const element = h(
    "section.column.film-pane",
    { "aria-label": "The pane in solar software", hidden: true },
    h("div.heading", h("h2", "The pane in solar software"), exports),
    said,
    h("div.film-pair", h("div", host, tables.element), table),
  );
  parent.append(element);
  const plot = createPlot(host, {
    name: "Incidence-angle modifiers",
    filename: "fresnel-pane-modifiers",
    names: 5,
    x: { title: "" },
    y: { title: "" },
  });
  const changed = createChanged();
  let drawn = false;

  return {
    /** @param {State} now @param {PaneCurves | undefined} found nothing where there is no pane */
    update(now, found) {
      element.hidden = !found;
      if (!found || !changed(found, now.angle)) return;
      const { n, thickness_mm, absorption_per_m, diffuse, modifiers } = found;
      said.textContent = `The incidence-angle modifier is T over T at normal incidence. Here n = ${plain(n, 5)}, ${plain(thickness_mm, 4)} mm, absorbing ${plain(absorption_per_m, 3)} per meter; the exact pane lets through ${percent(diffuse)} of that in diffuse light.`;
      plot.axes({
        name: "Incidence-angle modifiers",
        x: angleAxis(/** @type {any} */ (now)),
        y: { title: "T(θᵢ) / T(0)", range: [0, 1.05], labels: 40 },
      });
      drawn = true;
      void plot.draw(tracesOf(found, now.angle));
      tables.fill();
      render(
        html`<table class="claims">
          <thead><tr>
            <th scope="col">Modifier</th>
            <th scope="col">Largest error</th>
            <th scope="col">Up to ${angle(60, now.angle, 0)}</th>
            <th scope="col">Diffuse light</th>
          </tr></thead>
          <tbody>${modifiers.map(
            (one) => html`<tr title=${one.reference}>
              <th scope="row">${one.title}</th>
              <td>${plain(one.max_abs, 3)} at ${angle(one.max_abs_at_deg, now.angle, 1)}</td>
              <td>${plain(one.max_abs_to_60, 3)}</td>
              <td>${percent(one.diffuse)}</td>
            </tr>`,
          )}</tbody>
        </table>`,
        table,
      );
    },
    theme: () => plot.theme(),
    destroy: () => plot.destroy(),
  };
}
