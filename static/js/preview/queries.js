/** What the Preview view asks the server for. */

import { asked, openedAt, readLayers } from "../layers/layers.js";
import { spectral, unshortened } from "../layers/question.js";
import { atWavelength, isDispersive } from "../media/media.js";
import { decoded } from "../numbers/srgb.js";
import { mediaQuery, parameterQuery, path, stateName } from "../state/state.js";
import { codeOf, lutPath, snippetPath } from "../takeaway/fields.js";
import {
  isEven,
  isFilmed,
  isOpaque,
  isPaint,
  isShortcut,
  NONE,
  SHORTCUT,
  sided,
  withCode,
} from "./fields.js";

/**
 * @typedef {'left' | 'right'} Side
 */

export const SIDES = /** @type {const} */ (["left", "right"]);
export const CHANNELS = /** @type {const} */ (["red", "green", "blue"]);
/** Steps of an eighth of a degree, and more digits than a picture can show. */
const FINE = ["samples=721", "digits=7"];
/** Wavelengths that stand for R, G and B where a model takes an index and no color. */
const CHANNEL_NM = { red: 630, green: 532, blue: 465 };
const WATER = 1.333;

/** The material whose colors can be shown, if there is one. @param {State} state @param {Catalog} catalog */
export function coloredMaterial({ material, wavelength_nm, incident }, { materials }) {
  const found = materials.find((m) => m.id === material);
  const front = materials.find((m) => m.id === incident);
  const [low, high] = found?.n_range_nm ?? [Infinity, 0];
  const [first, last] = front?.n_range_nm ?? [0, Infinity];
  const covered = Math.max(low, first) <= CHANNEL_NM.blue && Math.min(high, last) >= CHANNEL_NM.red;
  return found?.kind === "spectrum" && covered && wavelength_nm === null ? found : null;
}

/** Whether a model can be had from a material's color alone. @param {State} state @param {Catalog} catalog @param {string} id */
function takesColor(state, { models }, id) {
  if (id === "exact") return true;
  const model = models.find((m) => m.id === id);
  const own = model?.parameters ?? [];
  return (
    model?.takes_color === true &&
    own.every((p) => (state[stateName(model, p)] ?? null) === p.default)
  );
}

/** @param {State} state @param {Catalog} catalog @param {string[]} ids */
function modelsQuery(state, catalog, ids) {
  return [
    ids.join() === "exact" ? "" : `models=${ids.join(",")}`,
    ...parameterQuery(state, catalog.models, ids),
  ];
}

/** One question for both sides. @param {State} state @param {Catalog} catalog */
function bothPath(state, catalog) {
  const ids = [...new Set([state.left, state.right])]
    .filter((id) => id !== NONE && !isShortcut(id) && !(isFilmed(state) && id === "exact"))
    .sort();
  return path("/curves", [
    ...mediaQuery(state, catalog),
    ...modelsQuery(state, catalog, ids),
    ...FINE,
  ]);
}

/**
 * Why a renderer's shortcut cannot stand on a side; empty where it can.
 * @param {State} state
 * @param {string} model
 */
export function shortcutReason({ layers, n_i }, model) {
  if (!isShortcut(model)) return "";
  return layers ? unshortened(layers, n_i) : "There is no film to be shortened: choose one below.";
}

/** Steps of half a degree: the colors of films have no more in them than a curve's. */
const FILM_ANGLES = 181;

/** The colors of the films, with the shortcuts that are on the sides. @param {State} state @param {Catalog} catalog @param {"R" | "T"} quantity */
function filmPath(state, catalog, quantity) {
  const layers = readLayers(state.layers) ?? [];
  const shortcuts = [...new Set([state.left, state.right])]
    .filter((id) => isShortcut(id) && !shortcutReason(state, id))
    .map((id) => id.slice(SHORTCUT.length))
    .sort();
  return path("/films/color", [
    ...spectral(state, catalog),
    asked(openedAt(layers, 0)),
    `thickness_nm=${layers[0]?.nm ?? 0}`,
    `samples=${FILM_ANGLES}`,
    quantity === "T" ? "quantity=T" : shortcuts.length > 0 && `models=${shortcuts.join(",")}`,
    "digits=6",
  ]);
}

/**
 * What is let through where that is not what is not reflected: films absorb.
 * @param {State} state
 * @param {Catalog} catalog
 * @param {Side} side
 * @returns {string | null}
 */
