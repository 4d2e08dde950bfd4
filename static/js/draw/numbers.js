/** Numbers as the pictures write them: a minus sign, not a hyphen, and no trailing noise. */

/**
 * @param {string} text of a number
 */
export function withMinus(text) {
  return text.replace(/-/gu, "−");
}

/**
 * A number as short as it can be without loss beyond twelve digits.
 * @param {number} value
 */
export function decimal(value) {
  return withMinus(String(Number(value.toPrecision(12))));
}

/**
 * Six significant digits; powers of ten where a decimal would be unreadable.
 * @param {number} value
 */
export function sixDigits(value) {
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e-4 && size < 1e7) return withMinus(value.toPrecision(6));
  return withMinus(value.toExponential(5));
}

/**
 * A share of one in percent, with the digits that a picture can use.
 * @param {number} share
 */
export function percent(share) {
  const value = share * 100;
  if (value === 0) return "0 %";
  if (value < 0.01) return "< 0.01 %";
  if (value < 1) return `${value.toFixed(2)} %`;
  // 99.97 must not be rounded up to a whole that is not there
  return `${value > 99.9 && value < 100 ? Math.min(value, 99.99).toFixed(2) : value === 100 ? "100" : value.toFixed(1)} %`;
}
