/** Pictures of the sources, and comparisons worth a look, one click each. */

import { h } from "../page/dom.js";
import { BOUNDS, NONE } from "./fields.js";

/**
 * @typedef {{id: string, title: string, source: string, state: State}} Example
 */

const CAMERA = {
  yaw: BOUNDS.yaw.default,
  pitch: BOUNDS.pitch.default,
  distance: BOUNDS.distance.default,
};
/** What every example says, unless it says otherwise. @type {State} */
const START = {
  ...CAMERA,
  incident: null,
  material: null,
  wavelength_nm: null,
  n_i: 1,
  n_t: 1.5,
  k_t: 0,
  scene: "ball",
  left: "exact",
  right: "schlick",
  left_by: "pixel",
  right_by: "pixel",
  see: "split",
  split: BOUNDS.split.default,
  body: "paint",
  sky: "day",
  colors: "rgb",
};
const WATER = { n_t: 1.333, scene: "water", pitch: 14, distance: 7 };

/** @type {Example[]} */
export const EXAMPLES = [
  { id: "paint", title: "Glossy paint", source: "Shirley", state: {} },
  { id: "mix", title: "Clear glass: T and R mixed", source: "Shirley", state: { body: "clear" } },
  { id: "gold", title: "Gold", source: "Lagarde", state: { material: "Au" } },
  {
    id: "vertex",
    title: "Per vertex, figure 7",
    source: "Wloka",
    state: { ...WATER, right: "exact", right_by: "vertex" },
  },
  {
    id: "texture",
    title: "Texture, figure 13",
    source: "Wloka",
    state: { ...WATER, right: "exact", right_by: "texture", texels: 16 },
  },
  {
    id: "none",
    title: "No reflection, figure 14",
    source: "Wloka",
    state: { ...WATER, right: NONE },
  },
  {
    id: "one-minus-cos",
    title: "1 − cos, figure 15",
    source: "Wloka",
    state: { ...WATER, right: "one_minus_cos" },
  },
  {
    id: "furnace",
    title: "Even light",
    source: "furnace",
    state: { material: "Au", sky: "even", right: "schlick" },
  },
];

/** @param {{onShow: (state: State) => void}} options */
export function createExamples({ onShow }) {
  const buttons = EXAMPLES.map((example) => {
    const state = { ...START, ...example.state };
    const button = h(
      "button",
      { type: "button", class: "example", "aria-pressed": "false", onclick: () => onShow(state) },
      h("b", {}, example.title),
      " ",
      h("span", {}, example.source),
    );
    return { state, button };
  });
  /** What a preset implies and how one looks at it are free. */
  const free = new Set(["yaw", "pitch", "distance", "split", "see", "wavelength_nm"]);
  return {
    element: h(
      "div",
      { class: "preview-examples", role: "group", "aria-label": "Examples" },
      ...buttons.map((b) => b.button),
    ),
    /** @param {State} now */
    update(now) {
      for (const { state, button } of buttons) {
        const implied = new Set(state.material ? ["n_t", "k_t"] : []);
        const same = Object.entries(state).every(
          ([key, value]) => free.has(key) || implied.has(key) || now[key] === value,
        );
        button.setAttribute("aria-pressed", String(same));
      }
    },
  };
}
