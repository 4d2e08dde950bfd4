/** Names of curves in rows below an exported plot, each behind a piece of its line. */

const SWATCH = 28;
const GAP = 7;
const BETWEEN = 20;
const ROW = 19;
const ABOVE = 4;

/**
 * @typedef {import("./model.js").Trace} Trace
 * @typedef {{trace: Trace, line: [number, number], text: number, y: number}} Entry in px
 */

/**
 * Entries one after the other, as many in a row as find room.
 * @param {readonly Trace[]} traces
 * @param {import("../draw/measure.js").Measure} measure
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
