/** n and k over the wavelength, with what rival measurements span, or the reflectance that follows. */

import { createChoice, createChoices } from "../controls/panel.js";
import { createField, indices } from "../media/media.js";
import { stretch } from "../media/wavelength.js";
import { createChanged } from "../page/changed.js";
import { h } from "../page/dom.js";
import { createPlot } from "../plot/plot.js";
import { known, spanned, valueAt, within } from "./band.js";
import { createPanel } from "./panel.js";
import { presetOf, rivalsOf } from "./queries.js";

/** Where colors are computed from. @type {[number, number]} */
const VISIBLE = [360, 830];
const LEAST_SEEN = 40; // nm of it that a material has to be known at, to be shown there
const STEPS = 240;
const RIVAL_DASHES = ["dash", "dot", "dashdot", "longdash", "longdashdot", "8px 3px 2px 3px"];

/** How the measurement that is shown looks. */
const LOOKS = {
  n: { color: "--n", dash: "solid", width: 2.4 },
  k: { color: "--k", dash: "dash", width: 2.4 },
  F0: { color: "--R", dash: "solid", width: 2.6 },
};

/** What distinguishes a measurement from others of the material. @param {{id: string, name: string, rival_of: string | null} | undefined} preset */
export function shortName(preset) {
  if (!preset) return "";
  const own = preset.rival_of === null ? null : /\(([^()]*)\)$/.exec(preset.name);
  return own?.[1] ?? preset.name;
}

/** The part of the wavelengths that the axis shows. @param {any} spectrum @param {State} state @returns {[number, number]} */
export function shownRange(spectrum, { reach }) {
  const ends = [spectrum.n_range_nm, spectrum.k_range_nm].filter(Boolean);
  const [low, high] = [Math.min(...ends.map((r) => r[0])), Math.max(...ends.map((r) => r[1]))];
  const seen = Math.min(high, VISIBLE[1]) - Math.max(low, VISIBLE[0]);
  return reach === "visible" && seen > LEAST_SEEN ? VISIBLE : [low, high];
}

/** A little beyond what is known, so that one sees where that ends. @param {[number, number]} range @param {boolean} log @returns {[number, number]} */
function widened([low, high], log) {
  const more = log ? (high / low) ** 0.02 : 0.02 * (high - low);
  return log ? [low / more, high * more] : [Math.max(low - more, 0), high + more];
}

