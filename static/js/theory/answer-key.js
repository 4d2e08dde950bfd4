/**
 * The answers to the worksheets, for teachers. Their numbers are asked of the server when a key is opened;
 * what stands here are the words around them.
 */

import { values } from "../curves/reading.js";
import { percent, plain } from "../numbers/format.js";
import { decode } from "./mystery-code.js";

/**
 * @typedef {Record<string, any>} Asked the answers by the names of the questions
 * @typedef {{asks: Record<string, string>, answers: ((asked: Asked) => string)[]}} Key
 */

const STEP = 5;
/** @param {any} curves in steps of five degrees @param {string} quantity @param {number} deg @returns {number} */
const at = (curves, quantity, deg) => values(curves, quantity)[deg / STEP] ?? Number.NaN;
/** @param {number | null} x */
const short = (x) => plain(x ?? Number.NaN, 3);
/** @param {number} x */
const degrees = (x) => `${plain(x, 4)}°`;

/**
 * Where a condition holds, as stretches of x.
 * @param {readonly number[]} xs
 * @param {(index: number) => boolean} holds
 */
export function stretches(xs, holds) {
  /** @type {[number, number][]} */
  const found = [];
  xs.forEach((x, i) => {
    const last = found.at(-1);
    if (!holds(i)) return;
    if (last && i > 0 && holds(i - 1)) last[1] = x;
    else found.push([x, x]);
  });
  return found.map(([from, to]) => `from ${short(from)} to ${short(to)}`).join(" and ");
}

/** By how much p is behind s, degrees, and where. @param {any} curves with phases @returns {{deg: number, by: number}[]} */
function delays(curves) {
  const [s, p] = ["phase_s_deg", "phase_p_deg"].map((name) => values(curves, name));
  return curves.theta_i_deg.map((/** @type {number} */ deg, /** @type {number} */ i) => {
    const between = Math.abs((s?.[i] ?? 0) - (p?.[i] ?? 0)) % 360;
    return { deg, by: Math.min(between, 360 - between) };
  });
}

/** The channel that a model misses most. @param {any} answer @param {string} model */
function worst(answer, model) {
  const { title, errors } = answer.rgb.curves.find((/** @type {any} */ c) => c.model === model);
  const [[name, { max_abs, max_abs_at_deg }]] = /** @type {[[string, any]]} */ (
    Object.entries(errors).sort((a, b) => b[1].max_abs - a[1].max_abs)
  );
  return `${title}: ${name}, by ${short(max_abs)} at ${degrees(max_abs_at_deg)}`;
}

/** @param {string} code of a mystery material */
function hidden(code) {
  const { n, k } = /** @type {{n: number, k: number}} */ (decode(code));
  return k > 0 ? `$n=${n}$, $k=${k}$` : `$n=${n}$`;
}

const METALS = ["Ag", "Al", "Fe"];
const MYSTERIES = ["z1amiz", "qy2f0x", "g21piv"];

