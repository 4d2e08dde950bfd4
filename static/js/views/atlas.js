/** Atlas: which formula for which material. */

import { pointsOf } from "../atlas/answers.js";
import {
  ABSCISSAS,
  atlasFields,
  BOUNDS,
  csvPath,
  hasColor,
  KINDS,
  METRICS,
  queries,
  within,
} from "../atlas/fields.js";
import { createFormulas } from "../atlas/formulas.js";
import { createList, where, written } from "../atlas/list.js";
import { createScatter, SYMBOLS } from "../atlas/scatter.js";
import { createChoices } from "../controls/panel.js";
import { createSelect } from "../controls/select.js";
import { createTyped } from "../controls/typed.js";
import { modelStyle } from "../models/look.js";
import { evaluate } from "../numbers/expression.js";
import { plain } from "../numbers/format.js";
import { createChanged } from "../page/changed.js";
import { createExports, h, setText } from "../page/dom.js";
import { html, render } from "../page/lit.js";
import { loadStyles } from "../page/style.js";
import { createProblems, createTrouble, sayProblem } from "../page/trouble.js";

export { queries, restCalls } from "../atlas/fields.js";
export const fields = atlasFields;

/**
 * @typedef {import('../atlas/answers.js').Answer} Answer
 * @typedef {import('../atlas/answers.js').Point} Point
 */

const API = "api/v1";
const PAUSE = 600; // ms after which what was typed stands
const SMALLEST = 1e-6; // what is less stands at the lower edge
const ALL = "all shelves";
/** Errors that may count as small, one click away. */
const BUDGETS = { share: [0.001, 0.01, 0.02, 0.05], delta_e: [0.5, 1, 2, 5] };

await loadStyles("heatmap", "albedo-claims", "compare-errors", "atlas");

/** Decimal logarithms and what stands at them. @param {number} low @param {number} high @param {string} metric @returns {Axis["ticks"]} */
function decades(low, high, metric) {
  const values = Array.from({ length: high - low + 1 }, (_, i) => low + i);
  const text = values.map((power) =>
    metric === "delta_e" ? plain(10 ** power) : `${plain(10 ** (power + 2))} %`,
  );
  return { values, text };
}

