/** The band of R where a source gives n from one value to another. */

import { inUnit } from "../numbers/format.js";
import { values } from "./reading.js";

/** @param {any} answer of /curves?band=true, if there is one @param {"deg" | "rad"} unit @returns {Band[]} */
export function bandsOf(answer, unit) {
  if (!answer) return [];
  const [low = [], high = []] = ["R_minimum", "R_maximum"].map((q) => values(answer, q));
  const x = answer.theta_i_deg.map((/** @type {number} */ deg) => inUnit(deg, unit));
  return [{ id: "range", x, low, high, color: "--R" }];
}
