/** The albedo over its abscissa and, below it on the same axis, the signed errors of the fits. */

import { createChoice } from "../controls/panel.js";
import { locate, read } from "../curves/reading.js";
import { errorRange } from "../errors/traces.js";
import { clamp } from "../numbers/entry.js";
import { h, setText } from "../page/dom.js";
import { createDataTables, createExports } from "../page/exports.js";
import { createTrouble } from "../page/trouble.js";
import { drawLegend } from "../plot/legend.js";
import { MOST_LABELS } from "../plot/overlay.js";
import { createPlot } from "../plot/plot.js";
import { createBounds } from "./bounds.js";
import { gone, isMetal, place, sweepRange } from "./fields.js";
import { held } from "./queries.js";
import { albedoTraces, claimTraces, decisive, errorTraces, tamed } from "./traces.js";

/**
 * @typedef {import('./answers.js').Fit} Fit
 * @typedef {import('./answers.js').Sweep} Sweep
 */

const LABELS = 46; // px that both plots keep for the labels of their vertical axes
const MOST_ERRORS = 5; // that carry their names
const STEPS = { step: 0.01, fine: 0.001, page: 0.1 };

/** @type {Record<string, {title: string, short: string, column: string, letter: string}>} */
const AXES = {
  eta: { title: "relative index η = n_t / n_i", short: "η", column: "eta", letter: "\\eta" },
  n_t: { title: "second index n_t", short: "n_t", column: "n_t", letter: "n_t" },
  k_t: { title: "extinction k_t", short: "k_t", column: "k_t", letter: "k_t" },
};

/** @param {State} state */
export function swept({ surface }) {
  return isMetal(surface) ? (surface === "metal-k" ? "k_t" : "n_t") : "eta";
}

/** An axis from 0 to 1, or to what the curves need where they stay far below. @param {readonly Trace[]} traces @returns {[number, number]} */
export function albedoRange(traces) {
  const values = decisive(traces).flatMap((t) => t.y.filter((v) => v !== null));
  const most = Math.max(0, ...values);
  const least = Math.min(...values);
  const high =
    most > 0.5 ? Math.max(1, Math.ceil(10 * most) / 10) : Math.ceil(10 * most + 0.2) / 10;
  // Metals reflect nearly all: what matters lies far from zero.
  const low = least > 0.5 ? Math.floor(5 * least) / 5 : Math.min(0, Math.floor(10 * least) / 10);
  return [low, Math.max(high, low + 0.1)];
}

/**
 * @param {HTMLElement} parent in the document: plots read their colours and sizes from it
 * @param {object} options
 * @param {Actions} options.actions
 * @param {(name: string, blob: Blob) => void} options.save
 */
