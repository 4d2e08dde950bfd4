/** A legend below the plot, for more curves than can carry their names. */

import { svg } from "../draw/svg.js";
import { runs } from "../draw/symbols.js";
import { dashArray } from "./dash.js";

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
 * @param {readonly import("./model.js").Trace[]} traces
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
