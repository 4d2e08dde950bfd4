/** A plot as a file that stands alone: title, names, marks and background included. */

import { advances, createMeasure, plainText, plotlyText } from "../draw/svg.js";
import { arrange } from "./arrange.js";
import { bandShapes } from "./bands.js";
import { library } from "./figure.js";
import { fontFaces, rasterized, withStyle } from "./image.js";
import { keyRows } from "./legend.js";
import { MOST_LABELS, placeLabels, placeMarkNames } from "./overlay.js";
import { CONFIG, plotlyLayout, plotlyTraces } from "./plotly.js";
import { drawingSize, onGround, onPaper, withDensity, wrapped } from "./publication.js";

const HEADER = 32;
const LABEL_SIZE = 17;
const SCALE = 2;
const PADDING = 12;
const WIDTH = { least: 800, most: 1600 };
const CAPTION_LINE = 15;
const CAPTION_GAP = 6;
/** A figure in a document has its room around it there. */
export const PRINT_PADDING = 2;
const DOTS_PER_MM = 600 / 25.4;

/** @param {Picture} picture @returns {Plotly.Figure} */
export function exportFigure({
  title,
  traces,
  marks,
  bands = [],
  most = MOST_LABELS,
  axes,
  theme,
  size,
  caption = [],
  padding = PADDING,
}) {
  const { family, symbolFamily } = theme;
  const faces = { ...theme, unit: 1 };
  const text = createMeasure(faces, 12);
  const label = createMeasure(faces, 13, LABEL_SIZE);
  const landmarks = marks.filter((mark) => mark.kind === "landmark");
  const named = traces.filter((trace) => !trace.bare);
  const arrangement = arrange({
    size,
    axes,
    traces,
    measure: text,
    marksRow: landmarks.length > 0,
    header: title ? HEADER : 0,
    padding,
  });
  const { frame, xPixel, yPixel, margins } = arrangement;
  const layout = plotlyLayout(axes, arrangement, theme);
  const legend = keyRows(named.length > most ? named : [], text, {
    left: padding,
    right: size.width - padding,
    top: size.height,
  });
  const below = captioned(caption, arrangement, legend.height, theme);
  const height = size.height + legend.height + below.height;
  const annotations = [...(layout.annotations ?? []), ...below.annotations];
  const paperX = (/** @type {number} */ x) => (x - frame.x) / frame.width;
  const paperY = (/** @type {number} */ y) => 1 - (y - frame.y) / frame.height;
  /** @param {number} x @param {number} y @param {string} words @param {object} font @param {string} [xanchor] */
  const write = (x, y, words, font, xanchor = "center") => {
    annotations.push({
      text: words,
      xref: "paper",
      yref: "paper",
      x: paperX(x),
      y: paperY(y),
      xanchor,
      yanchor: "middle",
      showarrow: false,
      borderpad: 0,
      font,
    });
  };
  /** @type {Record<string, unknown>[]} */
  const shapes = bandShapes(bands, theme);
  /** @param {Mark} mark @param {Plotly.Line} line */
  const upright = ({ x }, line) => {
    const ends = { x0: x, x1: x, y0: 0, y1: 1 };
    shapes.push({ type: "line", xref: "x", yref: "paper", ...ends, layer: "below", line });
  };
  for (const mark of landmarks) upright(mark, { color: theme.muted, width: 1, dash: "2px,3px" });
  const names = placeMarkNames({
    frame,
    reserved: padding + text(axes.y.title),
    marks: landmarks.map((mark) => ({ x: xPixel(mark.x), width: text(mark.label) })),
  });
  landmarks.forEach((mark, index) => {
    const place = names[index];
    if (place) write(place.x, place.y, plotlyText(mark.label), { size: 12, color: theme.muted });
  });
  for (const mark of marks)
    if (mark.kind === "current") upright(mark, { color: theme.accent, width: 1.5, dash: "solid" });

  for (const { trace, line, text: x, y } of legend.entries) {
    const ends = { x0: paperX(line[0]), x1: paperX(line[1]), y0: paperY(y), y1: paperY(y) };
    const { width = 2, dash = "solid" } = trace;
    const look = { color: theme.color(trace.color), width, dash };
    shapes.push({ type: "line", xref: "paper", yref: "paper", ...ends, line: look });
    write(x, y, plotlyText(trace.label), { size: 12, color: theme.ink }, "left");
  }
  if (legend.entries.length === 0) {
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
      title: title && {
        text: `<b>${plotlyText(title)}</b>`,
        x: 0,
        xref: "container",
        xanchor: "left",
        y: 1,
        yref: "container",
        yanchor: "top",
        pad: { l: padding, t: padding + 4 },
        font: { size: 16, color: theme.ink },
      },
      height,
      annotations,
      shapes,
      paper_bgcolor: theme.paper,
      plot_bgcolor: theme.paper,
      margin: { ...layout.margin, b: height - size.height + margins.bottom },
    },
    config: { ...CONFIG, staticPlot: true },
  };
}

