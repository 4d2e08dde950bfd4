/** Compare: exact against the models, how wrong each is and where, and which will do. */

import { createControls } from "../compare/controls.js";
import { createConvert } from "../compare/convert.js";
import { createExamples } from "../compare/examples.js";
import { compareFields, isMap, withCode } from "../compare/fields.js";
import { createFigure } from "../compare/figure.js";
import { createPlots } from "../compare/plots.js";
import { later, queries, restCalls } from "../compare/queries.js";
import { createRecommend } from "../compare/recommend.js";
import { createTable } from "../compare/table.js";
import { candidatesOf, rowsOf } from "../errors/answers.js";
import { short } from "../errors/metrics.js";
import { createDefinitions } from "../models/definitions.js";
import { angle } from "../numbers/format.js";
import { h } from "../page/dom.js";
import { loadStyle } from "../page/style.js";
import { freshOf } from "../server/questions.js";
import { createSnippets } from "../takeaway/code.js";
import { createTables } from "../takeaway/table.js";

export { later, queries, restCalls };
export const fields = compareFields;

await Promise.all(
  ["compare", "compare-errors", "convert", "heatmap"].map((name) => loadStyle(`css/${name}.css`)),
);

const SETTLE_AFTER = 250; // ms

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
  const { models } = catalog;
  const controls = createControls({
    catalog,
    presets,
    state,
    actions,
    describeMedia,
    family: /** @type {Field} */ (compareFields(catalog).family),
  });
  const examples = createExamples({ presets, actions });
  element.append(controls.element, examples.element);
  const plots = createPlots({ parent: element, models, actions, save });
  const figure = createFigure({ parent: element, catalog, actions, save });
  const recommend = createRecommend({ models, state, actions });
  const convert = createConvert({ state, actions });
  const snippets = createSnippets({ models, actions, say, save });
  const definitions = createDefinitions(models, typeset);
  const table = createTable({
    models,
    say,
    onSort: (by, order) => actions.set({ sort: by, order }),
    onLight: plots.light,
    onFocus: (model) => actions.set({ focus: state().focus === model ? null : model }),
  });

  element.append(
    h(
      "section",
      { class: "column metrics", "aria-label": "Errors" },
      h("div", { class: "heading" }, h("h2", {}, "Errors"), table.copy),
      table.element,
      definitions.element,
    ),
    recommend.element,
    convert.element,
    snippets.element,
  );
  const tables = createTables({ parent: element, catalog, actions });

  /** @type {Record<string, {title: string, lines: string[]}>} what went wrong, by the query's name */
  const problems = {};
  /** @type {Record<string, any>} */
  let before = {};
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let settling;

  return {
    /** @param {State} now @param {Record<string, any>} answers @param {boolean} moving */
    update(now, answers, moving) {
      for (const name of Object.keys(problems))
        if (answers[name] !== before[name]) delete problems[name];
      before = answers;
      const { curves, errors } = answers;
      const reasons = new Map(
        (curves?.curves ?? []).flatMap((/** @type {Curve} */ c) =>
          c.reason && c.model !== "exact" ? [[c.model, c.reason]] : [],
        ),
      );
      controls.update(now, reasons, solvedOf(answers.errors));
      definitions.update(now.against);
      const fresh = freshOf(answers, { ...queries(now, catalog), ...later(now, catalog) });
      const stale = moving || (now.against.length > 0 && !fresh.errors);
      examples.update(now, fresh, moving);
      clearTimeout(settling);
      const map = isMap(now.over) && !moving;
      plots.update(now, answers, moving || map);
      // Settling two plots takes longer than a map: the map comes first.
      if (map) settling = setTimeout(() => plots.update(now, answers, false), SETTLE_AFTER);
      const here = plots.reading(now.theta_i_deg);
      table.update(
        now.against.length ? rowsOf(errors).filter((r) => now.against.includes(r.model)) : [],
        {
          by: now.sort,
          order: now.order,
          focus: now.focus,
          unit: now.angle,
          here: (id) => short(here.get(id) ?? null),
          prices: prices(answers.recommend),
          at: angle(now.theta_i_deg, now.angle, now.angle === "deg" ? 1 : 3),
        },
        stale,
      );
      if (!moving) {
        figure.update(now, answers);
        recommend.update(now, answers.recommend, problems.recommend);
        convert.update(now, answers.convert, problems.convert);
        snippets.update(now, withCode(now), fresh.shader, problems.shader);
        tables.update(now, withCode(now), fresh.lut, problems.lut);
      }
    },

    /** @param {State} now @param {Record<string, any>} answers */
    sentence(now, answers) {
      const rows = rowsOf(answers.errors).filter((r) => now.against.includes(r.model));
      const titles = new Map(models.map((m) => [m.id, m.title]));
      return rows
        .map(
          (r) =>
            `${titles.get(r.model)}: largest error ${short(r.max_abs)} at ${angle(r.max_abs_at_deg, now.angle)}.`,
        )
        .join(" ");
    },

    /** @param {string} name @param {{title: string, lines: string[]}} problem */
    problem(name, problem) {
      if (!["recommend", "convert", "shader", "lut"].includes(name)) return false;
      problems[name] = problem;
      if (name === "recommend") recommend.update(state(), before.recommend, problem);
      else if (name === "shader") snippets.update(state(), withCode(state()), null, problem);
      else if (name === "lut") tables.update(state(), withCode(state()), null, problem);
      else convert.update(state(), before.convert, problem);
      return true;
    },

    theme() {
      plots.theme();
      figure.theme();
      tables.theme();
    },
    deactivate() {
      clearTimeout(settling);
      controls.stop();
    },
    destroy() {
      clearTimeout(settling);
      controls.stop();
      plots.destroy();
      figure.destroy();
      tables.destroy();
    },
  };
}

/** The server's weighted costs of all models. @param {any} answer of /recommend */
function prices(answer) {
  const { good, bad } = candidatesOf(answer);
  return new Map([...good, ...bad].map((c) => [c.model, c.weighted_cost]));
}

/** What the parameters left to the server came out as. @param {any} errors @returns {Map<string, number>} */
function solvedOf(errors) {
  return new Map(
    rowsOf(errors).flatMap((row) =>
      Object.entries(row.parameters ?? {}).flatMap(([name, value]) =>
        value === null ? [] : [[`${row.model}.${name}`, value]],
      ),
    ),
  );
}
