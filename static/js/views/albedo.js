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
import { createChanged } from "../page/changed.js";
import { h } from "../page/dom.js";
import { loadStyles } from "../page/style.js";
import { createProblems } from "../page/trouble.js";

export { queries, restCalls } from "../albedo/queries.js";
export const fields = albedoFields;

/**
 * @typedef {import('../albedo/answers.js').Fit} Fit
 */

await loadStyles("heatmap", "pair", "albedo", "albedo-coat", "albedo-claims");

/** @param {ViewContext} context */
export function createView(context) {
  const { element, state, say, typeset } = context;
  const controls = createControls(context);
  const coat = createCoat(context);
  const reading = createReading(say);
  const claims = createClaims(context);
  const formulas = h("div");

  element.append(controls.element);
  const plots = createPlots(context);
  const map = createMap(context);
  element.append(
    h(
      "section.column.here",
      { "aria-label": "This interface" },
      h("div.heading", h("h2", "This interface")),
      reading.element,
    ),
    coat.element,
    h(
      "section.column.claimed",
      { "aria-label": "Claimed and measured" },
      h("div.heading", h("h2", "Claimed and measured"), claims.copy),
      claims.element,
      formulas,
    ),
  );

  const problems = createProblems(["sweep", "map", "coat"]);
  /** @type {Record<string, any>} */
  let given = {};
  /** @type {ReturnType<typeof createDefinitions> | null} */
  let definitions = null;
  const newFits = createChanged();

  /** @param {readonly Fit[]} fits */
  function define(fits) {
    definitions = createDefinitions(
      fits.map((fit) => ({
        ...fit,
        validity: fit.note,
        kind: "approximation",
        applies_to: [],
        parameters: [],
        cost: {},
      })),
      typeset,
    );
    formulas.replaceChildren(definitions.element);
  }

  /** @param {State} now @param {boolean} moving */
  function show(now, moving) {
    /** @type {readonly Fit[]} */
    const fits = given.fits?.fits ?? [];
    if (fits.length && newFits(fits)) define(fits);
    /** @param {string} name */
    const problem = (name) => problems.of(name, given);
    controls.update(now, fits);
    plots.update(now, given, fits, moving, problem("sweep"));
    reading.update(now, given.here);
    coat.update(now, given.coat, problem("coat"));
    if (moving) return;
    definitions?.update([...chosenFits(now)]);
    map.update(now, given.map, fits, problem("map"));
    if (fits.length) claims.update(fits, now);
  }

  return {
    /** @param {State} now @param {Record<string, any>} answers @param {boolean} moving */
    update(now, answers, moving) {
      given = answers;
      show(now, moving);
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

    /** @param {string} name @param {import('../page/trouble.js').Problem} problem */
    problem(name, problem) {
      const told = problems.add(name, problem, given);
      if (told) show(state(), false);
      return told;
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
