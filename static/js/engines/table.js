/** The ways to enter a medium: what was typed, how far each is off, and what explains it. */

import { angle, significant } from "../numbers/format.js";
import { h } from "../page/dom.js";
import { addressOf } from "../page/links.js";
import { html, nothing, render } from "../page/lit.js";
import { typedWords } from "./answers.js";

/**
 * @typedef {import('./answers.js').Curve} Curve
 * @typedef {import('./answers.js').Measured} Measured
 */

/** @param {import('./answers.js').Largest} largest @param {boolean} metal @param {State} state */
const where = ({ max_abs, at_deg, channel }, metal, state) =>
  `${significant(max_abs, 3)} at ${angle(at_deg, state.angle, 0)}${metal ? `, ${channel}` : ""}`;

/** @param {ViewContext} context */
export function createTable({ catalog: { models } }) {
  const element = h("div.claims-scroll");

  /** @param {Curve} curve @param {boolean} metal @param {State} state */
  const row = (curve, metal, state) => {
    const model = models.find((m) => m.id === curve.model);
    return html`<tr>
      <th scope="row">${curve.way}</th>
      <td class="typed">${typedWords(curve.typed)}</td>
      <td>${where(curve.error, metal, state)}</td>
      <td>${
        model && curve.model_error
          ? html`<a href=${addressOf("compare", { models: model.id })}>${model.title}</a>, within
            ${where(curve.model_error, metal, state)}`
          : nothing
      }</td>
    </tr>`;
  };

  return {
    element,
    /** @param {readonly Curve[]} curves @param {boolean} metal @param {State} state */
    update(curves, metal, state) {
      render(
        html`<table class="claims">
          <thead>
            <tr>
              <th scope="col">Way</th>
              <th scope="col">Typed</th>
              <th scope="col">Largest error against exact</th>
              <th scope="col">Explained by</th>
            </tr>
          </thead>
          <tbody>${curves.map((curve) => row(curve, metal, state))}</tbody>
        </table>`,
        element,
      );
    },
  };
}
