/** What a caption says of a figure: what it shows, of what, after whom, and how to make it again. */

import { plain } from "../numbers/format.js";
import { load } from "../server/api.js";

/** @param {string} text */
const sentence = (text) =>
  `${text.replace(/^\p{Ll}(?=\p{L})/u, (letter) => letter.toUpperCase()).replace(/[.\s]+$/u, "")}.`;

/**
 * The media as numbers, as far as they are single ones or those of a family of curves.
 * @param {Record<string, any>} answer
 * @param {readonly string[]} ids of curves; `exact@2.4` is that of another n_t than the answer's
 */
function numbersOf(answer, ids) {
  const inputs = [answer, answer.interface ?? {}, answer.front ?? {}];
  const others = ids.flatMap((id) => id.split("@").slice(1).map(Number));
  return ["n_i", "n_t", "k_t"].flatMap((name) => {
    const value = inputs.map((part) => part[name]).find((one) => typeof one === "number");
    if (value === undefined) return [];
    const all = name === "n_t" ? [...new Set([value, ...others])] : [value];
    return [`${name} = ${all.map((one) => plain(one)).join(", ")}`];
  });
}

/**
 * @param {CitedPreset} preset
 * @param {CitedMedium} medium
 */
function cited({ name, kind, wavelength_nm, source, doi }, { at_nm, of }) {
  const links = doi.filter((one) => !source.includes(one)).map((one) => `, doi:${one}`);
  const nm = kind === "spectrum" ? (at_nm ?? wavelength_nm) : wavelength_nm;
  const at = at_nm === undefined || nm === null ? "" : ` at ${plain(nm)} nm`;
  const what = of ? `${of} of ${name}` : name;
  return `${what}${at}: ${source.replace(/[.\s]+$/u, "")}${links.join("")}.`;
}

/**
 * The sources of what is drawn.
 * @param {readonly string[]} ids of curves: `schlick`, `schlick.R_r`, `exact@1.5`
 * @param {readonly CitedMedium[]} media
 * @param {string} call that was drawn
 * @returns {Promise<string[]>} whom to cite, a paragraph each
 */
async function sourcesOf(ids, media, call) {
  const drawn = new Set(ids.map((id) => id.split(/[.@]/u)[0]));
  // A fit may have the id of a model.
  const fitted = call.startsWith("/albedo");
  const [listed, { materials }] = await Promise.all([
    load(fitted ? "/albedo/fits" : "/models?fields=id,title,reference"),
    load("/materials?fields=id,name,kind,wavelength_nm,source,doi"),
  ]);
  const entries = /** @type {Cited[]} */ (fitted ? listed.fits : listed.models);
  return [
    ...entries
      .filter(({ id }) => id !== "exact" && drawn.has(id))
      .map(({ title, reference }) => sentence(`${title}: ${reference}`)),
    ...media.flatMap((medium) => {
      const preset = /** @type {CitedPreset[]} */ (materials).find(({ id }) => id === medium.id);
      return preset ? [cited(preset, medium)] : [];
    }),
  ];
}

/**
 * @param {{name: string, ids: readonly string[]}} figure
 * @param {readonly CitedMedium[]} media
 * @param {{call: string, href: string, version: string}} page `call` is the path that it shows
 */
export async function captionOf({ name, ids }, media, { call, href, version }) {
  const numbers = numbersOf(call ? await load(call) : {}, ids).join("; ");
  return [
    sentence(name) + (numbers && ` ${sentence(numbers)}`),
    ...(await sourcesOf(ids, media, call)),
    `Fresnel Explorer ${version}, ${href}`,
  ].join("\n");
}

/** @param {Behind} behind @returns {CitedMedium[]} */
export function mediaBehind({ state, indices = [], presets = [] }) {
  const shown = presets.map((id) => ({ id }));
  if (!state) return shown;
  const { incident, material, wavelength_nm: at_nm, k_t } = state;
  const second = indices.filter((name) => name !== "n_i");
  const used = second.includes("n_t") || (second.includes("k_t") && k_t !== 0);
  return [
    ...shown,
    ...(incident && indices.includes("n_i") ? [{ id: incident, at_nm }] : []),
    ...(material && used
      ? [{ id: material, at_nm, ...(second.length === 1 && { of: second[0] }) }]
      : []),
  ];
}
