/** The collection of formulas: found by a word, each with its letters, source, error and live curve. */

import { createRow } from "../controls/row.js";
import { locate, read } from "../curves/reading.js";
import { modelStyle, shortTitle } from "../models/look.js";
import { plain, signed, significant } from "../numbers/format.js";
import { h, setText } from "../page/dom.js";
import { copyText, createDataTables, flash } from "../page/exports.js";
import { pageLink } from "../page/links.js";
import { display, math, pieces, words } from "../page/prose.js";
import { createPlot } from "../plot/plot.js";
import { UNTOUCHED } from "./fields.js";

/**
 * @typedef {{latex: string, meaning: string, unit: string}} Sign
 * @typedef {{value: number, of: string, over: string, against: string, relative: boolean, at_most: boolean, unit: string}} Accuracy
 * @typedef {{name: string, symbol: string, value: number, minimum: number, maximum: number}} Taken
 * @typedef {{id: string, kind: string, title: string, latex: string, convention: string, validity: string,
 *   reference: string, links: string[], symbols: Sign[], measured: Accuracy[], takes: Taken[]}} Formula
 * @typedef {{name: string, symbol: string, title: string, unit: string}} AxisName
 * @typedef {{formula: string, n_i: number, n_t: number, k_t: number, x: AxisName, at: number[], y: AxisName,
 *   series: {id: string, title: string, values: (number | null)[]}[]}} FormulaCurve
 */

export const FIRST = "model.exact";

const KINDS = /** @type {const} */ ({
  model: "Reflectance",
  albedo: "Albedo",
  angle: "Angles and depths",
  conversion: "Conversions",
});
/** State field, label and slider of what a curve may be given. */
const TAKES =
  /** @type {Record<string, {own: string, label: string, range: [number, number]}>} */ ({
    n_i: { own: "own_i", label: "incident index", range: [1, 3] },
    n_t: { own: "own_n", label: "second index", range: [0.1, 4] },
    k_t: { own: "own_k", label: "extinction", range: [0, 8] },
  });
const LOOKS = [
  { color: "--R", dash: "solid", width: 2.6 },
  { color: "--Rs", dash: "solid", width: 1.9 },
  { color: "--Rp", dash: "dash", width: 1.9 },
];

/** Where the formula is used: a view and its state. @param {Formula} formula @returns {[string, string, Record<string, string | number>]} */
export function used({ id, kind, takes }) {
  const [, name = ""] = id.split(".");
  const at = Object.fromEntries(takes.map((t) => [t.name, t.value]));
  if (kind === "model") {
    const own = {
      ...(at.n_i !== 1 && { n_i: at.n_i }),
      n_t: at.n_t,
      ...(at.k_t && { k_t: at.k_t }),
    };
    return ["Open in Compare", "compare", { ...own, against: name === "exact" ? "schlick" : name }];
  }
  if (kind === "albedo") {
    const exact = ["exact", "dielectric", "flatland", "reciprocity", "coat"].includes(name);
    /** @type {Record<string, string | number>} */
    const to = exact ? {} : { fits: name };
    if (takes.some((t) => t.name === "k_t"))
      Object.assign(to, { surface: "metal-n", k_t: at.k_t || 3 });
    else if (/internal|^egan_hilgeman_1973$|reciprocity/.test(name)) to.surface = "inside";
    return ["Open in Albedo", "albedo", to];
  }
  if (kind === "angle") {
    if (name === "pseudo_brewster") return ["Open in Explore", "explore", { k_t: 3 }];
    if (name === "principal") return ["Open in Explore", "explore", { k_t: 3, show: "phase" }];
    return name === "brewster"
      ? ["Open in Explore", "explore", { theta_i_deg: 56.309932474020215 }]
      : [
          "Open in Explore",
          "explore",
          { n_i: 1.5, n_t: 1, theta_i_deg: name === "refraction" ? 30 : 41.810314895778596 },
        ];
  }
  const from = ["ior", "nk", "f0", "f0_srgb", "specular", "reflectance", "rg", "dg"].includes(name)
    ? name
    : name === "f0_hex"
      ? "hex"
      : "nk";
  return ["Open the converter", "compare", { from }];
}