/** @param {ViewContext} context */
export function createView(context) {
  const { element, catalog, state, actions, save } = context;
  const { models } = catalog;

  /** @param {string} id */
  function take(id) {
    const { atlas_metric } = state();
    const lost = atlas_metric === "delta_e" && !hasColor(catalog, id);
    actions.set({ atlas_model: id, ...(lost && { atlas_metric: "max_abs" }) });
  }
  const model = createSelect("Formula", take);
  const metric = createSelect("Measure of the error", (name) =>
    actions.set({ atlas_metric: name, atlas_within: null }),
  );
  const shelf = createSelect("Shelf", (id) => actions.set({ atlas_shelf: id === ALL ? "" : id }));
  const choices = createChoices(actions, {
    atlas_kind: [
      "Materials",
      {
        all: "all",
        clear: ["clear", "k counts as 0 at all wavelengths"],
        absorbing: ["absorbing", "between clear and metal"],
        metal: ["metals", "k is more than half of n at all wavelengths"],
      },
    ],
    atlas_band: [
      "Wavelengths",
      {
        visible: ["visible", "400 to 700 nm by 50 nm, as far as they are known there"],
        elsewhere: ["elsewhere", "materials that are not known at any of these"],
      },
    ],
    atlas_x: ["Over", Object.fromEntries(Object.entries(ABSCISSAS).map(([x, a]) => [x, a.word]))],
  });
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let pause;
  const search = h("input.box.search", {
    type: "search",
    "aria-label": "Search the materials",
    autocomplete: "off",
    spellcheck: "false",
    placeholder: "name, page, author …",
    maxlength: "100",
    oninput() {
      actions.set({ atlas_find: search.value }, { history: "replace" });
      clearTimeout(pause);
      pause = setTimeout(actions.settle, PAUSE);
    },
    onchange() {
      clearTimeout(pause);
      actions.settle();
    },
  });
  const bound = createTyped({
    attributes: { class: "box bound", "aria-label": "What counts as small" },
    id: "atlas-within",
    parse(text) {
      const percent = text.endsWith("%");
      const value = evaluate(text.replace(/%$/u, "")) / (percent ? 100 : 1);
      if (!(value >= BOUNDS.minimum && value <= BOUNDS.maximum))
        throw new Error("allowed is more than 0, up to 100");
      return value;
    },
    onChange: (value) => actions.set({ atlas_within: value }),
  });
  const quick = h("span.quick");
  const sentence = h("p.take-home", { role: "status" });
  const trouble = createTrouble("Back to Schlick", () =>
    actions.set({ atlas_model: "schlick", atlas_metric: "max_abs", atlas_shelf: "" }),
  );
  const note = h("p.hint");
  const made = h("p.hint");
  const key = h(
    "p.scatter-key",
    ...Object.entries(SYMBOLS).map(([kind, { sign }]) => h("span", `${sign} ${KINDS[kind]}`)),
  );
  const host = h("div.plot-host");
  const shares = h("div");
  const list = h("div");
  const card = h("section.column.atlas-card", {
    "aria-label": "The chosen material",
    hidden: true,
  });

  const csv = async () => {
    const answer = await fetch(`${API}${csvPath(state())}`);
    if (!answer.ok) throw new Error("The server does not answer");
    return answer.blob();
  };
  const exports = createExports({
    what: "the atlas",
    name: () => `fresnel-atlas-${state().atlas_model}`,
    make: (format) => scatter.exportAs(format),
    print: {
      figures: () => [scatter],
      get call() {
        return queries(state()).atlas ?? "";
      },
      behind: () => ({}),
    },
    save,
  });
  element.append(
    h(
      "section.column.atlas-figure",
      { "aria-label": "Errors of the formula at all materials" },
      h("div.heading", h("h2", "Which formula for which material"), exports),
      sentence,
      trouble.element,
      host,
      key,
      note,
    ),
    h(
      "section.column.atlas-choice",
      { "aria-label": "Formula and materials" },
      h("h2", "Formula"),
      model.element,
      h("h2", "Error"),
      metric.element,
      h("div.budget", h("span", "small up to"), bound.box, quick),
      bound.wrong,
      choices.elements.atlas_kind,
      choices.elements.atlas_band,
      h("h2", "Among"),
      search,
      shelf.element,
      choices.elements.atlas_x,
    ),
    card,
    h(
      "section.column.atlas-shares",
      { "aria-label": "All formulas" },
      h("h2", "For how many the error is small"),
      shares,
    ),
    h(
      "section.column.atlas-list",
      { "aria-label": "Materials" },
      h("h2", "Materials, the largest error first"),
      list,
      made,
      h(
        "p.hint",
        "Everything as a file: ",
        h("a", { href: `${API}/atlas/errors.parquet`, download: "" }, "Parquet"),
      ),
    ),
  );
  const scatter = createScatter(host, {
    filename: "fresnel-atlas",
    csv,
    onPick(id) {
      if (state().atlas_at === id) void materials.open(id);
      else actions.set({ atlas_at: id });
    },
  });
  const formulas = createFormulas({ ...context, element: shares });
  const materials = createList({ ...context, list, card });
  const order = new Map(catalog.materials.map(({ id }, index) => [id, index]));

  const problems = createProblems(["atlas", "material"]);
  const changed = createChanged();
  /** @type {Record<string, any>} */
  let given = {};
  /** @type {Point[]} */
  let points = [];
  /** @type {Answer | null} */
  let read = null;

  function offers(/** @type {State} */ now, /** @type {Answer | undefined} */ answer) {
    const colored = now.atlas_metric === "delta_e";
    /** @param {(m: Model) => boolean} which */
    const titles = (which) =>
      Object.fromEntries(
        models
          .filter((m) => which(m) && (!colored || hasColor(catalog, m.id)))
          .map((m) => [m.id, m.title]),
      );
    model.update(now.atlas_model, {
      Approximations: titles((m) => m.kind !== "exact" && !m.trap),
      "Exact forms": titles((m) => m.kind === "exact"),
      Traps: titles((m) => Boolean(m.trap)),
    });
    const { delta_e: color = "", ...others } = METRICS;
    metric.update(now.atlas_metric, {
      ...others,
      ...(hasColor(catalog, now.atlas_model) && { delta_e: color }),
    });
    const shelves = Object.entries(answer?.shelves ?? {});
    shelf.update(now.atlas_shelf || ALL, {
      [ALL]: ALL,
      ...Object.fromEntries(shelves.map(([id, many]) => [id, `${id} (${many})`])),
    });
    choices.update(now);
    if (document.activeElement !== search) search.value = now.atlas_find;
    const small = within(now);
    /** @param {number} value */
    const print = (value) => (colored ? plain(value) : `${plain(100 * value)} %`);
    bound.update(print(small));
    render(
      BUDGETS[colored ? "delta_e" : "share"].map(
        (value) => html`<button
          type="button"
          class="mini"
          aria-pressed=${value === small}
          @click=${() => actions.set({ atlas_within: value })}
        >${print(value)}</button>`,
      ),
      quick,
    );
  }

  /** @param {State} now @param {Answer} answer */
  function draw(now, answer) {
    const { atlas_metric, atlas_x, atlas_at, atlas_model } = now;
    const look = JSON.stringify([atlas_metric, atlas_x, atlas_at, atlas_model, now.angle]);
    if (!changed(answer, look)) return;
    const { title, range } = ABSCISSAS[/** @type {keyof typeof ABSCISSAS} */ (atlas_x)];
    const [left = 0, right = 1] = range;
    const sizes = points.flatMap(({ error }) => (error ? [Math.abs(error)] : []));
    const small = answer.within;
    const top = Math.ceil(Math.log10(Math.max(small, ...sizes)) - 1e-9);
    const least = Math.min(small, ...sizes.filter((size) => size >= SMALLEST));
    const bottom = Math.min(Math.floor(Math.log10(least)), top - 1);
    const drawn = points.flatMap((point) => {
      if (point.error === null) return [];
      const x = Math.min(Math.max(/** @type {any} */ (point)[atlas_x] ?? 0, left), right);
      const y = Math.max(Math.log10(Math.abs(point.error) || SMALLEST / 10), bottom);
      const words = `${point.name}: ${written(point.error, atlas_metric)} ${where(point, now)}`;
      const rank = order.get(point.id) ?? Number.POSITIVE_INFINITY;
      return [{ id: point.id, name: point.name, kind: point.kind, x, y, words, rank }];
    });
    const name = `${models.find((m) => m.id === atlas_model)?.title}: ${METRICS[atlas_metric]} at ${drawn.length} materials`;
    void scatter.draw(drawn, {
      name,
      x: { title, scale: "log", range },
      y: {
        title: `${METRICS[atlas_metric]}${atlas_metric === "delta_e" ? "" : ", of the incident light"}`,
        range: [bottom, top],
        ticks: decades(bottom, top, atlas_metric),
      },
      color: modelStyle(models, atlas_model).color,
      line: Math.log10(small),
      at: atlas_at,
      ids: [atlas_model],
    });
    const missing = points.length - drawn.length;
    const lost = missing ? ` ${missing} where the formula is undefined are not drawn.` : "";
    setText(note, `A point a material; what lies beyond an axis stands at its end.${lost}`);
    materials.update(points, now);
  }

  /** @param {State} now */
  function show(now) {
    /** @type {Answer | undefined} */
    const answer = given.atlas;
    offers(now, answer);
    trouble.update(problems.of("atlas", given), true);
    if (!answer) return;
    if (answer !== read) {
      read = answer;
      points = pointsOf(answer);
      setText(sentence, answer.sentence);
      formulas.update(answer.models, now);
      const { program, date, database, wavelengths, left_out } = answer.made;
      const none = left_out.length
        ? ` ${left_out.length} materials have n and k nowhere together.`
        : "";
      setText(made, `${program}, ${date}, ${database}. Wavelengths: ${wavelengths}.${none}`);
    }
    draw(now, answer);
    const found = given.material;
    const point = points.find(({ id }) => id === now.atlas_at);
    const known = found?.material === now.atlas_at ? found : undefined;
    materials.choose(known, point, now, sayProblem(problems.of("material", given)));
  }

  return {
    /** @param {State} now @param {Record<string, any>} answers */
    update(now, answers) {
      given = answers;
      show(now);
    },
    /** @param {State} now @param {Record<string, any>} answers */
    sentence: (now, { atlas }) => (atlas?.model === now.atlas_model ? atlas.sentence : ""),
    /** @param {string} name @param {import('../page/trouble.js').Problem} problem */
    problem(name, problem) {
      const told = problems.add(name, problem, given);
      if (told) show(state());
      return told;
    },
    theme: scatter.theme,
    deactivate() {},
    destroy: scatter.destroy,
  };
}
