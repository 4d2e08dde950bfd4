/** The collection of formulas: found by a word, each with its letters, source, error and live curve. */

import { INDEX_STEPS } from "../controls/panel.js";
import { pointsAt } from "../curves/reading.js";
import { modelStyle, shortTitle } from "../models/look.js";
import { plain, signed, significant } from "../numbers/format.js";
import { createChanged } from "../page/changed.js";
import { copying, createDataTables, h } from "../page/dom.js";
import { addressOf, clicked, pageLink } from "../page/links.js";
import { html, nothing, render } from "../page/lit.js";
import { display, math, words } from "../page/prose.js";
import { createPlot } from "../plot/plot.js";
import { UNTOUCHED } from "./fields.js";
import { FIRST_FORMULA } from "./queries.js";
import { createOwnRow } from "./rows.js";

/**
 * @typedef {{latex: string, meaning: string, unit: string}} Sign
 * @typedef {{value: number, of: string, over: string, against: string, relative: boolean, at_most: boolean, unit: string}} Accuracy
 * @typedef {{name: string, symbol: string, value: number, minimum: number, maximum: number}} Taken
 * @typedef {{id: string, kind: string, title: string, latex: string, convention: string, validity: string, printed: string,
 *   reference: string, links: string[], symbols: Sign[], measured: Accuracy[], takes: Taken[]}} Formula
 * @typedef {{name: string, symbol: string, title: string, unit: string}} AxisName
 * @typedef {{formula: string, n_i: number, n_t: number, k_t: number, x: AxisName, at: number[], y: AxisName,
 *   series: {id: string, title: string, values: (number | null)[]}[]}} FormulaCurve
 */

