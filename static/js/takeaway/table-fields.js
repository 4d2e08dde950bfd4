/** What the panel of lookup tables adds to the state. */

import { choice } from "../state/state.js";

export const SIZES = [2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096];

/** Depths by their bits, as the page offers them; OpenEXR's halves are left to the API. */
export const DEPTHS = [
  { bits: "8", label: "8 bits", depth: "unorm8", formats: ["png", "npy", "csv", "json"] },
  { bits: "16", label: "16 bits", depth: "unorm16", formats: ["png", "npy", "csv", "json"] },
  { bits: "32", label: "float", depth: "float", formats: ["exr", "npy", "csv", "json"] },
];

/** @returns {Record<string, Field>} */
export function tableFields() {
  return {
    table_size: choice("256", SIZES.map(String)),
    bits: choice(
      "16",
      DEPTHS.map((d) => d.bits),
    ),
  };
}

/**
 * The size nearest to a place on the logarithmic axis; one texel more or less, which is what a key
 * gives, is the next size.
 * @param {number} x
 * @param {number} now
 */
export function pickedSize(x, now) {
  const step = Math.abs(x - now) === 1 ? Math.sign(x - now) : 0;
  const power = step ? Math.log2(now) + step : Math.round(Math.log2(x));
  return String(2 ** Math.min(12, Math.max(1, power)));
}
