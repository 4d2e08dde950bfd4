/** The name of the chosen preset, what it is, and where to go with it. */

import { pathOf } from "../media/brought.js";
import { stretch } from "../media/wavelength.js";
import { h } from "../page/dom.js";
import { addressOf, clicked } from "../page/links.js";
import { html, render } from "../page/lit.js";

/** Views whose second medium a material can be. */
const TARGETS = ["explore", "compare", "albedo", "preview"];
/** @type {Record<string, string>} */
const SAMPLES = {
  bulk: "bulk sample",
  film: "film",
  model: "fitted model",
  calculated: "calculated",
  unstated: "sample not stated",
};
/** @type {Record<string, string>} */
const AXES = {
  ...{ o: "ordinary ray", e: "extraordinary ray", para: "parallel", perp: "perpendicular" },
  ...{ alpha: "axis α", beta: "axis β", gamma: "axis γ" },
};

/** @param {Pick<ViewContext, 'views' | 'actions'>} context */
export function createHead({ views, actions }) {
  const element = h("header.material-head");
  const targets = views.filter((view) => TARGETS.includes(view.id));
  return {
    element,
    focus: () => element.querySelector("h2")?.focus({ preventScroll: true }),
    /** @param {any} detail @param {State} state */
    update(detail, { at_nm }) {
      const to = { material: detail.id, wavelength_nm: at_nm };
      const about = [
        detail.page && `refractiveindex.info, ${pathOf(detail.id)}`,
        detail.page && detail.category === "generic" ? "" : detail.category,
        AXES[detail.axis],
        SAMPLES[detail.sample],
        detail.confidence === "unstated" ? "" : `confidence ${detail.confidence}`,
        detail.n_range_nm ? `known ${stretch(detail.n_range_nm)}` : "",
        detail.abbe === null ? "" : `Abbe number ${detail.abbe.toFixed(1)}`,
      ];
      const link = (/** @type {{id: string, title: string}} */ { id, title }) =>
        html`<a class="use" href=${addressOf(id, to)}
          @click=${clicked(() => actions.set({ view: id, ...to }))}>${title}</a>`;
      render(
        html`<div>
            <h2 class="material-name" tabindex="-1">${detail.name}</h2>
            <p class="material-about">${about.filter(Boolean).join(" · ")}</p>
          </div>
          <nav class="uses" aria-label="Use this material"><span>use in</span>${targets.map(link)}</nav>`,
        element,
      );
    },
  };
}
