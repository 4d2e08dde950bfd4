/** What a caption says of a figure: what it shows, of what, after whom, and how to make it again. */

import { load } from "../api.js";

/** @typedef {{id: string, title: string, reference: string}} Entry */

/**
 * What is in a link and names a medium.
 * @param {URLSearchParams} link
 */
function mediaIn(link) {
  return [...new Set([link.get("incident"), link.get("material"), link.get("item")])].filter(
    (id) => id !== null && id !== "",
  );
}

/** @param {string} text */
const sentence = (text) => `${text.replace(/[.\s]+$/u, "")}.`;

/**
 * The sources of the models and fits that are drawn and of the media that are named.
 * @param {readonly string[]} ids of curves: `schlick`, `schlick.R_r`, `exact@1.5`
 * @param {URLSearchParams} link
 * @returns {Promise<string[]>} whom to cite, a paragraph each
 */
export async function sourcesOf(ids, link) {
  const drawn = new Set(ids.map((id) => id.split(/[.@]/u)[0]));
  const [{ models }, { fits }, ...media] = await Promise.all([
    load("/models?fields=id,title,reference"),
    load("/albedo/fits"),
    ...mediaIn(link).map((id) => load(`/materials/${encodeURIComponent(String(id))}`)),
  ]);
  const entries = /** @type {Entry[]} */ ([...models, ...fits]);
  return [
    ...entries
      .filter(({ id }) => id !== "exact" && drawn.has(id))
      .map(({ title, reference }) => sentence(`${title}: ${reference}`)),
    ...media.map(({ name, source }) => sentence(`${name}: ${source}`)),
  ];
}

/**
 * @param {readonly {name: string, ids: string[]}[]} figures
 * @param {{calls: string[], href: string, version: string}} page
 */
export async function captionOf(figures, { calls, href, version }) {
  const link = new URL(href);
  const request = calls[0] ? new URLSearchParams(calls[0].split("?")[1]) : null;
  const parameters = [...(request ?? [])]
    .filter(([, value]) => value !== "")
    .map(([name, value]) => `${name} = ${value.replaceAll(",", ", ")}`)
    .join("; ");
  const sources = await sourcesOf(
    figures.flatMap(({ ids }) => ids),
    link.searchParams,
  );
  return [
    sentence(figures.map(({ name }) => name).join("; ")) +
      (parameters ? ` ${sentence(parameters)}` : ""),
    ...sources,
    `Fresnel Explorer ${version}, ${href}`,
  ].join("\n");
}
