/** Reading between the samples of a curve that the server computed. */

/**
 * The sample interval that holds x: the largest i with xs[i] <= x, and the fraction of the way on.
 * @param {number[]} xs ascending
 * @param {number} x
 * @returns {{index: number, fraction: number}}
 */
export function locate(xs, x) {
  let low = 0;
  let high = xs.length - 1;
  if (high < 1 || x <= /** @type {number} */ (xs[0])) return { index: 0, fraction: 0 };
  if (x >= /** @type {number} */ (xs[high])) return { index: high, fraction: 0 };
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (/** @type {number} */ (xs[middle]) <= x) low = middle;
    else high = middle;
  }
  const x0 = /** @type {number} */ (xs[low]);
  const x1 = /** @type {number} */ (xs[high]);
  return { index: low, fraction: x1 > x0 ? (x - x0) / (x1 - x0) : 0 };
}

/**
 * Linear interpolation; null where either neighbour is missing, unless x is a sample itself.
 * @param {(number | null)[]} values
 * @param {{index: number, fraction: number}} place
 * @returns {number | null}
 */
export function read(values, { index, fraction }) {
  const here = values[index] ?? null;
  if (fraction === 0 || here === null) return here;
  const next = values[index + 1] ?? null;
  return next === null ? null : here + fraction * (next - here);
}
