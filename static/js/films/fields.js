/** The state that the Films view adds to the one all views share, and what it asks for. */

import {
  asked,
  MOST_LAYERS,
  openedAt,
  placeOf,
  readLayers,
  roundAbove,
  THICKEST,
} from "../layers/layers.js";
import { layersField, spectral, unshortened } from "../layers/question.js";
import { isDispersive } from "../media/media.js";
import { choice, list, mediaQuery, number, path, whole } from "../state/state.js";
import { text } from "../state/text.js";
import { useFields, usePath } from "../takeaway/use.js";

export const D_LINE = 587.6;
/** What eyes see. */
const VISIBLE = /** @type {const} */ ([380, 780]);
const THICK = 4000; // nm: narrower fringes want every nanometer
export const NO_MODEL = "none";
const MODEL_ID = /^[a-z0-9_]{1,40}$/u;
export const QUANTITIES = ["R", "Rs", "Rp", "T", "A"];
/** Thicknesses and angles of the map; fewer where each cell is a whole spectrum. */
const CELLS = { thicknesses: 256, angles: 91 };
const FEW = { thicknesses: 64, angles: 61 };

/** @returns {Record<string, Field>} */
export function filmFields() {
  return {
    layers: layersField(),
    film_layer: whole(number({ default: 1, minimum: 1, maximum: MOST_LAYERS })),
    film_show: list(QUANTITIES, ["R", "Rs", "Rp"]),
    film_to: number({ default: 1000, minimum: 1, maximum: THICKEST }),
    film_side: choice("R", ["R", "T"]),
    film_model: text((id) => MODEL_ID.test(id), "it is no id of a shortcut", NO_MODEL),
    film_light: choice("bright", ["bright", "true", "each"]),
    ...useFields(),
  };
}

/** @param {State} state */
export const wavelengthOf = ({ wavelength_nm }) => wavelength_nm ?? D_LINE;

/** Where all media are known. @param {State} state @param {Catalog} catalog @returns {[number, number]} */
export function spectrumRange(state, { materials }) {
  const layers = readLayers(state.layers) ?? [];
  const ids = [state.incident, state.material, ...layers.map((layer) => layer.medium)];
  const ranges = materials
    .filter((m) => ids.includes(m.id) && isDispersive(m) && m.n_range_nm)
    .map((m) => /** @type {[number, number]} */ (m.n_range_nm));
  const low = Math.ceil(Math.max(VISIBLE[0], ...ranges.map((r) => r[0])));
  const high = Math.floor(Math.min(VISIBLE[1], ...ranges.map((r) => r[1])));
  return low < high ? [low, high] : [...VISIBLE];
}

/** What is drawn where a link names no layers. */
const COATING = "MgF2-o:99.6";

/** The state with the layers that this view draws. @param {State} state @returns {State} */
export const filled = (state) => (state.layers ? state : { ...state, layers: COATING });

/** Whether a shortcut is to be shown, and why it cannot be. @param {State} state @returns {{wanted: boolean, why: string}} */
export function isAskedFor({ film_model, layers, n_i, film_side }) {
  if (film_model === NO_MODEL) return { wanted: false, why: "" };
  const why =
    unshortened(layers, n_i) || (film_side !== "R" ? "Shortcuts are of reflected light." : "");
  return { wanted: why === "", why };
}

/** Why films cannot be taken to a renderer, whatever is before them. @param {State} state @returns {string} */
export const untaken = ({ layers }) => unshortened(layers, 1);

/** How far the thickness reaches on the map. @param {State} state @returns {number} */
export function mapEnd({ layers, film_layer, film_to }) {
  const all = readLayers(layers) ?? [];
  return Math.max(film_to, roundAbove(all[placeOf({ film_layer }, all)]?.nm ?? 0));
}

/** @param {State} state @param {Catalog} catalog */
function mapPath(state, catalog) {
  const layers = readLayers(state.layers) ?? [];
  const coherent = layers.every((layer) => !layer.incoherent);
  const { thicknesses, angles } = coherent && state.film_side === "R" ? CELLS : FEW;
  return path("/films/color", [
    ...spectral(state, catalog),
    asked(openedAt(layers, placeOf(state, layers))),
    placeOf(state, layers) > 0 && `layer=${placeOf(state, layers) + 1}`,
    `thickness_nm=0..${mapEnd(state)}:${thicknesses}`,
    `samples=${angles}`,
    state.film_side === "T" && "quantity=T",
    isAskedFor(state).wanted && `models=${state.film_model}`,
    "digits=4",
  ]);
}

