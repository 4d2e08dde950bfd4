/** The albedo over its abscissa and, below it on the same axis, the signed errors of the fits. */

import { createEnds } from "../controls/typed.js";
import { ends as endsOf } from "../curves/reading.js";
import { errorRange } from "../errors/traces.js";
import { clamp } from "../numbers/format.js";
import { h } from "../page/dom.js";
import { createTrouble } from "../page/trouble.js";
import { drawLegend } from "../plot/legend.js";
import { MOST_LABELS } from "../plot/overlay.js";
import { createPair } from "../plot/pair.js";
import { gone, held, place, surfaceOf, sweepRange } from "./fields.js";
import { albedoTraces, claimTraces, decisive, errorTraces, tamed } from "./traces.js";

/**
 * @typedef {import('./answers.js').Fit} Fit
 * @typedef {import('./answers.js').Sweep} Sweep
 */

const MOST_ERRORS = 5; // that carry their names
const STEPS = { step: 0.01, fine: 0.001, page: 0.1 };

/** @type {Record<string, {title: string, short: string, column: string, letter: string}>} */
const AXES = {
  eta: { title: "relative index η = n_t / n_i", short: "η", column: "eta", letter: "\\eta" },
  n_t: { title: "second index n_t", short: "n_t", column: "n_t", letter: "n_t" },
  k_t: { title: "extinction k_t", short: "k_t", column: "k_t", letter: "k_t" },
};
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

/** @param {ViewContext} context */
export function createPlots({ element: parent, actions, save }) {
  /** @type {State | null} */
  let now = null;
  const note = h("p.figure-note", { hidden: true }, "Choose a fit to see its error here.");
  const title = document.createTextNode("Albedo");
  const legend = h("ul.plot-legend.shared-key");
  const ends = createEnds({
    letter: "\\eta",
    names: ["sweep_low", "sweep_high"],
    onChange: actions.set,
  });
  const trouble = createTrouble("Back to the usual fits and range", () =>
    actions.set({ fits: null, sweep_low: null, sweep_high: null }),
  );

  /** @param {number} x @param {{settled: boolean}} how */
  function onPick(x, { settled }) {
    if (!now) return;
    const [low, high] = sweepRange(now);
    const least = now.surface === "metal-k" ? 0 : 1e-3;
    const to = clamp(Number(x.toFixed(3)), Math.max(low, least), high);
    actions.set(gone(now, to), { history: "replace" });
    if (settled) actions.settle();
  }
  /** @param {string} over @param {readonly number[]} range */
  const axisOf = (over, range) => {
    const { letter, ...axis } = /** @type {typeof AXES.eta} */ (AXES[over]);
    return { ...axis, range, steps: STEPS };
  };
  const pair = createPair({
    parent,
    className: "albedos",
    label: "Albedo and errors of the fits",
    summary: "Albedos and errors as tables",
    upper: {
      heading: title,
      above: [trouble.element],
      below: [legend],
      what: "the albedos",
      table: "Table of the albedos",
      name: "Hemispherical albedo",
      filename: "fresnel-albedo",
    },
    lower: {
      heading: "Error of the fits",
      inside: note,
      below: [h("div.figure-foot", ends.element, h("p.hint", "Click or drag to go there."))],
      what: "the errors of the fits",
      table: "Table of the errors",
      name: "Error of the fits",
      filename: "fresnel-albedo-error",
      names: MOST_ERRORS,
    },
    onPick,
    onKind: (value) => actions.set({ albedo_error: value }),
    notes: ["the fit minus exact", "that over exact"],
    print: {
      call: "/albedo/sweep",
      behind: () => ({ state: now, indices: now ? held(now) : [] }),
    },
    save,
  });

  /** Names stand at the curves; where these are too many, in a list that both plots share. @param {Trace[]} curves @param {Trace[]} claims */
  function key(curves, claims) {
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
    const range = endsOf(sweep.values);
    const ids = sweep.curves.map((c) => c.id);
    const look = JSON.stringify([sweep.over, range, shown, ids]);
    note.hidden = sweep.curves.some((c) => c.kind === "fit");
    const axis = axisOf(sweep.over, range);
    pair.draw(look, [sweep, fits], moving, () => {
      const curves = albedoTraces(sweep, shown, fits);
      const errors = errorTraces(sweep, shown, fits);
      const claims = claimTraces(sweep, fits, relative);
      return {
        upper: {
          traces: curves,
          axes() {
            key(curves, claims);
            return {
              name: `Hemispherical albedo against ${axis.short}`,
              x: { ...axis, title: "" },
              y: { title: "albedo A", range: albedoRange(curves) },
            };
          },
        },
        lower: {
          traces: [...errors, ...claims],
          read: errors.filter((t) => t.id !== "zero"),
          axes() {
            const all = decisive([...errors, ...claims]);
            return {
              name: `Error of the fits against ${axis.short}`,
              x: axis,
              y: {
                title: relative ? "(fit − exact) / exact (%)" : "fit − exact",
                range: errorRange(relative ? tamed(all) : all),
              },
            };
          },
        },
      };
    });
  }

  return {
    /** @param {State} state @param {Record<string, any>} answers @param {readonly Fit[]} fits @param {boolean} moving @param {import("../page/trouble.js").Problem | undefined} problem */
    update(state, answers, fits, moving, problem) {
      now = state;
      trouble.update(
        problem,
        state.fits !== null || state.sweep_low !== null || state.sweep_high !== null,
      );
      pair.kind.update([state.albedo_error]);
      const { over, title: words } = surfaceOf(state);
      title.data = words;
      ends.update(sweepRange(state), AXES[over]?.letter);
      const sweep = /** @type {Sweep | undefined} */ (answers.sweep);
      if (!sweep || fits.length === 0) return;
      draw(state, sweep, fits, moving);
      pair.marker(sweep.over === over ? place(state) : null);
    },
    theme: pair.theme,
    destroy: pair.destroy,
  };
}
