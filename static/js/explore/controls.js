/** The controls of the Explore view, made from the declared parameters. */

import {
  ANGLE_STEPS,
  angleWriting,
  createChoice,
  createChoices,
  createFold,
  createRow,
  createSheet,
} from "../controls/panel.js";
import { createInterface } from "../media/media.js";
import { forMedium, modelStyle } from "../models/look.js";
import { angle } from "../numbers/format.js";
import { h, symbol } from "../page/dom.js";
import { chosenModels } from "../state/state.js";
import { createTerm } from "./term.js";

/** @param {ControlsOptions} options */
export function createControls({ catalog, presets, state, actions, describeMedia, say }) {
  /** @param {string} name @param {Node} heading */
  const term = (name, heading) => createTerm(name, heading, say);
  const { rows, media } = createInterface({
    catalog,
    presets,
    state,
    actions,
    prefix: "",
    term,
    describeMedia,
  });
  const declared = catalog.parameters.find((p) => p.name === "theta_i_deg");
  if (declared) {
    const { name, symbol: letter, minimum, maximum } = declared;
    const unit = () => state().angle;
    const row = createRow({
      parameter: declared,
      preset: presets[name],
      label: "angle of incidence",
      term: term(name, symbol(letter)),
      range: [0, 90],
      steps: ANGLE_STEPS,
      onChange: (value, moving) =>
        actions.set({ [name]: value }, { history: moving ? "replace" : "push" }),
      onSettle: actions.settle,
      writing: angleWriting(() => `${angle(minimum, unit())} to ${angle(maximum, unit())}`, unit),
    });
    const print = () => angle(state()[name], unit(), unit() === "deg" ? 1 : 3);
    rows.push({ name, symbol: letter, row, print });
  }

  const choices = createChoices(actions, {
    polarization: ["Polarization", { s: "s", p: "p", unpolarized: "unpolarized" }],
    angle: ["Angles", { deg: "degrees", rad: "radians" }],
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
  const overlays = ["approximation", "exact"].flatMap((kind) => {
    const models = catalog.models.filter((m) => m.kind === kind && m.id !== "exact");
    if (models.length === 0) return [];
    return createFold({
      legend: kind === "exact" ? "Equivalent exact forms" : "Approximations",
      entries: models.map(({ id, title, validity }) => ({
        id,
        title,
        note: validity,
        style: modelStyle(catalog.models, id),
      })),
      chosen: () =>
        chosenModels(state()).filter(
          (/** @type {string} */ id) => !models.some((m) => m.id === id),
        ),
      onChange: (ids) => actions.set({ models: ids.length ? ids : null }),
    });
  });
  /** @type {Set<typeof overlays[number]>} */
  const unfolded = new Set();
  const ownPlace = h("div");
  /** @type {ReturnType<typeof import("../controls/parameters.js").createParameters> | null} */
  let own = null;

  /** Rows for the models' parameters, once one of the models shown has any. */
  function updateOwn() {
    const models = chosenModels(state());
    if (own) own.update(state(), models);
    else if (catalog.models.some((m) => models.includes(m.id) && m.parameters.length > 0))
      void import("../controls/parameters.js").then(({ createParameters }) => {
        own ??= createParameters({ models: catalog.models, state, actions });
        ownPlace.replaceWith(own.element);
        updateOwn();
      });
  }

  const body = h(
    "div.panel-body",
    h("div.heading", h("h2", "Media")),
    media.element,
    h("div.rows", ...rows.map(({ row }) => row.element)),
    h(
      "div.choices",
      choices.elements.polarization,
      choices.elements.angle,
      show.element,
      ...overlays.map((o) => o.element),
      ownPlace,
    ),
  );
  const sheet = createSheet({ pages: rows, body, first: "theta_i_deg" });

  return {
    element: sheet.element,
    stop() {
      media.stop();
      for (const { row } of rows) row.stop();
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
      for (const { name, row } of rows) row.update(now[name], marks[name] ?? []);
      sheet.update();
      choices.update(now);
      show.update([
        ...now.show,
        ...(now.light === "white" ? ["white"] : []),
        ...(now.marks === "on" ? ["marks"] : []),
      ]);
      for (const fold of overlays) {
        // Folded until a link, or a hand, has chosen of it; then whoever folds it has it so.
        if (
          fold.update(chosenModels(now), reasons, forMedium(catalog.models, now.k_t)) &&
          !unfolded.has(fold)
        ) {
          fold.element.open = true;
          unfolded.add(fold);
        }
      }
      updateOwn();
    },
  };
}
