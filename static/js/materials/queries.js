/** What the Materials view asks the server for. */

import { path } from "../state/state.js";
import { usePath } from "../takeaway/use.js";

/** A cell's color needs no more digits. */
const MAP_DIGITS = 4;
const MAP_CELLS = { theta: 91, lambda: 201 };
/** RGB models beside the spectrum. */
const MODELS = "schlick,f82_tint,exact";
/** An index that stands for itself, without a spectrum, is seen by the models that take one. */
const INDEX_MODELS = "exact,schlick";

/** What is shown until one is chosen. */
const FIRST = "Au";

/** @param {Catalog} catalog @param {string} id */
export function presetOf({ materials }, id) {
  return materials.find((m) => m.id === id);
}

/**
 * The state with the preset that is shown: what was chosen here, else the other views' second medium.
 * @param {State} state
 * @param {Catalog} catalog
 * @returns {State}
 */
export function shown(state, { materials }) {
  const first = materials.find((m) => m.id === FIRST) ?? materials[0];
  return { ...state, preset: state.preset ?? state.material ?? first?.id };
}

/**
 * Other measurements of the same material, and of the one that is set beside it.
 * @param {Catalog} catalog
 * @param {string} id
 * @param {string | null} [beside]
 * @returns {string[]}
 */
export function rivalsOf(catalog, id, beside = null) {
  const roots = [id, beside].map((one) => presetOf(catalog, one ?? "")?.rival_of ?? one);
  return catalog.materials
    .filter((m) => (roots.includes(m.id) || roots.includes(m.rival_of ?? "")) && m.id !== id)
    .map((m) => m.id);
}

/** @param {State} state */
export function listPath({ find, category, of_kind, gamut }) {
  return path("/materials", [
    find.trim() !== "" && `q=${encodeURIComponent(find.trim())}`,
    category !== "all" && `category=${category}`,
    of_kind !== "all" && `kind=${of_kind}`,
    gamut === "clamped" && "gamut=clamped",
  ]);
}

/** @param {State} state */
function detailPath({ preset, at_nm, gamut, illuminant }) {
  return path(`/materials/${preset}`, [
    at_nm !== null && `wavelength_nm=${at_nm}`,
    gamut !== "scaled" && `gamut=${gamut}`,
    illuminant !== "D65" && `illuminant=${illuminant}`,
  ]);
}

/** @param {State} state */
function anglesPath({ preset, nm }) {
  return path(`/materials/${preset}/curves`, [
    nm !== null && `wavelengths_nm=${nm.join(",")}`,
    "rgb=false",
  ]);
}

/** @param {State} state */
function colorsPath({ preset, gamut, illuminant }) {
  return path(`/materials/${preset}/curves`, [
    `models=${MODELS}`,
    gamut !== "unclamped" && `gamut=${gamut}`,
    illuminant !== "D65" && `illuminant=${illuminant}`,
  ]);
}

/** @param {State} state */
function mapPath({ preset, map_of }) {
  return path(`/materials/${preset}/map`, [
    map_of !== "R" && `quantity=${map_of}`,
    `samples=${MAP_CELLS.theta}`,
    `steps=${MAP_CELLS.lambda}`,
    `digits=${MAP_DIGITS}`,
  ]);
}

/** @param {State} state */
function coveredPath({ preset, cover, cover_n, gamut, illuminant }) {
  return path(`/materials/${preset}/covered`, [
    cover !== "coat" && `cover=${cover}`,
    cover_n !== 1.5 && `n=${cover_n}`,
    gamut !== "clamped" && `gamut=${gamut}`,
    illuminant !== "D65" && `illuminant=${illuminant}`,
  ]);
}

/**
 * Paths by name. While one walks through the table only the list and the preset itself are asked for.
 * @param {State} now
 * @param {Catalog} catalog
 * @param {boolean} [moving]
 * @returns {Record<string, string>}
 */
export function queries(now, catalog, moving = false) {
  const state = shown(now, catalog);
  const preset = presetOf(catalog, state.preset);
  /** @type {Record<string, string>} */
  const wanted = { list: listPath(state), detail: detailPath(state) };
  if (moving || !preset) return wanted;
  wanted.use = usePath(`/materials/${state.preset}/export`, state, [
    state.gamut !== "clamped" && `policy=${state.gamut}`,
  ]);
  wanted.covered = coveredPath(state);
  wanted.index = `/curves?n_t=${preset.n_absolute}&models=${INDEX_MODELS}`;
  if (preset.kind !== "spectrum") return wanted;
  wanted.spectrum = `/materials/${preset.id}/spectrum`;
  wanted.angles = anglesPath(state);
  wanted.colors = colorsPath(state);
  wanted.map = mapPath(state);
  if (state.rivals === "shown")
    for (const id of rivalsOf(catalog, preset.id, state.beside))
      if (presetOf(catalog, id)?.kind === "spectrum")
        wanted[`rival:${id}`] = `/materials/${id}/spectrum`;
  return wanted;
}

/** @param {State} state @param {Catalog} catalog @returns {string[]} */
export function restCalls(state, catalog) {
  const { list, detail, use, covered, spectrum, angles, colors, map, index } = queries(
    state,
    catalog,
  );
  const filtered = list !== "/materials";
  const own = spectrum ? [spectrum, angles, colors, map] : [index];
  return [filtered ? list : null, detail, ...own, covered, use].filter(
    (one) => one !== null && one !== undefined,
  );
}
