/** The error over the media: against n or k for every model, or as a map of one. */

import { createChoice } from "../controls/panel.js";
import { locate, read } from "../curves/reading.js";
import { mapOf, sweepOf } from "../errors/answers.js";
import { short } from "../errors/metrics.js";
import { modelStyle, shortTitle } from "../models/look.js";
import { evaluate } from "../numbers/entry.js";
import { inDegrees, inUnit, percent, plain } from "../numbers/format.js";
import { h, setText } from "../page/dom.js";
import { createDataTables, createExports } from "../page/exports.js";
import { createHeatmap } from "../plot/heatmap.js";
import { createPlot } from "../plot/plot.js";
import { focused, isMap, isPointwise, ranges } from "./fields.js";
import { hasTriple, held } from "./queries.js";

/** @type {Record<string, string>} */
export const METRICS = {
  max_abs: "largest error",
  rms: "RMS error",
  cosine_weighted_mean: "cosine-weighted mean",
  max_relative: "largest relative error",
};
/** @type {Record<string, string>} */
const POINTS = { error: "signed error", absolute: "absolute error", relative: "relative error" };
const N_AXIS = { title: "second index n_t", short: "n", column: "n_t" };
const K_AXIS = { title: "extinction k_t", short: "k", column: "k_t" };

const ONE_CHANNEL = "This figure shows one channel: give one number for R, G and B.";

/** @param {string} name of a metric or a point's error */
const isRelative = (name) => name === "relative" || name === "max_relative";
/** @param {number | null} x */
const share = (x) => (x === null ? "undefined" : Math.abs(x) < 5e-4 ? short(x) : percent(x));

/**
 * @param {object} options
 * @param {HTMLElement} options.parent in the document, because plots read colours and sizes from it
 * @param {Catalog} options.catalog
 * @param {Actions} options.actions
 * @param {(name: string, blob: Blob) => void} options.save
 */
