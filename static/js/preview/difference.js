/** How far two pictures are apart, in steps of 8 bits and as eyes see it. */

import { decoded } from "../numbers/srgb.js";

const DEG = Math.PI / 180;
const TWENTY_FIVE_7 = 25 ** 7;
/** sRGB's white, D65. */
const WHITE = /** @type {const} */ ([0.95047, 1, 1.08883]);

/** Linear shares of the 256 steps of sRGB. */
const LINEAR = Float64Array.from({ length: 256 }, (_, i) => decoded(i / 255));

/** @param {number} t */
const root = (t) => (t > 216 / 24389 ? Math.cbrt(t) : ((24389 / 27) * t + 16) / 116);

/**
 * CIE L*a*b* of an sRGB color.
 * @param {number} r 0 to 255
 * @param {number} g
 * @param {number} b
 * @returns {[number, number, number]}
 */
export function lab(r, g, b) {
  const R = LINEAR[r] ?? 0;
  const G = LINEAR[g] ?? 0;
  const B = LINEAR[b] ?? 0;
  const x = root((0.4124564 * R + 0.3575761 * G + 0.1804375 * B) / WHITE[0]);
  const y = root((0.2126729 * R + 0.7151522 * G + 0.072175 * B) / WHITE[1]);
  const z = root((0.0193339 * R + 0.119192 * G + 0.9503041 * B) / WHITE[2]);
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}

/** @param {number} b @param {number} a @returns {number} degrees from 0 to 360 */
function hue(b, a) {
  if (a === 0 && b === 0) return 0;
  const h = Math.atan2(b, a) / DEG;
  return h < 0 ? h + 360 : h;
}

/**
 * CIEDE2000 with kL = kC = kH = 1, after G. Sharma, W. Wu and E. Dalal, The CIEDE2000 color-difference
 * formula, Color Res. Appl. 30 (2005) 21, equations 2 to 22.
 * @param {readonly [number, number, number]} one L*, a*, b*
 * @param {readonly [number, number, number]} two
 */
export function ciede2000([L1, a1, b1], [L2, a2, b2]) {
  const mean7 = ((Math.hypot(a1, b1) + Math.hypot(a2, b2)) / 2) ** 7;
  const G = 0.5 * (1 - Math.sqrt(mean7 / (mean7 + TWENTY_FIVE_7)));
  const [p1, p2] = [(1 + G) * a1, (1 + G) * a2];
  const [C1, C2] = [Math.hypot(p1, b1), Math.hypot(p2, b2)];
  const [h1, h2] = [hue(b1, p1), hue(b2, p2)];
  const gray = C1 * C2 === 0;
  let dh = gray ? 0 : h2 - h1;
  if (dh > 180) dh -= 360;
  else if (dh < -180) dh += 360;
  let h = h1 + h2;
  if (!gray) {
    if (Math.abs(h1 - h2) > 180) h += h < 360 ? 360 : -360;
    h /= 2;
  }
  const dL = L2 - L1;
  const dC = C2 - C1;
  const dH = 2 * Math.sqrt(C1 * C2) * Math.sin((dh / 2) * DEG);
  const L = (L1 + L2) / 2 - 50;
  const C = (C1 + C2) / 2;
  const T =
    1 -
    0.17 * Math.cos((h - 30) * DEG) +
    0.24 * Math.cos(2 * h * DEG) +
    0.32 * Math.cos((3 * h + 6) * DEG) -
    0.2 * Math.cos((4 * h - 63) * DEG);
  const C7 = C ** 7;
  const turn = 30 * Math.exp(-(((h - 275) / 25) ** 2));
  const RT = -2 * Math.sqrt(C7 / (C7 + TWENTY_FIVE_7)) * Math.sin(2 * turn * DEG);
  const l = dL / (1 + (0.015 * L * L) / Math.sqrt(20 + L * L));
  const c = dC / (1 + 0.045 * C);
  const k = dH / (1 + 0.015 * C * T);
  return Math.sqrt(l * l + c * c + k * k + RT * c * k);
}

/** Factors by which a difference is amplified, 1, 2 and 5 of each power of ten. */
const FACTORS = [1, 2, 5, 10, 20, 50, 100, 200];
/** Of 255: about as much of the scale of colors as is seen at a glance. */
const SEEN = 200;

/**
 * How much a difference is amplified so that something shows; 1 where there is none.
 * @param {number} largest in 8-bit steps
 */
export const amplification = (largest) =>
  FACTORS.filter((factor) => largest > 0 && factor * largest <= SEEN).at(-1) ?? 1;

/** What CIEDE2000 means to those who look, up to each value: 1 is its unit, 2.3 what is just noticed. */
const VERDICTS = /** @type {const} */ ([
  [1, "not visible side by side"],
  [2.3, "hardly visible side by side"],
  [5, "visible side by side"],
  [Number.POSITIVE_INFINITY, "plain to see"],
]);

/** @param {number} colors the largest CIEDE2000 of a picture */
export const verdictOf = (colors) => VERDICTS.find(([most]) => colors < most)?.[1] ?? "";

/**
 * @typedef {{mean: number, largest: number}} Figures
 * @typedef {{pixels: number, steps: Figures, colors: Figures}} Difference
 */

/**
 * Over the pixels that show the chosen surface: the largest of the channels' differences in 8-bit
 * steps, and CIEDE2000. A pixel on the surface's edge that holds something else too does not count.
 * @param {Uint8Array} left four bytes a pixel; the last is 255 where the surface is seen
 * @param {Uint8Array} right
 * @returns {Difference}
 */
export function differenceOf(left, right) {
  let pixels = 0;
  const steps = { mean: 0, largest: 0 };
  const colors = { mean: 0, largest: 0 };
  for (let i = 0; i < left.length; i += 4) {
    if (left[i + 3] !== 255) continue;
    pixels += 1;
    const [r, g, b] = [left[i] ?? 0, left[i + 1] ?? 0, left[i + 2] ?? 0];
    const [r2, g2, b2] = [right[i] ?? 0, right[i + 1] ?? 0, right[i + 2] ?? 0];
    const step = Math.max(Math.abs(r - r2), Math.abs(g - g2), Math.abs(b - b2));
    if (step === 0) continue;
    const color = ciede2000(lab(r, g, b), lab(r2, g2, b2));
    steps.mean += step;
    steps.largest = Math.max(steps.largest, step);
    colors.mean += color;
    colors.largest = Math.max(colors.largest, color);
  }
  steps.mean /= pixels || 1;
  colors.mean /= pixels || 1;
  return { pixels, steps, colors };
}
