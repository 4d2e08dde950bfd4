/** The ray at the surface as a file, alone or beside its curves, as on the screen or fitted to a publication. */

import { standalone } from "../draw/standalone.js";
import { advances } from "../draw/svg.js";
import { h } from "../page/dom.js";
import { textSize } from "../plot/arrange.js";
import { rasterized } from "../plot/image.js";
import { drawingSize, onPaper, withDensity, wrapped } from "../plot/publication.js";
import { createDiagram } from "./diagram.js";

/**
 * @typedef {object} RayPicture
 * @property {DiagramValues} values
 * @property {Size} size px on the screen
 * @property {Published | null} plot that stands beside it
 */

const LEAST = 480; // px of a picture that is not fitted to anything
const SCALE = 2;
const DOTS_PER_MM = 600 / 25.4;
const LINE = 15;
const GAP = 12;
/** Of the width, where curves stand beside it. */
const SHARE = 0.42;

const nothing = () => {};

/**
 * Draw it anew, as large as it is wanted.
 * @param {DiagramValues} values
 * @param {Size} size
 * @param {{theme?: "light" | "dark" | undefined, ground?: string | undefined}} look that of the page unless it is given
 * @returns {Promise<string>}
 */
async function drawn(values, size, { theme, ground }) {
  const frame = h("div.drawn-ray-frame");
  const host = h("div.drawn-ray", theme ? { "data-theme": theme } : {}, frame);
  for (const side of /** @type {const} */ (["width", "height"]))
    frame.style[side] = `${size[side]}px`;
  document.body.append(host);
  const diagram = createDiagram(frame, { onTheta: nothing });
  try {
    diagram.update({ ...values, held: false });
    await document.fonts.ready;
    // The rays of white light are drawn by what is fetched first.
    if (values.dispersion?.length) await import("./fan.js");
    await new Promise((seen) => setTimeout(seen));
    const root = /** @type {SVGElement} */ (frame.querySelector("svg"));
    const paper = ground ?? getComputedStyle(host).getPropertyValue("--paper");
    return await standalone(root, { ...size, ground: paper });
  } finally {
    diagram.destroy();
    host.remove();
  }
}

/**
 * A picture's source with other attributes of its root. It is never parsed: its style sheet would count as
 * one of this page, which its policy forbids.
 * @param {string} source
 * @param {Record<string, number>} attributes
 */
function placed(source, attributes) {
  const names = Object.keys(attributes).join("|");
  const given = Object.entries(attributes).map(([name, value]) => ` ${name}="${value}"`);
  return source.replace(/<svg([^>]*)>/u, (_, rest) => {
    const others = rest.replace(new RegExp(` (${names})="[^"]*"`, "gu"), "");
    return `<svg${others}${given.join("")}>`;
  });
}

/** @param {string} inside @param {Size} size @param {string} ground behind all of it */
const framed = (inside, { width, height }, ground) =>
  `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}"><rect width="${width}" height="${height}" fill="${ground}"/>${inside}</svg>`;

/**
 * One picture beside the other.
 * @param {readonly {source: string, size: Size}[]} pictures
 * @param {string} ground
 * @returns {{source: string, size: Size}}
 */
function beside(pictures, ground) {
  let x = 0;
  const inside = pictures.map(({ source, size }) => {
    const here = placed(source, { x, y: 0, ...size });
    x += size.width + GAP;
    return here;
  });
  const size = { width: x - GAP, height: Math.max(...pictures.map((one) => one.size.height)) };
  return { source: framed(inside.join(""), size, ground), size };
}

/** @param {string} text */
const escaped = (text) => text.replace(/&/gu, "&amp;").replace(/</gu, "&lt;");

/**
 * A picture with paragraphs below it.
 * @param {{source: string, size: Size}} picture
 * @param {readonly string[]} paragraphs
 * @param {string} ink
 * @param {string} ground
 */