/** @type {Record<string, Key>} by the id of the sheet, an answer a task */
export const KEYS = {
  pond: {
    asks: { water: "/curves?n_t=1.333&samples=19&refraction=true" },
    answers: [
      ({ water }) =>
        `$R$ is ${[0, 30, 60, 75, 85].map((deg) => `${percent(at(water, "R", deg))} at ${deg}°`).join(", ")}: flat up to 45°, then ever steeper.`,
      ({ water }) =>
        `${[15, 30, 45, 60, 75].map((deg) => `${deg}° is bent to ${degrees(at(water, "theta_t_deg", deg))}`).join(", ")}. The quotient of the sines is 1.333 each time.`,
      ({ water }) =>
        `${percent(at(water, "T", 50))} of the light from the fish reaches his eye, for the way there and the way back pass on the same share. If sky and fish are as bright, ${percent(at(water, "R", 50))} of what he sees is sky.`,
    ],
  },
  brewster: {
    asks: {
      water: "/snell?n_t=1.333&theta_i_deg=0",
      crown: "/snell?n_t=1.52&theta_i_deg=0",
      diamond: "/snell?n_t=2.417&theta_i_deg=0",
      absorbing: "/curves?n_t=1.5&k_t=0.5&landmarks=true",
    },
    answers: [
      ({ water, crown, diamond }) =>
        `Water ${degrees(water.interface.brewster_deg)}, crown glass ($n=1.52$) ${degrees(crown.interface.brewster_deg)}, diamond ($n=2.417$) ${degrees(diamond.interface.brewster_deg)}.`,
      () =>
        "With $\\theta_t=90^\\circ-\\theta_B$ the law reads $n_i\\sin\\theta_B=n_t\\cos\\theta_B$, and $\\tan\\theta_B=n_t/n_i$. The picture marks the right angle between the reflected and the refracted ray.",
      ({ absorbing }) => {
        const least = Math.min(...values(absorbing, "Rp").map((R) => R ?? 1));
        return `A least $R_p$ that is not 0: ${percent(least)} at the pseudo-Brewster angle, ${degrees(absorbing.interface.pseudo_brewster_deg)}.`;
      },
    ],
  },
  caught: {
    asks: {
      phases: "/curves?n_i=1.51&n_t=1&phase=true&samples=901",
      steep: "/snell?n_i=1.5&n_t=1&theta_i_deg=42",
      flat: "/snell?n_i=1.5&n_t=1&theta_i_deg=45",
    },
    answers: [
      () =>
        "The reflected arrow is as long as the incident one, $R=1$; the refracted ray lies in the surface, and its arrow has no length: nothing is carried away.",
      () =>
        `At $n_i=1.2/\\sin 60^\\circ=${plain(1.2 / Math.sin(Math.PI / 3), 4)}$: there 60° is the critical angle.`,
      ({ phases }) => {
        const caught = delays(phases).filter(
          ({ deg }) => deg > phases.interface.critical_deg && deg < 90,
        );
        const most = caught.reduce((a, b) => (b.by > a.by ? b : a));
        const [from, to] = [true, false].map((before) =>
          caught
            .filter(({ deg }) => deg < most.deg === before)
            .reduce((a, b) => (Math.abs(b.by - 45) < Math.abs(a.by - 45) ? b : a)),
        );
        return `By ${degrees(most.by)}, at ${degrees(most.deg)}. It is 45° at ${degrees(from?.deg ?? 0)} and at ${degrees(to?.deg ?? 0)}; Fresnel built his rhomb for the larger, where the difference changes less with the angle.`;
      },
      ({ flat, steep }) =>
        [
          ["45°", flat],
          ["42°", steep],
        ]
          .map(
            ([name, ray]) =>
              `At ${name} the power has fallen to 1/e in ${short(ray.penetration_depth_wavelengths)} wavelengths, the field in ${short(ray.field_penetration_depth_wavelengths)}`,
          )
          .join(". ")
          .concat("."),
    ],
  },
  renderer: {
    asks: {
      schlick: "/errors/sweep?model=schlick&over=n_t&minimum=1.01&maximum=3&steps=200",
      iron: "/recommend?n_t=2.9&k_t=3&max_error=0.01",
      over_k:
        "/errors/sweep?model=pharr_humphreys&n_t=1.5&over=k_t&minimum=0.05&maximum=5&steps=100",
    },
    answers: [
      ({ schlick }) =>
        `For $n$ ${stretches(schlick.values, (i) => schlick.max_abs[i] < 0.04)}, where its largest error over all angles is below 0.04.`,
      ({ iron }) =>
        `${iron.models
          .map((/** @type {any} */ m) => m.title)
          .slice(0, 2)
          .join(
            ", then ",
          )}: the first costs a fetch from a texture, so what is cheapest depends on the machine.`,
      ({ over_k }) =>
        `Wherever $k$ is large: at $n=1.5$ for $k$ ${stretches(over_k.values, (i) => over_k.max_abs[i] < 0.01)}. It drops what is of the order of $1/(n^2+k^2)$, so a large $n$ does as well.`,
      () => "The names stand on the cards; the point is to find each mistake in its curve first.",
    ],
  },
  metals: {
    asks: {
      gold: "/materials/Au/curves?wavelengths_nm=450,500,550,600,650&rgb=false&samples=2",
      copper: "/materials/Cu/curves?models=schlick,f82_tint&wavelengths_nm=550",
      ...Object.fromEntries(METALS.map((id) => [id, `/materials/${id}`])),
    },
    answers: [
      ({ gold }) =>
        `Its $F_0$ is ${gold.wavelengths.map((/** @type {any} */ w) => `${percent(w.F0)} at ${w.wavelength_nm} nm`).join(", ")}: it rises from the blue-green on, and takes away blue.`,
      ({ copper }) => `${["schlick", "f82_tint"].map((id) => worst(copper, id)).join("; ")}.`,
      (asked) => {
        const by = (/** @type {number} */ channel) =>
          METALS.map((id) => ({ name: asked[id].name, F0: asked[id].color.F0[channel] }))
            .sort((a, b) => b.F0 - a.F0)
            .map(({ name, F0 }) => `${name.toLowerCase()} ${percent(F0)}`)
            .join(", ");
        return `In the green ${by(1)}; in the blue ${by(2)}. The first of each is the best mirror there.`;
      },
    ],
  },
  paint: {
    asks: {
      wall: "/albedo/coat?n_t=1.5&body_albedo=0.8",
      wet: "/albedo?n_i=1.333&n_t=1",
    },
    answers: [
      ({ wall }) =>
        `${percent(wall.surface + wall.body)}: ${percent(wall.surface)} from the surface and ${percent(wall.body)} from the body.`,
      ({ wet }) =>
        `Of light that comes up through water from all sides, ${percent(wet.exact.unpolarized)} is thrown back at its surface. It meets the shirt again, which takes its part each time.`,
      () =>
        "More than one answer is right that names its range, its error measured there and its cost; sort the table by the measured error to find candidates.",
    ],
  },
  guess: {
    asks: {},
    answers: MYSTERIES.map((code) => () => `${hidden(code)}.`),
  },
};
