/** A legend below the plot, on the page and in a file, for more curves than can carry their names. */

import { runs, svg } from "../draw/svg.js";

const SWATCH = 28;

/**
 * @param {string} label
 */
function labelNode(label) {
  const node = document.createElement("span");
  for (const run of runs(label)) {
    const part = document.createElement(run.sub ? "sub" : "span");
    if (run.italic) part.className = "symbol-run";
    part.textContent = run.text;
    node.append(part);
  }
  return node;
}

/**
 * @param {HTMLElement} list
 * @param {readonly Trace[]} traces
 */
export function drawLegend(list, traces) {
  list.replaceChildren(
    ...traces.map((trace) => {
      const item = document.createElement("li");
      const swatch = svg("svg", { width: SWATCH, height: 12, "aria-hidden": "true" });
      const width = trace.width ?? 2;
      const line = svg(
        "line",
        { x1: 0, x2: SWATCH, y1: 6, y2: 6, stroke: `var(${trace.color})`, "stroke-width": width },
        swatch,
      );
      const dash = dashArray(trace.dash, width);
      if (dash) line.setAttribute("stroke-dasharray", dash);
      item.append(swatch, labelNode(trace.label));
      return item;
    }),
  );
  // What scrolls has to be reached by keys.
  if (list.scrollHeight > list.clientHeight) list.tabIndex = 0;
  else list.removeAttribute("tabindex");
}

/**
 * Plotly's name of a dash as SVG's `stroke-dasharray`, for lines drawn beside a plot.
 * @param {string | undefined} dash
 * @param {number} width of the line in px
 */
export function dashArray(dash, width) {
  const unit = Math.max(width, 3);
  /** @type {Record<string, number[]>} */
  const named = {
    dot: [1, 1],
    dash: [3, 3],
    longdash: [5, 5],
    dashdot: [3, 1, 1, 1],
    longdashdot: [5, 2, 1, 2],
  };
  if (!dash || dash === "solid") return null;
  const pattern = named[dash];
  return pattern ? pattern.map((length) => length * unit).join(" ") : dash.replace(/px/gu, "");
}

const GAP = 7;
const BETWEEN = 20;
const ROW = 19;
const ABOVE = 4;

/**
 * @typedef {{trace: Trace, line: [number, number], text: number, y: number}} Entry in px
 */

/**
 * Entries one after the other, as many in a row as find room.
 * @param {readonly Trace[]} traces
 * @param {Measure} measure
 * @param {{left: number, right: number, top: number}} room px
 * @returns {{entries: Entry[], height: number}}
 */
export function keyRows(traces, measure, { left, right, top }) {
  let x = left;
  let row = 0;
  const entries = traces.map((trace) => {
    const wide = SWATCH + GAP + measure(trace.label);
    if (x > left && x + wide > right) {
      x = left;
      row += 1;
    }
    const line = /** @type {[number, number]} */ ([x, x + SWATCH]);
    x += wide + BETWEEN;
    return { trace, line, text: line[1] + GAP, y: top + ABOVE + (row + 0.5) * ROW };
  });
  return { entries, height: entries.length ? ABOVE + (row + 1) * ROW : 0 };
}
