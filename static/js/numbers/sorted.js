/** Rows of a table by one of its columns. */

/**
 * What has no value comes last in either order; equals keep theirs.
 * @template Row
 * @param {readonly Row[]} rows
 * @param {(row: Row) => number | string | null} value
 * @param {'up' | 'down'} order
 * @returns {Row[]}
 */
export function byColumn(rows, value, order) {
  const sign = order === "up" ? 1 : -1;
  return [...rows].sort((a, b) => {
    const [x, y] = [value(a), value(b)];
    if (x === null || y === null) return x === y ? 0 : x === null ? 1 : -1;
    if (typeof x === "string" || typeof y === "string")
      return sign * String(x).localeCompare(String(y), "en", { numeric: true });
    return sign * (x - y);
  });
}
