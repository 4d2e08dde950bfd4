/**
 * The fast path: the curves' path elements, as the last settled drawing left them, are given new
 * data directly. It leans on two things inside the pinned Plotly, the class of a trace's group and
 * `l2p` of a computed axis; tests compare its paths with those that Plotly writes.
 */

import { traceUid } from "./figure.js";
import { createPixels, curvePath } from "./path.js";

/** @typedef {import("./model.js").Trace} Trace */
/** @typedef {{id: string, axis: string, path: Element, rest: Element[], scale: Plotly.FullAxis}} Line */

/** @param {Trace} trace */
const axisOf = (trace) => trace.axis ?? "y";

/** @param {HTMLElement} canvas where Plotly draws */
export function createFastPath(canvas) {
  /** @type {Line[] | null} */
  let lines = null;
  /** @type {((x: readonly number[]) => readonly number[]) | null} */
  let pixels = null;

  return {
    /**
     * Find the elements of what has just been drawn.
     * @param {readonly Trace[]} traces
     */
    find(traces) {
      const full = /** @type {Plotly.PlotElement} */ (canvas)._fullLayout;
      pixels = createPixels(full.xaxis);
      lines = [];
      for (const [index, trace] of traces.entries()) {
        const group = canvas.getElementsByClassName(`trace${traceUid(index)}`)[0];
        const [path, ...rest] = group?.querySelectorAll("path.js-line") ?? [];
        const scale = axisOf(trace) === "y2" ? full.yaxis2 : full.yaxis;
        if (!path) {
          // nothing was drawn of this curve, so there is nothing to write to
          lines = null;
          return;
        }
        lines.push({
          id: trace.id,
          axis: axisOf(trace),
          path,
          rest,
          scale: /** @type {Plotly.FullAxis} */ (scale),
        });
      }
    },

    /**
     * Write the curves, all or none.
     * @param {readonly Trace[]} traces
     * @returns {boolean} whether they were written; if not, they have to be drawn
     */
    write(traces) {
      if (!lines || !pixels || traces.length !== lines.length) return false;
      /** @type {string[]} */
      const paths = [];
      for (const [index, line] of lines.entries()) {
        const trace = traces[index];
        if (!trace || trace.id !== line.id || axisOf(trace) !== line.axis) return false;
        const path = curvePath(pixels(trace.x), trace.y, line.scale);
        if (path === null) return false;
        paths.push(path);
      }
      for (const [index, line] of lines.entries()) {
        line.path.setAttribute("d", paths[index] ?? "");
        for (const other of line.rest) other.removeAttribute("d");
      }
      return true;
    },
  };
}
