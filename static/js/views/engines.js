/** Engines: what render engines reflect, as measured, beside the exact curve. */

import { createChoices } from "../controls/panel.js";
import { createSelect } from "../controls/select.js";
import { angleAxis } from "../curves/reading.js";
import { channelOf, curvesOf, mediumOf } from "../engines/answers.js";
import { engineFields } from "../engines/fields.js";
import { createTable } from "../engines/table.js";
import { errorRange, errorTraces } from "../errors/traces.js";
import { inDegrees, inUnit, significant } from "../numbers/format.js";
import { createChanged } from "../page/changed.js";
import { h, setText } from "../page/dom.js";
import { loadStyles } from "../page/style.js";
import { createProblems, createTrouble } from "../page/trouble.js";
import { createPair } from "../plot/pair.js";

export { queries, restCalls } from "../engines/fields.js";
export const fields = engineFields;

/**
 * @typedef {import('../engines/answers.js').Measured} Measured
 * @typedef {import('../engines/answers.js').Engine} Engine
 */

const LOOKS = [
  { color: "--model-1", dash: "dash" },
  { color: "--model-2", dash: "longdash" },
  { color: "--model-4", dash: "dashdot" },
];

await loadStyles("heatmap", "pair", "albedo-claims", "engines");

/** @param {ViewContext} context */
export function createView(context) {
  const { element, state, actions, save } = context;
  const engines = createSelect("Engine", (engine) => actions.set({ engine }));
  const media = createSelect("Medium", (measured) => actions.set({ measured }));
  const choices = createChoices(actions, {
    engine_light: ["Lit by", { environment: "an even environment", light: "one light" }],
    engine_channel: ["Channel of a metal", { red: "red", green: "green", blue: "blue" }],
  });
  const how = h("p.hint");
  const repeat = h("code");
  const found = h("ul.departures");
  const trouble = createTrouble("Back to three.js", () => actions.set({ engine: "three" }));
  element.append(
    h(
      "section.column.engine-choice",
      { "aria-label": "Engine and medium" },
      h("h2", "Engine"),
      engines.element,
      media.element,
      choices.elements.engine_light,
      choices.elements.engine_channel,
      how,
      h("p.hint", "Measured again by ", repeat),
    ),
  );
  const pair = createPair({
    parent: element,
    className: "engine-curves",
    label: "Reflectance in the engine and its error",
    summary: "Curves and errors as tables",
    upper: {
      heading: "Reflectance, measured",
      above: [trouble.element],
      what: "the curves",
      table: "Table of the curves",
      name: "Reflectance in the engine and exact",
      filename: "fresnel-engine",
    },
    lower: {
      heading: "Error",
      what: "the errors",
      table: "Table of the errors",
      name: "Error of the engine",
      filename: "fresnel-engine-error",
    },
    onPick(x, { settled }) {
      const theta_i_deg = Number(inDegrees(x, state().angle).toFixed(2));
      actions.set({ theta_i_deg: Math.min(Math.max(theta_i_deg, 0), 90) }, { history: "replace" });
      if (settled) actions.settle();
    },
    onKind: (value) => actions.set({ engine_error: value }),
    notes: ["what the engine reflects minus exact", "that over exact"],
    print: { call: "/engines", behind: () => ({ state: state(), indices: [] }) },
    save,
  });
  const table = createTable(context);
  element.append(
    h(
      "section.column.departed",
      { "aria-label": "Where it departs" },
      h("h2", "Where it departs"),
      found,
    ),
    h(
      "section.column.ways",
      { "aria-label": "What was typed" },
      h("h2", "What was typed"),
      table.element,
    ),
  );
  const problems = createProblems(["measured"]);
  const newEngine = createChanged();
  /** @type {Record<string, any>} */
  let given = {};

  /** @param {Measured} engine */
  function describe(engine) {
    setText(
      how,
      `${engine.title} ${engine.version}, ${engine.date}. ${engine.how}
      Noise ${significant(engine.noise, 1)}.`,
    );
    setText(repeat, engine.repeat);
    const told = engine.departures.length
      ? engine.departures
      : ["Nowhere by more than the noise: at least one of its ways follows the exact curve."];
    found.replaceChildren(...told.map((sentence) => h("li", sentence)));
  }

  /** @param {State} now @param {Measured} engine @param {boolean} moving */
  function draw(now, engine, moving) {
    const medium = mediumOf(now, engine);
    const curves = curvesOf(now, engine);
    const relative = now.engine_error === "relative";
    const x = engine.theta_i_deg.map((deg) => inUnit(deg, now.angle));
    const y = channelOf(medium.exact, now);
    const axis = angleAxis(now);
    const { engine_light, engine_channel } = now;
    const look = JSON.stringify([
      engine.id,
      medium.name,
      engine_light,
      engine_channel,
      now.angle,
      relative,
    ]);
    pair.draw(look, [engine], moving, () => {
      const exact = { id: "exact", label: "exact", color: "--R", dash: "solid", width: 2.6, x, y };
      const ways = curves.map((curve, i) => ({
        id: curve.way,
        label: curve.way,
        width: 1.8,
        x,
        y: channelOf(curve.reflectance, now),
        .../** @type {{color: string, dash: string}} */ (LOOKS[i % LOOKS.length]),
      }));
      const errors = errorTraces([exact, ...ways], relative);
      const most = Math.max(1, ...ways.flatMap((way) => way.y));
      return {
        upper: {
          traces: [exact, ...ways],
          axes: () => ({
            x: { ...axis, title: "", short: "θᵢ" },
            y: { title: "reflectance", range: [0, Math.ceil(10 * most) / 10] },
          }),
        },
        lower: {
          traces: errors,
          read: errors.filter((t) => t.id !== "exact"),
          axes: () => ({
            x: axis,
            y: {
              title: relative ? "(engine − exact) / exact (%)" : "engine − exact",
              range: errorRange(errors),
            },
          }),
        },
      };
    });
    pair.marker(inUnit(now.theta_i_deg, now.angle));
    table.update(curves, medium.kind === "conductor", now);
  }

  /** @param {State} now @param {boolean} moving */
  function show(now, moving) {
    /** @type {Engine[]} */
    const known = given.engines?.engines ?? [];
    /** @type {Measured | undefined} */
    const engine = given.measured;
    engines.update(
      now.engine,
      Object.fromEntries(known.map((e) => [e.id, `${e.title} ${e.version}`])),
    );
    trouble.update(problems.of("measured", given), true);
    pair.kind.update([now.engine_error]);
    choices.update(now);
    if (!engine || engine.id !== now.engine) return;
    const names = engine.media.map(({ name }) => [name, name]);
    const medium = mediumOf(now, engine);
    if (medium.name !== now.measured) {
      const line = `${now.measured} was not measured in ${engine.title}; ${medium.name} is shown.`;
      trouble.update({ title: "", lines: [line] }, false);
    }
    media.update(medium.name, Object.fromEntries(names));
    choices.elements.engine_channel.hidden = medium.kind !== "conductor";
    choices.elements.engine_light.hidden = new Set(engine.curves.map((c) => c.light)).size < 2;
    if (newEngine(engine)) describe(engine);
    draw(now, engine, moving);
  }

  return {
    /** @param {State} now @param {Record<string, any>} answers @param {boolean} moving */
    update(now, answers, moving) {
      given = answers;
      show(now, moving);
    },

    /** @param {State} now @param {Record<string, any>} answers */
    sentence(now, { measured }) {
      if (!measured) return "";
      const [first] = curvesOf(now, measured);
      if (!first) return "";
      const { max_abs, at_deg } = first.error;
      return `${measured.title}, ${first.medium}: off by at most ${significant(max_abs, 3)}, at ${at_deg} degrees`;
    },

    /** @param {string} name @param {import('../page/trouble.js').Problem} problem */
    problem(name, problem) {
      const told = problems.add(name, problem, given);
      if (told) show(state(), false);
      return told;
    },

    theme: pair.theme,
    deactivate() {},
    destroy: pair.destroy,
  };
}
