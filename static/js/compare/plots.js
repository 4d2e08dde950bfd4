/** The overlaid curves and, below them on the same axis of angles, their errors. */

import { createChoice } from "../controls/panel.js";
import { landmarksOf, locate, read } from "../curves/reading.js";
import { curveTraces, distinct, errorRange, errorTraces } from "../errors/traces.js";
import { inDegrees, inUnit } from "../numbers/format.js";
import { h } from "../page/dom.js";
import { createDataTables, createExports } from "../page/exports.js";
import { traceUid } from "../plot/figure.js";
import { createPlot } from "../plot/plot.js";

const DEGREES = [0, 15, 30, 45, 60, 75, 90];
const TWELFTHS = ["0", "π/12", "π/6", "π/4", "π/3", "5π/12", "π/2"];
const LABELS = 46; // px that both plots keep for the labels of their vertical axes
const RESOLUTION = 0.05; // degrees

/** @param {'deg' | 'rad'} unit */
function angleAxis(unit) {
  const rad = unit === "rad";
  return {
    title: `angle of incidence θᵢ (${rad ? "rad" : "degrees"})`,
    range: [0, inUnit(90, unit)],
    ticks: {
      values: DEGREES.map((d) => inUnit(d, unit)),
      text: rad ? TWELFTHS : DEGREES.map((d) => `${d}°`),
    },
    unit: rad ? " rad" : "°",
    column: rad ? "theta_i" : "theta_i_deg",
  };
}

/**
 * @param {object} options
 * @param {HTMLElement} options.parent in the document, because plots read colours and sizes from it
 * @param {Model[]} options.models
 * @param {Actions} options.actions
 * @param {(name: string, blob: Blob) => void} options.save
 */
