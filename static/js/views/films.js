/** Films: layers drawn to scale, what they reflect and transmit, and in which colors. */

import { createExamples } from "../controls/examples.js";
import { locate, read } from "../curves/reading.js";
import { createBeside } from "../films/beside.js";
import { createControls } from "../films/controls.js";
import { createCurves } from "../films/curves.js";
import { EXAMPLES, isShown, stateOf } from "../films/examples.js";
import {
  filled,
  filmFields,
  isAskedFor,
  NO_MODEL,
  panePath,
  untaken,
  wavelengthOf,
} from "../films/fields.js";
import { createModifiers } from "../films/modifiers.js";
import { createNumbers } from "../films/numbers.js";
import { createDrawing } from "../layers/drawing.js";
import { placeOf, readLayers, withThickness } from "../layers/layers.js";
import { brightening, createMap, FITS_TO } from "../layers/map.js";
import { percent, plain } from "../numbers/format.js";
import { createChanged } from "../page/changed.js";
import { createExports, h, setText } from "../page/dom.js";
import { pageLink } from "../page/links.js";
import { loadStyles } from "../page/style.js";
import { createProblems, createTrouble } from "../page/trouble.js";
import { createUse } from "../takeaway/use.js";

export { later, queries, restCalls } from "../films/fields.js";
export const fields = filmFields;

await loadStyles("heatmap", "sheet", "take", "albedo-claims", "films");

/** What shows the films on a ball, a shortcut beside them if there is one. @param {State} now */
function ballOf(now) {
  const { layers, incident, material, n_i, n_t, k_t } = now;
  const { wanted } = isAskedFor(now);
  return {
    layers,
    incident,
    material,
    ...(incident === null && { n_i }),
    ...(material === null && { n_t, k_t }),
    ...(wanted && { right: `film.${now.film_model}` }),
    ...(material === null && k_t === 0 && { body: "clear" }),
  };
}

