/** Materials of one's own: rows of the catalog whose id is their data, kept in this browser. */

import { add, isPage, rowOf } from "../media/brought.js";
import { Problem } from "../server/api.js";
import { refusals } from "../state/state.js";

const PLACE = "own-materials";
const MOST_KEPT = 40;
const OWN = "own:";
/** Ids in a link, in `layers` with thicknesses after them. */
const BROUGHT = /own:[\w-]+|rii:[^:,]+/g;

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

/** @param {Catalog} catalog @param {string} id */
export async function keep(catalog, id) {
  const row = await rowOf(id);
  add(catalog.materials, row);
  store([row, ...keptRows().filter((one) => one.id !== id)]);
}

/** It stays a medium until the page is left, as it may be shown. @param {string} id */
export function forget(id) {
  store(keptRows().filter((one) => one.id !== id));
}

/**
 * Add those that this browser keeps, and what a link brings along: some of these and pages of
 * refractiveindex.info.
 * @param {Catalog} catalog
 * @param {string} search
 * @returns {Promise<void>}
 */
export async function bring({ materials }, search) {
  for (const row of keptRows()) add(materials, row);
  const linked = [...new URLSearchParams(search).values()].flatMap(
    (text) => text.match(BROUGHT) ?? [],
  );
  const ids = [...new Set(linked)].filter((id) => !materials.some((m) => m.id === id));
  const rows = await Promise.allSettled(ids.map(rowOf));
  // One that is broken stays out, and the link is told to name no medium.
  for (const [at, row] of rows.entries()) {
    const id = ids[at] ?? "";
    if (row.status === "fulfilled") add(materials, row.value);
    else if (isPage(id) && row.reason instanceof Problem && row.reason.errors[0])
      refusals.set(id, row.reason.errors[0].message);
  }
}
