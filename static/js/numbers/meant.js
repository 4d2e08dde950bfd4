/** What a number that is refused may have meant, in the words of the server (app/optics/meant.py). */

import { inMicrometers } from "../media/wavelength.js";
import { plain } from "./format.js";

const NO_GAIN = "N = n + i k with k >= 0";
const NUMBER = String.raw`(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?`;
const COMPLEX = new RegExp(
  String.raw`^\(?(?:(${NUMBER})\s*(?=[-+]))?([-+]?)\s*(${NUMBER})?\s*\*?\s*[ij]\)?$`,
  "i",
);

/**
 * @param {string} name of the parameter
 * @param {string | number} given what was typed, or the number that it is
 * @returns {string | null} what to give in its place; null where nothing is known
 */
export function instead(name, given) {
  if (typeof given === "number") {
    if (name === "wavelength_nm") return inMicrometers(given) || null;
    const hasGain = name === "k_t" && given < 0;
    return hasGain ? `${NO_GAIN}; for n - i k give ${plain(-given, 12)}` : null;
  }
  const parts = name === "n_t" || name === "k_t" ? given.trim().match(COMPLEX) : null;
  if (!parts) return null;
  const [, n, sign, k] = parts;
  return `${NO_GAIN}; for n ${sign || "+"} i k give ${n ? `n_t = ${n} and ` : ""}k_t = ${k ?? 1}`;
}
