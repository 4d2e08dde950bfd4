/** A plot as Plotly's data and layout, on the page and for export alike. */

import { plotlyText } from "../draw/svg.js";
import { unitSuffix } from "../numbers/format.js";

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