/**
 * A plot as it stands on the page, or fitted to a publication.
 * @param {HTMLElement} element of the plot
 * @param {Omit<Picture, "size"> & {size?: Size, at: number | null}} picture `at` is where the marker stands
 * @param {"png" | "svg"} format
 * @param {Publication} [publication]
 */
export function exportPlot(element, { at, size: shown, ...picture }, format, publication) {
  const still = picture.marks.filter((mark) => mark.kind !== "current");
  if (publication)
    // It has no pointer and no numbers that would say what the marker's line stands for.
    return published(element, publication, format, (how) =>
      exportFigure({ ...picture, ...how, marks: still, title: "", padding: PRINT_PADDING }),
    );
  const current = { x: at ?? 0, label: "", kind: /** @type {const} */ ("current") };
  const marks = at === null ? picture.marks : [...still, current];
  const { width, height } = shown ?? { width: 960, height: 600 };
  const wide = Math.min(Math.max(width, WIDTH.least), WIDTH.most);
  const size = { width: Math.round(wide), height: Math.round((wide * height) / width) + 40 };
  return imageOf(exportFigure({ ...picture, marks, size }), format);
}

/**
 * A figure drawn for a publication.
 * @param {HTMLElement} element
 * @param {Publication} publication
 * @param {"png" | "svg"} format
 * @param {(how: {size: Size, theme: Theme, caption: readonly string[]}) => Plotly.Figure} figure
 */
export function published(element, publication, format, figure) {
  const { mmPerPx, ...size } = drawingSize(publication);
  const { ground, caption } = publication;
  return onGround(element, ground, (theme) =>
    imageOf(figure({ size, theme, caption }), format, mmPerPx),
  );
}

/**
 * Paragraphs as lines below a picture, and the room they take.
 * @param {readonly string[]} paragraphs
 * @param {Pick<Arrangement, "size" | "margins" | "padding">} arrangement
 * @param {number} above room of a legend between the plot and them
 * @param {Theme} theme
 */
export function captioned(paragraphs, { size, margins, padding }, above, { family, ink }) {
  const font = { size: 11, color: ink };
  const advance = advances(`${font.size}px ${family}`); // as it stands, underscores and all
  const measure = (/** @type {string} */ text) =>
    [...text].reduce((width, character) => width + advance(character), 0);
  const lines = wrapped(paragraphs, measure, size.width - 2 * padding);
  const height = lines.length ? lines.length * CAPTION_LINE + CAPTION_GAP : 0;
  const below = margins.bottom + above;
  const annotations = lines.map((line, index) => ({
    text: line.replace(/&/gu, "&amp;").replace(/</gu, "&lt;"),
    xref: "paper",
    yref: "paper",
    x: 0,
    y: 0,
    xshift: padding - margins.left,
    yshift: -(below + index * CAPTION_LINE),
    xanchor: "left",
    yanchor: "top",
    align: "left",
    showarrow: false,
    borderpad: 0,
    font,
  }));
  return { height, annotations };
}

/**
 * @param {Plotly.Figure} figure
 * @param {"png" | "svg"} format
 * @param {number} [mmPerPx] its size on paper, where it has one
 * @returns {Promise<Blob>}
 */
export async function imageOf(figure, format, mmPerPx) {
  const { width = 960, height = 600, font } = figure.layout;
  await library();
  const uri = await Plotly.toImage(figure, { format: "svg", width, height });
  const family = /** @type {{family: string}} */ (font).family;
  const drawn = decodeURIComponent(uri.slice(uri.indexOf(",") + 1));
  const plain = withStyle(drawn, await fontFaces(family));
  const source = mmPerPx ? onPaper(plain, { width, height, mmPerPx }) : plain;
  const svg = new Blob([source], { type: "image/svg+xml;charset=utf-8" });
  if (format === "svg") return svg;
  const scale = mmPerPx ? mmPerPx * DOTS_PER_MM : SCALE;
  const png = await rasterized(svg, Math.round(width * scale), Math.round(height * scale));
  return mmPerPx ? withDensity(png, DOTS_PER_MM * 1000) : png;
}
