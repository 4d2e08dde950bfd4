/** The catalog: a search, two filters, the table of what they leave. */

import { h, setText } from "../page/dom.js";
import { createPresetTable } from "./table.js";

/**
 * @typedef {import('./columns.js').Preset} Preset
 */

const PAUSE = 600; // ms after which what was typed stands

/** What was done about colors outside sRGB. @type {Record<string, string>} */
export const POLICIES = {
  scaled: "divided by the largest channel where that exceeds 1",
  clamped: "each channel cut to 0 and 1",
  unclamped: "as it is",
};

/** @param {string} text */
const capital = (text) => text.charAt(0).toUpperCase() + text.slice(1);

/**
 * @param {object} options
 * @param {Catalog} options.catalog
 * @param {Actions} options.actions
 * @param {(id: string, moving: boolean) => void} options.onPick
 */
export function createBrowser({ catalog, actions, onPick }) {
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let pause;
  const search = h("input", {
    class: "box search",
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

  const category = h("select", {
    class: "preset",
    "aria-label": "Category",
    onchange: () => actions.set({ category: category.value }),
  });
  const kind = h(
    "select",
    {
      class: "preset",
      "aria-label": "Kind of data",
      onchange: () => actions.set({ of_kind: kind.value }),
    },
    h("option", { value: "all" }, "spectra and indices"),
    h("option", { value: "spectrum" }, "spectra"),
    h("option", { value: "single" }, "single indices"),
  );
  const count = h("p", { class: "count", role: "status" });
  const suggestions = h("p", { class: "suggestions" });
  const policy = h("p", { class: "hint" });

  const table = createPresetTable({
    onPick,
    onSettle: actions.settle,
    onSort: (list_by, list_order) => actions.set({ list_by, list_order }),
    onLeave: () => search.focus(),
  });

  const element = h(
    "section",
    { class: "browser", "aria-label": "Catalog" },
    h(
      "div",
      { class: "browser-head" },
      h("label", { class: "search-label", for: "find" }, h("h2", {}, "Catalog")),
      search,
      h("span", { class: "picker" }, category),
      h("span", { class: "picker" }, kind),
      count,
    ),
    suggestions,
    table.element,
    policy,
  );

  /** @param {Record<string, number>} categories */
  function fillCategories(categories) {
    if (category.options.length) return;
    const all = Object.values(categories).reduce((a, b) => a + b, 0);
    category.append(
      h("option", { value: "all" }, `all categories (${all})`),
      ...Object.entries(categories).map(([name, number]) =>
        h("option", { value: name }, `${capital(name)} (${number})`),
      ),
    );
  }

  let suggested = "";
  /** A button that is being pressed stays the same. @param {string} find @param {string[]} ids */
  function suggest(find, ids) {
    const asked = JSON.stringify([find, ids]);
    if (asked === suggested) return;
    suggested = asked;
    suggestions.replaceChildren(
      `Nothing is called “${find.trim()}”.`,
      ...(ids.length ? [" Did you mean "] : []),
      ...ids.flatMap((id, index) => {
        const preset = catalog.materials.find((m) => m.id === id);
        const button = h(
          "button",
          {
            type: "button",
            class: "suggestion",
            onclick: () => {
              onPick(id, false);
              actions.set({ find: preset?.name ?? id });
            },
          },
          preset?.name ?? id,
        );
        return [button, index + 1 < ids.length ? ", " : "?"];
      }),
    );
  }

  return {
    element,
    /** @param {State} state @param {any} answer */
    update(state, answer) {
      if (document.activeElement !== search && search.value !== state.find)
        search.value = state.find;
      if (!answer) return;
      fillCategories(answer.categories);
      category.value = state.category;
      kind.value = state.of_kind;
      /** @type {Preset[]} */
      const presets = answer.materials;
      const all = Object.values(/** @type {Record<string, number>} */ (answer.categories));
      const whole = all.reduce((a, b) => a + b, 0);
      setText(
        count,
        presets.length === whole ? `${whole} presets` : `${presets.length} of ${whole}`,
      );
      suggestions.hidden = presets.length > 0;
      table.element.hidden = presets.length === 0;
      if (presets.length === 0) suggest(state.find, answer.suggestions);
      table.update(presets, state.list_by, state.list_order, state.preset);
      const gamut = presets[0]?.swatch.gamut ?? "scaled";
      setText(policy, `Swatches: F₀ as sRGB under D65, ${gamut}: ${POLICIES[gamut]}.`);
    },
  };
}
