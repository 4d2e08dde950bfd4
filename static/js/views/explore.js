/** Explore: the ray at the surface beside the Fresnel curves. */

import { ANGLE_STEPS } from "../controls/panel.js";
import { allLandmarksOf, axesOf, marksOf, readingAt, tracesOf } from "../curves/reading.js";
import { createDiagram, createSplit } from "../diagram/diagram.js";
import { createControls } from "../explore/controls.js";
import { createNumbers } from "../explore/numbers.js";
import { atWavelength, bandPaths, knownAs, spreadPaths } from "../media/media.js";
import { angle, clamp, inDegrees, inUnit, percent, snap, stepped } from "../numbers/format.js";
import { createDataTables, createExports, h, setText } from "../page/dom.js";
import { createPlot } from "../plot/plot.js";
import {
  choice,
  chosenModels,
  freshOf,
  list,
  mediaQuery,
  modelFields,
  parameterQuery,
  path,
} from "../state/state.js";

const SNAP_DEGREES = 1;
/** px that the ray takes beside its curves at least. */
const RAY_WIDTH = 200;

/** The state that this view adds to the one all views share. @param {Catalog} catalog */
export function fields({ models }) {
  return {
    show: list(["T", "phase"]),
    marks: choice("on", ["on", "off"]),
    light: choice("one", ["one", "white"]),
    ...modelFields(models),
  };
}

