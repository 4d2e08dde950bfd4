/** All models of the atlas: for how many materials of each kind their error is small, best first. */

import { modelStyle } from "../models/look.js";
import { sampled } from "../models/sampled.js";
import { html, nothing, render } from "../page/lit.js";

/**
 * @typedef {import('./answers.js').ModelShare} ModelShare
 * @typedef {import('./answers.js').Share} Share
 */

const KINDS = /** @type {const} */ (["clear", "absorbing", "metal"]);
const HEADINGS = { clear: "Clear", absorbing: "Absorbing", metal: "Metals" };

/** @param {readonly Share[]} kinds */
function share(kinds) {
  const [within, all] = [0, 0].map((_, at) =>
    kinds.reduce((sum, one) => sum + (at ? one.materials : one.within), 0),
  );
  return all ? (within ?? 0) / all : 0;
}

/**
 * The models that are told: exact forms are within rounding everywhere, but a color made of three
 * numbers is none.
 * @param {readonly ModelShare[]} shares @param {readonly Model[]} models @param {string} metric
 */
export function told(shares, models, metric) {
  const exact = new Set(models.filter((m) => m.kind === "exact").map((m) => m.id));
  return shares
    .filter((one) => metric === "delta_e" || !exact.has(one.model))
    .sort((a, b) => Number(a.trap) - Number(b.trap) || share(b.kinds) - share(a.kinds));
}

/** @param {ViewContext} context */
export function createFormulas({ catalog: { models }, element, actions }) {
  element.classList.add("claims-scroll");

  /** @param {Share | undefined} one */
  const cell = (one) =>
    one
      ? html`<td class="share">
          <span class="bar" aria-hidden="true"><i style="width: ${(100 * one.within) / one.materials}%"></i></span>
          ${one.within.toLocaleString("en")} of ${one.materials.toLocaleString("en")}
        </td>`
      : html`<td class="share none"><span title="not made for these">–</span></td>`;

  /** @param {ModelShare} one @param {string} chosen */
  const row = ({ model, title, kinds }, chosen) => html`<tr>
    <th scope="row">
      <button
        type="button"
        class="pick-fit"
        aria-pressed=${model === chosen}
        @click=${() => actions.set({ atlas_model: model })}
      >${sampled(modelStyle(models, model))}<span>${title}</span></button>
    </th>
    ${KINDS.map((kind) => cell(kinds.find((k) => k.kind === kind)))}
  </tr>`;

  return {
    /** @param {readonly ModelShare[]} shares @param {State} now */
    update(shares, now) {
      const rows = told(shares, models, now.atlas_metric);
      render(
        rows.length
          ? html`<table class="claims shares">
              <thead>
                <tr>
                  <th scope="col">Formula</th>
                  ${KINDS.map((kind) => html`<th scope="col">${HEADINGS[kind]}</th>`)}
                </tr>
              </thead>
              <tbody>${rows.map((one) => row(one, now.atlas_model))}</tbody>
            </table>`
          : nothing,
        element,
      );
    },
  };
}
