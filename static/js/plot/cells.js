/**
 * What a heat map is drawn of: the scale of its colors and their key, cells, lines of equal value and
 * outlined regions.
 *
 * The cells are a picture of one pixel each, a tenth of what Plotly needs for its own. Plotly's
 * `<image>` covers exactly the cells, so that the picture only has to be put in its place.
 */

import { plainText, put, px, show, svg } from "../draw/svg.js";
import { plain } from "../numbers/format.js";

const SHADES = 256;
const XLINK = "http://www.w3.org/1999/xlink";

/**
 * The colours from one end of a scale to the other.
 * @param {CanvasRenderingContext2D} context
 * @param {readonly [number, string][]} stops
 * @returns {Uint32Array} a pixel for each shade
 */
function shades(context, stops) {
  const gradient = context.createLinearGradient(0, 0, SHADES, 0);
  for (const [at, color] of stops) gradient.addColorStop(at, color);
  context.canvas.width = SHADES;
  context.canvas.height = 1;
  context.fillStyle = gradient;
  context.fillRect(0, 0, SHADES, 1);
  return new Uint32Array(context.getImageData(0, 0, SHADES, 1).data.buffer);
}

/** @returns {(z: readonly (readonly (number | null)[])[], scale: MapScale, stops: readonly [number, string][]) => string} */
export function createCells() {
  const canvas = document.createElement("canvas");
  const context = canvas.getContext("2d", { willReadFrequently: true });
  return (z, { low, high }, stops) => {
    if (!context) return "";
    const colors = shades(context, stops);
    const [rows, columns] = [z.length, z[0]?.length ?? 0];
    canvas.width = columns;
    canvas.height = rows;
    const picture = context.createImageData(columns, rows);
    const pixels = new Uint32Array(picture.data.buffer);
    const unit = (SHADES - 1) / (high - low || 1);
    z.forEach((row, index) => {
      // The first row is the lowest.
      const start = (rows - 1 - index) * columns;
      row.forEach((value, column) => {
        if (value === null) return;
        const shade = Math.round((value - low) * unit);
        pixels[start + column] = colors[Math.min(Math.max(shade, 0), SHADES - 1)] ?? 0;
      });
    });
    context.putImageData(picture, 0, 0);
    return canvas.toDataURL();
  };
}

/**
 * Put a picture in place of Plotly's.
 * @param {HTMLElement} plot where Plotly has drawn a heat map
 * @param {string} url
 * @returns {boolean} whether there was one to replace
 */
export function putCells(plot, url) {
  const image = plot.querySelector(".heatmaplayer image");
  if (!(image instanceof SVGImageElement) || url === "") return false;
  image.style.imageRendering = "pixelated";
  image.setAttributeNS(XLINK, "xlink:href", url);
  return true;
}

/** Share of the cells that the scale's ends leave out, lest one corner darken all the rest. */
const LEFT_OUT = 0.02;

/** @param {number} value @returns {number} the next of 1, 1.5, 2, 3, 5, 7 times a power of ten */
export function roundUp(value) {
  if (!(value > 0)) return 1e-6;
  const power = 10 ** Math.floor(Math.log10(value));
  const factor = [1, 1.5, 2, 3, 5, 7, 10].find((f) => f * power >= value * (1 - 1e-9)) ?? 10;
  return Number((factor * power).toPrecision(3));
}

/**
 * @param {readonly (readonly (number | null)[])[]} z
 * @param {MapScale["kind"]} kind
 * @returns {MapScale}
 */
export function scaleOf(z, kind) {
  let count = 0;
  const all = new Float64Array(z.length * (z[0]?.length ?? 0));
  for (const row of z) {
    for (const value of row) {
      if (value === null || !Number.isFinite(value)) continue;
      all[count] = Math.abs(value);
      count += 1;
    }
  }
  const sizes = all.subarray(0, count).sort();
  const most = sizes.at(-1) ?? 1;
  const usual = sizes[Math.floor((sizes.length - 1) * (1 - LEFT_OUT))] ?? most;
  const high = roundUp(most > 2 * usual && usual > 0 ? usual : most);
  return { kind, low: kind === "signed" ? -high : 0, high, capped: most > high };
}

/**
 * Stops of the scale as Plotly and CSS gradients want them.
 * @param {MapScale["kind"]} kind
 * @param {(property: string) => string} color of a CSS custom property
 * @returns {[number, string][]}
 */
export function stops(kind, color) {
  const positive = ["--map-0", "--map-1", "--map-2", "--map-3"];
  const names = kind === "size" ? positive : ["--map-n3", "--map-n2", "--map-n1", ...positive];
  return names.map((name, i) => [i / (names.length - 1), color(name)]);
}

