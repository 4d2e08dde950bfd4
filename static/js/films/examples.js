/** Films that a person knows. */

/** @typedef {{title: string, source: string, set: State}} Example */

const MIRROR = Array.from({ length: 9 }, (_, i) => (i % 2 ? "MgF2-o:99.6" : "ZnS:57.6")).join(",");

/** What an example says nothing of. @type {State} */
export const PLAIN = {
  n_i: 1,
  incident: null,
  material: null,
  n_t: 1.5,
  k_t: 0,
  wavelength_nm: null,
  film_layer: 1,
  film_show: Object.freeze(["R", "Rs", "Rp"]),
  film_to: 1000,
  film_side: "R",
  film_light: "bright",
};

const WITH_T = Object.freeze(["R", "T"]);
const WITH_A = Object.freeze(["R", "T", "A"]);

/** Volts and nanometers of the oxide that grows on titanium: Ohtsuka, Masuda and Sato 1985, in sulfuric acid below 7.5 V. */
export const NM_PER_VOLT = 2.4;
export const TITANIA = "2.4";

/** @type {readonly Example[]} */
export const EXAMPLES = [
  {
    title: "Soap film",
    source: "water in air",
    set: { layers: "water:330", n_t: 1, theta_i_deg: 30 },
  },
  {
    title: "Oil on water",
    source: "n = 1.47",
    set: { layers: "1.47:280", material: "water", theta_i_deg: 30 },
  },
  {
    title: "MgF₂ on glass",
    source: "a quarter wave",
    set: { layers: "MgF2-o:99.6", material: "BK7", theta_i_deg: 0 },
  },
  {
    title: "Quarter-wave mirror",
    source: "nine layers",
    set: { layers: MIRROR, material: "BK7", theta_i_deg: 0, film_show: WITH_T, film_to: 300 },
  },
  {
    title: "Titanium, anodized",
    source: "by voltage",
    set: { layers: `${TITANIA}:60`, material: "Ti", theta_i_deg: 20, film_to: 300 },
  },
  {
    title: "SiO₂ on silicon",
    source: "a wafer",
    set: { layers: "fused-silica:300", material: "Si", theta_i_deg: 0 },
  },
  {
    title: "Gold leaf",
    source: "green from behind",
    set: {
      layers: "Au:50",
      n_t: 1,
      theta_i_deg: 0,
      film_show: WITH_A,
      film_to: 200,
      film_side: "T",
      film_light: "each",
    },
  },
  {
    title: "Window pane",
    source: "4 mm, no interference",
    set: {
      layers: "soda-lime:4000000:incoherent",
      n_t: 1,
      theta_i_deg: 45,
      film_show: WITH_A,
      film_to: 10_000_000,
    },
  },
  {
    title: "Frustrated total reflection",
    source: "a gap of air",
    set: { layers: "1:200", n_i: 1.5, theta_i_deg: 60, film_show: WITH_T },
  },
];

/** @param {Example} example @returns {State} */
export const stateOf = ({ set }) => ({ ...PLAIN, ...set });

/** Whether the films are those of an example, at any angle. @param {Example} example @param {State} state */
export function isShown({ set }, state) {
  const { layers, material = null, n_i = 1, n_t } = set;
  const same = state.layers === layers && state.material === material && state.n_i === n_i;
  return same && (material !== null || state.n_t === (n_t ?? PLAIN.n_t));
}
