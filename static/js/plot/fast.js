/** Curves written as paths, where Plotly has drawn them once: a tenth of the cost of drawing them anew. */

import { traceUid } from "./plotly.js";

/** Plotly clips points further than this many frames away; such a curve is left to Plotly. */
const FRAMES_AWAY = 20;

/**
 * Path of a curve with gaps at `null`, or `null` itself when Plotly would clip it. Its pieces, each an
 * element of its own in Plotly, are joined by an `M`, so that their number need not follow the data.
 * @param {readonly number[]} xPixels
 * @param {readonly (number | null)[]} y
 * @param {PixelAxis} axis
 * @returns {string | null}
 */
export function curvePath(xPixels, y, axis) {
  const lowest = axis._length * (FRAMES_AWAY + 1);
  const highest = -axis._length * FRAMES_AWAY;
  let path = "";
  let pen = "M";
  for (let index = 0; index < xPixels.length; index += 1) {
    const value = y[index];
    if (value === null || value === undefined || !Number.isFinite(value)) {
      pen = "M";
      continue;
    }
    const pixel = axis.l2p(value);
    if (pixel > lowest || pixel < highest) return null;
    path += `${pen}${xPixels[index]},${pixel}`;
    pen = "L";
  }
  return path;
}

/**
 * A memory of the pixels of an abscissa, which is the same for all curves and between frames.
 * @param {PixelAxis} axis
 */
export function createPixels(axis) {
  /** @type {readonly number[]} */
  let known = [];
  /** @type {number[]} */
  let pixels = [];
  return (/** @type {readonly number[]} */ x) => {
    if (x === known) return pixels;
    if (x.length !== known.length || x.some((value, index) => value !== known[index])) {
      pixels = x.map((value) => axis.l2p(value));
    }
    known = x;
    return pixels;
  };
}

/** @param {Trace} trace */
const axisOf = (trace) => trace.axis ?? "y";

/** @param {HTMLElement} canvas where Plotly draws */
export function createFastPath(canvas) {
  /** @type {DrawnLine[] | null} */
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
