/** What the server tells of the atlas, as materials one by one. */

/**
 * @typedef {{kind: string, materials: number, within: number, undefined: number, median: number | null,
 *   largest: number | null, largest_of: string | null}} Share
 * @typedef {{model: string, title: string, trap: boolean, kinds: Share[], sentence: string}} ModelShare
 * @typedef {{program: string, database: string, date: string, wavelengths: string, materials: number,
 *   left_out: string[]}} Made
 * @typedef {{made: Made, model: string, metric: string, within: number, sentence: string, kinds: Share[],
 *   models: ModelShare[], shelves: Record<string, number>, total: number,
 *   points: Record<string, any[]>}} Answer of /atlas
 * @typedef {{id: string, name: string, kind: string, shelf: string, n: number, k: number | null, F0: number,
 *   wavelength_nm: number | null, error: number | null, error_at_nm: number | null,
 *   error_at_deg: number | null, in_domain: boolean}} Point
 * @typedef {{model: string, title: string, max_abs: (number | null)[], max_abs_at_deg: (number | null)[],
 *   rms: (number | null)[], albedo_error: (number | null)[], delta_e: number | null,
 *   in_domain: boolean[]}} Rows
 * @typedef {{material: string, name: string, kind: string, shelf: string, models: Rows[]}} OfMaterial of
 *   /atlas/material
 */

/** @param {Answer} answer @returns {Point[]} the one with the largest error first, undefined ones last */
export function pointsOf({ points }) {
  const { material: ids = [], ...columns } = points;
  return ids.map((id, at) => {
    const fields = Object.entries(columns).map(([name, values]) => [name, values[at]]);
    return /** @type {Point} */ ({ id, ...Object.fromEntries(fields) });
  });
}

/** The largest error of a model over the wavelengths. @param {Rows} rows @param {string} metric @returns {number | null} */
export function largestOf(rows, metric) {
  if (metric === "delta_e") return rows.delta_e;
  const values = /** @type {Record<string, any>} */ (rows)[metric];
  const sizes = values.map((/** @type {number | null} */ v) => (v === null ? v : Math.abs(v)));
  return sizes.includes(null) ? null : Math.max(...sizes);
}
