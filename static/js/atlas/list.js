/** The materials of the figure as a list, and what the atlas has of the one that was chosen. */

import { short } from "../errors/metrics.js";
import { become } from "../media/brought.js";
import { modelStyle } from "../models/look.js";
import { sampled } from "../models/sampled.js";
import { angle, plain } from "../numbers/format.js";
import { addressOf, clicked, follow } from "../page/links.js";
import { html, nothing, render } from "../page/lit.js";
import { largestOf } from "./answers.js";
import { METRICS } from "./fields.js";

/**
 * @typedef {import('./answers.js').Point} Point
 * @typedef {import('./answers.js').OfMaterial} OfMaterial
 */

const FEW = 25;
const MORE = 200;

/** An error as the metric has it. @param {number | null} error @param {string} metric */
export function written(error, metric) {
  if (error === null) return "undefined";
  return metric === "delta_e" ? `ΔE ${short(error)}` : short(error);
}

/** @param {number | null} nm */
const at = (nm) => (nm === null ? "" : `${plain(nm, 5)} nm`);

/** Where the largest error is. @param {Point} point @param {State} state */
export const where = ({ error_at_deg, error_at_nm }, state) =>
  [error_at_deg === null ? "" : angle(error_at_deg, state.angle), at(error_at_nm)]
    .filter(Boolean)
    .join(", ");

/** @param {ViewContext & {list: HTMLElement, card: HTMLElement}} context */
export function createList({ catalog: { models, materials }, list, card, actions }) {
  let most = FEW;
  /** @type {readonly Point[]} */
  let last = [];
  /** @type {State} */
  let state = {};

  /** Go where a material is shown, which has to be a medium there. @param {string} id @param {string} href */
  async function open(id, href) {
    await become(materials, id).catch(() => {}); // what is wrong is told there
    follow(href);
  }
  /** @param {string} id */
  const openMaterial = (id) => open(id, addressOf("materials", { preset: id }));

  /** @param {string} text @param {string} id @param {string} href */
  const link = (text, id, href) =>
    html`<a href=${href} @click=${clicked(() => void open(id, href))}>${text}</a>`;

  /** @param {Point} point */
  const row = (point) => html`<tr data-chosen=${point.id === state.atlas_at ? "" : nothing}>
    <th scope="row">
      <button
        type="button"
        class="pick-fit"
        aria-pressed=${point.id === state.atlas_at}
        @click=${() => actions.set({ atlas_at: point.id })}
      ><span>${point.name}</span></button>
    </th>
    <td class="id">${point.id}</td>
    <td>${point.kind}</td>
    <td>${written(point.error, state.atlas_metric)}</td>
    <td class="where">${where(point, state)}</td>
  </tr>`;

  function draw() {
    const shown = last.slice(0, most);
    const more = last.length - shown.length;
    const next = () => {
      most += MORE;
      draw();
    };
    render(
      html`<div class="claims-scroll"><table class="claims">
          <thead>
            <tr>
              <th scope="col">Material</th>
              <th scope="col" class="id">Id</th>
              <th scope="col">Kind</th>
              <th scope="col">${METRICS[state.atlas_metric]}</th>
              <th scope="col" class="where">at</th>
            </tr>
          </thead>
          <tbody>${shown.map(row)}</tbody>
        </table></div>
        ${
          more > 0
            ? html`<button type="button" class="quiet" @click=${next}>
                ${Math.min(more, MORE)} more of ${more.toLocaleString("en")}
              </button>`
            : nothing
        }`,
      list,
    );
  }

  /** @param {OfMaterial} found */
  function formulas({ models: rows }) {
    const metric = state.atlas_metric;
    const named = rows
      .filter((one) => models.find((m) => m.id === one.model)?.kind !== "exact")
      .filter((one) => metric !== "delta_e" || one.delta_e !== null)
      .map((one) => ({ ...one, error: largestOf(one, metric) }))
      .sort((a, b) => (a.error ?? Infinity) - (b.error ?? Infinity));
    return html`<ol class="picks">${named.map(
      ({ model, title, error }) => html`<li>
        <button
          type="button"
          class="pick"
          aria-pressed=${model === state.atlas_model}
          @click=${() => actions.set({ atlas_model: model })}
        >${sampled(modelStyle(models, model))}<span class="pick-name">${title}</span></button>
        <span class="pick-error">${written(error, metric)}</span>
      </li>`,
    )}</ol>`;
  }

  return {
    open: openMaterial,
    /** @param {readonly Point[]} points @param {State} now */
    update(points, now) {
      if (points !== last) most = FEW;
      last = points;
      state = now;
      draw();
    },
    /** @param {OfMaterial | undefined} found @param {Point | undefined} point @param {State} now @param {string} trouble */
    choose(found, point, now, trouble) {
      state = now;
      const id = now.atlas_at;
      card.hidden = id === null;
      if (id === null) return;
      const name = found?.name ?? point?.name ?? id;
      render(
        html`<div class="heading">
            <h2>${name}</h2>
            <button type="button" class="quiet" @click=${() => actions.set({ atlas_at: null })}>
              close
            </button>
          </div>
          <p class="hint">${[id === name ? "" : id, found?.kind, point && `n ${plain(point.n, 4)}`, point && point.k !== null && `k ${plain(point.k, 4)}`, at(point?.wavelength_nm ?? null)].filter(Boolean).join(" · ")}</p>
          <p class="ways-on">
            ${link("Open in Materials", id, addressOf("materials", { preset: id }))}
            ${link("Explore its surface", id, addressOf("explore", { material: id, wavelength_nm: point?.wavelength_nm }))}
            ${link("Compare formulas", id, addressOf("compare", { material: id, wavelength_nm: point?.wavelength_nm }))}
          </p>
          <p class="row-error" role="alert">${trouble}</p>
          ${found ? html`<h3>${METRICS[now.atlas_metric]}, smallest first</h3>${formulas(found)}` : nothing}`,
        card,
      );
    },
  };
}
