/** What the diagram says in words: short labels on it, and a description for those who hear it. */

import { angle, percent, plain } from "../numbers/format.js";

/**
 * @param {"n_i" | "n_t"} symbol
 * @param {number} n
 * @param {number} k
 */
export function indexText(symbol, n, k) {
  return k > 0 ? `${symbol} = ${plain(n, 5)} + ${plain(k, 5)} i` : `${symbol} = ${plain(n, 5)}`;
}

/** @param {number | null} depth in vacuum wavelengths */
export function depthText(depth) {
  if (depth === null) return "";
  const size = depth >= 1000 ? "> 1000" : depth < 0.001 ? "< 0.001" : plain(depth, 3);
  return `penetration depth ${size} λ`;
}

/**
 * @param {object} values
 * @param {{n_i: number, n_t: number, k_t: number}} values.interface
 * @param {{incident: string, transmitted: string}} values.labels
 * @param {number} values.theta_i_deg
 * @param {number | null} values.theta_t_deg
 * @param {boolean} values.tir
 * @param {number} values.reflected share
 * @param {number} values.passed share
 * @param {number | null} values.depth
 * @param {string} values.polarization
 * @param {"deg" | "rad"} values.angleUnit
 */
export function description({
  interface: media,
  labels,
  theta_i_deg,
  theta_t_deg,
  tir,
  reflected,
  passed,
  depth,
  polarization,
  angleUnit,
}) {
  const light =
    polarization === "unpolarized" ? "Unpolarized light" : `${polarization}-polarized light`;
  const index = media.k_t > 0 ? `${plain(media.n_t)} + ${plain(media.k_t)} i` : plain(media.n_t);
  const first = `${light} in ${labels.incident} (index ${plain(media.n_i)}) meets ${labels.transmitted} (index ${index}) at ${angle(theta_i_deg, angleUnit)} from the normal.`;
  const then = tir
    ? "All of it is reflected: total internal reflection."
    : `${percent(reflected)} is reflected, ${percent(passed)} is transmitted${
        theta_t_deg === null ? "" : ` at ${angle(theta_t_deg, angleUnit)}`
      }.`;
  const deep = depth === null ? "" : `The ${depthText(depth).replace("λ", "vacuum wavelengths")}.`;
  return [first, then, deep].filter(Boolean).join(" ");
}
