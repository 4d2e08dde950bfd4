/** The error over the media: against n or k for every model, or as a map of one. */

import { createChoice } from "../controls/panel.js";
import { createSelect } from "../controls/select.js";
import { createEnds } from "../controls/typed.js";
import { angleAxis, ends, locate, read } from "../curves/reading.js";
import { METRICS, short } from "../errors/metrics.js";
import { modelStyle, shortTitle } from "../models/look.js";
import { inDegrees, inUnit, percent } from "../numbers/format.js";
import { createChanged } from "../page/changed.js";
import { createDataTables, createExports, h, setText } from "../page/dom.js";
import { html, render } from "../page/lit.js";
import { createHeatmap } from "../plot/heatmap.js";
import { createPlot } from "../plot/plot.js";
import { declared } from "../state/state.js";
import { against, FIGURES, figureOf, focused, ranges } from "./fields.js";
import { hasTriple } from "./queries.js";

/** @type {Record<string, string>} */
const POINTS = { error: "signed error", absolute: "absolute error", relative: "relative error" };
/** What an error is called. @type {Record<string, string>} */
const NAMES = { ...METRICS, ...POINTS };
const SIGNED = ["error", "relative", "cosine_weighted_mean"];
/** @type {Record<string, {title: string, short: string, column: string}>} */
const AXES = {
  n_t: { title: "second index n_t", short: "n", column: "n_t" },
  k_t: { title: "extinction k_t", short: "k", column: "k_t" },
};
const STEPS = { step: 0.01, fine: 0.001, page: 0.1 };
const ONE_CHANNEL = "This figure shows one channel: give one number for R, G and B.";

/** @param {string} name of a metric or a point's error */
const isRelative = (name) => name === "relative" || name === "max_relative";
/** @param {number | null} x */
const share = (x) => (x === null ? "undefined" : Math.abs(x) < 5e-4 ? short(x) : percent(x));

