/** Pictures of the sources, and comparisons worth a look, one click each. */

import { BOUNDS, NONE } from "./fields.js";

/** What every example says, unless it says otherwise. @type {State} */
const START = {
  yaw: BOUNDS.yaw.default,
  pitch: BOUNDS.pitch.default,
  distance: BOUNDS.distance.default,
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
  layers: "",
};
const WATER = { n_t: 1.333, scene: "water", pitch: 14, distance: 7 };

export const EXAMPLES = [
  { title: "Glossy paint", source: "Shirley", state: {} },
  { title: "T and R mixed, in glass", source: "after Shirley", state: { body: "clear" } },
  { title: "Gold", source: "measured n, k", state: { material: "Au" } },
  {
    title: "Per vertex, figure 7",
    source: "Wloka",
    state: { ...WATER, right: "schlick", right_by: "vertex" },
  },
  {
    title: "Per pixel, figure 12",
    source: "Wloka",
    state: { ...WATER, right: "schlick" },
  },
  {
    title: "Texture, figure 13, of 16 texels",
    source: "Wloka",
    state: { ...WATER, right: "exact", right_by: "texture", texels: 16 },
  },
  { title: "No reflection, figure 14", source: "Wloka", state: { ...WATER, right: NONE } },
  { title: "1 − cos, figure 15", source: "Wloka", state: { ...WATER, right: "one_minus_cos" } },
  { title: "Even light", source: "furnace", state: { material: "Au", sky: "even" } },
  {
    title: "Soap bubble",
    source: "330 nm of water",
    state: { layers: "water:330", n_t: 1, body: "clear", right: NONE },
  },
  {
    title: "Oil on water",
    source: "against no oil",
    state: { ...WATER, layers: "1.47:280", right: "schlick" },
  },
  {
    title: "Anodized titanium",
    source: "25 volts",
    state: { layers: "2.4:60", material: "Ti" },
  },
  {
    title: "Iridescence as glTF has it",
    source: "against the spectrum",
    state: { layers: "1.8:250", material: "Cr", right: "film.gltf_iridescence" },
  },
].map((example) => ({ ...example, state: /** @type {State} */ ({ ...START, ...example.state }) }));

/** How one looks at it is free. */
const FREE = ["yaw", "pitch", "distance", "split", "see", "wavelength_nm"];

/** @param {typeof EXAMPLES[number]} example @param {State} now */
export function isShown({ state }, now) {
  // A preset implies its indices.
  const free = state.material ? [...FREE, "n_t", "k_t"] : FREE;
  return Object.entries(state).every(([key, value]) => free.includes(key) || now[key] === value);
}
