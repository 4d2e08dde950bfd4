/** What a caption says of a figure: what it shows, of what, after whom, and how to make it again. */

import { load } from "../api.js";
import { plain } from "../format.js";

/**
 * @typedef {{id: string, title: string, reference: string}} Entry
 * @typedef {{id: string, name: string, source: string, doi: string[], wavelength_nm?: number}} Medium
 */

/** @param {string} text */
const sentence = (text) =>
  `${text.replace(/^\p{Ll}(?=\p{L})/u, (letter) => letter.toUpperCase()).replace(/[.\s]+$/u, "")}.`;

/** Where an answer says what it was computed for. @param {Record<string, any>} answer */
const inputsOf = (answer) => [answer, answer.interface ?? {}, answer.front ?? {}];

/** Both media as numbers, as far as they are single ones. @param {Record<string, any>} answer */
function numbersOf(answer) {
  const inputs = inputsOf(answer);
  return ["n_i", "n_t", "k_t"].flatMap((name) => {
    const value = inputs.map((part) => part[name]).find((one) => typeof one === "number");
    return value === undefined ? [] : [`${name} = ${plain(value)}`];
  });
}

/** @param {Record<string, any>} answer @returns {Medium[]} those that it was computed for */
function mediaOf(answer) {
  return inputsOf(answer)
    .flatMap(({ incident, material }) => [incident, material])
    .filter((medium) => medium?.source);
}

/** @param {Medium} medium */
function cited({ name, source, doi, wavelength_nm }) {
  const links = doi.filter((one) => !source.includes(one)).map((one) => `, doi:${one}`);
  const at = wavelength_nm ? ` at ${plain(wavelength_nm)} nm` : "";
  return sentence(`${name}${at}: ${source.replace(/\.$/u, "")}${links.join("")}`);
}

/**
 * The sources of what is drawn.
 * @param {readonly string[]} ids of curves: `schlick`, `schlick.R_r`, `exact@1.5`
 * @param {string} call that was drawn
 * @param {Record<string, any>} answer to it
 * @param {URLSearchParams} link to the page
 * @returns {Promise<string[]>} whom to cite, a paragraph each
 */
async function sourcesOf(ids, call, answer, link) {
  const drawn = new Set(ids.map((id) => id.split(/[.@]/u)[0]));
  // A fit may have the id of a model.
  const fitted = call.startsWith("/albedo");
  const [listed, { materials }] = await Promise.all([
    load(fitted ? "/albedo/fits" : "/models?fields=id,title,reference"),
    load("/materials?fields=id,name,source,doi"),
  ]);
  const entries = /** @type {Entry[]} */ (fitted ? listed.fits : listed.models);
  const own = mediaOf(answer);
  // The page asks for some of its media by their indices.
  const named = new Set([...drawn, link.get("incident"), link.get("material")]);
  const beside = /** @type {Medium[]} */ (materials).filter(
    ({ id }) => named.has(id) && own.every((medium) => medium.id !== id),
  );
  return [
    ...entries
      .filter(({ id }) => id !== "exact" && drawn.has(id))
      .map(({ title, reference }) => sentence(`${title}: ${reference}`)),
    ...[...own, ...beside].map(cited),
  ];
}

/**
 * @param {readonly {name: string, ids: readonly string[]}[]} figures
 * @param {{call: string, href: string, version: string}} page `call` is the path that they show
 */
export async function captionOf(figures, { call, href, version }) {
  const answer = call ? await load(call) : {};
  const numbers = numbersOf(answer).join("; ");
  const ids = figures.flatMap((figure) => figure.ids);
  return [
    sentence(figures.map(({ name }) => name).join("; ")) + (numbers && ` ${sentence(numbers)}`),
    ...(await sourcesOf(ids, call, answer, new URL(href).searchParams)),
    `Fresnel Explorer ${version}, ${href}`,
  ].join("\n");
}
