/** What the films do at one wavelength and angle, and the two colors that eyes see of them. */

import { angle, percent, plain, six } from "../numbers/format.js";
import { createChanged } from "../page/changed.js";
import { h } from "../page/dom.js";
import { html, nothing, render } from "../page/lit.js";
import { wavelengthOf } from "./fields.js";

/** @param {any} film @param {string} words @param {(value: number) => string} [write] */
const entry = (film, words, write = six) =>
  html`<div><dt>${words}</dt><dd>${film === null || film === undefined ? "none" : write(film)}</dd></div>`;

/** @param {any} answer @param {string} words @param {number} [which] of the models */
function swatch(answer, words, which = 0) {
  const color = answer?.colors?.[which];
  const hex = color?.hex?.[0]?.[0];
  if (!hex) return nothing;
  /** @type {number[]} */
  const lab = color.lab[0][0];
  const off = color.delta_e?.[0]?.[0];
  return html`<div class="film-swatch">
    <i style="background: ${hex}"></i>
    <span>${words} <b>${hex}</b></span>
    <span>Lab ${lab.map((v) => plain(v, 3)).join(", ")}${off === undefined ? nothing : `; ΔE ${plain(off, 3)}`}</span>
  </div>`;
}

export function createNumbers() {
  const element = h("div.film-numbers");
  const changed = createChanged();
  return {
    element,
    /** @param {State} now @param {Record<string, any>} answers */
    update(now, { here, reflected, transmitted }) {
      if (!here || !changed(here, reflected, transmitted, now.angle)) return;
      const deg = (/** @type {number} */ v) => angle(v, now.angle);
      /** @type {number[]} */
      const absorbed = here.absorbed ?? [];
      render(
        html`<p class="reason">At ${plain(here.wavelength_nm ?? wavelengthOf(now), 5)} nm and ${angle(here.theta_i_deg, now.angle)}</p>
          <dl>
            ${entry(here.R, "R")}${entry(here.T, "T")}${entry(here.A, "A")}
            ${entry(here.Rs, "Rs")}${entry(here.Rp, "Rp")}
            ${entry(here.psi_deg, "ψ", deg)}${entry(here.delta_deg, "Δ", deg)}
          </dl>
          ${
            absorbed.length > 1 && here.A > 0
              ? html`<p class="reason">Absorbed layer by layer: ${absorbed.map((a) => percent(a)).join(", ")}</p>`
              : nothing
          }
          <div class="film-swatches">${swatch(reflected, "reflected")}${swatch(reflected, "by the shortcut", 1)}${swatch(transmitted, "transmitted")}</div>`,
        element,
      );
    },
  };
}