export function throughPath(state, catalog, side) {
  const own = isFilmed(state) && state[side] === "exact" && !isOpaque(state);
  return own ? filmPath(state, catalog, "T") : null;
}

/**
 * Paths of a side's curves: one, or one for each channel; none where nothing is reflected.
 * @param {State} state
 * @param {Catalog} catalog
 * @param {Side} side
 * @returns {Record<string, string>}
 */
export function sidePaths(state, catalog, side) {
  const model = state[side];
  if (model === NONE || shortcutReason(state, model)) return {};
  if (isShortcut(model) || (isFilmed(state) && model === "exact"))
    return { film: filmPath(state, catalog, "R") };
  const material = state.colors === "rgb" ? coloredMaterial(state, catalog) : null;
  if (!material) return { curves: bothPath(state, catalog) };
  const front = isDispersive(catalog.materials.find((m) => m.id === state.incident))
    ? [`incident=${state.incident}`]
    : mediaQuery(state, catalog, ["n_i"]);
  if (takesColor(state, catalog, model)) {
    const beside = `models=${model === "exact" ? "schlick" : model}`;
    return {
      [side]: path(`/materials/${material.id}/curves`, [
        ...front,
        beside,
        "wavelengths_nm=550",
        ...FINE,
      ]),
    };
  }
  return Object.fromEntries(
    CHANNELS.map((channel) => [
      `${side}.${channel}`,
      path("/curves", [
        ...front,
        `material=${material.id}`,
        `wavelength_nm=${CHANNEL_NM[channel]}`,
        ...modelsQuery(state, catalog, [model]),
        ...FINE,
      ]),
    ]),
  );
}

/**
 * At which wavelengths a side is evaluated; empty where it is the whole spectrum or none matters.
 * @param {State} state
 * @param {Catalog} catalog
 * @param {Side} side
 */
export function lightOf(state, catalog, side) {
  const asked = Object.keys(sidePaths(state, catalog, side));
  if (asked.length === CHANNELS.length)
    return `It takes an index: R, G and B are those at ${CHANNELS.map((name) => CHANNEL_NM[name]).join(", ")} nm.`;
  const at = asked.includes("curves") ? atWavelength(catalog.materials, state) : "";
  return at && `Taken ${at} alone.`;
}

/** Linear shares of a color as style sheets write it. @param {string} color @returns {number[]} */
export function linear(color) {
  const steps = [1, 3, 5].map((at) => Number.parseInt(color.slice(at, at + 2), 16));
  return steps.map((step) => Number(decoded(step / 255).toPrecision(6)));
}

/** What paint there is under the coat. @param {State} state @param {Catalog} catalog @returns {Record<string, string>} */
export function coatPaths(state, catalog) {
  if (!isPaint(state)) return {};
  const albedo = linear(state.paint);
  return Object.fromEntries(
    CHANNELS.map((channel, i) => [
      `coat.${channel}`,
      path("/albedo/coat", [
        ...mediaQuery(state, catalog, ["n_i", "n_t"]),
        `body_albedo=${albedo[i]}`,
      ]),
    ]),
  );
}

/**
 * Paths by name, in the order of their importance.
 * @param {State} state
 * @param {Catalog} catalog
 * @returns {Record<string, string>}
 */
export function queries(state, catalog) {
  return queriesOf(sided(state), catalog);
}

/** @param {State} state @param {Catalog} catalog */
function queriesOf(state, catalog) {
  const through = SIDES.map((side) => throughPath(state, catalog, side)).find(Boolean);
  return {
    ...sidePaths(state, catalog, "right"),
    ...sidePaths(state, catalog, "left"),
    ...(through && { through }),
    ...coatPaths(state, catalog),
    ...(state.scene === "ball" &&
      !isEven(state) && { water: path("/curves", [`n_t=${WATER}`, ...FINE]) }),
  };
}

/** Code and tables, which are below the picture. @param {State} given @param {Catalog} catalog @returns {Record<string, string>} */
export function later(given, catalog) {
  const state = sided(given);
  const offered = withCode(state);
  return {
    ...(isFilmed(state) && { shortcuts: "/films/models" }),
    shader: snippetPath(state, offered),
    lut: lutPath(state, catalog, codeOf(state, offered), "/lut/errors"),
  };
}

/** @param {State} state @param {Catalog} catalog @returns {string[]} */
export function restCalls(state, catalog) {
  return [...new Set(Object.values(queries(state, catalog)))];
}
