/** Materials of one's own: rows of the catalog whose id is their data, kept in this browser. */

import { load } from "../server/api.js";

const PLACE = "own-materials";
const MOST_KEPT = 40;
const OWN = "own:";

/** @param {string} text whether an id is that of a material of one's own */
export const isOwn = (text) => text.startsWith(OWN);

/** @returns {Material[]} what this browser keeps, the newest first */
export function keptRows() {
  try {
    const rows = JSON.parse(localStorage.getItem(PLACE) ?? "[]");
    return Array.isArray(rows) ? rows.filter((row) => isOwn(String(row?.id))) : [];
  } catch {
    return []; // storage that is forbidden or damaged keeps nothing
  }
}

/** @param {Material[]} rows */
function store(rows) {
  try {
    localStorage.setItem(PLACE, JSON.stringify(rows.slice(0, MOST_KEPT)));
  } catch {
    // it lasts as long as the page then, or the link
  }
}

/** Make it a medium like any other. @param {Catalog} catalog @param {Material} row */
function add({ materials }, row) {
  if (!materials.some(({ id }) => id === row.id)) materials.push(row);
}

/** What the catalog has of each medium. @param {string} id @returns {Promise<Material>} */
async function rowOf(id) {
  const all = await load(`/materials/${encodeURIComponent(id)}`);
  const { name, category, n, n_absolute, k, wavelength_nm, kind, rival_of, n_range_nm } = all;
  const { aliases, source } = all;
  return {
    ...{ id: all.id, name, category, n, n_absolute, k, wavelength_nm, kind, rival_of },
    ...{ n_range_nm, aliases, source },
  };
}

/** @param {Catalog} catalog @param {string} id */
export async function keep(catalog, id) {
  const row = await rowOf(id);
  add(catalog, row);
  store([row, ...keptRows().filter((one) => one.id !== id)]);
}

/** It stays a medium until the page is left, as it may be shown. @param {string} id */
export function forget(id) {
  store(keptRows().filter((one) => one.id !== id));
}

/**
 * Add those that this browser keeps and those that a link brings along.
 * @param {Catalog} catalog
 * @param {string} search
 * @returns {Promise<void>}
 */
export async function bring(catalog, search) {
  for (const row of keptRows()) add(catalog, row);
  const linked = [...new URLSearchParams(search).values()].filter(isOwn);
  const missing = linked.filter((id) => !catalog.materials.some((m) => m.id === id));
  const rows = await Promise.allSettled([...new Set(missing)].map(rowOf));
  // One that is broken stays out, and the link is told to name no medium.
  for (const row of rows) if (row.status === "fulfilled") add(catalog, row.value);
}