function captioned({ source, size }, paragraphs, ink, ground) {
  const { fontFamily } = getComputedStyle(document.body);
  const advance = advances(`11px ${fontFamily}`);
  const measure = (/** @type {string} */ text) =>
    [...text].reduce((width, character) => width + advance(character), 0);
  const lines = wrapped(paragraphs, measure, size.width);
  if (lines.length === 0) return { source, size };
  const family = fontFamily.replaceAll('"', "'");
  const texts = lines.map(
    (line, i) =>
      `<text x="0" y="${size.height + GAP + i * LINE + 4}" font-family="${family}" font-size="11" fill="${ink}">${escaped(line)}</text>`,
  );
  const whole = { width: size.width, height: size.height + GAP + lines.length * LINE };
  return { source: framed(source + texts.join(""), whole, ground), size: whole };
}

/** @param {string} source */
const blobOf = (source) => new Blob([source], { type: "image/svg+xml;charset=utf-8" });

/**
 * @param {RayPicture} picture
 * @param {"png" | "svg"} format
 * @param {Publication} [publication]
 * @returns {Promise<Blob>}
 */
export async function exportRay({ values, size: seen, plot }, format, publication) {
  if (publication) return published({ values, plot }, format, publication);
  const shown = plot && (await curves(plot));
  const size = {
    width: Math.max(seen.width, LEAST),
    height: shown?.size.height ?? Math.max(seen.height, LEAST),
  };
  const ground = getComputedStyle(document.documentElement).getPropertyValue("--paper");
  const ray = { source: await drawn(values, size, { ground }), size };
  const whole = shown ? beside([ray, shown], ground) : ray;
  const file = blobOf(whole.source);
  const { width, height } = whole.size;
  return format === "svg" ? file : rasterized(file, SCALE * width, SCALE * height);
}

/** Its curves, as large as they are drawn unless that is given. @param {Published} plot @param {Publication} [publication] */
async function curves(plot, publication) {
  const make = /** @type {(format: "svg", publication?: Publication) => Promise<Blob>} */ (
    plot.exportAs
  );
  const source = await (await make("svg", publication)).text();
  const box = source.match(/viewBox="0 0 ([\d.]+) ([\d.]+)"/u);
  return { source, size: { width: Number(box?.[1]), height: Number(box?.[2]) } };
}

/**
 * @param {Pick<RayPicture, "values" | "plot">} picture
 * @param {"png" | "svg"} format
 * @param {Publication} publication
 */
async function published({ values, plot }, format, publication) {
  const { ground, caption, width_mm } = publication;
  const { mmPerPx, width, height } = drawingSize(publication);
  const theme = ground === "clear-dark" ? "dark" : "light";
  const paper = ground === "white" ? "#ffffff" : "none";
  // Its letters grow with the page's, so it is drawn larger by as much.
  const root = Number.parseFloat(getComputedStyle(document.documentElement).fontSize);
  const unit = (root / 14) * (12 / textSize(width));
  const own = plot ? SHARE * width : width;
  const drawing = { width: Math.round(own * unit), height: Math.round(height * unit) };
  const source = await drawn(values, drawing, { theme, ground: paper });
  const ray = { source, size: { width: own, height } };
  const narrow = { width: width - own - GAP, height };
  const right = plot && {
    ...(await curves(plot, { ...publication, width_mm: narrow.width * mmPerPx, caption: [] })),
    size: narrow,
  };
  const shown = beside(right ? [ray, right] : [ray], paper);
  const ink = theme === "dark" ? "#e9ecf1" : "#14181f";
  const whole = captioned(shown, caption, ink, paper);
  const file = blobOf(
    onPaper(whole.source, { ...whole.size, mmPerPx: width_mm / whole.size.width }),
  );
  if (format === "svg") return file;
  const dots = (width_mm / whole.size.width) * DOTS_PER_MM;
  const png = await rasterized(
    file,
    Math.round(whole.size.width * dots),
    Math.round(whole.size.height * dots),
  );
  return withDensity(png, DOTS_PER_MM * 1000);
}
