/** Media that the page does not start with: pages of refractiveindex.info, and materials of one's own. */

import { load } from "../server/api.js";

const FIELDS = [
  ...["id", "name", "category", "n", "n_absolute", "k", "wavelength_nm", "kind", "rival_of"],
  ...["n_range_nm", "aliases", "source"],
];
/** What tables show besides. */
const SHOWN = [...FIELDS, "n_min", "n_max", "confidence", "sample", "color", "swatch", "page"];
const MOST_FOUND = 60;

/** @param {string} id */
export const isPage = (id) => id.startsWith("rii:");

/** Shelf, book and page. @param {string} id */
export const pathOf = (id) => id.slice(4);

/**
 * Pages that a text fits, best first, and how many of them come before all presets, as those of tin.
 * @param {string} text
 * @returns {Promise<{rows: Material[], leading: number}>}
 */
export async function findPages(text) {
  const fields = `fields=${FIELDS.join(",")}`;
  const q = encodeURIComponent(text.trim().slice(0, 100));
  const { materials } = await load(`/materials?limit=${MOST_FOUND}&${fields}&q=${q}`);
  const leading = materials.findIndex((/** @type {Material} */ { id }) => !isPage(id));
  const rows = materials.filter((/** @type {Material} */ { id }) => isPage(id));
  return { rows, leading: Math.max(leading, 0) };
}

/** What the list has of a medium. @param {string} id @returns {Promise<Material>} */
export async function rowOf(id) {
  const all = await load(`/materials/${encodeURIComponent(id)}`);
  return /** @type {any} */ (Object.fromEntries(SHOWN.map((name) => [name, all[name]])));
}

/** Make it a medium like any other. @param {Material[]} materials @param {Material} row */
export function add(materials, row) {
  if (!materials.some(({ id }) => id === row.id)) materials.push(row);
}

/** Make a page a medium, unless it is one. @param {Material[]} materials @param {string} id */
export async function become(materials, id) {
  if (!materials.some((one) => one.id === id)) add(materials, await rowOf(id));
}
