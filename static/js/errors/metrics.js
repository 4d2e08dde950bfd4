/** The columns of the table of errors: what they hold, how it is written and sorted. */

import { angle, percent, significant } from "../numbers/format.js";
import { byColumn } from "../numbers/sorted.js";

/**
 * @typedef {object} Row the measured errors of one model
 * @property {string} model
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
 * @typedef {{unit: 'deg' | 'rad', titles: ReadonlyMap<string, string>, costs: ReadonlyMap<string, Cost>,
 *   prices: ReadonlyMap<string, number>}} Setting `prices` are the server's weighted costs
 * @typedef {Record<string, number>} Cost
 *
 * @typedef {object} Column
 * @property {string} name
 * @property {string} heading
 * @property {string} note
 * @property {(row: Row, setting: Setting) => number | string | null} value to sort by and to copy
 * @property {(row: Row, setting: Setting) => string} print
 */

const DIGITS = 3;

/** An error as a short number: three digits, none of them an invention. @param {number | null | undefined} x */
export function short(x) {
  if (x === null || x === undefined || !Number.isFinite(x)) return "none";
  const size = Math.abs(x);
  if (size !== 0 && size < 5e-7) return significant(x, 2);
  if (size >= 1e-4 && size < 10) {
    const text = significant(Number(x.toPrecision(DIGITS)), DIGITS);
    return text;
  }
  return significant(x, DIGITS);
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
  const parts = OPERATIONS.flatMap(([name, sign]) => {
    const count = cost?.[name] ?? 0;
    return count === 0 ? [] : [sign.length > 1 ? `${count}\u00a0${sign}` : `${count}${sign}`];
  });
  return parts.join(" ") || "0";
}

/** @param {Cost | undefined} cost for those who hear it */
export function sayCost(cost) {
  return (
    Object.entries(cost ?? {})
      .filter(([, count]) => count > 0)
      .map(([name, count]) => `${count} ${name}`)
      .join(", ") || "nothing"
  );
}

/** @type {Column[]} */
export const COLUMNS = [
  {
    name: "model",
    heading: "model",
    note: "",
    value: (row, { titles }) => titles.get(row.model) ?? row.model,
    print: (row, { titles }) => titles.get(row.model) ?? row.model,
  },
  {
    name: "max_abs",
    heading: "largest",
    note: "largest absolute error of R over the hemisphere",
    value: (row) => row.max_abs,
    print: (row) => short(row.max_abs),
  },
  {
    name: "max_abs_at_deg",
    heading: "at",
    note: "angle of the largest absolute error",
    value: (row) => row.max_abs_at_deg,
    print: (row, { unit }) => angle(row.max_abs_at_deg, unit, unit === "deg" ? 1 : 3),
  },
  {
    name: "rms",
    heading: "RMS",
    note: "root mean square error over the hemisphere, each solid angle alike",
    value: (row) => row.rms,
    print: (row) => short(row.rms),
  },
  {
    name: "max_relative",
    heading: "relative",
    note: "largest error relative to the exact R",
    value: (row) => row.max_relative,
    print: (row) => (row.rms === null ? short(null) : share(row.max_relative)),
  },
  {
    name: "cosine_weighted_mean",
    heading: "albedo",
    note: "mean signed error weighted by the cosine, which is the error of the hemispherical albedo",
    value: (row) => row.cosine_weighted_mean,
    print: (row) => short(row.cosine_weighted_mean),
  },
  {
    name: "cost",
    heading: "cost",
    note: "operations of one evaluation: multiplications, additions, divisions, roots, powers",
    value: (row, { costs, prices }) => prices.get(row.model) ?? operations(costs.get(row.model)),
    print: (row, { costs }) => printCost(costs.get(row.model)),
  },
];

/**
 * Rows by a column; what has no value comes last in either order, signed errors go by their size.
 * @param {readonly Row[]} rows
 * @param {string} by
 * @param {'up' | 'down'} order
 * @param {Setting} setting
 * @returns {Row[]}
 */
export function sorted(rows, by, order, setting) {
  const column = COLUMNS.find((c) => c.name === by) ?? /** @type {Column} */ (COLUMNS[0]);
  return byColumn(
    rows,
    (row) => {
      const value = column.value(row, setting);
      return typeof value === "number" ? Math.abs(value) : value;
    },
    order,
  );
}
