/** Where the numbers come from, and how far other measurements lie from them. */

import { isPage, pathOf } from "../media/brought.js";
import { stretch } from "../media/wavelength.js";
import { plain } from "../numbers/format.js";
import { copying, h } from "../page/dom.js";
import { aside } from "../page/links.js";
import { html, nothing, render } from "../page/lit.js";
import { narrow } from "./columns.js";

/** Units that end the names of conditions. @type {Record<string, string>} */
const UNITS = { k: "K", pa: "Pa", nm: "nm" };

/** A condition in words: `temperature_k` 293 is "temperature 293 K". @param {string} key @param {string | number} value */
export function condition(key, value) {
  const parts = key.split("_");
  const unit = typeof value === "number" ? UNITS[parts.at(-1) ?? ""] : undefined;
  const name = (unit ? parts.slice(0, -1) : parts).join(" ");
  return `${name} ${typeof value === "number" ? plain(value) : value}${unit ? `\u00a0${unit}` : ""}`;
}

/** @param {string} doi */
const resolved = (doi) => `https://doi.org/${doi}`;

/** What a reader would cite. @param {any} detail */
export function citation({ source, doi, provenance }) {
  const database = provenance ? `${provenance.database} ${provenance.tag}, ${provenance.page}` : "";
  return [source, ...doi.map(resolved), database].filter(Boolean).join(". ");
}

/** @param {string} term @param {unknown} words none leaves it out @param {string | typeof nothing} [name] of its class */
const entry = (term, words, name = nothing) =>
  words ? html`<div class=${name}><dt>${term}</dt><dd>${words}</dd></div>` : nothing;

/** @param {string} text @param {string} href */
const link = (text, href) =>
  entry("Link", html`<a href=${href} rel="noreferrer" target=${aside()}>${text}</a>`);

/** @param {any} provenance */
const data = ({ database, tag, file, sha256 }) => html`${database} ${tag}, ${file},
  <span class="sum" title=${sha256}>sha256 ${sha256.slice(0, 12)}…</span>`;

/** @type {Record<string, string>} */
const MEDIA = { air: "air: what is computed takes n times air’s index", vacuum: "vacuum" };

/** What n is relative to, and where wavelengths are counted. @param {any} detail */
export function reference({ relative_to, wavelength_in }) {
  const index = MEDIA[relative_to] ?? "not stated: n counts as absolute";
  return `${index}; wavelengths ${wavelength_in ? `in ${wavelength_in}` : "not said to be in air or vacuum"}`;
}

/** @param {(text: string) => void} say */
export function createSource(say) {
  const element = h("section.column.sheet.origin", { "aria-label": "Source" });
  return {
    element,
    /** @param {any} detail */
    update(detail) {
      const { source, sample, confidence, provenance, doi, n_range_nm: n, k_range_nm: k } = detail;
      const conditions = Object.entries(detail.conditions).map(([key, one]) => condition(key, one));
      /** @type {string[]} */
      const links = doi.length ? [] : (provenance?.links ?? []);
      render(
        html`<div class="heading">
            <h2>Source</h2>
            <button type="button" class="quiet"
              @click=${copying(() => citation(detail), say, "Citation copied")}>copy citation</button>
          </div>
          <dl class="source-list">
            ${entry("Reference", source)}
            ${doi.map((/** @type {string} */ one) => link(`doi:${one}`, resolved(one)))}
            ${links.map((url) => link(url, url))}
            ${entry("Sample", `${sample}; confidence ${confidence}`)}
            ${entry("Conditions", conditions.join(", "))}
            ${entry("Measured against", reference(detail))}
            ${entry("Note", detail.note)} ${entry("Comment", provenance?.comments)}
            ${entry("Known", n && `n ${stretch(n)}; k ${k ? stretch(k) : "not given"}`)}
            ${entry("Licence", detail.licence)} ${entry("Data", provenance && data(provenance))}
            ${detail.warnings.map((/** @type {string} */ one) => entry("Warning", one, "warning"))}
          </dl>`,
        element,
      );
    },
  };
}

const HEADINGS = ["measurement", "Y", "difference", "n", "k"];

/**
 * Measurements of the same material, this one among them, by their reflectance.
 * @param {(id: string) => void} onPick
 */
export function createRivals(onPick) {
  const element = h("section.column.sheet.rival-list", { "aria-label": "Other measurements" });
  return {
    element,
    /** @param {any} detail */
    update(detail) {
      element.hidden = detail.rivals.length === 0;
      const own = { ...detail, luminance: detail.color.luminance };
      // What dielectrics differ by is seen in the fourth digit.
      const fixed = (/** @type {number} */ Y) => Y.toFixed(own.luminance < 0.2 ? 5 : 3);
      const all = [own, ...detail.rivals].sort((a, b) => a.luminance - b.luminance);
      const { minimum, maximum } = detail.spread;
      /** @param {any} one */
      function row(one) {
        const here = one === own;
        const name = isPage(one.id) ? pathOf(one.id).split("/").at(-1) : one.name;
        const by = one.luminance - own.luminance;
        const pick = html`<button type="button" class="rival" title=${one.source}
          @click=${() => onPick(one.id)}>${name}</button>`;
        return html`<tr ?data-chosen=${here}>
          <th scope="row">${here ? html`<b>${name}</b>` : pick}<span class="rival-about">${one.sample}, ${one.confidence}</span></th>
          <td>${fixed(one.luminance)}</td>
          <td>${here ? "shown" : `${by < 0 ? "−" : "+"}${fixed(Math.abs(by))}`}</td>
          <td>${plain(one.n, 4)}</td>
          <td>${narrow(one.k)}</td>
        </tr>`;
      }
      render(
        html`<div class="heading"><h2>Other measurements</h2></div>
          <p class="hint">Luminous reflectance at normal incidence lies between ${fixed(minimum)} and ${fixed(maximum)} in ${all.length} measurements: which one is taken changes it by ${fixed(maximum - minimum)}.</p>
          <div class="rival-scroll" tabindex="0" role="region" aria-label="Measurements of the same material">
            <table class="rivals">
              <caption class="hidden">Measurements of the same material</caption>
              <thead><tr>${HEADINGS.map((words) => html`<th scope="col">${words}</th>`)}</tr></thead>
              <tbody>${all.map(row)}</tbody>
            </table>
          </div>`,
        element,
      );
    },
  };
}
