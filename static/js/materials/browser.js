/** The catalog: a search, two filters, the table of what they leave. */

import { createSelect } from "../controls/select.js";
import { h } from "../page/dom.js";
import { html, render } from "../page/lit.js";
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
export function createBrowser({ catalog, actions, onPick }) {
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let pause;
  const search = h("input.box.search", {
    type: "search",
    id: "find",
    autocomplete: "off",
    spellcheck: "false",
    placeholder: "name, formula, author …",
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
      const name = catalog.materials.find((m) => m.id === id)?.name ?? id;
      const take = () => {
        onPick(id, false);
        actions.set({ find: name });
      };
      return html`${index ? ", " : " Did you mean "}<button type="button" class="suggestion"
        @click=${take}>${name}</button>`;
    });
    return html`Nothing is called “${find.trim()}”.${buttons}${ids.length ? "?" : ""}`;
  }

  return {
    element,
    /** @param {State} state @param {any} answer */
    update(state, answer) {
      if (document.activeElement !== search && search.value !== state.find)
        search.value = state.find;
      /** @type {import('./columns.js').Preset[]} */
      const presets = answer?.materials ?? [];
      /** @type {[string, number][]} */
      const categories = Object.entries(answer?.categories ?? {});
      const all = categories.reduce((sum, [, many]) => sum + many, 0);
      const count = presets.length === all ? `${all} presets` : `${presets.length} of ${all}`;
      const none = Boolean(answer) && presets.length === 0;
      const gamut = presets[0]?.swatch.gamut ?? "scaled";
      table.element.hidden = none;
      if (answer) table.update(presets, state.list_by, state.list_order, state.preset);
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
            <p class="count" role="status">${answer ? count : ""}</p>
          </div>
          <p class="suggestions" ?hidden=${!none}>${none ? suggested(state.find, answer.suggestions) : ""}</p>
          ${table.element}
          <p class="hint">${answer ? `Swatches: F₀ as sRGB under D65, ${gamut}: ${POLICIES[gamut]}.` : ""}</p>`,
        element,
      );
    },
  };
}
