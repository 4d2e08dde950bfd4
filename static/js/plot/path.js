/** The `d` of a curve, written exactly as Plotly writes it with `line.simplify` off. */

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
