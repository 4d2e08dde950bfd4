/** One interface in the words of optics, of artists and of engines, each with what is lost. */

import { plain } from "../numbers/format.js";
import { h, setText, symbol } from "../page/dom.js";
import { BETWEEN, filled, printValue, SOURCES, texts } from "./conversions.js";

/**
 * @typedef {import('./conversions.js').Result} Result
 */

/** Symbols of values; what has none is named by its form. @type {Record<string, string>} */
const SYMBOLS = {
  n_i: "n_i",
  n_t: "n_t",
  k_t: "k_t",
  F0: "F_0",
  F0_srgb: "F_0",
  F82: "F_{82}",
  r: "r",
  g: "g",
  G: "G",
  tint: "tint",
};

/**
 * @param {object} options
 * @param {() => State} options.state
 * @param {Pick<Actions, 'set'>} options.actions
 */
export function createConvert({ state, actions }) {
  /** @type {Result[]} */
  let results = [];
  const from = h(
    "select",
    {
      class: "preset",
      "aria-label": "What is given",
      onchange: () => actions.set({ from: from.value, given: filled(from.value, results) }),
    },
    ...Object.entries(SOURCES).map(([value, { label }]) => h("option", { value }, label)),
  );
  const boxes = [0, 1].map((i) => {
    const box = h("input", {
      class: "box given",
      type: "text",
      autocomplete: "off",
      spellcheck: "false",
      "aria-describedby": "convert-problem",
      onchange: commit,
    });
    const name = h("span", { class: "given-name" });
    return { i, box, name, label: h("label", { class: "given-label" }, name, box) };
  });
  const color = h("input", {
    type: "color",
    class: "color",
    "aria-label": "Color of the picture",
    onchange: () => actions.set({ given: color.value }),
  });
  const seen = h("input", {
    class: "box bound",
    type: "text",
    autocomplete: "off",
    spellcheck: "false",
    "aria-label": "Index of the other medium that F0 is seen from",
    "aria-describedby": "convert-problem",
  });
  seen.addEventListener("change", () => {
    const value = Number(seen.value);
    const fine = seen.value.trim() !== "" && value >= 1e-3 && value <= 100;
    seen.toggleAttribute("aria-invalid", !fine && seen.value.trim() !== "");
    if (fine || seen.value.trim() === "") actions.set({ seen_from: fine ? value : null });
  });
  const problemBox = h("p", { class: "row-error", id: "convert-problem", role: "alert" });
  const body = h("tbody", {});
  const table = h(
    "table",
    { class: "conversions" },
    h("caption", { class: "hidden" }, "The same surface in other words"),
    h(
      "thead",
      { class: "hidden" },
      h(
        "tr",
        {},
        ...["form", "value", "status", "why", "use"].map((t) => h("th", { scope: "col" }, t)),
      ),
    ),
    body,
  );
  const element = h(
    "section",
    { class: "column convert", "aria-label": "Conversions" },
    h("div", { class: "heading" }, h("h2", {}, "Conversions")),
    h(
      "div",
      { class: "convert-from" },
      h("span", { class: "picker" }, from),
      ...boxes.map((b) => b.label),
      color,
      h(
        "label",
        { class: "given-label seen" },
        h("span", {}, "also seen from ", symbol("n"), " ="),
        seen,
      ),
    ),
    problemBox,
    table,
  );

  function commit() {
    const { from: now } = state();
    const count = SOURCES[now]?.inputs.length ?? 0;
    actions.set({
      given: boxes
        .slice(0, count)
        .map(({ box }) => box.value.trim())
        .join(BETWEEN),
    });
  }

  /** @param {Result} result */
  function line({ form, title, values, status, why }) {
    const entries = Object.entries(values).filter(([name]) => form !== "f0_hex" || name === "hex");
    const shown = entries.map(([name, value]) =>
      h(
        "span",
        { class: "conversion" },
        SYMBOLS[name] ? symbol(SYMBOLS[name] ?? "") : null,
        name === "hex" && typeof value === "string" ? swatch(value) : null,
        ` ${printValue(name === "n_i" && Array.isArray(value) ? value[0] : value)}`,
      ),
    );
    const { n_t, k_t = 0 } = values;
    const usable =
      (form === "nk" || form === "ior") && typeof n_t === "number" && typeof k_t === "number";
    const use = h(
      "button",
      {
        type: "button",
        class: "quiet",
        onclick: () =>
          actions.set({
            n_t: Math.max(1e-3, Number(n_t.toPrecision(12))),
            k_t: Number(k_t.toPrecision(12)),
            material: null,
          }),
      },
      "use",
    );
    use.setAttribute("aria-label", `Use ${title} as the second medium`);
    return h(
      "tr",
      { "data-status": status },
      h("th", { scope: "row" }, title),
      h("td", { class: "converted" }, ...shown),
      h("td", { class: "status-cell" }, h("span", { class: "status" }, status)),
      h("td", { class: "why" }, why),
      h("td", { class: "use" }, usable && state().from !== "media" ? use : null),
    );
  }

  /** @param {string} hex */
  function swatch(hex) {
    const chip = h("i", { class: "swatch", "aria-hidden": "true" });
    chip.style.background = hex;
    return chip;
  }

  /** @type {unknown} */
  let last = null;
  let look = "";
  return {
    element,
    /** @param {State} now @param {any} answer @param {{title: string, lines: string[]} | undefined} problem */
    update(now, answer, problem) {
      from.value = now.from;
      const inputs = SOURCES[now.from]?.inputs ?? [];
      const values = texts(/** @type {any} */ (now));
      for (const { i, box, name, label } of boxes) {
        const input = inputs[i];
        label.hidden = !input;
        if (!input) continue;
        if (name.dataset.symbol !== input.symbol) {
          name.dataset.symbol = input.symbol;
          name.replaceChildren(input.symbol ? symbol(input.symbol) : "");
        }
        box.placeholder = input.hint;
        box.setAttribute("aria-label", `${SOURCES[now.from]?.label}, ${input.name}`);
        box.toggleAttribute("aria-invalid", problem !== undefined);
        if (document.activeElement !== box) box.value = values[i] ?? "";
      }
      color.hidden = now.from !== "hex";
      if (now.from === "hex" && /^#?[0-9a-f]{6}$/i.test(values[0] ?? ""))
        color.value = `#${(values[0] ?? "").replace("#", "").toLowerCase()}`;
      if (document.activeElement !== seen)
        seen.value = plain(now.seen_from ?? answer?.seen_from ?? 1);
      setText(problemBox, problem ? problem.lines.join(" · ") || problem.title : "");
      table.toggleAttribute("data-stale", problem !== undefined);
      if (!answer || (answer === last && look === now.from)) return;
      last = answer;
      look = now.from;
      results = answer.results;
      body.replaceChildren(...results.map(line));
    },
  };
}
