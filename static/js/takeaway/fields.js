/** What the panel of shader code adds to the state, and what it asks the server for. */

import { asked } from "../layers/layers.js";
import { spectral } from "../layers/question.js";
import { choice, mediaQuery, optional, parameterQuery, path } from "../state/state.js";

/**
 * @typedef {{id: string, label: string, file: string}} Language
 */

/** @type {Language[]} */
export const LANGUAGES = [
  { id: "glsl", label: "GLSL", file: "glsl" },
  { id: "hlsl", label: "HLSL", file: "hlsl" },
  { id: "wgsl", label: "WGSL", file: "wgsl" },
  { id: "osl", label: "OSL", file: "osl" },
  { id: "javascript", label: "JavaScript", file: "js" },
  { id: "python", label: "Python", file: "py" },
];

/** Code that is no model's, but stands beside all of them. @type {Record<string, string>} */
const PIECES = {
  vectors: "Reflected and refracted directions",
  lookup: "Reading a table, Wloka's figure 10",
};

/** @param {string} id */
export const isPiece = (id) => Object.hasOwn(PIECES, id);

/** What code there is: of models, and the rest. @param {readonly string[]} offered models */
export const withPieces = (offered) => [...offered, ...Object.keys(PIECES)];

/** @param {Model[]} models @returns {Record<string, Field>} */
export function snippetFields(models) {
  return {
    code: optional(withPieces(models.map((m) => m.id))),
    language: choice(
      "glsl",
      LANGUAGES.map((l) => l.id),
    ),
    channels: choice("1", ["1", "3"]),
  };
}

/**
 * The model whose code is shown: the one asked for while it is offered, else the first.
 * @param {State} state
 * @param {readonly string[]} offered
 */
export function codeOf({ code }, offered) {
  return code !== null && offered.includes(code) ? code : (offered[0] ?? "exact");
}

/** The models that are offered, by their titles. @param {Model[]} models @param {readonly string[]} offered */
export function titlesOf(models, offered) {
  return Object.fromEntries(
    offered.map((id) => [id, PIECES[id] ?? models.find((m) => m.id === id)?.title ?? id]),
  );
}

/** @param {State} state @param {readonly string[]} offered @returns {string} */
export function snippetPath(state, offered) {
  const { language, channels } = state;
  const code = codeOf(state, withPieces(offered));
  const colors = channels === "3" && !isPiece(code) ? "&channels=3" : "";
  return `/shaders/${code}?language=${language}${colors}`;
}

export const SIZES = [2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096];

/** Depths by their bits, as the page offers them; OpenEXR's halves are left to the API. */
export const DEPTHS = [
  { bits: "8", label: "8 bits", depth: "unorm8", formats: ["png", "npy", "csv", "json"] },
  { bits: "16", label: "16 bits", depth: "unorm16", formats: ["png", "npy", "csv", "json"] },
  { bits: "32", label: "float", depth: "float", formats: ["exr", "npy", "csv", "json"] },
];

/** @returns {Record<string, Field>} */
export function tableFields() {
  return {
    table_size: choice("256", SIZES.map(String)),
    bits: choice(
      "16",
      DEPTHS.map((d) => d.bits),
    ),
  };
}

/**
 * The size nearest to a place on the logarithmic axis; one texel more or less, which is what a key
 * gives, is the next size.
 * @param {number} x
 * @param {number} now
 */
export function pickedSize(x, now) {
  const step = Math.abs(x - now) === 1 ? Math.sign(x - now) : 0;
  const power = step ? Math.log2(now) + step : Math.round(Math.log2(x));
  return String(2 ** Math.min(12, Math.max(1, power)));
}

/**
 * @param {State} state
 * @param {Catalog} catalog
 * @param {string} model
 * @param {"/lut" | "/lut/errors"} route
 * @param {string[]} [more]
 */
export function lutPath(state, catalog, model, route, more = []) {
  return path(route, [
    model === "exact" ? "" : `model=${model}`,
    ...mediaQuery(state, catalog),
    model === "exact" && state.layers ? asked(state.layers) : "",
    ...parameterQuery(state, catalog.models, [model]),
    ...more,
  ]);
}

/**
 * The table in RGB of films or of a material whose spectrum is known, for the exact curve.
 * @param {State} state
 * @param {Catalog} catalog
 * @param {string} model
 * @param {string[]} [more]
 */
export function rgbLutPath(state, catalog, model, more = []) {
  const { material, n_i, layers } = state;
  if (model === "exact" && layers)
    return path("/lut", [...spectral(state, catalog), asked(layers), "channels=3", ...more]);
  const { materials } = catalog;
  const known = materials.find((m) => m.id === material)?.n_range_nm;
  return model === "exact" && known
    ? path("/lut", [`material=${material}`, `n_i=${n_i}`, "channels=3", ...more])
    : null;
}
