/** Compare: exact against the models, how wrong each is and where, and which will do. */

import { createControls } from "../compare/controls.js";
import { createConvert } from "../compare/convert.js";
import { createNamedExamples } from "../compare/examples.js";
import { against, compareFields, figureOf, withCode } from "../compare/fields.js";
import { createFigure } from "../compare/figure.js";
import { createPlots } from "../compare/plots.js";
import { bare, later, queries, restCalls } from "../compare/queries.js";
import { createRecommend } from "../compare/recommend.js";
import { createTable, errorsOf } from "../compare/table.js";
import { short } from "../errors/metrics.js";
import { angle } from "../numbers/format.js";
import { loadStyles } from "../page/style.js";
import { createProblems } from "../page/trouble.js";
import { freshOf } from "../state/state.js";
import { createSnippets } from "../takeaway/code.js";
import { createTables } from "../takeaway/table.js";

export { later, queries, restCalls };
export const fields = compareFields;

/** @typedef {import('../errors/metrics.js').Row} Row */

await loadStyles("heatmap", "pair", "compare", "compare-errors", "convert");

const SETTLE_AFTER = 250; // ms

/** @param {ViewContext} context */
export function createView(context) {
  const { element, catalog, state, actions, say, save } = context;
  const { models } = catalog;
  const controls = createControls(context);
  const examples = createNamedExamples(context);
  element.append(controls.element, examples.element);
  const plots = createPlots(context);
  const figure = createFigure(context);
  const recommend = createRecommend(context);
  const convert = createConvert(context);
  const snippets = createSnippets({ models, actions, say, save });
  const table = createTable(context, plots.light);
  element.append(table.element, recommend.element, convert.element, snippets.element);
  const tables = createTables({ parent: element, catalog, actions });
  const pictures = [plots, figure, tables];

  const problems = createProblems(["recommend", "convert", "color", "shader", "lut"]);
  /** @type {Record<string, any>} */
  let given = {};
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let settling;

  /** The panels that stay as they are while something moves. @param {State} now */
  function rest(now) {
    /** @param {string} name */
    const problem = (name) => problems.of(name, given);
    const fresh = freshOf(given, later(now, catalog));
    figure.update(now, given);
    recommend.update(now, given.recommend, problem("recommend"));
    convert.update(now, given.convert, problem("convert"), fresh.color);
    snippets.update(now, withCode(now), fresh.shader, problem("shader"));
    tables.update(bare(now), withCode(now), fresh.lut, problem("lut"));
  }

  return {
    /** @param {State} now @param {Record<string, any>} answers @param {boolean} moving */
    update(now, answers, moving) {
      given = answers;
      controls.update(now, reasonsOf(answers.curves), solvedOf(answers.errors));
      const fresh = freshOf(answers, later(now, catalog));
      examples.update(now, fresh, moving);
      clearTimeout(settling);
      const map = figureOf(now).isMap && !moving;
      plots.update(now, answers, moving || map);
      // Settling two plots takes longer than a map: the map comes first.
      if (map) settling = setTimeout(() => plots.update(now, answers, false), SETTLE_AFTER);
      const stale = moving || (against(now).length > 0 && !fresh.errors);
      table.update(now, answers, plots.reading(now.theta_i_deg), stale);
      if (!moving) rest(now);
    },

    /** @param {State} now @param {Record<string, any>} answers */
    sentence(now, answers) {
      return errorsOf(now, answers)
        .map(
          (r) =>
            `${r.title}: largest error ${short(r.max_abs)} at ${angle(r.max_abs_at_deg, now.angle)}.`,
        )
        .join(" ");
    },

    /** @param {string} name @param {import('../page/trouble.js').Problem} problem */
    problem(name, problem) {
      const told = problems.add(name, problem, given);
      if (told) rest(state());
      return told;
    },

    theme() {
      for (const one of pictures) one.theme();
    },
    deactivate() {
      clearTimeout(settling);
      controls.stop();
    },
    destroy() {
      clearTimeout(settling);
      controls.stop();
      for (const one of pictures) one.destroy();
    },
  };
}

/** Why models are outside their domains here. @param {Curves | undefined} curves @returns {Map<string, string>} */
function reasonsOf(curves) {
  return new Map(
    curves?.curves.flatMap(({ model, reason }) =>
      reason && model !== "exact" ? [[model, reason]] : [],
    ),
  );
}

/** What the parameters left to the server came out as. @param {any} answer of /errors @returns {Map<string, number>} */
function solvedOf(answer) {
  /** @type {Row[]} */
  const rows = answer?.errors ?? [];
  return new Map(
    rows.flatMap((row) =>
      Object.entries(row.parameters ?? {}).flatMap(([name, value]) =>
        value === null ? [] : [[`${row.model}.${name}`, value]],
      ),
    ),
  );
}