/** @param {Accuracy} accuracy */
function amount({ value, relative, at_most, unit }) {
  const number =
    relative && value >= 1e-4 ? `${plain(100 * value, 3)} %` : significantOrPower(value);
  return `${at_most ? "≤ " : ""}${number}${unit ? ` ${unit}` : ""}${relative && value < 1e-4 ? ", relative" : ""}`;
}

/** @param {number} value */
function significantOrPower(value) {
  const power = Math.round(Math.log10(value));
  if (value < 1e-3 && Math.abs(value / 10 ** power - 1) < 1e-9)
    return significant(value, 1).replace(/^1 × /, "");
  return value < 1e-3 ? significant(value, 3) : signed(plain(value, 3));
}

/** @param {ViewContext} context */
export function createFormulas({ catalog, actions, say }) {
  const box = h("input", {
    type: "search",
    class: "find-box",
    placeholder: "Find a formula",
    "aria-label": "Find a formula",
    autocomplete: "off",
    spellcheck: "false",
  });
  box.addEventListener("input", () =>
    actions.set({ word: box.value.trim() || null }, { history: "replace" }),
  );
  box.addEventListener("change", actions.settle);
  const groups = h("div", { class: "formula-groups" });
  const none = h("p", { class: "hint", hidden: true }, "No formula is called so.");
  const nav = h(
    "nav",
    { class: "formula-list", "aria-label": "Formulas" },
    h("div", { class: "find" }, h("h2", {}, "Formulas"), box, none),
    groups,
  );
  const kind = h("p", { class: "lesson-count" });
  const title = h("h3", { class: "lesson-title", tabindex: "-1" });
  const equation = h("div", { class: "formula-place" });
  const facts = h("div", { class: "formula-facts" });
  const actionsPlace = h("p", { class: "lesson-more" });
  const rowsPlace = h("div", { class: "rows lesson-rows" });
  const plotFrame = h("div", { class: "frame" });
  const tables = createDataTables("The curve as a table", {
    "Table of the curve": () => [plot.table()],
  });
  const detail = h(
    "article",
    { class: "formula-detail" },
    kind,
    title,
    equation,
    h(
      "div",
      { class: "formula-columns" },
      facts,
      h(
        "section",
        { class: "formula-curve", "aria-label": "Its curve" },
        h("h4", {}, "Its curve"),
        h("div", { class: "plot-host" }, plotFrame),
        rowsPlace,
        actionsPlace,
        tables.element,
      ),
    ),
  );
  const element = h("div", { class: "formulas" }, nav, detail);

  const plot = createPlot(plotFrame, {
    name: "Curve of the formula",
    x: { title: "", range: null },
    y: { title: "", range: null },
    filename: "fresnel-formula",
    onPick: (x) => point(x),
  });
  /** @type {Formula[]} */
  let formulas = [];
  /** @type {{formula: Formula, li: HTMLElement, link: HTMLElement}[]} */
  let entries = [];
  let shown = "";
  /** @type {FormulaCurve | null} */
  let drawn = null;
  /** @type {Trace[]} */
  let traces = [];
  /** @type {Map<string, ReturnType<typeof createRow>>} */
  let rows = new Map();

  /** @param {number} x */
  function point(x) {
    plot.marker(
      x,
      traces.map((t) => ({ id: t.id, y: read(t.y, locate(t.x, x)) })),
    );
  }

  /** @param {Formula[]} all */
  function fill(all) {
    formulas = all;
    entries = all.map((formula) => {
      const to = { section: "formulas", formula: formula.id };
      const link = pageLink(formula.title, "theory", to, () => {
        actions.set({ ...UNTOUCHED, ...to });
        detail.scrollIntoView({ block: "nearest" });
        title.focus({ preventScroll: true });
      });
      return { formula, link, li: h("li", {}, link) };
    });
    groups.replaceChildren(
      ...Object.entries(KINDS).map(([id, name]) =>
        h(
          "section",
          { "data-kind": id },
          h("h3", {}, name),
          h("ul", {}, ...entries.filter((e) => e.formula.kind === id).map((e) => e.li)),
        ),
      ),
    );
  }

  /** @param {string | null} find */
  function filter(find) {
    const wanted = (find ?? "").toLowerCase().split(/\s+/).filter(Boolean);
    let any = false;
    for (const { formula, li } of entries) {
      const text = `${formula.id} ${formula.title} ${formula.reference}`.toLowerCase();
      li.hidden = !wanted.every((word) => text.includes(word));
      any ||= !li.hidden;
    }
    for (const group of groups.children)
      group.toggleAttribute("hidden", !group.querySelector("li:not([hidden])"));
    none.hidden = any || entries.length === 0;
  }

  /** @param {Formula} formula */
  function build(formula) {
    for (const { formula: one, link } of entries) {
      if (one === formula) link.setAttribute("aria-current", "true");
      else link.removeAttribute("aria-current");
    }
    const current = entries.find((e) => e.formula === formula)?.li;
    for (const box of [groups, nav])
      if (current && box.scrollHeight > box.clientHeight)
        box.scrollTop +=
          current.getBoundingClientRect().top - box.getBoundingClientRect().top - 120;
    setText(kind, KINDS[/** @type {keyof typeof KINDS} */ (formula.kind)]);
    setText(title, formula.title);
    equation.replaceChildren(display(formula.latex, formula.title));
    const copy = h("button", { type: "button", class: "quiet" }, "copy LaTeX");
    copy.addEventListener("click", async () => {
      const done = await copyText(formula.latex);
      flash(copy, done);
      say(done ? "LaTeX copied" : "Copying is not allowed here");
    });
    equation.append(copy);
    facts.replaceChildren(
      h("h4", {}, "Where it holds"),
      h("p", {}, ...words(formula.validity)),
      h("h4", {}, "Letters"),
      h(
        "dl",
        { class: "letters" },
        ...formula.symbols.map(({ latex, meaning, unit }) =>
          h(
            "div",
            {},
            h("dt", {}, math(latex)),
            h(
              "dd",
              {},
              ...words(meaning),
              unit ? h("span", { class: "unit" }, ` (${unit})`) : null,
            ),
          ),
        ),
      ),
      h("h4", {}, "Measured error"),
      h(
        "table",
        { class: "measured" },
        h(
          "thead",
          {},
          h(
            "tr",
            {},
            ...["error", "of", "over", "against"].map((t) => h("th", { scope: "col" }, t)),
          ),
        ),
        h(
          "tbody",
          {},
          ...formula.measured.map((one) =>
            h(
              "tr",
              {},
              h("td", {}, amount(one)),
              h("td", {}, one.of),
              h("td", {}, ...words(one.over)),
              h("td", {}, one.against),
            ),
          ),
        ),
      ),
      h("h4", {}, "Convention"),
      h("p", {}, ...words(formula.convention)),
      h("h4", {}, "Source"),
      h("p", {}, formula.reference),
      h(
        "p",
        { class: "source-links" },
        ...formula.links.map((href) =>
          h(
            "a",
            { href, rel: "noreferrer", target: "_blank" },
            href.replace(/^https:\/\/(www\.)?/, ""),
          ),
        ),
      ),
    );
    const [label, view, to] = used(formula);
    actionsPlace.replaceChildren(pageLink(label, view, to));
    rows = new Map(
      formula.takes.map((taken) => {
        const {
          own,
          label: name,
          range,
        } = /** @type {{own: string, label: string, range: [number, number]}} */ (
          TAKES[taken.name]
        );
        const row = createRow({
          parameter: {
            name: taken.name,
            symbol: taken.symbol,
            minimum: taken.minimum,
            maximum: taken.maximum,
          },
          prefix: "formula-",
          preset: taken.value,
          label: name,
          range,
          steps: { step: 0.01, fine: 0.001, page: 0.1 },
          onChange: (value, moving) =>
            actions.set(
              { [own]: value === taken.value ? null : value },
              { history: moving ? "replace" : "push" },
            ),
          onSettle: actions.settle,
        });
        return [taken.name, row];
      }),
    );
    rowsPlace.replaceChildren(...[...rows.values()].map((r) => r.element));
  }

  /** @param {AxisName} axis */
  function axisOf({ name, title: words, unit }) {
    const deg = unit === "deg";
    return {
      title: deg ? `${words} (degrees)` : words,
      column: name,
      unit: deg ? "°" : "",
      range: null,
    };
  }

  /** How what stands beside the exact values looks. @param {string} formula @param {string} id */
  function approximate(formula, id) {
    if (formula.startsWith("model.")) return modelStyle(catalog.models, id);
    return { color: "--model-1", dash: "dash" };
  }

  /** @param {FormulaCurve} curve @param {boolean} moving */
  function draw(curve, moving) {
    if (curve === drawn && !moving) return;
    const same = drawn?.formula === curve.formula;
    const compared = curve.series[0]?.id === "exact" && curve.series.length === 2;
    traces = curve.series.map(({ id, title: name, values }, i) => ({
      id,
      label: shortTitle(name),
      x: curve.at,
      y: values,
      .../** @type {typeof LOOKS[0]} */ (LOOKS[i % LOOKS.length]),
      ...(compared && i === 1 && approximate(curve.formula, id)),
    }));
    if (!same) {
      const from = curve.at[0] ?? 0;
      const to = curve.at.at(-1) ?? 1;
      const share =
        ["R", "albedo", "share"].includes(curve.y.name) && !/large_k/.test(curve.formula);
      const theta = curve.x.name === "theta_i_deg";
      plot.axes({
        name: `${curve.y.title} against ${curve.x.title}`,
        x: {
          ...axisOf(curve.x),
          range: [from, to],
          ...(theta && { ticks: [0, 15, 30, 45, 60, 75, 90] }),
        },
        y: { ...axisOf(curve.y), range: share ? [0, 1] : null },
      });
    }
    drawn = curve;
    void plot.draw(traces);
    const { at } = curve;
    point(at[Math.round(0.6 * (at.length - 1))] ?? 0);
    tables.fill();
  }

  return {
    element,
    /** @param {State} now @param {Record<string, any>} answers @param {boolean} moving */
    update(now, answers, moving) {
      if (answers.formulas && formulas.length === 0) fill(answers.formulas.formulas);
      if (document.activeElement !== box) box.value = now.word ?? "";
      filter(now.word);
      const id = now.formula ?? FIRST;
      const formula = formulas.find((f) => f.id === id);
      if (formula && shown !== id) {
        shown = id;
        build(formula);
      } else if (formulas.length > 0 && !formula) {
        shown = "";
        setText(kind, "");
        setText(title, "There is no such formula");
        equation.replaceChildren();
        facts.replaceChildren(
          h("p", {}, ...pieces(`${id} is not among them; choose one of the list.`)),
        );
        rowsPlace.replaceChildren();
        actionsPlace.replaceChildren();
      }
      element.toggleAttribute("data-missing", formulas.length > 0 && !formula);
      for (const taken of formula?.takes ?? []) {
        const own = TAKES[taken.name]?.own ?? "";
        rows.get(taken.name)?.update(now[own] ?? taken.value);
      }
      if (answers.curve?.formula === id) draw(answers.curve, moving);
    },
    /** @param {State} now */
    sentence: (now) => (now.formula ? `Formula: ${title.textContent}` : ""),
    theme: () => plot.theme(),
    stop() {
      for (const row of rows.values()) row.stop();
    },
    destroy: () => plot.destroy(),
  };
}