/** @param {import('./panel.js').FigureContext} context */
export function createSpectrum(context) {
  const { catalog, actions, now, describeMedia } = context;
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
  const beside = createField({
    label: "Another material beside it",
    placeholder: "none",
    materials: catalog.materials,
    note: indices,
    refusal: ({ kind }) => (kind === "spectrum" ? null : "one index: it has no curve"),
    describe: describeMedia,
    onPick(id) {
      if (catalog.materials.some((m) => m.id === id)) actions.set({ beside: id });
      else window.dispatchEvent(new CustomEvent("ownmaterial", { detail: "material" }));
    },
  });
  const alone = h(
    "button.quiet",
    { type: "button", onclick: () => actions.set({ beside: null }) },
    "alone",
  );
  const row = h("span.beside-row", h("span", "beside"), beside.element, alone);
  const frame = h("div.frame");
  /** @type {any} */
  let spectrum = null;
  const panel = createPanel(context, {
    title: "Over the wavelength",
    name: "spectrum",
    controls: [...Object.values(choices.elements), rivals.element, row],
    frames: [h("div.plot-host", frame)],
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
  const changed = createChanged();
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
      beside.show({ id: state.beside, like: null });
      alone.hidden = state.beside === null;
      const others = rivalsOf(catalog, state.preset, state.beside).filter(
        (id) => presetOf(catalog, id)?.kind === "spectrum",
      );
      rivals.element.hidden = others.length === 0;
      if (answers.spectrum?.material.id !== state.preset) return;
      spectrum = answers.spectrum;
      const measured =
        state.rivals === "shown"
          ? others.flatMap((id) => (answers[`rival:${id}`] ? [answers[`rival:${id}`]] : []))
          : [];
      sources = [spectrum, ...measured];
      if (changed(state.plot_of, state.reach, state.lambda_axis, ...sources))
        draw(state, spectrum, measured);
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
    const wide = range === VISIBLE ? range : widened(range, log);
    const asF0 = state.plot_of === "F0";
    const keys = /** @type {('n' | 'k' | 'F0')[]} */ (asF0 ? ["F0"] : ["n", "k"]);
    /** @param {any} answer @param {'n' | 'k' | 'F0'} key */
    const series = (answer, key) => within(known(answer.wavelength_nm, answer[key] ?? []), range);
    /** @param {any} answer */
    const nameOf = ({ material }) => shortName(presetOf(catalog, material.id));
    traces = keys
      .map((key) => ({
        ...{ id: key, label: asF0 ? nameOf(own) : key },
        ...series(own, key),
        ...LOOKS[key],
      }))
      .filter((t) => t.x.length > 1);
    if (asF0)
      measured.forEach((answer, i) => {
        traces.push({
          ...{ id: answer.material.id, label: nameOf(answer) },
          ...series(answer, "F0"),
          color: `--model-${(i % 8) + 1}`,
          dash: RIVAL_DASHES[i % RIVAL_DASHES.length] ?? "dot",
          width: 1.3,
        });
      });
    const family = new Set([state.beside, ...rivalsOf(catalog, state.beside ?? "")]);
    const [others, rivals] = [true, false].map((is) =>
      measured.filter(({ material }) => family.has(material.id) === is),
    );
    const set = measured.find(({ material }) => material.id === state.beside);
    if (set && !asF0)
      for (const key of keys)
        traces.push({
          ...{ id: `${key}_${set.material.id}`, label: `${key} ${nameOf(set)}` },
          ...series(set, key),
          ...{ color: LOOKS[key].color, dash: "dot", width: 1.4 },
        });
    /** What some measurements span. @param {string} name @param {any[]} among */
    const bandsOf = (name, among) =>
      keys.map((key) => ({
        id: `${key}${name}`,
        ...spanned(
          among.map((one) => series(one, key)),
          range,
          STEPS,
          log,
        ),
        color: LOOKS[key].color,
      }));
    const bands = [
      ...(rivals?.length ? bandsOf("", [own, ...rivals]) : []),
      ...(others && others.length > 1 ? bandsOf("_beside", others) : []),
    ];
    const highest = Math.max(0, ...traces.flatMap((t) => t.y.map((v) => v ?? 0)));
    const name = presetOf(catalog, state.preset)?.name;
    plot.axes({
      name: `${asF0 ? "Reflectance at normal incidence" : "n and k"} of ${name} over the wavelength`,
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
    const k = own.k_range_nm ? "" : " k is not given.";
    const points =
      own.native?.n.kind === "points" ? `${own.native.n.wavelength_nm.length} points` : "a formula";
    const spans = [
      rivals?.length && ` The bands span ${rivals.map(nameOf).join(", ")} and this one.`,
      set && ` Dotted: ${nameOf(set)}`,
      set &&
        (others && others.length > 1 ? `, in the band of ${others.length} measurements.` : "."),
    ];
    const span = spans.filter(Boolean).join("");
    panel.filled(
      `n is known for ${stretch(own.n_range_nm)} from ${points}.${k}${span} Drag to read at another wavelength.`,
    );
  }
}

/** Where everything that is given at all is known. @param {any} spectrum @returns {[number, number]} */
export function bothKnown({ n_range_nm: n, k_range_nm: k }) {
  return k ? [Math.max(n[0], k[0]), Math.min(n[1], k[1])] : n;
}

/** Marks where the data begin and end, as far as that is on the axis. @param {any} spectrum @param {readonly [number, number]} range @returns {Mark[]} */
export function limits({ n_range_nm: n, k_range_nm: k }, [low, high]) {
  const same = !k || (k[0] === n[0] && k[1] === n[1]);
  const own = same
    ? { from: n[0], to: n[1] }
    : { "n from": n[0], "n to": n[1], "k from": k[0], "k to": k[1] };
  return Object.entries(own)
    .filter(([, x]) => x > low && x < high)
    .map(([words, x]) => ({ x, label: `${words} ${stretch([x, x])}`, kind: "landmark" }));
}
