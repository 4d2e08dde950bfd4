/** Layers as links and the server's questions write them: `MgF2-o:99.6,BK7:3000000:incoherent`, from the incident side. */

import { plain } from "../numbers/format.js";

/** @typedef {{medium: string, nm: number, incoherent: boolean}} Layer */

export const MOST_LAYERS = 200;
export const THICKEST = 1e9; // nm
const LONGEST = 6000;

/** The medium, which may have a colon in it, is all in front of the thickness. */
const LAYER = /^(.+?):(\d+\.?\d*(?:e[+-]?\d+)?|\.\d+)(:incoherent)?$/iu;

/** @param {string} text @returns {Layer[] | null} null where it is not so written */
export function readLayers(text) {
  if (text.length > LONGEST) return null;
  const parts = text.split(",");
  const layers = parts.flatMap((part) => {
    const [, medium = "", nm, incoherent] = LAYER.exec(part.trim()) ?? [];
    return Number(nm) <= THICKEST
      ? [{ medium, nm: Number(nm), incoherent: incoherent !== undefined }]
      : [];
  });
  return layers.length === parts.length && layers.length <= MOST_LAYERS ? layers : null;
}

/** A medium as labels have it: an id that is long in few letters. @param {string} medium */
export function shortMedium(medium) {
  if (medium.startsWith("own:")) return "your own";
  return medium.startsWith("rii:") ? medium.split("/").slice(1).join("/") : medium;
}

/** @param {Layer} layer */
const ending = ({ incoherent }) => (incoherent ? ":incoherent" : "");

/** @param {readonly Layer[]} layers @returns {string} */
export function printLayers(layers) {
  return layers
    .map((layer) => `${layer.medium}:${Number(layer.nm.toPrecision(7))}${ending(layer)}`)
    .join(",");
}

/** With the thickness of one left open. @param {readonly Layer[]} layers @param {number} place @returns {string} */
export function openedAt(layers, place) {
  return layers
    .map((layer, i) => (i === place && !layer.incoherent ? layer.medium : printLayers([layer])))
    .join(",");
}

/** As a part of an address: a comma and a colon stay what they are, a plus does not. @param {string} layers */
export const asked = (layers) =>
  `layers=${encodeURIComponent(layers).replace(/%2C/gu, ",").replace(/%3A/gu, ":")}`;

/** @param {number} nm */
export function thicknessText(nm) {
  if (nm >= 1e6) return `${plain(nm / 1e6, 4)} mm`;
  return nm >= 1e4 ? `${plain(nm / 1e3, 4)} µm` : `${plain(nm, 4)} nm`;
}

/** The layer whose thickness is at hand, from 0. @param {State} state @param {readonly Layer[]} layers */
export const placeOf = ({ film_layer }, layers) => Math.min(film_layer, layers.length) - 1;

/** The state with another thickness of the layer at hand. @param {State} state @param {number} nm @param {number} [place] @returns {State} */
export function withThickness(state, nm, place) {
  const layers = readLayers(state.layers) ?? [];
  const at = place ?? placeOf(state, layers);
  const next = layers.map((layer, i) => (i === at ? { ...layer, nm } : layer));
  return { layers: printLayers(next), film_layer: at + 1 };
}

const STEPS = [1, 1.5, 2, 3, 5, 7.5];

/** The least round thickness that holds another. @param {number} nm @returns {number} */
export function roundAbove(nm) {
  const power = 10 ** Math.floor(Math.log10(Math.max(nm, 1)));
  return power * (STEPS.find((step) => step * power >= nm) ?? 10);
}
