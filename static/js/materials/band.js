/** What several measurements of one quantity span. */

import { locate, read } from "../curves/reading.js";

/**
 * @typedef {{x: number[], y: (number | null)[]}} Series
 * @typedef {{x: number[], low: (number | null)[], high: (number | null)[]}} Band
 */

/** The value between two samples, null outside the series' own range. @param {Series} series @param {number} x */
export function valueAt({ x: xs, y }, x) {
  const [first, last] = [xs[0], xs.at(-1)];
  if (first === undefined || last === undefined || x < first || x > last) return null;
  return read(y, locate(xs, x));
}

/**
 * The least and the largest of all series wherever at least two of them are known.
 * @param {readonly Series[]} all
 * @param {readonly [number, number]} range
 * @param {number} steps
 * @param {boolean} [log] whether the abscissas stand in equal ratios
 * @returns {Band}
 */
export function spanned(all, [from, to], steps, log = false) {
  const x = Array.from({ length: steps }, (_, i) => {
    const part = i / (steps - 1);
    return log ? from * (to / from) ** part : from + part * (to - from);
  });
  const columns = x.map((at) => all.map((series) => valueAt(series, at)).filter((v) => v !== null));
  return {
    x,
    low: columns.map((c) => (c.length > 1 ? Math.min(...c) : null)),
    high: columns.map((c) => (c.length > 1 ? Math.max(...c) : null)),
  };
}

/**
 * A series inside a range of abscissas, its ends interpolated where it goes on beyond them.
 * @param {Series} series
 * @param {readonly [number, number]} range
 * @returns {Series}
 */
export function within(series, [from, to]) {
  /** @type {Series} */
  const cut = { x: [], y: [] };
  /** @param {number} x @param {number | null} y */
  const add = (x, y) => {
    if (cut.x.at(-1) === x) return;
    cut.x.push(x);
    cut.y.push(y);
  };
  const [first = Infinity, last = -Infinity] = [series.x[0], series.x.at(-1)];
  if (first < from && last > from) add(from, valueAt(series, from));
  series.x.forEach((x, i) => {
    if (x >= from && x <= to) add(x, series.y[i] ?? null);
  });
  if (last > to && first < to) add(to, valueAt(series, to));
  return cut;
}

/** A series without what is not known at its ends. @param {readonly number[]} x @param {readonly (number | null)[]} y @returns {Series} */
export function known(x, y) {
  const kept = x.flatMap((_, i) => (y[i] === null || y[i] === undefined ? [] : [i]));
  return { x: kept.map((i) => x[i] ?? 0), y: kept.map((i) => y[i] ?? null) };
}
