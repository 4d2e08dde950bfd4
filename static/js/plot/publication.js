/** A figure for a paper or a slide: its size there, the size of its letters, its ground and its caption. */

import { h } from "../page/dom.js";
import { textSize } from "./arrange.js";
import { readTheme } from "./figure.js";

const MM_PER_POINT = 25.4 / 72;
/** What a plot needs to have room for its axes and names. */
const LEAST = { width: 240, height: 170 };

/**
 * A figure is drawn in px and then scaled as a whole, so that lines and letters keep their proportions.
 * @param {Pick<Publication, "width_mm" | "height_mm" | "font_pt">} publication
 */
export function drawingSize({ width_mm, height_mm, font_pt }) {
  const letters = font_pt * MM_PER_POINT;
  // narrow figures have smaller letters, in px
  const wide = width_mm / (letters / textSize(Number.POSITIVE_INFINITY));
  const mmPerPx = letters / textSize(wide);
  return { width: width_mm / mmPerPx, height: height_mm / mmPerPx, mmPerPx };
}

/**
 * What is too small to hold letters of that size, in words; empty when nothing is.
 * @param {Pick<Publication, "width_mm" | "height_mm" | "font_pt">} publication
 * @param {number} [beside] px of the width that are not the plot's
 */
export function tooSmall(publication, beside = 0) {
  const { mmPerPx, ...size } = drawingSize(publication);
  const least = { ...LEAST, width: LEAST.width + beside };
  for (const side of /** @type {const} */ (["width", "height"])) {
    if (size[side] < least[side])
      return `${publication.font_pt} pt letters need a ${side} of ${Math.ceil(least[side] * mmPerPx)} mm or more`;
  }
  return "";
}

/**
 * Draw with the colors of a ground, whatever the page's are.
 * @template Result
 * @param {HTMLElement} element
 * @param {Publication["ground"]} ground
 * @param {(theme: Theme) => Promise<Result>} draw
 */
export async function onGround(element, ground, draw) {
  const scheme = ground === "clear-dark" ? "dark" : "light";
  const probe = h("div", { hidden: true, "data-theme": scheme });
  element.append(probe); // stays while it is drawn: its colors are read one by one
  try {
    const paper = ground === "white" ? "#ffffff" : "rgba(0,0,0,0)";
    return await draw({ ...readTheme(probe), paper, unit: 1 });
  } finally {
    probe.remove();
  }
}

/**
 * Paragraphs as lines no wider than a width; a word that is wider by itself is cut.
 * @param {readonly string[]} paragraphs
 * @param {(text: string) => number} measure px
 * @param {number} width px
 */
export function wrapped(paragraphs, measure, width) {
  /** @type {string[]} */
  const lines = [];
  for (const paragraph of paragraphs) {
    let line = "";
    for (const word of paragraph.split(/\s+/u).filter(Boolean)) {
      const longer = line ? `${line} ${word}` : word;
      if (measure(longer) <= width) {
        line = longer;
        continue;
      }
      if (line) lines.push(line);
      line = "";
      for (const letter of word) {
        if (line && measure(line + letter) > width) {
          lines.push(line);
          line = "";
        }
        line += letter;
      }
    }
    if (line) lines.push(line);
  }
  return lines;
}

/**
 * A picture's SVG with its size on paper.
 * @param {string} source
 * @param {{width: number, height: number, mmPerPx: number}} size
 */
export function onPaper(source, { width, height, mmPerPx }) {
  const mm = (/** @type {number} */ px) => `${Number((px * mmPerPx).toFixed(3))}mm`;
  return source.replace(/<svg[^>]*>/u, (start) =>
    start
      .replace(/\swidth="[^"]*"/u, ` width="${mm(width)}"`)
      .replace(/\sheight="[^"]*"/u, ` height="${mm(height)}"`),
  );
}

/** @param {Uint8Array} bytes the checksum that PNG asks for */
function crc32(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; bit += 1) crc = (crc >>> 1) ^ (crc & 1 ? 0xedb88320 : 0);
  }
  return (crc ^ 0xffffffff) >>> 0;
}

const AFTER_HEADER = 33; // signature and IHDR

/**
 * A PNG that says how large its pixels are (a pHYs chunk), so that a document shows it in its size.
 * @param {Blob} png
 * @param {number} perMetre pixels
 */
export async function withDensity(png, perMetre) {
  const chunk = new DataView(new ArrayBuffer(21));
  chunk.setUint32(0, 9);
  [..."pHYs"].forEach((letter, i) => {
    chunk.setUint8(4 + i, letter.charCodeAt(0));
  });
  chunk.setUint32(8, Math.round(perMetre));
  chunk.setUint32(12, Math.round(perMetre));
  chunk.setUint8(16, 1); // the unit is the metre
  chunk.setUint32(17, crc32(new Uint8Array(chunk.buffer, 4, 13)));
  const parts = [png.slice(0, AFTER_HEADER), chunk.buffer, png.slice(AFTER_HEADER)];
  return new Blob(parts, { type: "image/png" });
}
