/** Albedo: the exact values, every fit beside them, how wrong each is, and paint under a coat. */

import { sideOf } from "../albedo/answers.js";
import { createClaims } from "../albedo/claims-table.js";
import { createControls } from "../albedo/controls.js";
import { albedoFields, chosenFits, facing, isMetal } from "../albedo/fields.js";
import { createMap } from "../albedo/map.js";
import { createPlots } from "../albedo/plots.js";
import { createReading, direction } from "../albedo/reading.js";
import { createCoat } from "../coat/coat.js";
import { createDefinitions } from "../models/definitions.js";
import { six } from "../numbers/format.js";
import { h } from "../page/dom.js";
import { loadStyle } from "../page/style.js";

export { queries, restCalls } from "../albedo/queries.js";
export const fields = albedoFields;

/**
 * @typedef {import('../albedo/answers.js').Fit} Fit
 */

await Promise.all(
  ["heatmap", "albedo", "albedo-coat", "albedo-claims"].map((name) => loadStyle(`css/${name}.css`)),
);

/** @param {ViewContext} context */
export function createView({
  element,
  catalog,
  presets,
  state,
  actions,
  say,
  save,
  describeMedia,
  typeset,
}) {
  const controls = createControls({ catalog, presets, state, actions, describeMedia });
  const coat = createCoat({ presets, state, actions, save, say });
  const reading = createReading(say);
  const claims = createClaims({
    say,
    onSort: (by, order) => actions.set({ claims_by: by, claims_order: order }),
    onPick(id, surface) {
      const { surface: here, k_t } = state();
      const chosen = chosenFits(state());
      const others = chosen.filter((other) => other !== id);
      const there = here === surface;
      actions.set({
        surface,
        fits: Object.freeze(there && chosen.includes(id) ? others : there ? [...others, id] : [id]),
        ...(!there && { sweep_low: null, sweep_high: null }),
        ...(isMetal(surface) && k_t === 0 && { k_t: 3, material: null }),
      });
    },
  });
  const formulas = h("div", {});

  element.append(controls.element);
  const plots = createPlots(element, { actions, save });
  const map = createMap(element, { actions, state, save });
  element.append(
    h(
      "section",
      { class: "column here", "aria-label": "This interface" },
      h("div", { class: "heading" }, h("h2", {}, "This interface")),
      reading.element,
    ),
    coat.element,
    h(
      "section",
      { class: "column claimed", "aria-label": "Claimed and measured" },
      h("div", { class: "heading" }, h("h2", {}, "Claimed and measured"), claims.copy),
      claims.element,
      formulas,
    ),
  );

  /** @type {Record<string, {title: string, lines: string[]}>} what went wrong, by the query's name */
  const problems = {};
  /** @type {Record<string, any>} */
  let before = {};
  /** @type {ReturnType<typeof createDefinitions> | null} */
  let definitions = null;

  /** @param {readonly Fit[]} fits */
  function define(fits) {
    definitions = createDefinitions(
      fits.map((fit) => ({
        id: fit.id,
        title: fit.title,
        latex: fit.latex,
        validity: fit.note,
        reference: fit.reference,
        kind: "approximation",
        applies_to: [],
        parameters: [],
        cost: {},
      })),
      typeset,
    );
    formulas.replaceChildren(definitions.element);
  }

  return {
    /** @param {State} now @param {Record<string, any>} answers @param {boolean} moving */
    update(now, answers, moving) {
      for (const name of Object.keys(problems))
        if (answers[name] !== before[name]) delete problems[name];
      /** @type {readonly Fit[]} */
      const fits = answers.fits?.fits ?? [];
      if (fits.length && answers.fits !== before.fits) define(fits);
      before = answers;
      controls.update(now, fits);
      plots.update(now, answers, fits, moving, problems.sweep);
      reading.update(now, answers.here, fits);
      coat.update(now, answers.coat, problems.coat);
      if (moving) return;
      definitions?.update([...chosenFits(now)]);
      map.update(now, answers.map, fits, problems.map);
      if (fits.length)
        claims.update(fits, {
          by: now.claims_by,
          order: now.claims_order,
          chosen: chosenFits(now),
          surface: now.surface,
        });
    },

    /** @param {State} now @param {Record<string, any>} answers */
    sentence(now, answers) {
      /** @type {import('../albedo/answers.js').Here | undefined} */
      const here = answers.here;
      if (!here) return "";
      const forward = isMetal(now.surface) || facing(now);
      const side = sideOf(here, forward);
      const off = chosenFits(now).flatMap((id) => {
        const found = side.approximations.find((a) => a.id === id);
        return found?.error == null ? [] : [`${found.title} is off by ${six(found.error)}`];
      });
      const way = direction(here.interface, !forward && here.reverse !== null);
      return `Albedo ${way}: ${six(side.exact.unpolarized)}. ${off.join(", ")}`;
    },

    /** @param {string} name @param {{title: string, lines: string[]}} problem */
    problem(name, problem) {
      const fits = before.fits?.fits ?? [];
      if (name === "sweep") plots.update(state(), before, fits, false, problem);
      else if (name === "map") map.update(state(), before.map, fits, problem);
      else if (name === "coat") coat.update(state(), before.coat, problem);
      else return false;
      problems[name] = problem;
      return true;
    },

    theme() {
      plots.theme();
      map.theme();
    },
    deactivate() {
      controls.stop();
      coat.stop();
    },
    destroy() {
      controls.stop();
      coat.stop();
      coat.destroy();
      plots.destroy();
      map.destroy();
    },
  };
}