/** @param {ViewContext} context */
export function createView({
  element,
  first,
  catalog,
  presets,
  state,
  actions,
  say,
  save,
  describe,
  describeMedia,
  typeset,
}) {
  const controls = createControls({ catalog, presets, state, actions, describeMedia, say });
  const numbers = createNumbers(say);
  const split = createSplit();
  const light = h("span.at-nm");
  const whitePlace = h("div", { hidden: true });
  const fold = h("details.definitions", h("summary", "Formulas and sources of these curves"));
  /** Fetched when the fold is opened. @type {{update: (ids: readonly string[]) => void} | null} */
  let definitions = null;
  fold.addEventListener(
    "toggle",
    async () => {
      const { createDefinitions } = await import("../models/definitions.js");
      definitions = createDefinitions(catalog.models, typeset, describe, fold);
      if (now) definitions.update(chosenModels(now));
    },
    { once: true },
  );
  const useFold = h("details.definitions", h("summary", "Use it in"));
  /** @type {{update: (state: State) => void} | null} */
  let use = null;
  useFold.addEventListener(
    "toggle",
    async () => {
      const { createUseHere } = await import("../takeaway/use-here.js");
      use = await createUseHere(useFold, { catalog, say, save });
      if (now) use.update(now);
    },
    { once: true },
  );
  const diagramFrame = h("div.frame");
  const diagramHost = h("div.diagram-host", diagramFrame);
  const plotFrame = h("div.frame");
  const plotHost = h("div.plot-host", plotFrame);
  // What the server drew stands until the same is drawn here.
  const firstRay = first?.querySelector(".first-ray");
  const firstCurves = first?.querySelector(".first-curves");
  if (firstRay) diagramHost.append(firstRay);
  if (firstCurves) {
    // For who hears the page the figure beside it stands from the start, and stays.
    firstCurves.setAttribute("aria-hidden", "true");
    plotHost.append(firstCurves);
  }
  const firstAngle = state().theta_i_deg;
  const caption = h(
    "p.hint",
    "Drag the ray, or use ← → (Shift: finer). Alt frees it from the marks.",
  );
  const tables = createDataTables("The curves as a table", {
    "Table of the curves": () => (drawn.settled ? [plot.table()] : []),
  });
  const exports = createExports({
    what: "the plot",
    name: () => "fresnel-curves",
    make: (kind) => plot.exportAs(kind),
    print: {
      figures: () => [plot],
      call: "/curves",
      behind: () => ({ state: now, indices: ["n_i", "n_t", "k_t"] }),
    },
    save,
  });

  const withCurve = h("input", { type: "checkbox" });
  /** The ray that is drawn. @type {any} */
  let ray = null;
  /** As a file, alone or beside its curves. @returns {Published} */
  function rayFigure() {
    const picture = {
      values: ray,
      size: { width: diagramFrame.clientWidth, height: diagramFrame.clientHeight },
      plot: withCurve.checked ? plot : null,
    };
    const { name, ids } = picture.plot?.about() ?? { name: "", ids: [] };
    return {
      about: () => ({ name: `Ray at the surface${name && `; ${name.toLowerCase()}`}`, ids }),
      beside: picture.plot ? RAY_WIDTH : 0,
      exportAs: async (...how) =>
        (await import("../diagram/picture.js")).exportRay(picture, ...how),
    };
  }
  const rayExports = createExports({
    what: "the ray",
    kinds: ["png", "svg"],
    name: () => (withCurve.checked ? "fresnel-ray-and-curves" : "fresnel-ray"),
    make: (kind) => /** @type {any} */ (rayFigure()).exportAs(kind),
    print: {
      figures: () => [rayFigure()],
      call: "/curves",
      behind: () => ({ state: now, indices: ["n_i", "n_t", "k_t"] }),
      wide: () => withCurve.checked,
    },
    save,
  });

  element.append(
    // Before the controls, which stand left of it, for who comes by the Tab key.
    h(
      "section.column.ray",
      { "aria-label": "Ray at the surface" },
      diagramHost, // below its heading, which has more to press
      h(
        "div.heading.above",
        h("h2", "Ray at the surface"),
        h("label.with-curve", withCurve, "with its curve"),
        rayExports,
      ),
      split.element,
      whitePlace,
      caption,
    ),
    controls.element,
    h(
      "section.column.curves",
      { "aria-label": "Reflectance" },
      h("div.heading", h("h2", "Reflectance"), exports),
      plotHost,
      h("div.heading", h("h2", "Numbers"), light, numbers.copyAll),
      numbers.grid,
      fold,
      useFold,
      tables.element,
    ),
    h(
      "section.column.amplitude-column",
      { "aria-label": "Amplitude coefficients" },
      h("div.heading", h("h2", "Amplitude coefficients")),
      numbers.table,
    ),
  );

  /** @type {State | null} */
  let now = null;
  /** @type {any} */
  let answers = {};
  let drawn = {
    curves: /** @type {unknown} */ (null),
    band: /** @type {unknown} */ (null),
    look: "",
    settled: false,
  };

  const landmarks = () => (answers.curves ? allLandmarksOf(answers.curves.interface) : []);
  const stops = () => (now?.marks === "on" ? landmarks() : []);

  /** @param {number} deg @param {boolean} free */
  function drag(deg, free) {
    const raw = Number((Math.round(deg / ANGLE_STEPS.fine) * ANGLE_STEPS.fine).toFixed(9));
    const next = free
      ? raw
      : snap(
          raw,
          stops().map((l) => l.deg),
          SNAP_DEGREES,
        );
    if (next !== state().theta_i_deg)
      actions.set({ theta_i_deg: clamp(next, 0, 90) }, { history: "replace" });
  }

  const diagram = createDiagram(diagramFrame, {
    onTheta: (/** @type {number} */ deg, /** @type {{free: boolean}} */ { free }) =>
      drag(deg, free),
    onSettle: actions.settle,
    onStep(/** @type {string} */ kind) {
      const at = state().theta_i_deg; // which may be ahead of what is drawn
      const size =
        { fine: ANGLE_STEPS.fine, page: ANGLE_STEPS.page }[kind.slice(0, -1)] ?? ANGLE_STEPS.step;
      const next =
        kind === "home"
          ? 0
          : kind === "end"
            ? 90
            : stepped(
                at,
                kind.endsWith("-") ? -size : size,
                stops().map((l) => l.deg),
              );
      actions.set({ theta_i_deg: clamp(next, 0, 90) }, { history: "replace" });
    },
  });

  const plot = createPlot(plotFrame, {
    ...axesOf(/** @type {any} */ (state())),
    filename: "fresnel-curves",
    meanwhile: firstCurves,
    onPick(x, { settled, free }) {
      drag(inDegrees(x, now?.angle ?? "deg"), free);
      if (settled) actions.settle();
    },
  });

  /** White light, once it was to be seen. @type {WhiteLight | null} */
  let white = null;
  async function loadWhite() {
    const { spread, createDispersion } = await import("../explore/dispersion.js");
    const panel = await createDispersion();
    if (white) return;
    white = { spread, panel };
    whitePlace.replaceWith(white.panel.element);
    actions.set({}, { history: "none" });
  }

  /** @param {boolean} moving */
  function draw(moving) {
    if (!now) return;
    const shown = /** @type {Shown} */ ({
      ...now,
      models: chosenModels(now),
      marks: now.marks === "on",
    });
    const look = JSON.stringify([
      shown.polarization,
      shown.angle,
      shown.show,
      shown.models,
      shown.marks,
    ]);
    const { band } = freshOf(answers, bandPaths(now, catalog));
    const changed = drawn.curves !== answers.curves || drawn.band !== band;
    if (!changed && look === drawn.look && (drawn.settled || moving)) return;
    const traces = tracesOf(answers.curves, shown, catalog.models);
    const marks = marksOf(answers.curves, shown);
    if (moving && look === drawn.look) {
      plot.fast(traces, marks);
      drawn = { ...drawn, curves: answers.curves, look, settled: false };
      return;
    }
    if (look !== drawn.look) plot.axes(axesOf(shown));
    // Another state than that of the address: its curves are not to be taken for this one's.
    if (drawn.curves && drawn.curves !== answers.curves) firstCurves?.remove();
    void plot.draw(traces, marks).then(() => firstCurves?.remove());
    drawn = { curves: answers.curves, band, look, settled: true };
    if (band)
      import("../curves/band.js").then(({ bandsOf }) =>
        plot.draw(traces, marks, bandsOf(band, shown.angle)),
      );
    tables.fill();
  }

  return {
    /**
     * @param {State} next
     * @param {any} nextAnswers
     * @param {boolean} moving
     */
    update(next, nextAnswers, moving) {
      now = next;
      answers = nextAnswers;
      controls.update(next, stops(), reasonsOf(answers.curves));
      definitions?.update(chosenModels(next));
      use?.update(next);
      if (!answers.curves) return;
      const reading = readingAt(answers.curves, answers.snell, next.theta_i_deg);
      const { polarization, angle: unit } = next;
      const [share, passed] = { s: [reading.Rs, reading.Ts], p: [reading.Rp, reading.Tp] }[
        /** @type {string} */ (polarization)
      ] ?? [reading.R, reading.T];
      const media = reading.interface;
      if (next.light === "white" && !white) void loadWhite();
      const rays = white?.spread(next, catalog.materials, answers) ?? [];
      ray = {
        ...reading,
        polarization,
        angleUnit: unit,
        labels: {
          incident:
            mediumName(catalog, next.incident, media.n_i, 0, next.n_i, presets) ??
            "incident medium",
          transmitted:
            mediumName(catalog, next.material, media.n_t, media.k_t, next.n_t, presets) ??
            "second medium",
        },
        landmarks: stops(),
        dispersion: rays,
        held: moving,
      };
      diagram.update(ray);
      firstRay?.remove();
      if (next.theta_i_deg !== firstAngle)
        for (const part of firstCurves?.querySelectorAll(".first-marker, .first-point") ?? [])
          part.remove();
      white?.panel.update(rays, next, catalog.materials);
      split.update(/** @type {number} */ (share), /** @type {number} */ (passed), media.k_t > 0);
      setText(light, atWavelength(catalog.materials, next));
      numbers.update(reading, unit, moving);
      draw(moving);
      const points = [
        { id: "Rs", y: reading.Rs },
        { id: "Rp", y: reading.Rp },
        { id: "R", y: reading.R },
        ...(next.show.includes("T") ? [{ id: "T", y: reading.T }] : []),
      ];
      plot.marker(inUnit(next.theta_i_deg, unit), points);
    },

    /** A sentence for those who hear the page. @param {State} next @param {any} given */
    sentence(next, given) {
      if (!given.curves) return "";
      const r = readingAt(given.curves, given.snell, next.theta_i_deg);
      const into = r.tir
        ? "total internal reflection"
        : `refracted at ${angle(r.theta_t_deg, next.angle)}`;
      return `At ${angle(r.theta_i_deg, next.angle)}: ${percent(r.R)} reflected, ${into}.`;
    },

    theme() {
      plot.theme();
      if (now) this.update(now, answers, false);
    },
    deactivate: () => controls.stop(),
    destroy() {
      controls.stop();
      diagram.destroy();
      plot.destroy();
    },
  };
}