export function createPlots({ parent, models, actions, save }) {
  /** @type {State | null} */
  let now = null;
  /** @param {string} name @param {string} label @param {() => Plot} plot */
  const exports = (name, label, plot) =>
    createExports({
      what: `the ${label}`,
      name: () => name,
      make: (format) => plot().exportAs(format),
      print: {
        figures: () => [plot()],
        call: "/curves",
        behind: () => ({ state: now, indices: ["n_i", "n_t", "k_t"] }),
      },
      save,
    });
  const kind = createChoice({
    legend: "Error",
    items: [
      { value: "signed", label: "absolute", note: "R of the model minus exact R" },
      { value: "relative", label: "relative", note: "that over the exact R" },
    ],
    onChange: ([value]) => actions.set({ error: value }),
  });
  kind.element.classList.add("unnamed");
  const upperHost = h("div", { class: "plot-host upper" });
  const lowerHost = h("div", { class: "plot-host lower" });
  const tables = createDataTables("Curves and errors as tables", {
    "Table of the curves": () => (drawn.settled ? [upper.table()] : []),
    "Table of the errors over the angle": () => (drawn.settled ? [lower.table()] : []),
  });
  const element = h(
    "section",
    { class: "column overlaid", "aria-label": "Reflectance and its error" },
    h(
      "div",
      { class: "heading" },
      h("h2", {}, "Reflectance"),
      exports("fresnel-compare", "curves", () => upper),
    ),
    upperHost,
    h(
      "div",
      { class: "heading error-heading" },
      h("h2", {}, "Error"),
      kind.element,
      exports("fresnel-compare-error", "errors", () => lower),
    ),
    lowerHost,
    tables.element,
  );
  parent.append(element);

  /** @param {number} x @param {{settled: boolean}} how */
  function pick(x, { settled }) {
    const raw = inDegrees(x, now?.angle ?? "deg");
    const deg = Math.min(
      90,
      Math.max(0, Number((Math.round(raw / RESOLUTION) * RESOLUTION).toFixed(6))),
    );
    if (deg !== now?.theta_i_deg) actions.set({ theta_i_deg: deg }, { history: "replace" });
    if (settled) actions.settle();
  }
  const upper = createPlot(upperHost, {
    name: "Reflectance of the models and exact",
    x: { ...angleAxis("deg"), title: "" },
    y: { title: "reflectance", range: [0, 1], labels: LABELS },
    filename: "fresnel-compare",
    onPick: pick,
  });
  const lower = createPlot(lowerHost, {
    name: "Error of the models",
    x: angleAxis("deg"),
    y: { title: "model − exact", range: null, labels: LABELS },
    filename: "fresnel-compare-error",
    onPick: pick,
  });

  /** @type {Trace[]} */
  let all = [];
  /** @type {Trace[]} */
  let curves = [];
  /** @type {Trace[]} */
  let errors = [];
  let drawn = { look: "", sources: /** @type {unknown[]} */ ([]), settled: false };
  /** @type {string | null} the model under the pointer */
  let hovered = null;
  /** @type {string | null} */
  let lastLit = null;
  const lit = () => hovered ?? now?.focus ?? null;

  /** The members of the family that the server has answered. @param {State} state @param {Record<string, any>} answers */
  const members = (state, answers) =>
    state.family.flatMap((/** @type {number} */ n) => {
      const own = answers[`curves@${n}`];
      return own ? [{ n, curves: own }] : [];
    });

  /** Reflectance may leave 0 to 1 where a model does. @param {Trace[]} traces @returns {[number, number]} */
  function upperRange(traces) {
    const values = traces.flatMap((t) => t.y.filter((v) => v !== null));
    return [
      Math.min(0, Math.floor(10 * Math.min(...values)) / 10),
      Math.max(1, Math.ceil(10 * Math.max(...values)) / 10),
    ];
  }

  function paintLight() {
    const wanted = lit();
    // A model that is not shown would dim all the others.
    const one = curves.some((t) => t.id.split(/[.@]/)[0] === wanted) ? wanted : null;
    for (const [host, traces] of /** @type {const} */ ([
      [upperHost, curves],
      [lowerHost, errors],
    ])) {
      traces.forEach((trace, index) => {
        const group = host.getElementsByClassName(`trace${traceUid(index)}`)[0];
        if (!(group instanceof SVGElement)) return;
        const own = one === null || trace.id === "exact" || trace.id.split(/[.@]/)[0] === one;
        group.style.opacity = own ? "" : "0.18";
      });
    }
  }

  return {
    /** @param {State} state @param {Record<string, any>} answers @param {boolean} moving */
    update(state, answers, moving) {
      now = state;
      kind.update([state.error]);
      if (!answers.curves) return;
      const look = JSON.stringify([state.angle, state.error, state.against, state.family]);
      const family = members(state, answers);
      const sources = [answers.curves, ...family.map((/** @type {any} */ m) => m.curves)];
      const same =
        look === drawn.look &&
        sources.length === drawn.sources.length &&
        sources.every((s, i) => s === drawn.sources[i]);
      if (!same || (!drawn.settled && !moving)) {
        const relative = state.error === "relative";
        all = curveTraces(
          answers.curves,
          state.against,
          models,
          (d) => inUnit(d, state.angle),
          family,
        );
        curves = distinct(all);
        const plain = errorTraces(all, relative);
        errors = relative
          ? plain.map((t) => ({
              ...t,
              unit: " %",
              y: t.y.map((v) => (v === null ? null : 100 * v)),
            }))
          : plain;
        const marks = landmarksOf(answers.curves.interface).map((m) => ({
          x: inUnit(m.deg, state.angle),
          label: m.label,
          kind: /** @type {const} */ ("landmark"),
        }));
        if (moving && look === drawn.look) {
          upper.fast(curves, marks);
          lower.fast(
            errors,
            marks.map((m) => ({ ...m, label: "" })),
          );
        } else {
          upper.axes({
            x: { ...angleAxis(state.angle), title: "", short: "θᵢ" },
            y: { title: "reflectance", range: upperRange(curves), labels: LABELS },
          });
          lower.axes({
            x: angleAxis(state.angle),
            y: {
              title: relative ? "(model − exact) / exact (%)" : "model − exact",
              range: errorRange(errors),
              labels: LABELS,
            },
          });
          void upper.draw(curves, marks);
          void lower.draw(errors);
        }
        drawn = { look, sources, settled: !moving };
        paintLight();
        tables.fill();
      }
      if (lastLit !== lit()) {
        lastLit = lit();
        paintLight();
      }
      const x = inUnit(state.theta_i_deg, state.angle);
      /** @param {Trace[]} traces */
      const points = (traces) => traces.map((t) => ({ id: t.id, y: read(t.y, locate(t.x, x)) }));
      upper.marker(x, points(curves));
      lower.marker(x, points(errors.filter((t) => t.id !== "exact")));
    },
    /**
     * Signed errors of the models at an angle, from the curves.
     * @param {number} theta_i_deg
     * @returns {Map<string, number | null>}
     */
    reading(theta_i_deg) {
      const exact = curves.find((t) => t.id === "exact");
      if (!exact || !now) return new Map();
      const place = locate(exact.x, inUnit(theta_i_deg, now.angle));
      const right = read(exact.y, place);
      return new Map(
        curves
          .filter((t) => t.id !== "exact" && !t.id.includes("@"))
          .map((t) => {
            const value = read(t.y, place);
            return [t.id, value === null || right === null ? null : value - right];
          }),
      );
    },
    /** @param {string | null} id of the model whose curve stands out */
    light(id) {
      if (id === hovered) return;
      hovered = id;
      paintLight();
    },
    theme() {
      upper.theme();
      lower.theme();
    },
    destroy() {
      upper.destroy();
      lower.destroy();
    },
  };
}
