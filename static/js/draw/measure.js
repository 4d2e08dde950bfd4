/** Widths of labels without asking the layout: glyph advances are measured once per face. */

import { runs, SUBSCRIPT_SCALE } from "./symbols.js";

/** @typedef {(label: string) => number} Measure */

/** @type {CanvasRenderingContext2D | null} */
let context = null;

/**
 * @param {string} font a CSS font shorthand
 * @returns {(character: string) => number}
 */
export function advances(font) {
  /** @type {Map<string, number>} */
  const known = new Map();
  return (character) => {
    let width = known.get(character);
    if (width === undefined) {
      context ??= document.createElement("canvas").getContext("2d");
      if (context) context.font = font;
      width = context ? context.measureText(character).width : 8;
      known.set(character, width);
    }
    return width;
  };
}

/**
 * A function that gives the width of a label in px, for one size and weight of the text face.
 * @param {{family: string, symbolFamily: string, size: number, weight?: number, symbolSize?: number}} face
 * @returns {Measure}
 */
export function createMeasure({ family, symbolFamily, size, weight = 400, symbolSize = size }) {
  const text = advances(`${weight} ${size}px ${family}`);
  const symbol = advances(`italic ${weight} ${symbolSize}px ${symbolFamily}`);
  return (label) => {
    let width = 0;
    for (const run of runs(label)) {
      const advance = run.italic ? symbol : text;
      const scale = run.sub ? SUBSCRIPT_SCALE : 1;
      for (const character of run.text) width += advance(character) * scale;
    }
    return width;
  };
}