/** @param {ViewContext} page */
export function createView(page) {
  const context = { ...page, state: () => filled(page.state()) };
  const { element, state, actions } = context;
  const controls = createControls(context);
  const examples = createExamples({
    examples: EXAMPLES,
    name: "film-examples",
    label: "Films that a person knows",
    onShow: (example) => actions.set(stateOf(example)),
    isShown,
  });
  const replace = /** @type {const} */ ({ history: "replace" });
  const drawing = createDrawing(
    (place, nm) => actions.set(withThickness(state(), nm, place), replace),
    actions.settle,
  );
  const trouble = createTrouble("Back to a coating of glass", () => {
    const coating = EXAMPLES.find(({ title }) => title.startsWith("MgF₂"));
    if (coating) actions.set(stateOf(coating));
  });
  /** @param {number} nm @param {number} theta_i_deg @param {boolean} settled */
  const go = (nm, theta_i_deg, settled) =>
    actions.set(
      { ...withThickness(state(), nm), theta_i_deg },
      { history: settled ? "push" : "replace" },
    );
  const map = createMap("Thickness and angle on the map of colors", go, actions.settle);
  const beside = createBeside(context, go);
  const numbers = createNumbers();
  const said = h("p.reason");
  const warned = h("p.reason");
  const onBall = h("p");
  const exports = createExports({
    what: "the colors",
    name: () => "fresnel-film-colors",
    make: (format) => map.file(format, said.textContent ?? ""),
    save: page.save,
  });
  const newBall = createChanged();
  const ofMap = createTrouble("Show the exact colors alone", () =>
    actions.set({ film_model: NO_MODEL }),
  );
  element.append(
    controls.element,
    h("section.column.film-choice", { "aria-label": "Films to start from" }, examples.element),
    h(
      "section.column.film-stack",
      { "aria-label": "The layers" },
      h("div.heading", h("h2", "Layers, to scale")),
      trouble.element,
      drawing.element,
      numbers.element,
    ),
  );
  element.append(
    h(
      "section.column.film-colors",
      { "aria-label": "Colors" },
      h("div.heading", h("h2", "Colors over thickness and angle"), exports),
      ofMap.element,
      map.element,
      said,
      warned,
      onBall,
    ),
  );
  const curves = createCurves(context, (patch, settled) => {
    actions.set(patch, replace);
    if (settled) actions.settle();
  });
  element.append(beside.element);
  const modifiers = createModifiers(context);
  const use = createUse({ ...context, parent: element });
  const problems = createProblems([
    "spectrum",
    "curves",
    "here",
    "map",
    "reflected",
    "transmitted",
    "pane",
    "use",
  ]);
  const newMap = createChanged();
  let factor = 1;
  /** @type {Record<string, any>} */
  let given = {};

  /** R and T where the state is, from the curves that are on the screen. @param {State} now */
  function readingOf(now) {
    if (!given.curves) return null;
    const place = locate(given.curves.theta_i_deg, now.theta_i_deg);
    /** @param {string} quantity */
    const at = (quantity) => {
      const found = given.curves.curves.find((/** @type {Curve} */ c) => c.quantity === quantity);
      return found ? (read(found.values, place) ?? 0) : 0;
    };
    return { R: at("R"), T: at("T") };
  }

  /** @param {State} now @param {number} nm @param {boolean} moving */
  function showColors(now, nm, moving) {
    /** @type {import('../layers/map.js').ColorMap | undefined} */
    const found = given.map;
    const [exact] = found?.colors ?? [];
    if (!found || !exact) return;
    const light = now.film_light;
    if (newMap(exact, light))
      factor = light === "bright" ? brightening(exact.linear_srgb, found.theta_i_deg) : 1;
    const shown = light === "each" ? null : factor;
    map.update(now, nm, found, exact, shown);
    beside.update(now, nm, found, given.shortcuts?.models ?? [], shown, moving);
    if (moving) return;
    const each = light === "each" ? ", each color as bright as a screen can show it" : "";
    const times =
      factor > 1.005
        ? `, ${plain(factor, 3)} times as bright as they are, so that all up to ${FITS_TO}° fit`
        : "";
    const which = now.film_side === "R" ? "reflected" : "transmitted";
    setText(said, `Daylight, ${which}, from the whole spectrum${each}${times}.`);
    setText(warned, found.warnings.join("; "));
  }

  /** @param {State} now @param {boolean} moving */
  function show(now, moving) {
    const layers = readLayers(now.layers) ?? [];
    const place = placeOf(now, layers);
    controls.update(now);
    drawing.update(now, given.curves?.layers, given.here, readingOf(now));
    curves.update(now, given.spectrum, given.curves, moving);
    showColors(now, layers[place]?.nm ?? 0, moving);
    if (moving) return;
    examples.update(now);
    const ball = ballOf(now);
    if (newBall(JSON.stringify(ball)))
      onBall.replaceChildren(pageLink("On a ball, in Preview", "preview", ball));
    numbers.update(now, given);
    modifiers.update(now, panePath(now, page.catalog) ? given.pane : undefined);
    const why = untaken(now);
    use.update(now, why ? undefined : given.use);
    use.problem(why ? { title: why, lines: [] } : problems.of("use", given));
    const problem = ["spectrum", "curves", "here"]
      .map((name) => problems.of(name, given))
      .find(Boolean);
    trouble.update(problem, true);
    ofMap.update(problem ? undefined : problems.of("map", given), isAskedFor(now).wanted);
  }

  return {
    /** @param {State} now @param {Record<string, any>} answers @param {boolean} moving */
    update(now, answers, moving) {
      given = answers;
      show(filled(now), moving);
    },

    /** @param {State} now @param {Record<string, any>} answers */
    sentence(now, { here, reflected }) {
      if (!here) return "";
      const color = reflected?.colors?.[0]?.hex?.[0]?.[0];
      const seen = color ? ` Reflected color ${color}` : "";
      return `At ${plain(wavelengthOf(now), 5)} nm ${percent(here.R)} reflected, ${percent(here.T)} transmitted, ${percent(here.A ?? 0)} absorbed.${seen}`;
    },

    /** @param {string} name @param {import('../page/trouble.js').Problem} problem */
    problem(name, problem) {
      const told = problems.add(name, problem, given);
      if (told) show(state(), false);
      return told;
    },

    theme() {
      curves.theme();
      beside.theme();
      modifiers.theme();
    },
    deactivate: controls.stop,
    destroy() {
      controls.stop();
      curves.destroy();
      beside.destroy();
      modifiers.destroy();
      drawing.destroy();
    },
  };
}
