/** Curves above their errors on one abscissa: two plots that are drawn, marked and saved alike. */

import { createChoice } from "../controls/panel.js";
import { locate, read } from "../curves/reading.js";
import { createChanged } from "../page/changed.js";
import { createDataTables, createExports, h } from "../page/dom.js";
import { createPlot } from "./plot.js";

/**
 * @typedef {{name?: string, x: Axis, y: Axis}} PairAxes
 * @typedef {{traces: Trace[], marks?: Mark[], bands?: Band[], axes: () => PairAxes, read?: Trace[]}} Picture `read` are the
 *   curves whose values stand at the marker, all unless said otherwise
 * @typedef {object} Part
 * @property {Node | string} heading
 * @property {Node[]} [above] between it and the plot
 * @property {Node} [inside] on the plot
 * @property {Node[]} [below]
 * @property {string} what is saved, such as "the curves"
 * @property {string} table name of the plot's table
 * @property {string} name of the plot, until its axes tell another
 * @property {string} filename without ending
 * @property {number} [names] so many curves at most carry their names
 */

const LABELS = 46; // px that both plots keep for the labels of their vertical axes

/**
 * @param {object} options
 * @param {HTMLElement} options.parent in the document, because plots read colors and sizes from it
 * @param {string} options.className
 * @param {string} options.label
 * @param {Part} options.upper
 * @param {Part} options.lower
 * @param {string} options.summary of the tables
 * @param {OnPick} options.onPick
 * @param {(value: string | undefined) => void} options.onKind how the error is to be shown
 * @param {[string, string]} options.notes what it is, absolute and relative
 * @param {{value: string, label: string, note: string}[]} [options.more] other ways to show it
 * @param {{call: string, behind: () => Behind}} options.print
 * @param {(name: string, blob: Blob) => void} options.save
 */
export function createPair({
  parent,
  className,
  label,
  upper,
  lower,
  summary,
  onPick,
  onKind,
  notes,
  more = [],
  print,
  save,
}) {
  const kind = createChoice({
    legend: "Error",
    items: [
      { value: "signed", label: "absolute", note: notes[0] },
      { value: "relative", label: "relative", note: notes[1] },
      ...more,
    ],
    onChange: ([value]) => onKind(value),
  });
  kind.element.classList.add("unnamed");
  /** @param {Part} part @param {"upper" | "lower"} place */
  function made({ heading, above = [], inside, below = [], what, filename }, place) {
    const host = h("div", { class: `plot-host ${place}` }, inside);
    const exports = createExports({
      what,
      name: () => filename,
      make: (format) => plots[place].exportAs(format),
      print: { figures: () => [plots[place]], ...print },
      save,
    });
    const line =
      place === "upper"
        ? h("div.heading", h("h2", heading), exports)
        : h("div.heading.error-heading", h("h2", heading), kind.element, exports);
    return { host, nodes: [line, ...above, host, ...below] };
  }
  const parts = { upper: made(upper, "upper"), lower: made(lower, "lower") };
  const tables = createDataTables(summary, {
    [upper.table]: () => (settled ? [plots.upper.table()] : []),
    [lower.table]: () => (settled ? [plots.lower.table()] : []),
  });
  parent.append(
    h(
      "section",
      { class: `column pair ${className}`, "aria-label": label },
      ...parts.upper.nodes,
      ...parts.lower.nodes,
      tables.element,
    ),
  );
  /** @param {HTMLElement} host @param {Part} part */
  const plotOf = (host, { name, filename, names }) =>
    createPlot(host, { name, filename, names, x: { title: "" }, y: { title: "" }, onPick });
  const plots = {
    upper: plotOf(parts.upper.host, upper),
    lower: plotOf(parts.lower.host, lower),
  };
  const places = /** @type {const} */ (["upper", "lower"]);

  let settled = false;
  let look = "";
  /** @type {Record<"upper" | "lower", Picture> | null} */
  let shown = null;
  const changed = createChanged();

  return {
    kind,
    hosts: { upper: parts.upper.host, lower: parts.lower.host },
    /**
     * @param {string} next what is shown besides the numbers; the axes stay while it does and something moves
     * @param {unknown[]} sources what the numbers are made from
     * @param {boolean} moving
     * @param {() => Record<"upper" | "lower", Picture>} make
     * @returns {boolean} whether there was anything to draw
     */
    draw(next, sources, moving, make) {
      if (!changed(next, ...sources) && (settled || moving)) return false;
      shown = make();
      for (const place of places) {
        const { traces, marks, bands, axes } = shown[place];
        const plot = plots[place];
        if (moving && next === look) plot.fast(traces, marks);
        else {
          const { y, ...others } = axes();
          plot.axes({ ...others, y: { ...y, labels: LABELS } });
          void plot.draw(traces, marks, bands);
        }
      }
      look = next;
      settled = !moving;
      tables.fill();
      return true;
    },
    /** @param {number | null} x where the curves are read */
    marker(x) {
      for (const place of places) {
        const { traces = [], read: own = traces } = shown?.[place] ?? {};
        plots[place].marker(
          x,
          own.map((t) => ({ id: t.id, y: x === null ? null : read(t.y, locate(t.x, x)) })),
        );
      }
    },
    theme() {
      for (const place of places) plots[place].theme();
    },
    destroy() {
      for (const place of places) plots[place].destroy();
    },
  };
}
