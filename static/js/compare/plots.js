/** The overlaid curves and, below them on the same axis of angles, their errors. */

import { bandsOf } from "../curves/band.js";
import { angleAxis, landmarksOf, locate, read } from "../curves/reading.js";
import { curveTraces, distinct, errorRange, errorTraces, takenTraces } from "../errors/traces.js";
import { bandPaths } from "../media/media.js";
import { clamp, inDegrees, inUnit } from "../numbers/format.js";
import { createPair } from "../plot/pair.js";
import { traceUid } from "../plot/plotly.js";
import { freshOf } from "../state/state.js";
import { against, errorShown, showingError } from "./fields.js";

const RESOLUTION = 0.05; // degrees

/** The model that a curve is of: `schlick@1.33` and `schlick.R_red` are of `schlick`. @param {Trace} trace */
const modelOf = ({ id }) => id.split(/[.@]/)[0];

/** Reflectance may leave 0 to 1 where a model does. @param {Trace[]} traces @returns {[number, number]} */
function curveRange(traces) {
  const values = traces.flatMap((t) => t.y.filter((v) => v !== null));
  return [
    Math.min(0, Math.floor(10 * Math.min(...values)) / 10),
    Math.max(1, Math.ceil(10 * Math.max(...values)) / 10),
  ];
}

/** @param {ViewContext} context */
export function createPlots({ element, catalog, state: current, actions, save }) {
  const { models } = catalog;
  /** @type {State | null} */
  let now = null;

  /** @param {number} x @param {{settled: boolean}} how */
  function onPick(x, { settled }) {
    const raw = inDegrees(x, now?.angle ?? "deg");
    const deg = clamp(Number((Math.round(raw / RESOLUTION) * RESOLUTION).toFixed(6)), 0, 90);
    if (deg !== now?.theta_i_deg) actions.set({ theta_i_deg: deg }, { history: "replace" });
    if (settled) actions.settle();
  }
  const pair = createPair({
    parent: element,
    className: "overlaid",
    label: "Reflectance and its error",
    summary: "Curves and errors as tables",
    upper: {
      heading: "Reflectance",
      what: "the curves",
      table: "Table of the curves",
      name: "Reflectance of the models and exact",
      filename: "fresnel-compare",
    },
    lower: {
      heading: "Error",
      what: "the errors",
      table: "Table of the errors over the angle",
      name: "Error of the models",
      filename: "fresnel-compare-error",
    },
    onPick,
    onKind: (value) => actions.set(showingError(current(), value)),
    notes: ["R of the model minus exact R", "that over the exact R"],
    more: [
      {
        value: "taken",
        label: "taken from Schlick",
        note: "Schlick's R minus the model's, beside what has to be taken from it: Schlick's R minus exact R",
      },
    ],
    print: {
      call: "/curves",
      behind: () => ({ state: now, indices: ["n_i", "n_t", "k_t"] }),
    },
    save,
  });

  /** @type {Trace[]} */
  let curves = [];
  /** @type {Trace[]} */
  let errors = [];
  /** @type {Trace[]} as they stand in the table */
  let signed = [];
  /** @type {string | null} the model under the pointer */
  let hovered = null;
  /** @type {string | null} */
  let lastLit = null;
  const lit = () => hovered ?? now?.focus ?? null;

  function paintLight() {
    const wanted = lit();
    // A model that is not shown would dim all the others.
    const one = curves.some((t) => modelOf(t) === wanted) ? wanted : null;
    for (const [host, traces] of /** @type {const} */ ([
      [pair.hosts.upper, curves],
      [pair.hosts.lower, errors],
    ])) {
      traces.forEach((trace, index) => {
        const group = host.getElementsByClassName(`trace${traceUid(index)}`)[0];
        if (!(group instanceof SVGElement)) return;
        const own = one === null || modelOf(trace) === "exact" || modelOf(trace) === one;
        group.style.opacity = own ? "" : "0.18";
      });
    }
  }

  return {
    /** @param {State} state @param {Record<string, any>} answers @param {boolean} moving */
    update(state, answers, moving) {
      now = state;
      const shown = errorShown(state);
      pair.kind.update([shown]);
      if (!answers.curves) return;
      /** @param {number} deg */
      const toUnit = (deg) => inUnit(deg, state.angle);
      // The members of the family that the server has answered.
      const family = state.family.flatMap((/** @type {number} */ n) => {
        const own = answers[`curves@${n}`];
        return own ? [{ n, curves: own }] : [];
      });
      const look = JSON.stringify([
        state.angle,
        shown,
        state.polarized,
        against(state),
        state.family,
      ]);
      const { band } = freshOf(answers, bandPaths(state, catalog));
      const sources = [answers.curves, band, ...family.map((/** @type {any} */ m) => m.curves)];
      const relative = shown === "relative";
      const axis = angleAxis(state);
      const drawn = pair.draw(look, sources, moving, () => {
        const polarized = state.polarized === "on";
        const ids = against(state);
        const all = curveTraces(answers.curves, ids, models, toUnit, family, polarized);
        curves = distinct(all);
        const taken = shown === "taken" ? takenTraces(all) : null;
        errors = taken ?? errorTraces(all, relative);
        signed = errorTraces(all, false).filter((t) => !t.id.includes("@"));
        const marks = landmarksOf(answers.curves.interface).map((m) => ({
          x: toUnit(m.deg),
          label: m.label,
          kind: /** @type {const} */ ("landmark"),
        }));
        return {
          upper: {
            traces: curves,
            marks,
            bands: bandsOf(band, state.angle),
            axes: () => ({
              x: { ...axis, title: "", short: "θᵢ" },
              y: { title: "reflectance", range: curveRange(curves) },
            }),
          },
          lower: {
            traces: errors,
            read: taken ?? errors.filter((t) => t.id !== "exact"),
            axes: () => ({
              x: axis,
              y: {
                title: taken
                  ? "Schlick − model"
                  : relative
                    ? "(model − exact) / exact (%)"
                    : "model − exact",
                range: errorRange(errors),
              },
            }),
          },
        };
      });
      if (drawn || lastLit !== lit()) {
        lastLit = lit();
        paintLight();
      }
      pair.marker(toUnit(state.theta_i_deg));
    },
    /** Signed errors of the models at an angle, from the curves. @param {number} theta_i_deg @returns {Map<string, number | null>} */
    reading(theta_i_deg) {
      const x = inUnit(theta_i_deg, now?.angle);
      return new Map(signed.map((t) => [t.id, read(t.y, locate(t.x, x))]));
    },
    /** @param {string | null} id of the model whose curve stands out */
    light(id) {
      if (id === hovered) return;
      hovered = id;
      paintLight();
    },
    theme: pair.theme,
    destroy: pair.destroy,
  };
}
