/** The picture of a lesson: the ray at the surface beside its curves, or a metal's colors. */

import { ANGLE_STEPS } from "../controls/panel.js";
import { axesOf, landmarksOf, pointsAt, readingAt, values } from "../curves/reading.js";
import { createDiagram, createSplit } from "../diagram/diagram.js";
import { CHANNELS, modelTraces, shortTitle } from "../models/look.js";
import { clamp, snap, stepped } from "../numbers/format.js";
import { createDataTables, h, setText } from "../page/dom.js";
import { createPlot } from "../plot/plot.js";

/**
 * @typedef {import('./lesson.js').Lesson} Lesson
 * @typedef {import('./lesson.js').Setting} Setting
 */

const SNAP_DEGREES = 1;
const AXES = /** @type {any} */ (
  axesOf({ polarization: "unpolarized", angle: "deg", show: [], models: [], marks: true })
);

/** @type {Record<string, Omit<Trace, 'x' | 'y'>> & Record<'R' | 'Rs' | 'Rp', Omit<Trace, 'x' | 'y'>>} */
export const LOOKS = {
  R: { id: "R", label: "R", color: "--R", dash: "solid", width: 2.6 },
  Rs: { id: "Rs", label: "Rₛ", color: "--Rs", dash: "solid", width: 1.9 },
  Rp: { id: "Rp", label: "Rₚ", color: "--Rp", dash: "dash", width: 1.9 },
  T: { id: "T", label: "T", color: "--T", dash: "longdash", width: 1.9 },
};

/** R, G and B of a material by its spectrum and by models. @param {any} answer @param {readonly string[]} ids @param {Model[]} models @returns {Trace[]} */
function colorTraces({ theta_i_deg: x, rgb }, ids, models) {
  /** @param {string} id @param {(quantity: string, letter: string) => {id: string, label: string}} name @param {object} look */
  const three = (id, name, look) => {
    const curve = rgb.curves.find((/** @type {any} */ c) => c.model === id);
    return Object.entries(CHANNELS).map(([quantity, { color, label }]) => ({
      ...{ ...name(quantity, label), x, y: curve[quantity], color },
      ...look,
    }));
  };
  return [
    ...three("spectral", (id, label) => ({ id, label }), { dash: "solid", width: 2.4 }),
    ...ids.flatMap((model) => {
      const title = shortTitle(models.find((m) => m.id === model)?.title ?? model);
      const look = { bare: true, dash: model === "exact" ? "dot" : "dash", width: 1.6 };
      return three(model, (id, x) => ({ id: `${model}.${id}`, label: `${title} ${x}` }), look);
    }),
  ];
}

/**
 * @param {object} options
 * @param {Catalog} options.catalog
 * @param {string} options.name what readers hear of the plot
 * @param {Actions} options.actions
 */
