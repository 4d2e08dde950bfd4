/** From the server's curves over the angle to textures over its cosine. */

import { isShortcut, SHORTCUT } from "./fields.js";
import { CHANNELS } from "./queries.js";
import { INTERVALS, UNDEFINED } from "./shader.js";

/**
 * @typedef {(number | null)[]} Values
 * @typedef {{theta_i_deg: number[], rgb: {curves: {model: string, R_red: Values, R_green: Values, R_blue: Values}[]}}} Colored
 * @typedef {{theta_i_deg: number[], colors: {model: string, linear_srgb: [number, number, number][][]}[]}} Filmed of one thickness
 */

/**
 * R, G and B of one answer; the same curve three times where there is only one.
 * @param {Curves | Colored | Filmed} answer
 * @param {string} model
 * @returns {[Values, Values, Values]}
 */
function channelsOf(answer, model) {
  if ("colors" in answer) {
    const id = isShortcut(model) ? model.slice(SHORTCUT.length) : model;
    const row = answer.colors.find((c) => c.model === id)?.linear_srgb[0];
    if (!row) throw new Error(`the answer has no colors of ${id}`);
    return [row.map(([r]) => r), row.map(([, g]) => g), row.map(([, , b]) => b)];
  }
  if ("rgb" in answer) {
    // The spectrum itself is what is exact for a material.
    const name = model === "exact" ? "spectral" : model;
    const found = answer.rgb.curves.find((c) => c.model === name);
    if (!found) throw new Error(`the answer has no curve of ${name}`);
    return [found.R_red, found.R_green, found.R_blue];
  }
  const own = answer.curves.filter((c) => c.model === model);
  const single = own.find((c) => c.quantity === "R");
  const [red, green, blue] = CHANNELS.map(
    (channel) => (single ?? own.find((c) => c.quantity === `R_${channel}`))?.values,
  );
  if (!red || !green || !blue) throw new Error(`the answer has no curve of ${model}`);
  return [red, green, blue];
}

/**
 * A curve over equally spaced angles read at cosines from 0 to 1.
 * @param {Values} values at 0 to 90 degrees
 * @param {number} mu
 */
function readAt(values, mu) {
  const at = (Math.acos(mu) / (Math.PI / 2)) * (values.length - 1);
  const i = Math.min(Math.floor(at), values.length - 2);
  const [a, b] = [values[i] ?? null, values[i + 1] ?? null];
  const fraction = at - i;
  if (fraction === 0 && a !== null) return a;
  return a === null || b === null ? UNDEFINED : a + fraction * (b - a);
}

/**
 * The texels of a side: R, G, B and 1 at cosines from 0 to 1.
 * @param {(Curves | Colored | Filmed)[]} answers one, or one for each of R, G and B
 * @param {string} model
 * @returns {Float32Array}
 */
export function texelsOf(answers, model) {
  const channels = answers.map((answer) => channelsOf(answer, model));
  const three = channels.length === 3 ? channels.map((c, i) => c[i]) : channels[0];
  const texels = new Float32Array(4 * (INTERVALS + 1)).fill(1);
  for (let j = 0; j <= INTERVALS; j += 1) {
    const rgb = three?.map((values) => readAt(/** @type {Values} */ (values), j / INTERVALS)) ?? [];
    // Where one is undefined there is no color.
    texels.set(rgb.includes(UNDEFINED) ? [UNDEFINED, UNDEFINED, UNDEFINED] : rgb, 4 * j);
  }
  return texels;
}

/** The same value at every angle. @param {number} R */
export function constantTexels(R) {
  return new Float32Array(4 * (INTERVALS + 1)).fill(R);
}

/**
 * A table of 8-bit texels at cosines j / (N - 1), which hold no more than 0 to 1.
 * @param {Float32Array} texels
 * @param {number} size N
 * @returns {Uint8Array}
 */
export function tableOf(texels, size) {
  const table = new Uint8Array(4 * size);
  for (let j = 0; j < size; j += 1) {
    const at = (j / (size - 1)) * INTERVALS;
    const i = Math.min(Math.floor(at), INTERVALS - 1);
    for (let c = 0; c < 4; c += 1) {
      const a = /** @type {number} */ (texels[4 * i + c]);
      const b = /** @type {number} */ (texels[4 * i + 4 + c]);
      table[4 * j + c] = Math.round(255 * Math.min(1, Math.max(0, a + (at - i) * (b - a))));
    }
  }
  return table;
}
