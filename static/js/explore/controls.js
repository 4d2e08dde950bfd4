/** The controls of the Explore view, made from the declared parameters. */

import { createMedia } from "../controls/media.js";
import { createChoice, createSheet } from "../controls/panel.js";
import { createRow } from "../controls/row.js";
import { modelStyle, sample } from "../models/look.js";
import { evaluateAngle } from "../numbers/entry.js";
import { angle, inDegrees, inUnit, plain } from "../numbers/format.js";
import { h, setText, symbol } from "../page/dom.js";

/**
 * @typedef {Pick<import('../controls/row.js').RowOptions, 'label' | 'range' | 'wide' | 'steps'>} Manner
 */

/** How the parameters of the surface are moved; what they may be is declared by the server. @type {Record<string, Manner>} */
const MANNERS = {
  n_i: {
    label: "incident index",
    range: [1, 3],
    wide: [0.1, 10],
    steps: { step: 0.01, fine: 0.001, page: 0.1 },
  },
  n_t: {
    label: "second index",
    range: [1, 3],
    wide: [0.1, 10],
    steps: { step: 0.01, fine: 0.001, page: 0.1 },
  },
  k_t: {
    label: "extinction",
    range: [0, 5],
    wide: [0, 20],
    steps: { step: 0.01, fine: 0.001, page: 0.1 },
  },
  theta_i_deg: {
    label: "angle of incidence",
    range: [0, 90],
    steps: { step: 0.5, fine: 0.05, page: 5 },
  },
};
export const ANGLE_STEPS = { step: 0.5, fine: 0.05, page: 5 };

/**
 * @param {object} options
 * @param {Catalog} options.catalog
 * @param {State} options.presets the state's defaults
 * @param {() => State} options.state
 * @param {Actions} options.actions
 * @param {() => Promise<void>} options.describeMedia
 */
