/** Lines of equal value through a grid, by marching squares. */

/**
 * @typedef {[number, number]} Place
 * @param {readonly number[]} x ascending
 * @param {readonly number[]} y ascending
 * @param {readonly (readonly (number | null)[])[]} z a row for each y
 * @param {number} level
 * @returns {[Place, Place][]} segments in the units of x and y
 */
export function contour(x, y, z, level) {
  /** @type {[Place, Place][]} */
  const segments = [];
  for (let row = 0; row + 1 < y.length; row += 1) {
    const below = z[row] ?? [];
    const above = z[row + 1] ?? [];
    for (let column = 0; column + 1 < x.length; column += 1) {
      const [a, b, c, d] = [below[column], below[column + 1], above[column + 1], above[column]];
      if (a == null || b == null || c == null || d == null) continue;
      const sides =
        (a > level ? 1 : 0) | (b > level ? 2 : 0) | (c > level ? 4 : 0) | (d > level ? 8 : 0);
      if (sides === 0 || sides === 15) continue;
      const [x0, x1] = [x[column] ?? 0, x[column + 1] ?? 0];
      const [y0, y1] = [y[row] ?? 0, y[row + 1] ?? 0];
      /** @param {number} from @param {number} to */
      const part = (from, to) => (level - from) / (to - from);
      /** @type {Place[]} crossings of the cell's bottom, right, top and left side, as far as there are any */
      const crossings = [];
      if (a > level !== b > level) crossings.push([x0 + (x1 - x0) * part(a, b), y0]);
      if (b > level !== c > level) crossings.push([x1, y0 + (y1 - y0) * part(b, c)]);
      if (d > level !== c > level) crossings.push([x0 + (x1 - x0) * part(d, c), y1]);
      if (a > level !== d > level) crossings.push([x0, y0 + (y1 - y0) * part(a, d)]);
      for (let i = 0; i + 1 < crossings.length; i += 2)
        segments.push([
          /** @type {Place} */ (crossings[i]),
          /** @type {Place} */ (crossings[i + 1]),
        ]);
    }
  }
  return segments;
}
