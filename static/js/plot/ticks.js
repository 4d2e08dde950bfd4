/** Where ticks stand, and ranges that end at them. */

import { plain } from "../numbers/format.js";

const DEGREE_STEPS = [15, 30, 45, 90, 180];

/**
 * The smallest of 1, 2, 5 times a power of ten that is at least `least`.
 * @param {number} least
 */
export function roundStep(least) {
  const power = 10 ** Math.floor(Math.log10(least));
  const factor = [1, 2, 5, 10].find((candidate) => candidate * power >= least * (1 - 1e-9)) ?? 10;
  return factor * power;
}

/**
 * Multiples of a step inside a range.
 * @param {number} low
 * @param {number} high
 * @param {number} step
 */
function multiples(low, high, step) {
  const values = [];
  const slack = step * 1e-9;
  for (let n = Math.ceil((low - slack) / step); n * step <= high + slack; n += 1) {
    values.push(Number((n * step).toPrecision(12)));
  }
  return values;
}

/**
 * Every second, third … of the ticks, so that they stand at least `spacing` px apart.
 * @param {Tick[]} ticks ascending, equally spaced
 * @param {number} apart px from one to the next
 * @param {number} spacing px
 */
function thinned(ticks, apart, spacing) {
  const every = Math.max(1, Math.ceil(spacing / apart - 1e-9));
  const last = ticks.length - 1;
  // The ends of a range are kept where the count allows: 0, 30, 60, 90 and not 0, 45.
  const kept = [every, every + 1, every + 2].find((n) => last % n === 0) ?? every;
  return ticks.filter((_, index) => index % kept === 0);
}

/**
 * Ticks of an axis of a length.
 * @param {Pick<Axis, "ticks" | "unit" | "scale">} axis
 * @param {readonly [number, number]} range
 * @param {number} length px
 * @param {number} spacing smallest distance of two ticks in px
 * @returns {Tick[]}
 */
export function axisTicks(axis, range, length, spacing) {
  const low = Math.min(...range);
  const high = Math.max(...range);
  const span = high - low || 1;
  const suffix = axis.unit === "°" ? "°" : "";
  if (axis.ticks) {
    // an array has a method called `values`, so that is no way to tell them apart
    const { values, text } =
      "text" in axis.ticks
        ? axis.ticks
        : { values: axis.ticks, text: /** @type {string[]} */ ([]) };
    const given = values.map((value, index) => ({
      value,
      label: text[index] ?? plain(value, 12) + suffix,
    }));
    const place = axis.scale === "log" ? Math.log10 : Number;
    const whole = place(high) - place(low) || 1;
    const apart = (Math.abs(place(values[1] ?? high) - place(values[0] ?? low)) / whole) * length;
    return thinned(given, apart, spacing);
  }
  const least = (spacing / Math.max(length, 1)) * span;
  const step =
    (suffix && span >= 45 && DEGREE_STEPS.find((candidate) => candidate >= least * (1 - 1e-9))) ||
    roundStep(least);
  return multiples(low, high, step).map((value) => ({ value, label: plain(value, 12) + suffix }));
}

/**
 * Ticks of a logarithmic axis: 1, 2 and 5 of each decade, or 1 alone, or every second decade ...
 * @param {readonly [number, number]} range
 * @param {number} length px
 * @param {number} spacing smallest distance of two ticks in px
 * @returns {Tick[]}
 */
export function logTicks(range, length, spacing) {
  const [low, high] = [Math.min(...range), Math.max(...range)];
  const decades = Math.log10(high / low) || 1;
  const decade = length / decades;
  /** @param {readonly number[]} factors @param {number} every */
  const at = (factors, every) => {
    const values = [];
    const first = Math.floor(Math.log10(low));
    for (let power = first; power <= Math.log10(high); power += 1) {
      if (power % every !== 0) continue;
      for (const factor of factors) {
        const value = Number((factor * 10 ** power).toPrecision(6));
        if (value >= low * (1 - 1e-9) && value <= high * (1 + 1e-9)) values.push(value);
      }
    }
    return values;
  };
  const sets = [
    { factors: [1, 2, 3, 4, 5, 6, 7, 8, 9], apart: Math.log10(10 / 9) },
    { factors: [1, 2, 3, 5, 7], apart: Math.log10(7 / 5) },
    { factors: [1, 2, 5], apart: Math.log10(2) },
    { factors: [1, 3], apart: Math.log10(3) },
  ];
  const dense = sets.find(({ apart }) => apart * decade >= spacing);
  const every = dense ? 1 : Math.max(1, Math.ceil(spacing / decade - 1e-9));
  return at(dense?.factors ?? [1], every).map((value) => ({ value, label: plain(value, 12) }));
}

/**
 * A range that holds all values and ends at round numbers.
 * @param {Iterable<readonly (number | null)[]>} series
 * @returns {[number, number]}
 */
export function roundRange(series) {
  let low = Number.POSITIVE_INFINITY;
  let high = Number.NEGATIVE_INFINITY;
  for (const values of series) {
    for (const value of values) {
      if (value === null || !Number.isFinite(value)) continue;
      if (value < low) low = value;
      if (value > high) high = value;
    }
  }
  if (low > high) return [0, 1];
  if (low === high) {
    const around = Math.abs(low) || 1;
    return low === 0 ? [0, 1] : [low - around / 2, high + around / 2];
  }
  const step = roundStep((high - low) / 8);
  return [
    Number((Math.floor(low / step + 1e-9) * step).toPrecision(12)),
    Number((Math.ceil(high / step - 1e-9) * step).toPrecision(12)),
  ];
}
