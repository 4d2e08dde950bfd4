/** n and k over the wavelength, with what rival measurements span, or the reflectance that follows. */

import { createChoice, createChoices } from "../controls/panel.js";
import { stretch } from "../numbers/format.js";
import { h } from "../page/dom.js";
import { createPlot } from "../plot/plot.js";
import { known, spanned, valueAt, within } from "./band.js";
import { createPanel } from "./panel.js";
import { presetOf, rivalsOf } from "./queries.js";

/** Where colors are computed from. @type {[number, number]} */
const VISIBLE = [360, 830];
const STEPS = 240;
const RIVAL_DASHES = ["dash", "dot", "dashdot", "longdash", "longdashdot", "8px 3px 2px 3px"];

/** What distinguishes a measurement from others of the material. @param {{id: string, name: string, rival_of: string | null} | undefined} preset */
export function shortName(preset) {
  if (!preset) return "";
  const own = preset.rival_of === null ? null : /\(([^()]*)\)$/.exec(preset.name);
  return own?.[1] ?? preset.name;
}

/** The part of the wavelengths that the axis shows. @param {any} spectrum @param {State} state @returns {[number, number]} */
export function shownRange(spectrum, { reach }) {
  if (reach === "visible") return VISIBLE;
  const ends = [spectrum.n_range_nm, spectrum.k_range_nm].filter(Boolean);
  return [Math.min(...ends.map((r) => r[0])), Math.max(...ends.map((r) => r[1]))];
}