/** @param {ViewContext} context */
export function createFigure({ element: parent, catalog, actions, save }) {
  const { models, parameters } = catalog;
  /** @type {State | null} */
  let now = null;
  const shown = () => (now && figureOf(now).isMap ? map : plot);
  /** @param {string} id */
  const titleOf = (id) => models.find((m) => m.id === id)?.title ?? id;

  const over = createChoice({
    legend: "Error over",
    items: Object.entries(FIGURES).map(([value, { label }]) => ({ value, label })),
    onChange: ([value]) =>
      actions.set({ over: value, n_low: null, n_high: null, k_low: null, k_high: null }),
  });
  over.element.classList.add("unnamed");
  const metric = createSelect(
    "Measure of the error",
    (name) => actions.set({ metric: name }),
    METRICS,
  );
  const point = createSelect("Error shown", (name) => actions.set({ point: name }), POINTS);
  const focus = createSelect("Model of the map", (id) => actions.set({ focus: id }));
  const wrong = h("p.row-error", { role: "alert" });
  /** @param {"n" | "k"} letter */
  const endsOf = (letter) =>
    createEnds({
      letter,
      names: [`${letter}_low`, `${letter}_high`],
      onChange: actions.set,
      bounds: declared(parameters, `${letter}_t`),
      wrong,
    });
  const bounds = { n_t: endsOf("n"), k_t: endsOf("k") };
  const hosts = {
    sweep: h("div.figure-host"),
    map: h("div.figure-host", { hidden: true }),
  };
  const waiting = h("p.figure-note");
  const hint = h("p.hint");
  const tables = createDataTables("This figure as a table", {
    "Table of the error over the media": () => (now ? [shown().table()] : []),
  });
  const exports = createExports({
    what: "the figure of the error",
    name: () => `fresnel-error-${now?.over ?? "n"}`,
    make: (format) => shown().exportAs(format),
    print: {
      figures: () => [shown()],
      call: "/errors/",
      behind: () => ({ state: now, indices: now ? figureOf(now).held : [] }),
    },
    save,
  });
  const element = h("section.column.figure", { "aria-label": "Error over the media" });
  render(
    html`<div class="heading"><h2>Error over the media</h2>${exports}</div>
      <div class="figure-controls">
        ${over.element}${metric.element}${point.element}${focus.element}
      </div>
      <div class="figure-area">${hosts.sweep}${hosts.map}${waiting}</div>
      <div class="figure-foot">${bounds.n_t.element}${bounds.k_t.element}${hint}</div>
      ${wrong}${tables.element}`,
    element,
  );
  parent.append(element);

  // A click makes the medium one's own.
  const plot = createPlot(hosts.sweep, {
    name: "Largest error against n",
    x: { .../** @type {any} */ (AXES.n_t), range: [1, 4] },
    y: { title: "error", range: null },
    filename: "fresnel-error",
    onPick(x, { settled }) {
      const name = now?.over === "k" ? "k_t" : "n_t";
      actions.set({ [name]: Number(x.toPrecision(4)), material: null }, { history: "replace" });
      if (settled) actions.settle();
    },
  });
  const map = createHeatmap(hosts.map, {
    name: "Map of the error",
    x: { title: "", range: [0, 90] },
    y: { title: "", range: [0, 1] },
    z: { title: "", kind: "size", print: short },
    onPick: (x, y) =>
      actions.set({
        ...(now?.over === "theta-n"
          ? { theta_i_deg: inDegrees(x, now.angle), n_t: y }
          : { n_t: x, k_t: y }),
        material: null,
      }),
  });
  const changed = createChanged();

  /** @param {State} state @param {Record<string, any>} answers */
  function drawSweep(state, answers) {
    const { x: name } = figureOf(state);
    const single = against(state).filter((/** @type {string} */ id) => !hasTriple(state, id));
    const sweeps = single
      .map((/** @type {string} */ id) => answers[`sweep:${id}`])
      .filter((/** @type {any} */ answer) => answer?.over === name);
    const relative = isRelative(state.metric);
    /** @type {Trace[]} */
    const traces = sweeps.map((/** @type {any} */ sweep) => ({
      id: sweep.model,
      label: shortTitle(titleOf(sweep.model)),
      x: sweep.values,
      y: sweep[state.metric].map((/** @type {number | null} */ v) =>
        v !== null && relative ? 100 * v : v,
      ),
      width: 1.9,
      unit: relative ? " %" : undefined,
      ...modelStyle(models, sweep.model),
    }));
    const empty = traces.length === 0;
    waiting.hidden = !empty;
    hosts.sweep.toggleAttribute("data-empty", empty);
    const chosen = against(state).length > 0;
    const split = chosen && single.length === 0;
    setText(waiting, split ? ONE_CHANNEL : chosen ? "…" : "Choose a model to see its error here.");
    if (empty) return;
    const range = ranges(state)[/** @type {"n_t" | "k_t"} */ (name)];
    if (changed(JSON.stringify([name, state.metric, range]), ...sweeps)) {
      const axis = /** @type {typeof AXES.n_t} */ (AXES[name]);
      plot.axes({
        name: `${NAMES[state.metric]} against ${axis?.short}`,
        x: { ...axis, range, steps: STEPS },
        y: { title: `${NAMES[state.metric]}${relative ? " (%)" : ""}`, range: null },
      });
      void plot.draw(traces);
      tables.fill();
    }
    const x = state[name];
    plot.marker(
      x,
      traces.map((t) => ({ id: t.id, y: read(t.y, locate(t.x, x)) })),
    );
  }

  /** @param {State} state @param {any} answer */
  function drawMap(state, answer) {
    const { x, y = "", pointwise } = figureOf(state);
    const wanted = pointwise ? state.point : state.metric;
    const split = hasTriple(state, focused(state));
    waiting.hidden = Boolean(answer) && !split;
    hosts.map.toggleAttribute("data-empty", split || !answer);
    setText(waiting, split ? ONE_CHANNEL : "…");
    if (!answer || split) return;
    const look = [state.over, wanted, state.angle, state.budget, state.within];
    // A map of another kind may be on its way.
    const fits = answer.metric === wanted && answer.x.name === x;
    if (fits && changed(JSON.stringify(look), answer)) {
      const relative = isRelative(wanted);
      const { values } = answer.x;
      void map.draw(
        {
          x: pointwise ? values.map((/** @type {number} */ d) => inUnit(d, state.angle)) : values,
          y: answer.y.values,
          z: answer.values,
        },
        {
          name: `${titleOf(answer.model)}: ${NAMES[wanted]}`,
          ids: [answer.model],
          x: pointwise
            ? { ...angleAxis(state), ticks: undefined, short: "θᵢ" }
            : { .../** @type {any} */ (AXES[x]), range: ends(values) },
          y: { .../** @type {any} */ (AXES[y]), range: ends(answer.y.values) },
          z: {
            title: NAMES[wanted] ?? "",
            kind: SIGNED.includes(wanted) ? "signed" : "size",
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
      const { x, y, isMap, pointwise } = figureOf(state);
      over.update([state.over]);
      metric.update(state.metric);
      point.update(state.point);
      const ids = against(state).length ? against(state) : [focused(state)];
      focus.update(
        focused(state),
        Object.fromEntries(ids.map((/** @type {string} */ id) => [id, titleOf(id)])),
      );
      metric.element.hidden = pointwise;
      point.element.hidden = !pointwise;
      focus.element.hidden = !isMap;
      const automatic = ranges(state);
      for (const name of /** @type {const} */ (["n_t", "k_t"])) {
        bounds[name].update(automatic[name]);
        bounds[name].element.hidden = name !== x && name !== y;
      }
      setText(hint, isMap ? "Click to go there." : "Click or drag to go there.");
      hosts.sweep.hidden = isMap;
      hosts.map.hidden = !isMap;
      if (isMap) drawMap(state, answers.map);
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