const KINDS = /** @type {const} */ ({
  model: "Reflectance",
  albedo: "Albedo",
  angle: "Angles, directions and depths",
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

/** Media and an angle at which there is something to see. @type {Record<string, Record<string, string | number>>} */
const ANGLES = {
  brewster: { theta_i_deg: 56.309932474020215 },
  pseudo_brewster: { k_t: 3 },
  principal: { k_t: 3, show: "phase" },
  refraction: { n_i: 1.5, n_t: 1, theta_i_deg: 30 },
  reflected_direction: { theta_i_deg: 50 },
  refracted_direction: { theta_i_deg: 50 },
};
const EXACT_ALBEDOS = ["exact", "dielectric", "dunkle", "flatland", "allen", "reciprocity", "coat"];
const CRITICAL = { n_i: 1.5, n_t: 1, theta_i_deg: 41.810314895778596 };
/** What the converter takes. */
const GIVEN = ["ior", "nk", "f0", "f0_srgb", "specular", "reflectance", "rg", "dg"];

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
    return ["Open in Compare", "compare", { ...own, models: name === "exact" ? "schlick" : name }];
  }
  if (kind === "albedo") {
    const exact = EXACT_ALBEDOS.includes(name);
    /** @type {Record<string, string | number>} */
    const to = exact ? {} : { fits: name };
    if (takes.some((t) => t.name === "k_t"))
      Object.assign(to, { surface: "metal-n", k_t: at.k_t || 3 });
    else if (/internal|^egan_hilgeman_1973$|reciprocity/.test(name)) to.surface = "inside";
    return ["Open in Albedo", "albedo", to];
  }
  if (kind === "angle") return ["Open in Explore", "explore", ANGLES[name] ?? CRITICAL];
  const from = name === "f0_hex" ? "hex" : GIVEN.includes(name) ? name : "nk";
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

/** @param {Formula} formula */
const facts = ({ validity, printed, symbols, measured, convention, reference, links }) => html`
  <h4>Where it holds</h4>
  <p>${words(validity)}</p>
  ${printed ? html`<h4>In print</h4><p class="printed-otherwise">${words(printed)}</p>` : nothing}
  <h4>Letters</h4>
  <dl class="letters">
    ${symbols.map(({ latex, meaning, unit }) => html`<div><dt>${math(latex)}</dt><dd>${words(meaning)}${unit ? html`<span class="unit"> (${unit})</span>` : nothing}</dd></div>`)}
  </dl>
  <h4>Measured error</h4>
  <table class="measured">
    <thead><tr>${["error", "of", "over", "against"].map((t) => html`<th scope="col">${t}</th>`)}</tr></thead>
    <tbody>
      ${measured.map((one) => html`<tr><td>${amount(one)}</td><td>${one.of}</td><td>${words(one.over)}</td><td>${one.against}</td></tr>`)}
    </tbody>
  </table>
  <h4>Convention</h4>
  <p>${words(convention)}</p>
  <h4>Source</h4>
  <p>${reference}</p>
  <p class="source-links">
    ${links.map((href) => html`<a href=${href} rel="noreferrer" target="_blank">${href.replace(/^https:\/\/(www\.)?/, "")}</a>`)}
  </p>`;

/** @param {Pick<ViewContext, 'catalog' | 'actions' | 'say'>} context */
export function createFormulas({ catalog, actions, say }) {
  const box = h("input", {
    type: "search",
    class: "find-box",
    placeholder: "Find a formula",
    "aria-label": "Find a formula",
    autocomplete: "off",
    spellcheck: "false",
    oninput: () => actions.set({ word: box.value.trim() || null }, { history: "replace" }),
    onchange: actions.settle,
  });
  const nav = h("nav.formula-list", { "aria-label": "Formulas" });
  const detail = h("article.formula-detail");
  const element = h("div.formulas", nav, detail);
  const plotFrame = h("div.frame");
  const tables = createDataTables("The curve as a table", {
    "Table of the curve": () => [plot.table()],
  });
  const plot = createPlot(plotFrame, {
    name: "Curve of the formula",
    x: { title: "", range: null },
    y: { title: "", range: null },
    filename: "fresnel-formula",
    onPick: (x) => point(x),
  });
  /** @type {Formula[]} */
  let formulas = [];
  const listed = createChanged();
  /** @type {Formula | null | undefined} null before there are any, undefined where there is none of the name */
  let shown = null;
  /** @type {FormulaCurve | null} */
  let drawn = null;
  /** @type {Trace[]} */
  let traces = [];
  /** @type {{own: string, preset: number, row: ReturnType<typeof createOwnRow>}[]} */
  let rows = [];
  show(null, "");

  /** @param {number} x */
  const point = (x) => plot.marker(x, pointsAt(traces, x));

  /** The formulas that hold all words, by kind. @param {string | null} find @param {string} current */
  function list(find, current) {
    if (!listed(formulas, find, current)) return;
    const wanted = (find ?? "").toLowerCase().split(/\s+/).filter(Boolean);
    const found = formulas.filter(({ id, title, reference }) => {
      const text = `${id} ${title} ${reference}`.toLowerCase();
      return wanted.every((word) => text.includes(word));
    });
    /** @param {Formula} formula */
    const item = ({ id, title }) => {
      const to = { section: "formulas", formula: id };
      const go = () => {
        actions.set({ ...UNTOUCHED, ...to });
        detail.scrollIntoView({ block: "nearest" });
        detail.querySelector("h3")?.focus({ preventScroll: true });
      };
      return html`<li><a href=${addressOf("theory", to)} aria-current=${id === current ? "true" : nothing}
        @click=${clicked(go)}>${title}</a></li>`;
    };
    /** @param {[string, string]} kind */
    const group = ([id, name]) => {
      const some = found.filter((f) => f.kind === id);
      return some.length
        ? html`<section data-kind=${id}><h3>${name}</h3><ul>${some.map(item)}</ul></section>`
        : nothing;
    };
    render(
      html`<div class="find">
          <h2>Formulas</h2>
          ${box}
          <p class="hint" ?hidden=${found.length > 0 || formulas.length === 0}>No match.</p>
        </div>
        <div class="formula-groups">${Object.entries(KINDS).map(group)}</div>`,
      nav,
    );
  }

  /** Scroll the list, not the page, to the formula that is shown. */
  function reveal() {
    const current = nav.querySelector("[aria-current]");
    for (const box of [nav.querySelector(".formula-groups"), nav])
      if (box && current && box.scrollHeight > box.clientHeight)
        box.scrollTop +=
          current.getBoundingClientRect().top - box.getBoundingClientRect().top - 120;
  }

  /** @param {Formula | null | undefined} formula @param {string} id */
  function show(formula, id) {
    shown = formula;
    rows = (formula?.takes ?? []).map(({ name, symbol, value: preset, minimum, maximum }) => {
      const { own, label, range } = /** @type {typeof TAKES[string]} */ (TAKES[name]);
      const row = createOwnRow(own, actions, {
        ...{ preset, label, range, steps: INDEX_STEPS, prefix: "formula-" },
        parameter: { name, symbol, minimum, maximum },
      });
      return { own, preset, row };
    });
    const none = formula === undefined;
    const kind = formula ? KINDS[/** @type {keyof typeof KINDS} */ (formula.kind)] : "";
    const copy =
      formula &&
      html`${display(formula.latex, formula.title)}
      <button type="button" class="quiet" @click=${copying(() => formula.latex, say, "LaTeX copied")}>copy LaTeX</button>`;
    element.toggleAttribute("data-missing", none);
    render(
      html`<p class="lesson-count">${kind}</p>
        <h3 class="lesson-title" tabindex="-1">${none ? "There is no such formula" : formula?.title}</h3>
        <div class="formula-place">${copy}</div>
        <div class="formula-columns">
          <div class="formula-facts">
            ${none ? html`<p>${id} is not among them; choose one of the list.</p>` : formula && facts(formula)}
          </div>
          <section class="formula-curve" aria-label="Its curve">
            <h4>Its curve</h4>
            <div class="plot-host">${plotFrame}</div>
            <div class="rows lesson-rows">${rows.map(({ row }) => row.element)}</div>
            <p class="lesson-more">${formula && pageLink(...used(formula))}</p>
            ${tables.element}
          </section>
        </div>`,
      detail,
    );
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
      if (answers.formulas && formulas.length === 0) formulas = answers.formulas.formulas;
      if (document.activeElement !== box) box.value = now.word ?? "";
      const id = now.formula ?? FIRST_FORMULA;
      list(now.word, id);
      const formula = formulas.find((f) => f.id === id);
      if (formulas.length > 0 && (formula !== shown || !formula)) {
        show(formula, id);
        reveal();
      }
      for (const { own, preset, row } of rows) row.update(now[own] ?? preset);
      if (answers.curve?.formula === id) draw(answers.curve, moving);
    },
    /** @param {State} now */
    sentence: (now) =>
      now.formula ? `Formula: ${shown?.title ?? "There is no such formula"}` : "",
    theme: () => plot.theme(),
    stop() {
      for (const { row } of rows) row.stop();
    },
    destroy: () => plot.destroy(),
  };
}
