/** Landmarks hold a moving value: dragging snaps to them, a step does not jump over them. */

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
