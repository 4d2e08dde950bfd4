/** The room that a plot has, parted: ranges, margins, frame and ticks. */

import { axisTicks, logTicks, roundRange } from "./ticks.js";

/** A line at the very end of a range would lose half its width to the frame's edge. */
const EDGE = 3;
const NARROW = 420;
const X_SPACING = 40;
const Y_SPACING = 44;

/**
 * @param {Axis} axis
 * @param {readonly Trace[]} traces
 * @returns {Span}
 */
export function axisRange(axis, traces) {
  const [low, high] = axis.range ?? roundRange(traces.map((trace) => trace.y));
  return [low ?? 0, high ?? 1];
}

/**
 * @param {Span} range
 * @param {number} length px
 * @returns {Span}
 */
function padded([low, high], length) {
  const more = ((high - low) / Math.max(length - 2 * EDGE, 1)) * EDGE;
  return [low - more, high + more];
}

/** The size of what stands at the axes, px. @param {number} width of the plot @param {number} [unit] */
export function textSize(width, unit = 1) {
  return (width < NARROW * unit ? 11 : 12) * unit;
}

/** @param {ArrangeOptions} task @returns {Arrangement} */
export function arrange({
  size,
  axes,
  traces,
  measure,
  marksRow,
  unit = 1,
  header = 0,
  padding = 0,
}) {
  const narrow = size.width < NARROW * unit;
  const fontSize = textSize(size.width, unit);
  const second = traces.some((trace) => trace.axis === "y2") ? axes.y2 : null;
  const top = padding + header + (marksRow ? 42 : 26) * unit;
  const bottom = padding + (axes.x.title ? 50 : 28) * unit;
  const height = Math.max(size.height - top - bottom, 20);

  const yRange = axisRange(
    axes.y,
    traces.filter((trace) => trace.axis !== "y2"),
  );
  const y2Range =
    second &&
    axisRange(
      second,
      traces.filter((trace) => trace.axis === "y2"),
    );
  const yTicks = axisTicks(
    axes.y,
    yRange,
    height,
    Math.min(Y_SPACING * unit, Math.max(26 * unit, height / 6)),
  );
  const y2Ticks = second && y2Range ? axisTicks(second, y2Range, height, Y_SPACING * unit) : [];
  /** @param {Tick[]} ticks */
  const widest = (ticks) => Math.max(0, ...ticks.map((tick) => measure(tick.label)));
  const left =
    padding + Math.ceil(Math.max(widest(yTicks), (axes.y.labels ?? 0) * unit)) + 12 * unit;
  const right = padding + (second ? Math.ceil(widest(y2Ticks)) + 14 * unit : 18 * unit);
  const width = Math.max(size.width - left - right, 20);
  const xRange = axisRange(axes.x, []);
  const log = axes.x.scale === "log";
  const xSpacing = (narrow ? X_SPACING - 6 : X_SPACING) * unit;
  const xTicks =
    log && !axes.x.ticks
      ? logTicks(xRange, width, xSpacing)
      : axisTicks(axes.x, xRange, width, xSpacing);
  const [xLow, xHigh] = log ? xRange.map(Math.log10) : xRange;
  const xSpan = (xHigh ?? 1) - (xLow ?? 0);

  const frame = { x: left, y: top, width, height };
  const ranges = {
    x: xRange,
    y: padded(yRange, height),
    y2: y2Range && padded(y2Range, height),
  };
  return {
    size,
    margins: { left, right, top, bottom },
    frame,
    ranges,
    ticks: { x: xTicks, y: yTicks, y2: y2Ticks },
    fontSize,
    unit,
    padding,
    marksRow,
    xPixel: (value) =>
      frame.x + (((log ? Math.log10(value) : value) - (xLow ?? 0)) / xSpan) * frame.width,
    yPixel: (value, axis = "y") => {
      const [low, high] = (axis === "y2" && ranges.y2) || ranges.y;
      return frame.y + ((high - value) / (high - low)) * frame.height;
    },
    xValue: (pixel) => {
      const value = (xLow ?? 0) + ((pixel - frame.x) / frame.width) * xSpan;
      return log ? 10 ** value : value;
    },
  };
}
