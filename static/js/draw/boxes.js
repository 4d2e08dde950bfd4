/** Rectangles and segments in pixels: what labels must not cover. */

/**
 * @param {Box} box
 * @param {number} by grown by this on every side
 * @returns {Box}
 */
export function grown(box, by) {
  return {
    x: box.x - by,
    y: box.y - by,
    width: box.width + 2 * by,
    height: box.height + 2 * by,
  };
}

/**
 * @param {Box} a
 * @param {Box} b
 */
export function overlap(a, b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

/**
 * @param {Box} inner
 * @param {Box} outer
 */
export function within(inner, outer) {
  return (
    inner.x >= outer.x &&
    inner.y >= outer.y &&
    inner.x + inner.width <= outer.x + outer.width &&
    inner.y + inner.height <= outer.y + outer.height
  );
}

/**
 * Whether a segment meets a box (Liang and Barsky's clipping).
 * @param {Segment} segment
 * @param {Box} box
 */
export function crosses({ x1, y1, x2, y2 }, box) {
  const dx = x2 - x1;
  const dy = y2 - y1;
  let enter = 0;
  let leave = 1;
  for (const [p, q] of /** @type {[number, number][]} */ ([
    [-dx, x1 - box.x],
    [dx, box.x + box.width - x1],
    [-dy, y1 - box.y],
    [dy, box.y + box.height - y1],
  ])) {
    if (p === 0) {
      if (q < 0) return false;
      continue;
    }
    const t = q / p;
    if (p < 0) enter = Math.max(enter, t);
    else leave = Math.min(leave, t);
    if (enter > leave) return false;
  }
  return true;
}

/**
 * How far a box reaches from its centre in a direction, so that a label can be set just outside a
 * circle or a line.
 * @param {{width: number, height: number}} size
 * @param {number} dx unit direction
 * @param {number} dy
 */
export function reach({ width, height }, dx, dy) {
  return (Math.abs(dx) * width + Math.abs(dy) * height) / 2;
}

/**
 * @param {{x: number, y: number}} centre
 * @param {{width: number, height: number}} size
 * @returns {Box}
 */
export function boxOf({ x, y }, { width, height }) {
  return { x: x - width / 2, y: y - height / 2, width, height };
}
