/** The state that the Preview view adds to the one all views share. */

import { layersField } from "../layers/question.js";
import {
  choice,
  chosenModels,
  LinkError,
  modelFields,
  number,
  optional,
  whole,
} from "../state/state.js";
import { snippetFields, tableFields } from "../takeaway/fields.js";

/** Without any reflection, as in Wloka's figure 14; all else is a registered model. */
export const NONE = "none";

/** Before the id of a renderer's shortcut for a film; which there are the server tells. */
export const SHORTCUT = "film.";
const SHORTCUT_ID = /^film\.[a-z0-9_]{1,40}$/u;

/** What of both sides is seen. */
export const SEEN = ["split", "flicker", "difference", "left", "right"];

export const BOUNDS = {
  texels: { default: 16, minimum: 2, maximum: 4096 },
  gain: { default: 5, minimum: 1, maximum: 200 },
  split: { default: 0.5, minimum: 0, maximum: 1 },
  yaw: { default: 0, minimum: -180, maximum: 180 },
  pitch: { default: 11, minimum: 2, maximum: 85 },
  distance: { default: 6.2, minimum: 3.4, maximum: 14 },
};

/** A color as style sheets write it. @param {string} preset @returns {Field} */
function hex(preset) {
  return {
    default: preset,
    parse(text) {
      if (!/^#?[0-9a-f]{6}$/i.test(text))
        throw new LinkError("allowed are six digits, such as b3201e");
      return `#${text.replace("#", "").toLowerCase()}`;
    },
    print: (value) => value.slice(1),
  };
}

/** What a side may show besides: a renderer's shortcut for a film. @param {Field} model @returns {Field} */
const orShortcut = (model) => ({
  ...model,
  parse: (text) => (SHORTCUT_ID.test(text) ? text : model.parse(text)),
});

/** @param {Catalog} catalog @returns {Record<string, Field>} */
export function previewFields({ models }) {
  const ids = [...models.map((m) => m.id), NONE];
  const by = ["pixel", "vertex", "texture"];
  return {
    scene: choice("ball", ["ball", "water"]),
    left: orShortcut(choice("exact", ids)),
    right: orShortcut(optional(ids)),
    layers: layersField(),
    left_by: choice("pixel", by),
    right_by: choice("pixel", by),
    texels: whole(number(BOUNDS.texels)),
    see: choice("split", SEEN),
    split: number(BOUNDS.split),
    gain: number({ ...BOUNDS.gain, default: null }),
    body: choice("paint", ["paint", "clear"]),
    paint: hex("#d8322a"),
    sky: choice("day", ["day", "even"]),
    colors: choice("rgb", ["rgb", "single"]),
    yaw: number(BOUNDS.yaw),
    pitch: number(BOUNDS.pitch),
    distance: number(BOUNDS.distance),
    ...snippetFields(models),
    ...tableFields(),
    ...modelFields(models),
  };
}

/** What stands on the right when nothing was chosen, of a metal and of all else. */
const firstModel = (/** @type {State} */ { k_t }) => (k_t > 0 ? "f82_tint" : "schlick");

/** The state with the model on the right: the first of those chosen in any view, unless a link names another. @param {State} state @returns {State} */
export const sided = (state) => ({
  ...state,
  right: state.right ?? chosenModels(state)[0] ?? firstModel(state),
});

/**
 * What the state becomes when a model is put on the right: it is the first of those of all views. The
 * exact curve, none at all and shortcuts for films are no models that stand beside it.
 * @param {State} state
 * @param {string} id
 * @returns {State}
 */
export function putRight(state, id) {
  if (id === "exact" || id === NONE || isShortcut(id)) return { right: id };
  const others = chosenModels(state).filter((other) => other !== id);
  return { right: null, models: Object.freeze([id, ...others]) };
}

/** Models whose code is offered: those on the sides, and what they are measured by. @param {State} state */
export const withCode = ({ left, right }) =>
  [...new Set([right, left, "exact"])].filter((id) => id !== NONE && !isShortcut(id));

/** @param {string} id */
export const isShortcut = (id) => id.startsWith(SHORTCUT);

/** Whether there are films on the surface. @param {State} state */
export const isFilmed = ({ layers }) => Boolean(layers);

/** Whether what enters the chosen medium never comes back: under films paint is left out, which would hide their colors. @param {State} state */
export const isOpaque = ({ k_t, layers, scene, body }) =>
  k_t > 0 || (Boolean(layers) && scene === "ball" && body === "paint");

/** Whether the ball is coated paint here. @param {State} state */
export const isPaint = (state) =>
  state.scene === "ball" && state.body === "paint" && !isOpaque(state);

/** Whether light comes evenly from everywhere, which shows the ball alone. @param {State} state */
export const isEven = ({ scene, sky }) => scene === "ball" && sky === "even";
