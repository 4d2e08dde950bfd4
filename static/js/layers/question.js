/** Layers in the state, and how films are asked for with what is known of their media. */

import { isDispersive } from "../media/media.js";
import { mediaQuery } from "../state/state.js";
import { text } from "../state/text.js";
import { MOST_LAYERS, readLayers } from "./layers.js";

const AIR = 0.001; // how far n_i may be from 1 where a shortcut takes air for granted

/** The layers on the surface, empty without any; one field for all views that have it. */
export const layersField = () =>
  text(
    (given) => readLayers(given) !== null,
    `allowed are at most ${MOST_LAYERS} of MEDIUM:NM, or MEDIUM:NM:incoherent, separated by commas`,
    "",
  );

/** The media by their spectra where they have any. @param {State} state @param {Catalog} catalog @returns {string[]} */
export function spectral(state, catalog) {
  const { incident, material } = state;
  /** @param {string | null} id */
  const varies = (id) => isDispersive(catalog.materials.find((m) => m.id === id));
  return [
    ...(varies(incident) ? [`incident=${incident}`] : mediaQuery(state, catalog, ["n_i"])),
    ...(varies(material) ? [`material=${material}`] : mediaQuery(state, catalog, ["n_t", "k_t"])),
  ];
}

/** Why renderers' shortcuts say nothing of these films; empty where they do. @param {string} layers @param {number} n_i */
export function unshortened(layers, n_i) {
  const all = readLayers(layers) ?? [];
  if (all.length !== 1) return "Renderers know one film: this is a stack of several.";
  if (all[0]?.incoherent) return "Renderers know films with interference alone.";
  return Math.abs(n_i - 1) > AIR ? "Renderers take air for granted on the incident side." : "";
}
