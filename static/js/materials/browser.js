/** The catalog: a search, two filters, the table of what they leave. */

import { matching } from "../controls/picker.js";
import { createSelect } from "../controls/select.js";
import { add, isPage, pathOf } from "../media/brought.js";
import { isOwn } from "../own/kept.js";
import { createChanged } from "../page/changed.js";
import { h } from "../page/dom.js";
import { html, nothing, render } from "../page/lit.js";
import { createPresetTable } from "./table.js";

const PAUSE = 600; // ms after which what was typed stands

/** What was done about colors outside sRGB. @type {Record<string, string>} */
export const POLICIES = {
  scaled: "divided by the largest channel where that exceeds 1",
  clamped: "each channel cut to 0 and 1",
  unclamped: "as it is",
};
const KINDS = { all: "spectra and indices", spectrum: "spectra", single: "single indices" };

/** @param {string} text */
const capital = (text) => text.charAt(0).toUpperCase() + text.slice(1);

/** @param {Pick<ViewContext, 'catalog' | 'actions'> & {onPick: (id: string, moving: boolean) => void}} options */
export function createBrowser({ catalog, actions, onPick: chosen }) {
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let pause;
  const fresh = createChanged();
  /** @type {import('./columns.js').Preset[]} */
  let rows = [];
  /** A page that is listed becomes a medium with what is known of it. @param {string} id @param {boolean} moving */
  function onPick(id, moving) {
    const row = isPage(id) && rows.find((one) => one.id === id);
    if (row) add(catalog.materials, /** @type {any} */ (row));
    chosen(id, moving);
  }
  const search = h("input.box.search", {
    type: "search",
    id: "find",
    autocomplete: "off",
    spellcheck: "false",
    placeholder: "name, formula, maker, author …",
    maxlength: "100",
  });
  search.addEventListener("input", () => {
    actions.set({ find: search.value }, { history: "replace" });
    clearTimeout(pause);
    pause = setTimeout(actions.settle, PAUSE);
  });
  search.addEventListener("change", () => {
    clearTimeout(pause);
    actions.settle();
  });
  search.addEventListener("keydown", (event) => {
    if (event.key === "ArrowDown") {
      event.preventDefault();
      table.enter();
    } else if (event.key === "Enter") table.first();
  });
  const table = createPresetTable({
    onPick,
    onSettle: actions.settle,
    onSort: (list_by, list_order) => actions.set({ list_by, list_order }),
    onLeave: () => search.focus(),
  });
  const category = createSelect("Category", (category) => actions.set({ category }));
  const kind = createSelect("Kind of data", (of_kind) => actions.set({ of_kind }), KINDS);
  const element = h("section.browser", { "aria-label": "Catalog" });

  /** @param {string} find @param {string[]} ids */
  function suggested(find, ids) {
    const buttons = ids.map((id, index) => {
      const name = catalog.materials.find((m) => m.id === id)?.name ?? pathOf(id);
      const take = () => {
        onPick(id, false);
        actions.set({ find: name });
      };
      return html`${index ? ", " : " Did you mean "}<button type="button" class="suggestion"
        @click=${take}>${name}</button>`;
    });
    return html`No match for “${find.trim()}”.${buttons}${ids.length ? "?" : ""}`;
  }

  /** @param {any} answer @param {number} own how many of one's own are listed @param {number} all presets */
  function counted({ curated, total, materials }, own, all) {
    const presets = curated === all ? `${all} presets` : `${curated} of ${all} presets`;
    const [pages, listed] = [total - curated, materials.length - curated];
    const some =
      pages > listed ? `${listed} of ${pages} pages` : `${pages} page${pages === 1 ? "" : "s"}`;
    return [presets, own > 0 && `${own} of yours`, pages > 0 && some].filter(Boolean).join(", ");
  }

  return {
    element,
    /** @param {State} state @param {any} answer */
    update(state, answer) {
      if (document.activeElement !== search && search.value !== state.find)
        search.value = state.find;
      const own = answer ? ownRows(state, catalog) : [];
      if (answer && fresh(answer, ...own)) rows = [...own, ...answer.materials];
      /** @type {[string, number][]} */
      const categories = Object.entries(answer?.categories ?? {});
      const all = categories.reduce((sum, [, many]) => sum + many, 0);
      const none = Boolean(answer) && rows.length === 0;
      const gamut = answer?.materials[0]?.swatch.gamut ?? "scaled";
      table.element.hidden = none;
      if (answer) table.update(rows, state.list_by, state.list_order, state.preset);
      const names = categories.map(([name, many]) => [name, `${capital(name)} (${many})`]);
      if (answer)
        category.update(state.category, {
          all: `all categories (${all})`,
          ...Object.fromEntries(names),
        });
      kind.update(state.of_kind);
      render(
        html`<div class="browser-head">
            <label class="search-label" for="find"><h2>Catalog</h2></label>
            ${search} ${category.element} ${kind.element}
            <p class="count" role="status">${answer ? counted(answer, own.length, all) : ""}</p>
          </div>
          <p class="suggestions" ?hidden=${!none}>${none ? suggested(state.find, answer.suggestions) : ""}</p>
          ${table.element}
          ${answer?.refused.length ? refused(answer.refused) : nothing}
          <p class="hint">${answer ? `Swatches: F₀ as sRGB under D65, ${gamut}: ${POLICIES[gamut]}.` : ""}</p>`,
        element,
      );
    },
  };
}

/** Pages of which nothing is computed. @param {{id: string, title: string, why: string}[]} pages */
const refused = (pages) =>
  html`<details class="refused"><summary>${pages.length === 1 ? "One more page fits" : `${pages.length} more pages fit`}, without use here</summary>
    <ul>${pages.map(({ id, title, why }) => html`<li>${pathOf(id)}, ${title}: it takes ${why}</li>`)}</ul></details>`;

/** One's own materials that the search and the filters leave. @param {State} state @param {Catalog} catalog @returns {any[]} */
function ownRows({ find, category, of_kind }, { materials }) {
  if (of_kind === "single" || category !== "all") return [];
  return matching(
    materials.filter(({ id }) => isOwn(id)),
    find,
  );
}
