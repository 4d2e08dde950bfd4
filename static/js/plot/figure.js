/** A plot as Plotly's data and layout; on the page and for export alike. */

import { plotlyText } from "../draw/svg.js";

/** Nothing of a plot leaves the page, and what can be done with it stands beside it, not on it. */
export const CONFIG = Object.freeze({
  displayModeBar: false,
  displaylogo: false,
  doubleClick: false,
  plotlyServerURL: "",
  responsive: false,
  scrollZoom: false,
  showSendToCloud: false,
  showTips: false,
});

const TRANSPARENT = "rgba(0,0,0,0)";

/**
 * A unit as it stands behind a number: degrees close up, others keep a space.
 * @param {string | undefined} unit
 */
export function unitSuffix(unit) {
  if (!unit) return "";
  return unit === "°" ? unit : ` ${unit.trim()}`;
}

/**
 * The symbol of a title when it has one ("angle of incidence θ_i (degrees)" is "θ_i"), else all of it.
 * @param {string} title
 */
export function shortTitle(title) {
  return title.match(/\p{L}(?:_\{[^}]*\}|_[\p{L}\p{N}]|[₀₁₂ᵢₚₛₜ])/u)?.[0] ?? title;
}

/**
 * @param {readonly Trace[]} traces
 * @param {Theme} theme
 * @returns {Plotly.Trace[]}
 */
export function plotlyTraces(traces, theme) {
  return traces.map((trace, index) => ({
    type: "scatter",
    mode: "lines",
    uid: traceUid(index),
    name: plotlyText(trace.label),
    x: trace.x,
    y: trace.y,
    xaxis: "x",
    yaxis: trace.axis ?? "y",
    connectgaps: false,
    hovertemplate: `%{y:.6g}${unitSuffix(trace.unit)}<extra>${plotlyText(trace.label)}</extra>`,
    line: {
      color: theme.color(trace.color),
      width: trace.width ?? 2,
      dash: trace.dash ?? "solid",
      shape: "linear",
      // Every sample stays a point of the path, as the fast path writes it.
      simplify: false,
    },
  }));
}

/** @param {number} index */
export function traceUid(index) {
  return `curve${index}`;
}

/**
 * @param {Axis} axis
 * @param {[number, number]} range
 * @param {Tick[]} ticks
 * @param {Arrangement} arrangement
 * @param {Theme} theme
 * @returns {Plotly.Axis}
 */
function plotlyAxis(axis, range, ticks, arrangement, theme) {
  return {
    type: axis.scale ?? "linear",
    range: axis.scale === "log" ? [Math.log10(range[0]), Math.log10(range[1])] : range,
    autorange: false,
    automargin: false,
    fixedrange: true,
    tickmode: "array",
    tickvals: ticks.map((tick) => tick.value),
    ticktext: ticks.map((tick) => tick.label),
    tickangle: 0,
    tickfont: { size: arrangement.fontSize, color: theme.muted },
    ticks: "",
    ticklabelstandoff: 3,
    gridcolor: theme.rule,
    gridwidth: 1,
    showgrid: true,
    showline: false,
    zeroline: false,
    hoverformat: axis.unit === "°" ? ".2f" : ".6~g",
  };
}

/**
 * The title of a vertical axis stands level above it: nobody turns the head to read it.
 * @param {Axis} axis
 * @param {"left" | "right"} side
 * @param {Arrangement} arrangement
 * @param {Theme} theme
 */
function levelTitle(axis, side, arrangement, theme) {
  const { margins, fontSize, padding } = arrangement;
  const left = side === "left";
  return {
    text: plotlyText(axis.title),
    xref: "paper",
    yref: "paper",
    x: left ? 0 : 1,
    y: 1,
    xanchor: side,
    yanchor: "bottom",
    xshift: left ? padding - margins.left : margins.right - padding,
    yshift: 6,
    showarrow: false,
    borderpad: 0,
    font: { size: fontSize, color: theme.muted },
  };
}

/** How much of the page shows through a band. */
const BAND_OPACITY = 0.16;

/**
 * Bands as closed paths below the curves, a piece for each stretch without gaps.
 * @param {readonly Band[]} bands
 * @param {Theme} theme
 */
export function bandShapes(bands, theme) {
  return bands.flatMap(({ x, low, high, color }) => {
    /** @type {number[][]} */
    const pieces = [[]];
    x.forEach((_, i) => {
      if (low[i] === null || high[i] === null) pieces.push([]);
      else pieces.at(-1)?.push(i);
    });
    return pieces
      .filter((piece) => piece.length > 1)
      .map((piece) => {
        const there = piece.map((i) => `${x[i]},${high[i]}`);
        const back = [...piece].reverse().map((i) => `${x[i]},${low[i]}`);
        return {
          type: "path",
          path: `M${[...there, ...back].join("L")}Z`,
          xref: "x",
          yref: "y",
          layer: "below",
          fillcolor: theme.color(color),
          opacity: BAND_OPACITY,
          line: { width: 0 },
        };
      });
  });
}

/**
 * @param {Axes} axes
 * @param {Arrangement} arrangement
 * @param {Theme} theme
 * @returns {Plotly.Layout}
 */
export function plotlyLayout(axes, arrangement, theme) {
  const { size, margins, ranges, ticks, fontSize } = arrangement;
  const x = plotlyAxis(axes.x, ranges.x, ticks.x, arrangement, theme);
  const annotations = [levelTitle(axes.y, "left", arrangement, theme)];
  /** @type {Plotly.Layout} */
  const layout = {
    width: size.width,
    height: size.height,
    autosize: false,
    margin: { l: margins.left, r: margins.right, t: margins.top, b: margins.bottom, pad: 0 },
    paper_bgcolor: TRANSPARENT,
    plot_bgcolor: TRANSPARENT,
    font: { family: theme.family, size: fontSize, color: theme.muted },
    showlegend: false,
    dragmode: false,
    hovermode: "x unified",
    hoverlabel: {
      bgcolor: theme.panel,
      bordercolor: theme.rule,
      font: { family: theme.family, size: 12 * arrangement.unit, color: theme.ink },
    },
    xaxis: {
      ...x,
      title: {
        text: plotlyText(axes.x.title),
        standoff: 10 * arrangement.unit,
        font: { size: fontSize, color: theme.muted },
      },
      // The overlay draws the hovered abscissa itself: Plotly's spike is three lines thick.
      showspikes: false,
      unifiedhovertitle: {
        text: `${plotlyText(shortTitle(axes.x.title || axes.x.short || "x"))} = %{x:${axes.x.unit === "°" ? ".2f" : ".6~g"}}${unitSuffix(axes.x.unit)}`,
      },
    },
    yaxis: plotlyAxis(axes.y, ranges.y, ticks.y, arrangement, theme),
    annotations,
  };
  if (axes.y2 && ranges.y2) {
    layout.yaxis2 = {
      ...plotlyAxis(axes.y2, ranges.y2, ticks.y2, arrangement, theme),
      overlaying: "y",
      side: "right",
      showgrid: false,
    };
    annotations.push(levelTitle(axes.y2, "right", arrangement, theme));
  }
  return layout;
}

/** Plotly clips points further than this many frames away; such a curve is left to Plotly. */
const FRAMES_AWAY = 20;

/**
 * @typedef {object} PixelAxis
 * @property {(value: number) => number} l2p
 * @property {number} _length
 */

/**
 * Path of a curve with gaps at `null`, or `null` itself when Plotly would clip it.
 *
 * Plotly makes one path element of each piece between gaps. Pieces are joined here with a new `M`,
 * which draws the same, so that the number of elements need not follow the data.
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