export function createControls({ catalog, presets, state, actions, describeMedia }) {
  const unit = () => state().angle;
  /** A value of one's own is no preset any more. @type {Record<string, string>} */
  const preset = { n_i: "incident", n_t: "material", k_t: "material" };

  /** @param {string} name @param {number | null} value @param {boolean} moving */
  function change(name, value, moving) {
    /** @type {State} */
    const patch = { [name]: value };
    const side = preset[name];
    if (side) patch[side] = null;
    actions.set(patch, { history: moving ? "replace" : "push" });
  }

  /** @param {Parameter} parameter @param {Manner} manner @param {string} [name] */
  function row(parameter, manner, name = parameter.name) {
    const isAngle = parameter.unit === "deg";
    return createRow({
      parameter: { ...parameter, name },
      preset: presets[name],
      ...manner,
      onChange: (value, moving) => change(name, value, moving),
      onSettle: actions.settle,
      ...(isAngle && {
        writing: {
          print: (/** @type {number} */ v) =>
            unit() === "rad" ? angle(v, "rad") : `${plain(v, 6)}°`,
          end: (/** @type {number} */ v) =>
            unit() === "rad" ? `${plain(inUnit(v, "rad"), 4)}\u00a0rad` : `${plain(v)}°`,
          parse(/** @type {string} */ text) {
            const typed = evaluateAngle(text, unit());
            return inDegrees(typed.value, typed.unit);
          },
          allowed: () =>
            `${angle(parameter.minimum, unit())} to ${angle(parameter.maximum, unit())}`,
        },
      }),
    });
  }

  const rows = new Map(
    catalog.parameters
      .filter((p) => p.name in MANNERS)
      .map((p) => [p.name, row(p, /** @type {Manner} */ (MANNERS[p.name]))]),
  );

  const media = createMedia({
    materials: catalog.materials,
    describe: describeMedia,
    actions,
    onPick(side, id) {
      const material = catalog.materials.find((m) => m.id === id);
      if (!material) return;
      actions.set({ [side]: id });
    },
    onSwap() {
      const { n_i, n_t, incident, material } = state();
      actions.set({ n_i: n_t, n_t: n_i, incident: material, material: incident });
    },
  });
  const polarization = createChoice({
    legend: "Polarization",
    items: [
      { value: "s", label: "s" },
      { value: "p", label: "p" },
      { value: "unpolarized", label: "unpolarized" },
    ],
    onChange: ([value]) => actions.set({ polarization: value }),
  });
  const angles = createChoice({
    legend: "Angles",
    items: [
      { value: "deg", label: "degrees" },
      { value: "rad", label: "radians" },
    ],
    onChange: ([value]) => actions.set({ angle: value }),
  });
  const show = createChoice({
    legend: "Overlay",
    several: true,
    items: [
      { value: "T", label: "T", content: symbol("T"), note: "transmittance" },
      { value: "phase", label: "phases", note: "phases of r_s and r_p" },
      { value: "white", label: "white light", note: "refracted rays at several wavelengths" },
      {
        value: "marks",
        label: "marks",
        note: "Brewster's, the critical, the pseudo-Brewster and the principal angle",
      },
    ],
    onChange: (picked) =>
      actions.set({
        show: picked.filter((p) => p !== "marks" && p !== "white"),
        light: picked.includes("white") ? "white" : "one",
        marks: picked.includes("marks") ? "on" : "off",
      }),
  });
  const overlays = ["approximation", "exact"]
    .map((kind) => {
      const models = catalog.models.filter((m) => m.kind === kind && m.id !== "exact");
      const legend = kind === "exact" ? "Equivalent exact forms" : "Approximations";
      const group = createChoice({
        legend,
        several: true,
        listed: true,
        items: models.map((m) => ({
          value: m.id,
          label: m.title,
          note: m.validity,
          content: h(
            "span",
            { class: "overlay-name" },
            sample(modelStyle(catalog.models, m.id)),
            m.title,
          ),
        })),
        onChange(picked) {
          const others = state().models.filter(
            (/** @type {string} */ id) => !models.some((m) => m.id === id),
          );
          actions.set({ models: [...others, ...picked] });
        },
      });
      const count = h("span", { class: "count" });
      const box = h(
        "details",
        { class: "forms", open: kind === "approximation" },
        h("summary", {}, legend, count),
        group.element,
      );
      return { models, group, box, count };
    })
    .filter(({ models }) => models.length > 0);
  const ownPlace = h("div");
  /** @type {ReturnType<typeof import("../controls/parameters.js").createParameters> | null} */
  let own = null;

  /** Rows for the models' parameters, once one of the models shown has any. */
  function updateOwn() {
    const { models } = state();
    if (own) own.update(state(), models);
    else if (catalog.models.some((m) => models.includes(m.id) && m.parameters.length > 0))
      void import("../controls/parameters.js").then(({ createParameters }) => {
        own ??= createParameters({ models: catalog.models, state, actions });
        ownPlace.replaceWith(own.element);
        updateOwn();
      });
  }

  const body = h(
    "div",
    { class: "panel-body" },
    h("div", { class: "heading" }, h("h2", {}, "Media")),
    media.element,
    h("div", { class: "rows" }, ...[...rows.values()].map((r) => r.element)),
    h(
      "div",
      { class: "choices" },
      polarization.element,
      angles.element,
      show.element,
      ...overlays.map((o) => o.box),
      ownPlace,
    ),
  );
  const pages = [...rows].map(([name, row]) => ({
    name,
    symbol: catalog.parameters.find((p) => p.name === name)?.symbol ?? name,
    row,
    print() {
      const now = state();
      return name === "theta_i_deg"
        ? angle(now[name], now.angle, now.angle === "deg" ? 1 : 3)
        : plain(now[name], 4);
    },
  }));
  const sheet = createSheet({ pages, body, first: "theta_i_deg" });

  return {
    element: sheet.element,
    stop() {
      media.stop();
      for (const r of rows.values()) r.stop();
      own?.stop();
    },
    /**
     * @param {State} now
     * @param {Landmark[]} landmarks
     * @param {Map<string, string>} reasons why a model is outside its domain here
     */
    update(now, landmarks, reasons) {
      media.update(now);
      /** @type {Record<string, {value: number, label: string}[]>} */
      const marks = {
        n_i: [{ value: now.n_t, label: "equal to n_t" }],
        n_t: [{ value: now.n_i, label: "equal to n_i" }],
        theta_i_deg: landmarks.map((l) => ({ value: l.deg, label: l.label })),
      };
      for (const [name, row] of rows) row.update(now[name], marks[name] ?? []);
      sheet.update();
      polarization.update([now.polarization]);
      angles.update([now.angle]);
      show.update([
        ...now.show,
        ...(now.light === "white" ? ["white"] : []),
        ...(now.marks === "on" ? ["marks"] : []),
      ]);
      for (const { group, models, count } of overlays) {
        group.update(now.models, reasons);
        const chosen = models.filter((m) => now.models.includes(m.id)).length;
        setText(count, chosen ? ` ${chosen} of ${models.length}` : ` ${models.length}`);
      }
      updateOwn();
    },
  };
}