export function createFigure({ parent, catalog, actions, save }) {
  const over = createChoice({
    legend: "Error over",
    items: [
      { value: "n", label: "n" },
      { value: "k", label: "k" },
      { value: "theta-n", label: "θ × n" },
      { value: "n-k", label: "n × k" },
    ],
    onChange: ([value]) =>
      actions.set({ over: value, n_low: null, n_high: null, k_low: null, k_high: null }),
  });
  over.element.classList.add("unnamed");
  /** @param {string} name @param {Record<string, string>} labels @param {string} label */
  const select = (name, labels, label) =>
    h(
      "select",
      {
        class: "preset",
        "aria-label": label,
        onchange: (/** @type {Event} */ event) =>
          actions.set({ [name]: /** @type {HTMLSelectElement} */ (event.target).value }),
      },
      ...Object.entries(labels).map(([value, text]) => h("option", { value }, text)),
    );
  const metric = select("metric", METRICS, "Measure of the error");
  const point = select("point", POINTS, "Error shown");
  const focus = h("select", {
    class: "preset",
    "aria-label": "Model of the map",
    onchange: () => actions.set({ focus: focus.value }),
  });
  const pickers = [metric, point, focus].map((one) => h("span", { class: "picker" }, one));

  const wrong = h("p", { class: "row-error", role: "alert" });
  /** @param {string} name @param {string} label */
  const bound = (name, label) => {
    const box = h("input", {
      class: "box bound",
      type: "text",
      autocomplete: "off",
      spellcheck: "false",
      "aria-label": label,
    });
    box.addEventListener("change", () => {
      const text = box.value.trim();
      try {
        const declared = catalog.parameters.find((p) => p.name === `${name[0]}_t`);
        const value = text === "" ? null : evaluate(text);
        if (value !== null && declared && (value < declared.minimum || value > declared.maximum))
          throw new Error(`allowed is ${plain(declared.minimum)} to ${plain(declared.maximum)}`);
        setText(wrong, "");
        actions.set({ [name]: value });
      } catch (problem) {
        setText(
          wrong,
          `${label}, “${text}”: ${problem instanceof Error ? problem.message : problem}`,
        );
      }
    });
    return { name, box };
  };
  const bounds = [
    bound("n_low", "n from"),
    bound("n_high", "n to"),
    bound("k_low", "k from"),
    bound("k_high", "k to"),
  ];
  /** @param {string} letter @param {number} first */
  const span = (letter, first) =>
    h(
      "span",
      { class: "span" },
      h("var", { class: "symbol" }, letter),
      bounds[first]?.box,
      "to",
      bounds[first + 1]?.box,
    );
  const spans = [span("n", 0), span("k", 2)];

  const sweepHost = h("div", { class: "figure-host" });
  const mapHost = h("div", { class: "figure-host", hidden: true });
  const waiting = h("p", { class: "figure-note" });
  const tables = createDataTables("This figure as a table", {
    "Table of the error over the media": () => (now ? [shown().table()] : []),
  });
  /** @type {State | null} */
  let now = null;
  const shown = () => (now && isMap(now.over) ? map : plot);
  const exports = createExports({
    what: "the figure of the error",
    name: () => `fresnel-error-${now?.over ?? "n"}`,
    make: (format) => shown().exportAs(format),
    print: {
      figures: () => [shown()],
      call: "/errors/",
      behind: () => ({ state: now, indices: now ? held(now) : [] }),
    },
    save,
  });
  const hint = h("p", { class: "hint" });
  const element = h(
    "section",
    { class: "column figure", "aria-label": "Error over the media" },
    h("div", { class: "heading" }, h("h2", {}, "Error over the media"), exports),
    h("div", { class: "figure-controls" }, over.element, ...pickers),
    h("div", { class: "figure-area" }, sweepHost, mapHost, waiting),
    h("div", { class: "figure-foot" }, ...spans, hint),
    wrong,
    tables.element,
  );
  parent.append(element);

  /** The medium's index that a figure's axis stands for; a click makes it one's own. @param {State} patch @param {boolean} settled */
  function go(patch, settled) {
    actions.set({ ...patch, material: null }, { history: settled ? "push" : "replace" });
  }
  const plot = createPlot(sweepHost, {
    name: "Largest error against n",
    x: { ...N_AXIS, range: [1, 4] },
    y: { title: "error", range: null },
    filename: "fresnel-error",
    onPick(x, { settled }) {
      const name = now?.over === "k" ? "k_t" : "n_t";
      go({ [name]: Number(x.toPrecision(4)) }, false);
      if (settled) actions.settle();
    },
  });
  const map = createHeatmap(mapHost, {
    name: "Map of the error",
    x: { title: "", range: [0, 90] },
    y: { title: "", range: [0, 1] },
    z: { title: "", kind: "size", print: short },
    onPick(x, y) {
      if (now?.over === "theta-n") go({ theta_i_deg: inDegrees(x, now.angle), n_t: y }, true);
      else go({ n_t: x, k_t: y }, true);
    },
  });

  let drawn = "";
  /** @type {unknown[]} the answers that are drawn */
  let sources = [];
  /** @param {string} look @param {unknown[]} answers */
  function isDrawn(look, answers) {
    const same =
      look === drawn &&
      answers.length === sources.length &&
      answers.every((a, i) => a === sources[i]);
    drawn = look;
    sources = answers;
    return same;
  }

  /** @param {State} state @param {Record<string, any>} answers */
  function drawSweep(state, answers) {
    const name = state.over === "k" ? "k_t" : "n_t";
    const range = ranges(state)[state.over === "k" ? "k" : "n"];
    const given = state.against
      .filter((/** @type {string} */ id) => !hasTriple(state, id))
      .map((/** @type {string} */ id) => answers[`sweep:${id}`])
      .filter((/** @type {any} */ answer) => answer && answer.over === name);
    const sweeps = given.map(sweepOf);
    const relative = isRelative(state.metric);
    const traces = sweeps.map(
      (/** @type {import('../errors/answers.js').Sweep} */ { model, x, metrics }) => ({
        id: model,
        label: shortTitle(catalog.models.find((m) => m.id === model)?.title ?? model),
        x,
        y: (metrics[state.metric] ?? []).map((v) => (v !== null && relative ? 100 * v : v)),
        width: 1.9,
        unit: relative ? " %" : undefined,
        ...modelStyle(catalog.models, model),
      }),
    );
    waiting.hidden = traces.length > 0;
    const chosen = state.against.length > 0;
    const split = chosen && state.against.every((/** @type {string} */ id) => hasTriple(state, id));
    setText(waiting, split ? ONE_CHANNEL : chosen ? "…" : "Choose a model to see its error here.");
    sweepHost.toggleAttribute("data-empty", traces.length === 0);
    if (traces.length === 0) return;
    const look = JSON.stringify([name, state.metric, range]);
    const axis = state.over === "k" ? K_AXIS : N_AXIS;
    const current = catalog.parameters.find((p) => p.name === name);
    if (!isDrawn(look, given)) {
      plot.axes({
        name: `${METRICS[state.metric]} against ${axis.short}`,
        x: { ...axis, range, steps: { step: 0.01, fine: 0.001, page: 0.1 } },
        y: { title: `${METRICS[state.metric]}${relative ? " (%)" : ""}`, range: null },
      });
      void plot.draw(traces);
      tables.fill();
    }
    const x = state[current?.name ?? name];
    plot.marker(
      x,
      traces.map((/** @type {{id: string, x: number[], y: (number | null)[]}} */ t) => ({
        id: t.id,
        y: read(t.y, locate(t.x, x)),
      })),
    );
  }

  /** @param {State} state @param {any} answer */
  function drawMap(state, answer) {
    const pointwise = isPointwise(state.over);
    const wanted = pointwise ? state.point : state.metric;
    const split = hasTriple(state, focused(state));
    waiting.hidden = Boolean(answer) && !split;
    mapHost.toggleAttribute("data-empty", split || !answer);
    setText(waiting, split ? ONE_CHANNEL : "…");
    if (!answer || split) return;
    const look = JSON.stringify([state.over, wanted, state.angle, state.budget, state.within]);
    const grid = mapOf(answer);
    // A map of another kind may be on its way.
    const fits = grid.metric === wanted && grid.pointwise === pointwise;
    if (fits && !isDrawn(look, [answer])) {
      const relative = isRelative(wanted);
      const title = catalog.models.find((m) => m.id === grid.model)?.title ?? grid.model;
      const what = pointwise ? POINTS[wanted] : METRICS[wanted];
      const signed =
        wanted === "error" || wanted === "relative" || wanted === "cosine_weighted_mean";
      const rad = state.angle === "rad";
      const x = pointwise
        ? {
            title: `angle of incidence θᵢ (${rad ? "rad" : "degrees"})`,
            short: "θᵢ",
            column: rad ? "theta_i" : "theta_i_deg",
            unit: rad ? " rad" : "°",
            range: [0, inUnit(90, state.angle)],
          }
        : { ...N_AXIS, range: ends(grid.x) };
      void map.draw(
        { ...grid, x: pointwise ? grid.x.map((d) => inUnit(d, state.angle)) : grid.x },
        {
          name: `${title}: ${what}`,
          ids: [grid.model],
          x,
          y: pointwise ? { ...N_AXIS, range: ends(grid.y) } : { ...K_AXIS, range: ends(grid.y) },
          z: {
            title: what ?? "",
            kind: signed ? "signed" : "size",
            print: relative ? share : short,
            level: relative || (!pointwise && wanted !== state.within) ? null : state.budget,
          },
        },
      );
      tables.fill();
    }
    if (pointwise) map.marker(inUnit(state.theta_i_deg, state.angle), state.n_t);
    else map.marker(state.n_t, state.k_t);
  }

  return {
    /** @param {State} state @param {Record<string, any>} answers */
    update(state, answers) {
      now = state;
      over.update([state.over]);
      const pointwise = isPointwise(state.over);
      const asMap = isMap(state.over);
      metric.value = state.metric;
      point.value = state.point;
      const ids = state.against.length ? state.against : [focused(state)];
      if (focus.dataset.ids !== ids.join()) {
        focus.dataset.ids = ids.join();
        focus.replaceChildren(
          ...ids.map((/** @type {string} */ id) =>
            h("option", { value: id }, catalog.models.find((m) => m.id === id)?.title ?? id),
          ),
        );
      }
      focus.value = focused(state);
      const shown = [!pointwise, pointwise, asMap];
      pickers.forEach((p, i) => {
        p.hidden = !shown[i];
      });
      const automatic = ranges(state);
      for (const { name, box } of bounds) {
        const value = automatic[name.startsWith("n") ? "n" : "k"][name.endsWith("low") ? 0 : 1];
        if (document.activeElement !== box) box.value = plain(value);
      }
      const [nSpan, kSpan] = spans;
      if (nSpan) nSpan.hidden = state.over === "k";
      if (kSpan) kSpan.hidden = state.over !== "k" && state.over !== "n-k";
      setText(hint, asMap ? "Click to go there." : "Click or drag to go there.");
      const changed = sweepHost.hidden !== asMap;
      sweepHost.hidden = asMap;
      mapHost.hidden = !asMap;
      if (changed) drawn = "";
      if (asMap) drawMap(state, answers.map);
      else drawSweep(state, answers);
    },
    theme() {
      plot.theme();
      map.theme();
    },
    destroy() {
      plot.destroy();
      map.destroy();
    },
  };
}

/** @param {readonly number[]} values @returns {[number, number]} */
function ends(values) {
  return [values[0] ?? 0, values.at(-1) ?? 1];
}
