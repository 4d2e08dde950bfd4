/** A plot as a file that stands alone: title, names, marks and background included. */

import { createMeasure } from "../draw/measure.js";
import { plainText, plotlyText } from "../draw/symbols.js";
import { bandShapes, CONFIG, plotlyLayout, plotlyTraces } from "./figure.js";
import { fontFaces, rasterized, withStyle } from "./image.js";
import { placeLabels } from "./labels.js";
import { arrange } from "./layout.js";
import { placeMarkNames } from "./marks.js";
import { MOST_LABELS } from "./overlay.js";

/** @typedef {import("./model.js").Trace} Trace */
/** @typedef {import("./model.js").Mark} Mark */

const HEADER = 32;
const LEGEND_ROW = 22;
const LABEL_SIZE = 17;
const SCALE = 2;
const PADDING = 12;

/**
 * @param {object} picture
 * @param {string} picture.title
 * @param {readonly Trace[]} picture.traces
 * @param {readonly Mark[]} picture.marks
 * @param {readonly import("./model.js").Band[]} [picture.bands]
 * @param {number} [picture.most] names at the curves
 * @param {import("./layout.js").Axes} picture.axes
 * @param {import("./theme.js").Theme} picture.theme
 * @param {import("./model.js").Size} picture.size
 * @returns {Plotly.Figure}
 */
export function exportFigure({
  title,
  traces,
  marks,
  bands = [],
  most = MOST_LABELS,
  axes,
  theme,
  size,
}) {
  const { family, symbolFamily } = theme;
  const text = createMeasure({ family, symbolFamily, size: 12 });
  const label = createMeasure({ family, symbolFamily, size: 13, symbolSize: LABEL_SIZE });
  const landmarks = marks.filter((mark) => mark.kind === "landmark");
  const named = traces.filter((trace) => !trace.bare);
  const legend = named.length > most;
  const layoutSize = { width: size.width, height: size.height - (legend ? LEGEND_ROW : 0) };
  const arrangement = arrange({
    size: layoutSize,
    axes,
    traces,
    measure: text,
    marksRow: landmarks.length > 0,
    header: HEADER,
    padding: PADDING,
  });
  const { frame, xPixel, yPixel, margins } = arrangement;
  const layout = plotlyLayout(axes, arrangement, theme);
  const annotations = layout.annotations ?? [];
  /** @param {number} x @param {number} y @param {string} words @param {object} font */
  const write = (x, y, words, font) => {
    annotations.push({
      text: words,
      xref: "paper",
      yref: "paper",
      x: (x - frame.x) / frame.width,
      y: 1 - (y - frame.y) / frame.height,
      xanchor: "center",
      yanchor: "middle",
      showarrow: false,
      borderpad: 0,
      font,
    });
  };
  /** @type {Record<string, unknown>[]} */
  const shapes = bandShapes(bands, theme);
  const uprights = landmarks.map((mark) => ({
    type: "line",
    xref: "x",
    yref: "paper",
    x0: mark.x,
    x1: mark.x,
    y0: 0,
    y1: 1,
    layer: "below",
    line: { color: theme.muted, width: 1, dash: "2px,3px" },
  }));
  shapes.push(...uprights);
  const names = placeMarkNames({
    frame,
    reserved: PADDING + text(axes.y.title),
    marks: landmarks.map((mark) => ({ x: xPixel(mark.x), width: text(mark.label) })),
  });
  landmarks.forEach((mark, index) => {
    const place = names[index];
    if (place) write(place.x, place.y, plotlyText(mark.label), { size: 12, color: theme.muted });
  });
  for (const mark of marks) {
    if (mark.kind !== "current") continue;
    shapes.push({
      type: "line",
      xref: "x",
      yref: "paper",
      x0: mark.x,
      x1: mark.x,
      y0: 0,
      y1: 1,
      layer: "below",
      line: { color: theme.accent, width: 1.5, dash: "solid" },
    });
  }

  if (!legend) {
    const placed = placeLabels({
      frame,
      uprights: marks.map((mark) => xPixel(mark.x)),
      curves: named.map((trace) => ({
        id: trace.id,
        width: label(trace.label) + 4,
        height: LABEL_SIZE + 2,
        x: trace.x.map(xPixel),
        y: trace.y.map((value) => (value === null ? null : yPixel(value, trace.axis))),
      })),
    });
    for (const trace of named) {
      const place = placed.get(trace.id);
      if (!place) continue;
      const symbol = plainText(trace.label).length <= 3;
      write(place.x, place.y, plotlyText(trace.label), {
        size: symbol ? LABEL_SIZE : 13,
        color: theme.color(trace.color),
        family: symbol ? symbolFamily : family,
      });
    }
  }
  return {
    data: plotlyTraces(traces, theme),
    layout: {
      ...layout,
      title: {
        text: `<b>${plotlyText(title)}</b>`,
        x: 0,
        xref: "container",
        xanchor: "left",
        y: 1,
        yref: "container",
        yanchor: "top",
        pad: { l: PADDING, t: PADDING + 4 },
        font: { size: 16, color: theme.ink },
      },
      height: size.height,
      annotations,
      shapes,
      paper_bgcolor: theme.paper,
      plot_bgcolor: theme.paper,
      showlegend: legend,
      margin: { ...layout.margin, b: margins.bottom + (legend ? LEGEND_ROW : 0) },
      legend: {
        orientation: "h",
        x: PADDING / size.width,
        xref: "container",
        xanchor: "left",
        y: 0,
        yref: "container",
        yanchor: "bottom",
        itemwidth: 44,
        font: { size: 12, color: theme.ink },
      },
    },
    config: { ...CONFIG, staticPlot: true },
  };
}

/**
 * @param {Plotly.Figure} figure
 * @param {"png" | "svg"} format
 * @returns {Promise<Blob>}
 */
export async function imageOf(figure, format) {
  const { width = 960, height = 600, font } = figure.layout;
  const uri = await Plotly.toImage(figure, { format: "svg", width, height });
  const family = /** @type {{family: string}} */ (font).family;
  const drawn = decodeURIComponent(uri.slice(uri.indexOf(",") + 1));
  const source = withStyle(drawn, await fontFaces(family));
  const svg = new Blob([source], { type: "image/svg+xml;charset=utf-8" });
  return format === "svg" ? svg : rasterized(svg, width * SCALE, height * SCALE);
}
