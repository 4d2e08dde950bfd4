/** The name of the chosen preset, what it is, and where to go with it. */

import { stretch } from "../numbers/format.js";
import { h, setText } from "../page/dom.js";

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
const AXES = { o: "ordinary ray", e: "extraordinary ray" };

/**
 * @param {object} options
 * @param {readonly {id: string, title: string}[]} options.views
 * @param {Pick<Actions, 'set'>} options.actions
 */
export function createHead({ views, actions }) {
  const name = h("h2", { class: "material-name", tabindex: "-1" });
  const about = h("p", { class: "material-about" });
  let id = "";
  /** @type {number | null} */
  let at_nm = null;
  const targets = views.filter((view) => TARGETS.includes(view.id));
  const links = targets.map(({ id: view, title }) => {
    const link = h("a", { class: "use" }, title);
    link.addEventListener("click", (event) => {
      if (event.ctrlKey || event.metaKey || event.shiftKey) return;
      event.preventDefault();
      actions.set({ view, material: id, wavelength_nm: at_nm });
    });
    return { view, link };
  });
  const element = h(
    "header",
    { class: "material-head" },
    h("div", {}, name, about),
    h(
      "nav",
      { class: "uses", "aria-label": "Use this material" },
      h("span", {}, "use in"),
      ...links.map((l) => l.link),
    ),
  );
  return {
    element,
    name,
    /** @param {any} detail @param {State} state */
    update(detail, state) {
      id = detail.id;
      at_nm = state.at_nm;
      setText(name, detail.name);
      const words = [
        detail.category,
        AXES[detail.axis],
        SAMPLES[detail.sample],
        `confidence ${detail.confidence}`,
        detail.n_range_nm ? `known ${stretch(detail.n_range_nm)}` : "",
        detail.abbe === null ? "" : `Abbe number ${detail.abbe.toFixed(1)}`,
      ];
      setText(about, words.filter(Boolean).join(" · "));
      for (const { view, link } of links) {
        const at = at_nm === null ? "" : `&wavelength_nm=${at_nm}`;
        const own = `material=${encodeURIComponent(detail.id)}${at}`;
        link.href = view === "explore" ? `?${own}` : `?view=${view}&${own}`;
      }
    },
  };
}
