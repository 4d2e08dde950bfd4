import { locate, read, values } from "../curves/reading.js";
import { thinQueries } from "./film-lesson.js";

/**
 * What a lesson is, and the numbers that hold in it: its own, until the reader moves them.
 *
 * @typedef {{n_i: number, n_t: number, k_t: number, deg: number, polarization: string, of: string}} Setting
 * @typedef {{setting: Setting, reading: Reading | null, answers: Record<string, any>, state: State}} Scene what is
 *   on the picture now
 * @typedef {Scene & {reading: Reading}} ReadScene
 * @typedef {'own_i' | 'own_n' | 'own_k' | 'own_deg'} RowName
 * @typedef {object} Try
 * @property {string} say what to do
 * @property {(scene: Scene) => boolean} done
 * @property {string} reply what it shows
 *
 * @typedef {object} Lesson
 * @property {string} id
 * @property {string} title
 * @property {string[]} text paragraphs; `$…$` is mathematics
 * @property {string} [formula] of `/formulas`, shown with a link
 * @property {string} [code] what people write
 * @property {boolean} [planes] whether the planes of the wave beyond the surface are drawn
 * @property {'colors' | 'coat' | 'films'} [picture] in place of the ray beside the curves
 * @property {Partial<Setting>} at
 * @property {Partial<Record<RowName, [number, number]>>} [rows] what can be moved, with the slider's range
 * @property {string[]} [models]
 * @property {string[]} [quantities] curves of the exact solution; R alone if nothing else is said
 * @property {boolean} [polarized] whether the polarization can be chosen
 * @property {readonly [string, string]} [names] of the two media, as long as they are the lesson's own
 * @property {string[]} [media] presets to choose among
 * @property {string[]} [errors] models whose largest error is told
 * @property {(scene: ReadScene) => string} [live] a sentence that follows the picture
 * @property {Try[]} [tries]
 * @property {[string, string, Record<string, string | number>][]} [more] text, view and state of links
 */

/** @type {Setting} */
const PLAIN = { n_i: 1, n_t: 1.5, k_t: 0, deg: 60, polarization: "unpolarized", of: "Au" };

/** @param {State} state @param {Lesson} lesson @returns {Setting} */
export function settingOf(state, { at }) {
  const own = { ...PLAIN, ...at };
  return {
    n_i: state.own_i ?? own.n_i,
    n_t: state.own_n ?? own.n_t,
    k_t: state.own_k ?? own.k_t,
    deg: state.own_deg ?? own.deg,
    polarization: state.own_pol ?? own.polarization,
    of: state.own_of ?? own.of,
  };
}

/** The interface's part of a query. @param {Setting} setting */
export function media({ n_i, n_t, k_t }) {
  return [n_i !== 1 && `n_i=${n_i}`, `n_t=${n_t}`, k_t > 0 && `k_t=${k_t}`].filter(Boolean);
}

/**
 * What a lesson asks the server for.
 * @param {State} state
 * @param {Lesson} lesson
 * @returns {Record<string, string>}
 */
export function lessonQueries(state, lesson) {
  const setting = settingOf(state, lesson);
  if (lesson.picture === "coat") return {}; // the Albedo view's own
  if (lesson.picture === "films") return thinQueries(state, setting.deg);
  if (lesson.picture === "colors") {
    const models = (lesson.models ?? []).join(",");
    return {
      colors: `/materials/${setting.of}/curves?wavelengths_nm=550&models=${models}`,
      detail: `/materials/${setting.of}`,
    };
  }
  const here = media(setting);
  const models = ["exact", ...(lesson.models ?? [])].join(",");
  return {
    curves: `/curves?${[...here, `models=${models}`, "landmarks=true", "refraction=true"].join("&")}`,
    snell: `/snell?${[...here, `theta_i_deg=${setting.deg}`].join("&")}`,
    ...(lesson.errors && {
      errors: `/errors?${[...here, `models=${lesson.errors.join(",")}`].join("&")}`,
    }),
  };
}

/** A model's value at the angle, read from its curve. @param {Scene} scene @param {string} model @param {string} [quantity] */
export function shareBy({ answers, setting }, model, quantity = "R") {
  if (!answers.curves) return null;
  const place = locate(answers.curves.theta_i_deg, setting.deg);
  return read(values(answers.curves, quantity, model), place);
}

/** What is wrong with a model here. @param {Scene} scene @param {string} model */
export function errorOf({ answers }, model) {
  /** @type {import('../errors/metrics.js').Row[]} */
  const rows = answers.errors?.errors ?? [];
  return rows.find((row) => row.model === model) ?? null;
}

/**
 * By how much planes of equal phase lean beyond the surface: where all is reflected the wave runs along it.
 * @param {number | null} theta_t_deg
 */
export const leaning = (theta_t_deg) => theta_t_deg ?? 90;