/** @param {any} curves @returns {Map<string, string>} why a model is outside its domain here */
function reasonsOf(curves) {
  /** @type {Curve[]} */
  const all = curves?.curves ?? [];
  return new Map(all.flatMap((c) => (c.reason ? [[c.model, c.reason]] : [])));
}

/**
 * What the view asks the server for: paths by name, in the order of their importance.
 * @param {State} state
 * @param {Catalog} catalog
 * @returns {Record<string, string>}
 */
export function queries(state, catalog) {
  const media = mediaQuery(state, catalog);
  const models = chosenModels(state);
  return {
    curves: path("/curves", [
      ...media,
      models.length && `models=exact,${models.join(",")}`,
      ...parameterQuery(state, catalog.models, models),
      "landmarks=true",
      "refraction=true",
      state.show.includes("phase") && "phase=true",
    ]),
    snell: path("/snell", [...media, `theta_i_deg=${state.theta_i_deg}`]),
  };
}

/**
 * White light is asked for when the light of one wavelength is drawn, and the band of an index that is
 * a range when the curves of its middle are.
 * @param {State} state
 * @param {Catalog} catalog
 */
export function later(state, catalog) {
  return { ...spreadPaths(state, catalog.materials), ...bandPaths(state, catalog) };
}

/**
 * The calls that give what is on the screen, for people who want it in their program.
 * @param {State} state
 * @param {Catalog} catalog
 */
export function restCalls(state, catalog) {
  const { snell, curves } = queries(state, catalog);
  const [white] = Object.values(spreadPaths(state, catalog.materials));
  return [snell, curves, white].filter((path) => path !== undefined);
}

/** @param {Catalog} catalog @param {string | null} id @param {number} n @param {number} k @param {number} set what the page says n is @param {State} presets */
function mediumName({ materials }, id, n, k, set, presets) {
  const known = knownAs(materials, id, n, k, presets);
  const found = materials.find((m) => m.id === (known.id ?? known.like));
  // While the second medium moves, the named one is already left but its curves are still shown.
  const shown = found && n === (id === null ? found.n_absolute : set);
  if (!shown) return null;
  const name = found.name.replace(/\s*\(.*\)$/, "");
  return known.like === null ? name : `like ${name}`;
}
