/** A metal's color, which its whole spectrum has and no single n and k. */

import { isDispersive } from "../media/media.js";
import { significant } from "../numbers/format.js";
import { symbol } from "../page/dom.js";
import { html, nothing } from "../page/lit.js";

/** @typedef {{display: {hex: string, F0: number[], F82: number[], F82_tint: number[], in_gamut: boolean, codes: Record<string, string>} | null}} Detail */

const ROWS = /** @type {const} */ ([
  ["F0", "F_0", "as base color"],
  ["F82", "F_{82}", "near 82°"],
  ["F82_tint", "", "F82-tint, as specular color"],
]);

/** @param {State} state */
const isOwn = ({ from, k_t }) => from === "media" && k_t > 0;

/** @param {State} state @param {Catalog} catalog */
const measured = ({ material }, { materials }) => {
  const found = materials.find((m) => m.id === material);
  return isDispersive(found) ? found : undefined;
};

/** What the color is asked with; null where what is converted has none. @param {State} state @param {Catalog} catalog */
export function colorPath(state, catalog) {
  const found = isOwn(state) ? measured(state, catalog) : undefined;
  return found ? `/materials/${encodeURIComponent(found.id)}?gamut=scaled` : null;
}

/**
 * What a metal looks like, above what one wavelength of it is in other words.
 * @param {State} state
 * @param {Catalog} catalog
 * @param {Detail | undefined} detail of the material, once it has come
 */
export function colored(state, catalog, detail) {
  if (!isOwn(state)) return nothing;
  const found = measured(state, catalog);
  const shown = detail?.display;
  if (!found)
    return html`<p class="reason">One n and k are of one wavelength: what they come to is gray. A metal
      that was measured over the spectrum has a color; choose one above.</p>`;
  if (!shown)
    return detail ? html`<p class="reason">It is not known over all visible light.</p>` : nothing;
  return html`<table class="metal-color">
      <caption>${found.name} in linear sRGB${state.n_i === 1 ? "" : ", seen from vacuum"}</caption>
      <tbody>${ROWS.map(
        ([name, sign, words]) => html`<tr>
          <th scope="row">${sign ? symbol(sign) : nothing} ${words}</th>
          <td><i class="swatch" aria-hidden="true" style="background: ${shown.codes[name]}"></i>${shown.codes[name]}</td>
          <td>${shown[name].map((value) => significant(value, 4)).join(", ")}</td>
        </tr>`,
      )}</tbody>
    </table>
    <p class="reason">Of its whole spectrum under D65${shown.in_gamut ? "" : ", scaled into 0 to 1"}. What follows is
      of one wavelength alone, which has no color.</p>`;
}
