/** Numbers as the page writes them and as people move them; what is copied is always the full double. */

export const MINUS = "\u2212";
const SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/** @param {string} text @returns {string} with a minus sign in place of a hyphen */
export function signed(text) {
  return text.replace(/-/g, MINUS);
}

/**
 * A number with the given significant digits; exact 0 and exact 1 stay bare.
 * @param {number | null | undefined} x
 * @param {number} [digits]
 * @returns {string}
 */
export function significant(x, digits = 6) {
  if (x === null || x === undefined || !Number.isFinite(x)) return "none";
  if (Object.is(x, -0) || x === 0) return "0";
  if (Math.abs(x) === 1) return signed(String(x));
  const size = Math.abs(x);
  if (size >= 1e-4 && size < 10 ** digits) return signed(x.toPrecision(digits));
  const [mantissa = "", exponent = "0"] = x.toExponential(digits - 1).split("e");
  const power = [...exponent.replace("+", "")]
    .map((c) => (c === "-" ? "⁻" : SUPERSCRIPTS[Number(c)]))
    .join("");
  return `${signed(mantissa)} × 10${power}`;
}

/** @param {number | null | undefined} x @returns {string} six significant digits */
export function six(x) {
  return significant(x, 6);
}

/**
 * A number as people type it: no trailing zeros, at most `digits` significant ones.
 * @param {number} x
 * @param {number} [digits]
 */
export function plain(x, digits = 6) {
  return signed(String(Number(x.toPrecision(digits))));
}

/**
 * A unit as it stands behind a number: degrees close up, others keep a space.
 * @param {string | undefined} unit
 */
export function unitSuffix(unit) {
  if (!unit) return "";
  return unit === "°" ? unit : ` ${unit.trim()}`;
}

/** @param {number} x a share from 0 to 1 @returns {string} such as "11.3 %" */
export function percent(x) {
  const hundredfold = 100 * x;
  // 100.0 % and 0.0 % are claims: they are written only where they are true.
  if (hundredfold > 99.95 && hundredfold < 100) return "> 99.9\u00a0%";
  if (hundredfold > 0 && hundredfold < 0.05) return "< 0.1\u00a0%";
  return `${signed(hundredfold.toFixed(1))}\u00a0%`;
}

/** @param {number} deg @param {'deg' | 'rad'} unit @returns {number} the angle in that unit */
export function inUnit(deg, unit) {
  return unit === "rad" ? (deg * Math.PI) / 180 : deg;
}

/** @param {number} value @param {'deg' | 'rad'} unit @returns {number} the angle in degrees */
export function inDegrees(value, unit) {
  return unit === "rad" ? (value * 180) / Math.PI : value;
}

/**
 * An angle given in degrees, written in the unit that the page shows.
 * @param {number | null | undefined} deg
 * @param {'deg' | 'rad'} unit
 * @param {number} [digits] decimals; by default 2 for degrees and 4 for radians
 */
export function angle(deg, unit, digits) {
  if (deg === null || deg === undefined || !Number.isFinite(deg)) return "none";
  const text = inUnit(deg, unit).toFixed(digits ?? (unit === "rad" ? 4 : 2));
  return (
    signed(/^-0\.?0*$/.test(text) ? text.slice(1) : text) + (unit === "rad" ? "\u00a0rad" : "°")
  );
}

/**
 * @param {number} value
 * @param {number[]} landmarks
 * @param {number} tolerance
 * @returns {number} the nearest landmark within the tolerance, else the value
 */
export function snap(value, landmarks, tolerance) {
  let best = value;
  let distance = tolerance;
  for (const mark of landmarks) {
    const d = Math.abs(mark - value);
    if (d <= distance) {
      best = mark;
      distance = d;
    }
  }
  return best;
}

/**
 * One step from a value: it lands on the grid of the step and stops at a landmark on the way.
 * @param {number} value
 * @param {number} step signed
 * @param {number[]} landmarks
 * @returns {number}
 */
export function stepped(value, step, landmarks) {
  const size = Math.abs(step);
  const up = step > 0;
  const grid = value / size;
  const near = Math.round(grid);
  // A value that is on the grid but for rounding moves a whole step, any other goes to the next line.
  const on = Math.abs(grid - near) < 1e-6;
  const line = on ? near + (up ? 1 : -1) : up ? Math.ceil(grid) : Math.floor(grid);
  const target = tidy(line * size);
  const between = landmarks.filter((m) => (up ? m > value && m < target : m < value && m > target));
  if (between.length === 0) return target;
  return up ? Math.min(...between) : Math.max(...between);
}

/** @param {number} value @returns {number} without the last digits' noise of a multiple of 0.001 */
export function tidy(value) {
  return Number(value.toFixed(9));
}

/** @param {number} value @param {number} low @param {number} high */
export function clamp(value, low, high) {
  return Math.min(high, Math.max(low, value));
}