export function createPlots(parent, { actions, save }) {
  /** @type {State | null} */
  let now = null;
  const kind = createChoice({
    legend: "Error",
    items: [
      { value: "signed", label: "absolute", note: "the fit minus exact" },
      { value: "relative", label: "relative", note: "that over exact" },
    ],
    onChange: ([value]) => actions.set({ albedo_error: value }),
  });
  const upperHost = h("div", { class: "frame" });
  const lowerHost = h("div", { class: "frame" });
  const note = h("p", { class: "figure-note", hidden: true });
  const title = h("h2", {}, "Albedo");
  const legend = h("ul", { class: "plot-legend shared-key" });
  const bounds = createBounds({
    letter: "\\eta",
    names: ["sweep_low", "sweep_high"],
    onChange: (patch) => actions.set(patch),
  });
  const trouble = createTrouble("Back to the usual fits and range", () =>
    actions.set({ fits: null, sweep_low: null, sweep_high: null }),
  );
  const tables = createDataTables("Albedos and errors as tables", {
    "Table of the albedos": () => (drawn.settled ? [upper.table()] : []),
    "Table of the errors": () => (drawn.settled ? [lower.table()] : []),
  });
  const print = {
    call: "/albedo/sweep",
    behind: () => ({ state: now, indices: now ? held(now) : [] }),
  };
  const element = h(
    "section",
    { class: "column albedos", "aria-label": "Albedo and errors of the fits" },
    h(
      "div",
      { class: "heading" },
      title,
      createExports({
        what: "the albedos",
        name: () => "fresnel-albedo",
        make: (format) => upper.exportAs(format),
        print: { figures: () => [upper], ...print },
        save,
      }),
    ),
    trouble.element,
    h("div", { class: "plot-host upper" }, upperHost),
    legend,
    h(
      "div",
      { class: "heading error-heading" },
      h("h2", {}, "Error of the fits"),
      kind.element,
      createExports({
        what: "the errors of the fits",
        name: () => "fresnel-albedo-error",
        make: (format) => lower.exportAs(format),
        print: { figures: () => [lower], ...print },
        save,
      }),
    ),
    h("div", { class: "plot-host lower" }, lowerHost, note),
    h(
      "div",
      { class: "figure-foot" },
      bounds.element,
      h("p", { class: "hint" }, "Click or drag to go there."),
    ),
    tables.element,
  );

  parent.append(element);

  /** @param {number} x @param {{settled: boolean}} how */
  function pick(x, { settled }) {
    if (!now) return;
    const [low, high] = sweepRange(now);
    const patch = gone(
      now,
      clamp(Number(x.toFixed(3)), Math.max(low, 1e-3 * Number(now.surface !== "metal-k")), high),
    );
    actions.set(patch, { history: "replace" });
    if (settled) actions.settle();
  }
  const upper = createPlot(upperHost, {
    name: "Hemispherical albedo",
    x: { ...AXES.eta, title: "", range: [1, 3], steps: STEPS },
    y: { title: "albedo A", range: [0, 0.5], labels: LABELS },
    filename: "fresnel-albedo",
    onPick: pick,
  });
  const lower = createPlot(lowerHost, {
    name: "Error of the fits",
    x: { .../** @type {any} */ (AXES.eta), range: [1, 3], steps: STEPS },
    y: { title: "fit − exact", range: null, labels: LABELS },
    filename: "fresnel-albedo-error",
    names: MOST_ERRORS,
    onPick: pick,
  });

  /** @type {Trace[]} */
  let curves = [];
  /** @type {Trace[]} */
  let errors = [];
  let drawn = {
    look: "",
    sweep: /** @type {unknown} */ (null),
    fits: /** @type {unknown} */ (null),
    settled: false,
  };

  /** Names stand at the curves; where these are too many, in a list that both plots share. @param {readonly Trace[]} claims */
  function key(claims) {
    legend.hidden = curves.filter((t) => !t.bare).length <= MOST_LABELS;
    const beyond = curves.find((t) => t.id.endsWith(".outside"));
    const named = curves.filter((t) => !t.id.endsWith(".outside"));
    drawLegend(legend, [
      ...named,
      ...(beyond ? [{ ...beyond, label: "outside a fit’s domain" }] : []),
      ...(claims[0] ? [{ ...claims[0], color: "--muted", label: "largest error claimed" }] : []),
    ]);
  }

  /** @param {State} state @param {Sweep} sweep @param {readonly Fit[]} fits @param {boolean} moving */
  function draw(state, sweep, fits, moving) {
    const relative = state.albedo_error === "relative";
    const shown = { lights: state.lights, relative };
    const x = sweep.values;
    const range = [x[0] ?? 0, x.at(-1) ?? 1];
    const ids = sweep.curves.map((c) => c.id);
    const look = JSON.stringify([sweep.over, range, shown, ids]);
    const changed = sweep !== drawn.sweep || fits !== drawn.fits;
    if (!changed && look === drawn.look && (drawn.settled || moving)) return;
    curves = albedoTraces(sweep, shown, fits);
    errors = errorTraces(sweep, shown, fits);
    const claims = claimTraces(sweep, fits, relative);
    const all = decisive([...errors, ...claims]);
    const axis = /** @type {typeof AXES.eta} */ (AXES[sweep.over]);
    if (moving && look === drawn.look) {
      upper.fast(curves);
      lower.fast([...errors, ...claims]);
    } else {
      upper.axes({
        name: `Hemispherical albedo against ${axis.short}`,
        x: { .../** @type {any} */ (axis), title: "", range, steps: STEPS },
        y: { title: "albedo A", range: albedoRange(curves), labels: LABELS },
      });
      lower.axes({
        name: `Error of the fits against ${axis.short}`,
        x: { .../** @type {any} */ (axis), range, steps: STEPS },
        y: {
          title: relative ? "(fit − exact) / exact (%)" : "fit − exact",
          range: errorRange(relative ? tamed(all) : all),
          labels: LABELS,
        },
      });
      void upper.draw(curves);
      key(claims);
      void lower.draw([...errors, ...claims]);
    }
    drawn = { look, sweep, fits, settled: !moving };
    note.hidden = sweep.curves.some((c) => c.kind === "fit");
    setText(note, "Choose a fit to see its error here.");
    tables.fill();
  }

  return {
    /** @param {State} state @param {Record<string, any>} answers @param {readonly Fit[]} fits @param {boolean} moving @param {import("../page/trouble.js").Problem | undefined} problem */
    update(state, answers, fits, moving, problem) {
      now = state;
      trouble.update(
        problem,
        state.fits !== null || state.sweep_low !== null || state.sweep_high !== null,
      );
      kind.update([state.albedo_error]);
      const over = swept(state);
      setText(
        title,
        {
          outside: "Albedo from outside",
          inside: "Albedo from inside",
          "metal-n": "Albedo of metals over n",
          "metal-k": "Albedo of metals over k",
        }[/** @type {string} */ (state.surface)] ?? "Albedo",
      );
      bounds.update(sweepRange(state), AXES[over]?.letter);
      const sweep = /** @type {Sweep | undefined} */ (answers.sweep);
      if (!sweep || fits.length === 0) return;
      draw(state, sweep, fits, moving);
      const x = sweep.over === over ? place(state) : null;
      /** @param {Trace[]} traces */
      const points = (traces) =>
        traces.map((t) => ({ id: t.id, y: x === null ? null : read(t.y, locate(t.x, x)) }));
      upper.marker(x, points(curves));
      lower.marker(x, points(errors.filter((t) => t.id !== "zero")));
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