/** The colors of what is there. @param {State} state @param {Catalog} catalog @param {"R" | "T"} quantity */
function herePath(state, catalog, quantity) {
  const layers = readLayers(state.layers) ?? [];
  const place = placeOf(state, layers);
  return path("/films/color", [
    ...spectral(state, catalog),
    asked(openedAt(layers, place)),
    place > 0 && `layer=${place + 1}`,
    `thickness_nm=${layers[place]?.nm ?? 0}`,
    `theta_i_deg=${state.theta_i_deg}`,
    quantity === "T" && "quantity=T",
    quantity === "R" && isAskedFor(state).wanted && `models=${state.film_model}`,
  ]);
}

const CLEAR = 1e-4; // k behind a pane up to which it counts as clear
const COMPLEX = /^([\d.]+(?:e[+-]?\d+)?)(?:\+([\d.]+(?:e[+-]?\d+)?)i)?$/iu;

/** n and k of a medium at the wavelength that stands for it. @param {string} text @param {Catalog} catalog */
function indexOf(text, { materials }) {
  const [, n, k = "0"] = COMPLEX.exec(text) ?? [];
  if (n !== undefined) return { n: Number(n), k: Number(k), nm: D_LINE };
  const found = materials.find(({ id }) => id === text);
  if (!found) return null;
  return { n: found.n_absolute ?? found.n, k: found.k ?? 0, nm: found.wavelength_nm ?? D_LINE };
}

/** The pane that is there, one thick layer in air, as solar software counts it; nothing where it is none. @param {State} state @param {Catalog} catalog */
export function panePath(state, catalog) {
  const [layer, ...more] = readLayers(state.layers) ?? [];
  if (!layer?.incoherent || more.length > 0 || state.n_i !== 1 || state.k_t > CLEAR) return null;
  const index = indexOf(layer.medium, catalog);
  if (!index) return null;
  const absorption = (4e9 * Math.PI * index.k) / index.nm;
  const thickness = layer.nm / 1e6;
  const held = [index.n, state.n_t].every((n) => n >= 1 && n <= 4);
  if (!held || absorption > 1000 || thickness > 100) return null;
  return path("/films/pane", [
    `n=${index.n}`,
    `thickness_mm=${thickness}`,
    `absorption_per_m=${absorption}`,
    `n_behind=${state.n_t}`,
    "digits=7",
  ]);
}

/**
 * Paths by name. What a drag does not need keeps its last answer, and curves are coarser in it. The first
 * is always answered: what is dragged moves at once, and waits for no curve.
 * @param {State} given
 * @param {Catalog} catalog
 * @param {boolean} [moving]
 * @returns {Record<string, string>}
 */
export function queries(given, catalog, moving = false) {
  const state = filled(given);
  const layers = readLayers(state.layers) ?? [];
  const [low, high] = spectrumRange(state, catalog);
  const thick = layers.some((layer) => !layer.incoherent && layer.nm > THICK);
  const films = asked(state.layers);
  const media = [...spectral(state, catalog), films];
  const nm = `wavelength_nm=${wavelengthOf(state)}`;
  const theta = `theta_i_deg=${state.theta_i_deg}`;
  return {
    shortcuts: "/films/models",
    spectrum: path("/films/spectrum", [
      ...media,
      theta,
      `minimum_nm=${low}`,
      `maximum_nm=${high}`,
      !thick && `step_nm=${moving ? 4 : 2}`,
      "digits=7",
    ]),
    curves: path("/curves", [...media, nm, `samples=${moving ? 91 : 181}`, "digits=7"]),
    ...(!moving && { here: path("/snell", [...media, nm, theta]) }),
  };
}

/** The colors, which stay while the thickness on their axis moves. @param {State} given @param {Catalog} catalog @returns {Record<string, string>} */
export function later(given, catalog) {
  const state = filled(given);
  const pane = panePath(state, catalog);
  return {
    ...(pane && { pane }),
    map: mapPath(state, catalog),
    reflected: herePath(state, catalog, "R"),
    transmitted: herePath(state, catalog, "T"),
    ...(!untaken(state) && {
      use: usePath("/export", state, [
        ...mediaQuery(state, catalog, ["n_i"]),
        ...spectral(state, catalog).filter((part) => !/^(n_i|incident)=/.test(part)),
        asked(state.layers),
      ]),
    }),
  };
}

/** @param {State} state @param {Catalog} catalog @returns {string[]} */
export function restCalls(state, catalog) {
  const { shortcuts, ...others } = queries(state, catalog);
  return [...Object.values({ ...others, ...later(state, catalog) }), shortcuts ?? ""];
}