export function createStage({ catalog, name, actions }) {
  const diagramFrame = h("div.frame");
  const plotFrame = h("div.frame");
  const split = createSplit();
  const ray = h("div.stage-ray", h("div.diagram-host", diagramFrame), split.element);
  const key = h("p.stage-key");
  const tables = createDataTables("The curves as a table", {
    "Table of the curves": () => [plot.table()],
  });
  const curves = h("div.stage-curves", h("div.plot-host", plotFrame), key, tables.element);
  const element = h("div.stage", ray, curves);

  let theta = 0;
  /** @type {{deg: number, label: string}[]} */
  let marks = [];
  const stops = () => marks.map((m) => m.deg);

  /** @param {number} deg */
  function turn(deg) {
    theta = clamp(deg, 0, 90); // at once: the next step may come before the next frame
    actions.set({ own_deg: theta }, { history: "replace" });
  }

  /** @param {number} deg @param {boolean} free */
  function drag(deg, free) {
    const raw = Number((Math.round(deg / ANGLE_STEPS.fine) * ANGLE_STEPS.fine).toFixed(9));
    const next = free ? raw : snap(raw, stops(), SNAP_DEGREES);
    if (next !== theta) turn(next);
  }

  const diagram = createDiagram(diagramFrame, {
    onTheta: (/** @type {number} */ deg, /** @type {{free: boolean}} */ { free }) =>
      drag(deg, free),
    onSettle: actions.settle,
    onStep(/** @type {string} */ kind) {
      const size =
        { fine: ANGLE_STEPS.fine, page: ANGLE_STEPS.page }[kind.slice(0, -1)] ?? ANGLE_STEPS.step;
      if (kind === "home") turn(0);
      else if (kind === "end") turn(90);
      else turn(stepped(theta, kind.endsWith("-") ? -size : size, stops()));
    },
  });
  const plot = createPlot(plotFrame, {
    ...AXES,
    name,
    filename: "fresnel-lesson",
    onPick(x, { settled, free }) {
      drag(x, free);
      if (settled) actions.settle();
    },
  });

  /** @type {{sources: readonly unknown[], look: string, settled: boolean}} */
  let drawn = { sources: [], look: "", settled: false };
  /** @type {Trace[]} */
  let traces = [];

  /**
   * @param {readonly unknown[]} sources what the traces are made of
   * @param {string} look
   * @param {boolean} moving
   * @param {() => Trace[]} make
   * @param {{x: number, label: string, kind: 'landmark'}[]} landmarks
   */
  function draw(sources, look, moving, make, landmarks) {
    const same = sources.every((source, i) => source === drawn.sources[i]);
    if (same && look === drawn.look && (drawn.settled || moving)) return;
    traces = make();
    if (moving && look === drawn.look) plot.fast(traces, landmarks);
    else void plot.draw(traces, landmarks);
    if (!moving) tables.fill();
    drawn = { sources, look, settled: !moving || look !== drawn.look };
  }

  function mark() {
    const named = traces.filter((t) => !t.bare);
    plot.marker(theta, pointsAt(named, theta));
  }

  return {
    element,
    /**
     * @param {Lesson} lesson
     * @param {Setting} setting
     * @param {Record<string, any>} answers
     * @param {boolean} moving
     * @param {Trace[]} [more] curves of others
     * @returns {Reading | null} the numbers at the angle
     */
    update(lesson, setting, answers, moving, more = []) {
      theta = setting.deg;
      const models = lesson.models ?? [];
      ray.hidden = lesson.picture !== undefined;
      key.hidden = lesson.picture !== "colors";
      if (lesson.picture === "colors") {
        marks = [];
        const answer = answers.colors;
        if (!answer?.rgb || answer.material.id !== setting.of) return null;
        const look = `${lesson.id} ${models}`;
        const beyond = answer.rgb.curves[0].R_red.some((/** @type {number} */ v) => v > 1);
        if (look !== drawn.look || answer !== drawn.sources[0])
          plot.axes({ y: { ...AXES.y, range: [0, beyond ? 1.1 : 1] } });
        draw([answer], look, moving, () => colorTraces(answer, models, catalog.models), []);
        mark();
        return null;
      }
      const { curves } = answers;
      if (!curves) return null;
      const reading = readingAt(curves, answers.snell, theta);
      marks = landmarksOf(curves.interface);
      const { polarization } = setting;
      const [share, passed] = { s: [reading.Rs, reading.Ts], p: [reading.Rp, reading.Tp] }[
        polarization
      ] ?? [reading.R, reading.T];
      const own = { ...lesson.at };
      const [from, into] = lesson.names ?? ["first medium", "second medium"];
      diagram.update({
        ...reading,
        polarization: /** @type {any} */ (polarization),
        angleUnit: "deg",
        labels: {
          incident: setting.n_i === (own.n_i ?? 1) ? from : "first medium",
          transmitted:
            setting.n_t === own.n_t && setting.k_t === (own.k_t ?? 0) ? into : "second medium",
        },
        landmarks: marks,
        held: moving,
      });
      split.update(
        /** @type {number} */ (share),
        /** @type {number} */ (passed),
        reading.interface.k_t > 0,
      );
      const x = curves.theta_i_deg;
      if (drawn.sources.length > 0 && !drawn.look.startsWith("[")) plot.axes({ y: AXES.y });
      const look = JSON.stringify([lesson.id, lesson.quantities, models, more.map((t) => t.id)]);
      draw(
        [curves, ...more.map((t) => t.y)],
        look,
        moving,
        () => [
          ...(lesson.quantities ?? ["R"]).map((id) => ({
            .../** @type {Omit<Trace, 'x' | 'y'>} */ (LOOKS[id]),
            x,
            y: values(curves, id),
          })),
          ...models.flatMap((id) => modelTraces(curves, [id], catalog.models, x)),
          ...more,
        ],
        marks.map(({ deg, label }) => ({ x: deg, label, kind: "landmark" })),
      );
      mark();
      return reading;
    },
    /** @param {string} words what the lines of a color picture are */
    explain: (words) => setText(key, words),
    theme: () => plot.theme(),
    destroy() {
      diagram.destroy();
      plot.destroy();
    },
  };
}