/**
 * @param {readonly number[]} x ascending
 * @param {readonly number[]} y ascending
 * @param {readonly (readonly (number | null)[])[]} z a row for each y
 * @param {number} level
 * @returns {[Span, Span][]} segments in the units of x and y
 */
export function contour(x, y, z, level) {
  /** @type {[Span, Span][]} */
  const segments = [];
  for (let row = 0; row + 1 < y.length; row += 1) {
    const below = z[row] ?? [];
    const above = z[row + 1] ?? [];
    for (let column = 0; column + 1 < x.length; column += 1) {
      const [a, b, c, d] = [below[column], below[column + 1], above[column + 1], above[column]];
      if (a == null || b == null || c == null || d == null) continue;
      const sides =
        (a > level ? 1 : 0) | (b > level ? 2 : 0) | (c > level ? 4 : 0) | (d > level ? 8 : 0);
      if (sides === 0 || sides === 15) continue;
      const [x0, x1] = [x[column] ?? 0, x[column + 1] ?? 0];
      const [y0, y1] = [y[row] ?? 0, y[row + 1] ?? 0];
      /** @param {number} from @param {number} to */
      const part = (from, to) => (level - from) / (to - from);
      /** @type {Span[]} crossings of the cell's bottom, right, top and left side, as far as there are any */
      const crossings = [];
      if (a > level !== b > level) crossings.push([x0 + (x1 - x0) * part(a, b), y0]);
      if (b > level !== c > level) crossings.push([x1, y0 + (y1 - y0) * part(b, c)]);
      if (d > level !== c > level) crossings.push([x0 + (x1 - x0) * part(d, c), y1]);
      if (a > level !== d > level) crossings.push([x0, y0 + (y1 - y0) * part(a, d)]);
      for (let i = 0; i + 1 < crossings.length; i += 2)
        segments.push([/** @type {Span} */ (crossings[i]), /** @type {Span} */ (crossings[i + 1])]);
    }
  }
  return segments;
}

/**
 * The part of a region that lies on the map; null where there is none.
 * @param {Region} region
 * @param {{x: readonly [number, number], y: readonly [number, number]}} ranges
 */
export function clipped({ x, y }, ranges) {
  const [left, right] = [Math.max(x[0], ranges.x[0]), Math.min(x[1], ranges.x[1])];
  const [low, high] = [Math.max(y[0], ranges.y[0]), Math.min(y[1], ranges.y[1])];
  return left > right || low > high ? null : { x: [left, right], y: [low, high] };
}

/** @param {SVGElement} root */
export function createOutlines(root) {
  const casing = svg("path", { class: "map-region-casing" }, root);
  const line = svg("path", { class: "map-region" }, root);
  return {
    /** @param {readonly Region[]} regions @param {Arrangement} arrangement */
    place(regions, { ranges, xPixel, yPixel }) {
      const path = regions
        .map((region) => {
          const part = clipped(region, ranges);
          if (!part) return "";
          const [left, right] = part.x.map((v) => px(xPixel(v)));
          const [bottom, top] = part.y.map((v) => px(yPixel(v)));
          return `M${left},${bottom}H${right}V${top}H${left}Z`;
        })
        .join("");
      for (const node of [casing, line]) {
        show(node, path !== "");
        put(node, "d", path);
      }
    },
  };
}

/**
 * The same as shapes of an exported picture.
 * @param {readonly Region[]} regions
 * @param {string} color
 */
export function regionShapes(regions, color) {
  return regions.map(({ x, y }) => ({
    type: "rect",
    xref: "x",
    yref: "y",
    x0: x[0],
    x1: x[1],
    y0: y[0],
    y1: y[1],
    line: { color, width: 1.5, dash: "5px,4px" },
  }));
}

/** @param {string} className @param {...(Node | string)} children */
function span(className, ...children) {
  const node = document.createElement("span");
  node.className = className;
  node.append(...children);
  return node;
}

/**
 * @param {HTMLElement} element
 * @param {MapScale} scale
 * @param {MapValues} values
 * @param {(property: string) => string} color
 */
export function drawKey(element, scale, values, color) {
  const colors = stops(scale.kind, color).map(([at, c]) => `${c} ${100 * at}%`);
  const bar = span("map-bar");
  bar.style.background = `linear-gradient(90deg, ${colors.join(", ")})`;
  const signed = scale.kind === "signed";
  const ends = [
    signed ? `${scale.capped ? "≤ " : ""}${plain(scale.low)}` : "0",
    ...(signed ? ["0"] : []),
    `${scale.capped ? "≥ " : ""}${plain(scale.high)}`,
  ].map((text) => span("", text));
  element.replaceChildren(
    span("map-title", plainText(values.title)),
    span("map-scale", bar, span("map-ends", ...ends)),
  );
  if (values.level)
    element.append(span("map-note", `line at ${signed ? "±" : ""}${plain(values.level)}`));
}
