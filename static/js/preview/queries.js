/** What the Preview view asks the server for. */

import { isDispersive } from "../media/media.js";
import { decoded } from "../numbers/srgb.js";
import { mediaQuery, parameterQuery, path, stateName } from "../state/state.js";
import { codeOf, lutPath, snippetPath } from "../takeaway/fields.js";
import { isEven, isPaint, NONE, sided, withCode } from "./fields.js";

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
  const ids = [...new Set([state.left, state.right])].filter((id) => id !== NONE).sort();
  return path("/curves", [
    ...mediaQuery(state, catalog),
    ...modelsQuery(state, catalog, ids),
    ...FINE,
  ]);
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
  if (model === NONE) return {};
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
  return {
    ...sidePaths(state, catalog, "right"),
    ...sidePaths(state, catalog, "left"),
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
    shader: snippetPath(state, offered),
    lut: lutPath(state, catalog, codeOf(state, offered), "/lut/errors"),
  };
}

/** @param {State} state @param {Catalog} catalog @returns {string[]} */
export function restCalls(state, catalog) {
  return [...new Set(Object.values(queries(state, catalog)))];
}