/** @param {import('./panel.js').FigureContext} context */
export function createSpectrum(context) {
  const { catalog, actions, now } = context;
  const choices = createChoices(actions, {
    plot_of: [
      "Quantity",
      { nk: "n and k", F0: ["R at 0°", "reflectance at normal incidence from vacuum"] },
    ],
    reach: ["Wavelengths", { visible: "visible", all: ["all", "all that is known"] }],
    lambda_axis: ["Wavelength axis", { linear: "linear", log: "log" }],
  });
  const rivals = createChoice({
    legend: "Rivals",
    several: true,
    items: [{ value: "shown", label: "rivals", note: "other measurements of the same material" }],
    onChange: (values) => actions.set({ rivals: values.length ? "shown" : "hidden" }),
  });
  const frame = h("div", { class: "frame" });
  /** @type {any} */
  let spectrum = null;
  const panel = createPanel(context, {
    title: "Over the wavelength",
    name: "spectrum",
    controls: [...Object.values(choices.elements), rivals.element],
    frames: [h("div", { class: "plot-host" }, frame)],
    figures: () => [plot],
    what: () => (now().plot_of === "F0" ? "F0" : "n-k"),
    call: "/spectrum",
    presets: () => sources.map(({ material }) => material.id),
  });
  const plot = createPlot(frame, {
    name: "n and k over the wavelength",
    x: { title: "wavelength λ (nm)", range: VISIBLE },
    y: { title: "n, k", range: null },
    filename: "material-spectrum",
    onPick(x, { settled }) {
      if (!spectrum) return;
      const [low, high] = bothKnown(spectrum);
      const at = Number(Math.min(Math.max(x, low), high).toPrecision(4));
      actions.set({ at_nm: Math.min(Math.max(at, low), high) }, { history: "replace" });
      if (settled) actions.settle();
    },
  });
  let drawn = "";
  /** @type {{material: {id: string}}[]} the spectra that are drawn */
  let sources = [];
  /** @type {Trace[]} */
  let traces = [];

  return {
    ...panel,
    /** @param {State} state @param {Record<string, any>} answers @param {number | null} at */
    update(state, answers, at) {
      choices.update(state);
      rivals.update(state.rivals === "shown" ? ["shown"] : []);
      const others = rivalsOf(catalog, state.preset).filter(
        (id) => presetOf(catalog, id)?.kind === "spectrum",
      );
      rivals.element.hidden = others.length === 0;
      if (answers.spectrum?.material.id !== state.preset) return;
      spectrum = answers.spectrum;
      const measured =
        state.rivals === "shown"
          ? others.flatMap((id) => (answers[`rival:${id}`] ? [answers[`rival:${id}`]] : []))
          : [];
      const look = JSON.stringify([state.plot_of, state.reach, state.lambda_axis]);
      const all = [spectrum, ...measured];
      const same = all.length === sources.length && all.every((a, i) => a === sources[i]);
      if (look !== drawn || !same) {
        drawn = look;
        sources = all;
        draw(state, spectrum, measured);
      }
      plot.marker(
        at,
        at === null ? [] : traces.slice(0, 2).map((t) => ({ id: t.id, y: valueAt(t, at) })),
      );
    },
  };

  /** @param {State} state @param {any} own @param {any[]} measured */
  function draw(state, own, measured) {
    const range = shownRange(own, state);
    const log = state.lambda_axis === "log";
    // The axis goes on a little beyond what is known, so that one sees where that ends.
    const more = log ? (range[1] / range[0]) ** 0.02 : 0.02 * (range[1] - range[0]);
    const wide = /** @type {[number, number]} */ (
      state.reach === "visible"
        ? range
        : log
          ? [range[0] / more, range[1] * more]
          : [Math.max(range[0] - more, 0), range[1] + more]
    );
    /** @param {any} answer @param {'n' | 'k' | 'F0'} key */
    const series = (answer, key) => within(known(answer.wavelength_nm, answer[key] ?? []), range);
    const asF0 = state.plot_of === "F0";
    const keys = /** @type {('n' | 'k' | 'F0')[]} */ (asF0 ? ["F0"] : ["n", "k"]);
    /** @type {Record<string, Partial<Trace>>} */
    const styles = {
      n: { color: "--n", dash: "solid", width: 2.4 },
      k: { color: "--k", dash: "dash", width: 2.4 },
      F0: { color: "--R", dash: "solid", width: 2.6 },
    };
    const name = presetOf(catalog, state.preset);
    traces = keys
      .map((key) => ({
        id: key,
        label: asF0 ? shortName(name) : key,
        ...series(own, key),
        .../** @type {{color: string}} */ (styles[key]),
      }))
      .filter((t) => t.x.length > 1);
    if (asF0)
      measured.forEach((answer, i) => {
        const other = presetOf(catalog, answer.material.id);
        traces.push({
          id: answer.material.id,
          label: shortName(other),
          ...series(answer, "F0"),
          color: `--model-${(i % 8) + 1}`,
          dash: RIVAL_DASHES[i % RIVAL_DASHES.length] ?? "dot",
          width: 1.3,
        });
      });
    const bands = measured.length
      ? keys.map((key) => ({
          id: key,
          ...spanned(
            [own, ...measured].map((one) => series(one, key)),
            range,
            STEPS,
            log,
          ),
          color: styles[key]?.color ?? "--R",
        }))
      : [];
    const highest = Math.max(0, ...traces.flatMap((t) => t.y.map((v) => v ?? 0)));
    plot.axes({
      name: `${asF0 ? "Reflectance at normal incidence" : "n and k"} of ${name?.name} over the wavelength`,
      x: {
        title: "wavelength λ (nm)",
        short: "λ",
        column: "wavelength_nm",
        unit: " nm",
        range: wide,
        ...(log && { scale: /** @type {const} */ ("log") }),
        steps: { step: 5, fine: 0.5, page: 50 },
      },
      y: {
        title: asF0 ? "reflectance at 0°" : "n, k",
        range: asF0 && highest > 0.4 ? [0, 1] : null,
      },
    });
    void plot.draw(traces, limits(own, wide), bands);
    const names = measured.map((one) => shortName(presetOf(catalog, one.material.id)));
    const k = own.k_range_nm ? "" : " k is not given.";
    const points =
      own.native?.n.kind === "points" ? `${own.native.n.wavelength_nm.length} points` : "a formula";
    panel.filled(
      `n is known for ${stretch(own.n_range_nm)} from ${points}.${k}${
        names.length ? ` The bands span ${names.join(", ")} and this one.` : ""
      } Drag to read at another wavelength.`,
    );
  }
}

/** Where everything that is given at all is known. @param {any} spectrum @returns {[number, number]} */
export function bothKnown({ n_range_nm, k_range_nm }) {
  if (!k_range_nm) return n_range_nm;
  return [Math.max(n_range_nm[0], k_range_nm[0]), Math.min(n_range_nm[1], k_range_nm[1])];
}

/** Marks where the data begin and end, as far as that is on the axis. @param {any} spectrum @param {readonly [number, number]} range */
export function limits({ n_range_nm, k_range_nm }, [low, high]) {
  const same = !k_range_nm || (k_range_nm[0] === n_range_nm[0] && k_range_nm[1] === n_range_nm[1]);
  const ranges = same
    ? [{ sign: "", range: n_range_nm }]
    : [
        { sign: "n ", range: n_range_nm },
        { sign: "k ", range: k_range_nm },
      ];
  return ranges.flatMap(({ sign, range }) =>
    /** @type {const} */ ([
      [0, "from"],
      [1, "to"],
    ])
      .filter(([end]) => range[end] > low && range[end] < high)
      .map(([end, word]) => ({
        x: range[end],
        label: `${sign}${word} ${stretch([range[end], range[end]])}`,
        kind: /** @type {const} */ ("landmark"),
      })),
  );
}
