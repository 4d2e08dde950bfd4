/** The columns of the table of errors: what they hold, how it is written and sorted. */

import { angle, percent, significant } from "../numbers/format.js";
import { byColumn } from "../numbers/sorted.js";

/**
 * @typedef {object} Row the measured errors of one model
 * @property {string} model
 * @property {string} title
 * @property {string} quantity R, or one of R_red, R_green, R_blue
 * @property {boolean} in_domain
 * @property {string | null} reason
 * @property {number | null} max_abs
 * @property {number | null} max_abs_at_deg
 * @property {number | null} rms
 * @property {number | null} cosine_weighted_mean
 * @property {number | null} max_relative
 * @property {Record<string, number | null>} parameters given or solved
 *
 * @typedef {{unit: 'deg' | 'rad', costs: ReadonlyMap<string, Cost>, prices: ReadonlyMap<string, number>}} Setting
 *   `prices` are the server's weighted costs
 * @typedef {Record<string, number>} Cost
 *
 * @typedef {object} Column
 * @property {string} name
 * @property {string} heading
 * @property {string} note
 * @property {(row: Row, setting: Setting) => number | string | null} value to sort by and to copy
 * @property {(row: Row, setting: Setting) => string} print
 */

/** What an error over all angles may be measured by. */
export const METRICS = {
  max_abs: "largest error",
  rms: "RMS error",
  cosine_weighted_mean: "cosine-weighted mean",
  max_relative: "largest relative error",
};

/** An error as a short number: three digits, none of them an invention. @param {number | null | undefined} x */
export function short(x) {
  if (x === null || x === undefined || !Number.isFinite(x)) return "none";
  const size = Math.abs(x);
  if (size !== 0 && size < 5e-7) return significant(x, 2);
  // What rounds to 1 is written as 1, without digits that it does not have.
  const rounded = size >= 1e-4 && size < 10 ? Number(x.toPrecision(3)) : x;
  return significant(rounded, 3);
}

/** @param {number | null} x */
function share(x) {
  if (x === null) return "∞";
  return x < 1e-12 ? short(x) : x >= 10 ? `${significant(100 * x, 3)}\u00a0%` : percent(x);
}

/** @param {Cost | undefined} cost */
function operations(cost) {
  return Object.values(cost ?? {}).reduce((sum, count) => sum + count, 0);
}

const OPERATIONS = /** @type {const} */ ([
  ["mul", "×"],
  ["add", "+"],
  ["div", "÷"],
  ["sqrt", "√"],
  ["pow", "^"],
  ["trig", "trig"],
  ["lookup", "texel"],
]);

/** @param {Cost | undefined} cost such as "4× 2+" */
export function printCost(cost) {
  const parts = OPERATIONS.filter(([name]) => cost?.[name]).map(
    ([name, sign]) => `${cost?.[name]}${sign.length > 1 ? "\u00a0" : ""}${sign}`,
  );
  return parts.join(" ") || "0";
}

/** @param {Cost | undefined} cost for those who hear it */
export function sayCost(cost) {
  const parts = Object.entries(cost ?? {}).filter(([, count]) => count > 0);
  return parts.map(([name, count]) => `${count} ${name}`).join(", ") || "nothing";
}

/**
 * @param {keyof Row} name
 * @param {string} heading
 * @param {string} note
 * @param {Column["print"]} [print]
 * @returns {Column}
 */
const measured = (name, heading, note, print) => {
  const value = (/** @type {Row} */ row) => /** @type {number | null} */ (row[name]);
  return { name, heading, note, value, print: print ?? ((row) => short(value(row))) };
};

/** @type {Column[]} */
export const COLUMNS = [
  { name: "model", heading: "model", note: "", value: (r) => r.title, print: (r) => r.title },
  measured("max_abs", "largest", "largest absolute error of R over the hemisphere"),
  measured("max_abs_at_deg", "at", "angle of the largest absolute error", (row, { unit }) =>
    angle(row.max_abs_at_deg, unit, unit === "deg" ? 1 : 3),
  ),
  measured("rms", "RMS", "root mean square error over the hemisphere, each solid angle alike"),
  measured("max_relative", "relative", "largest error relative to the exact R", (row) =>
    row.rms === null ? short(null) : share(row.max_relative),
  ),
  measured(
    "cosine_weighted_mean",
    "albedo",
    "mean signed error weighted by the cosine, which is the error of the hemispherical albedo",
  ),
  {
    name: "cost",
    heading: "cost",
    note: "operations of one evaluation: multiplications, additions, divisions, roots, powers",
    value: ({ model }, { costs, prices }) => prices.get(model) ?? operations(costs.get(model)),
    print: ({ model }, { costs }) => printCost(costs.get(model)),
  },
];

/**
 * Rows by a column; what has no value comes last in either order, signed errors go by their size.
 * @param {readonly Row[]} rows
 * @param {string} by
 * @param {'up' | 'down'} order
 * @param {Setting} setting
 */
export function sorted(rows, by, order, setting) {
  const column = COLUMNS.find((c) => c.name === by) ?? /** @type {Column} */ (COLUMNS[0]);
  const size = (/** @type {Row} */ row) => {
    const value = column.value(row, setting);
    return typeof value === "number" ? Math.abs(value) : value;
  };
  return byColumn(rows, size, order);
}
