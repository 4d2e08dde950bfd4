/** The panel of the Preview view: media, what stands on either side and how it is evaluated, the scene. */

import { createChoices, createRow, createSheet } from "../controls/panel.js";
import { createParameters } from "../controls/parameters.js";
import { createSelect } from "../controls/select.js";
import { printLayers, readLayers, THICKEST, thicknessText } from "../layers/layers.js";
import { createInterface } from "../media/media.js";
import { forMedium } from "../models/look.js";
import { ExpressionError, evaluate } from "../numbers/expression.js";
import { plain } from "../numbers/format.js";
import { h } from "../page/dom.js";
import { html, render } from "../page/lit.js";
import { BOUNDS, isFilmed, isOpaque, isShortcut, NONE, putRight, SHORTCUT } from "./fields.js";
import { coloredMaterial, SIDES } from "./queries.js";

/** @type {Record<string, {label: string, range: [number, number], wide: [number, number]}>} */
const MANNERS = {
  n_i: { label: "incident index", range: [1, 3], wide: [0.1, 10] },
  n_t: { label: "second index", range: [1, 3], wide: [0.1, 10] },
  k_t: { label: "extinction", range: [0, 5], wide: [0, 20] },
};
const HOW = /** @type {const} */ ({
  pixel: "per pixel",
  vertex: ["per vertex", "R at the corners of a coarse mesh"],
  texture: ["8-bit texture", "R from a table over the cosine"],
});

/** Films to begin with, by their layers. */
const FILMS = {
  "": "no film",
  "water:330": "soap film",
  "1.47:280": "oil",
  "MgF2-o:99.6": "MgF₂ of a quarter wave",
  "2.4:60": "titanium oxide",
  "1.3:400": "n = 1.3, 400 nm: glTF's default",
  "Au:30": "gold leaf",
};

/** @type {Record<string, (model: Model) => boolean>} */
const GROUPS = {
  Approximations: ({ kind, trap }) => kind !== "exact" && !trap,
  Traps: ({ trap }) => trap === true,
  "Exact forms": ({ kind, trap }) => kind === "exact" && !trap,
};

/** The films, and those that are there if they are others. @param {string} layers @returns {import('../controls/select.js').Options} */
function filmsOf(layers) {
  const all = readLayers(layers) ?? [];
  const [only] = all;
  const words =
    all.length > 1
      ? `${all.length} layers, d of the first`
      : `${only?.medium}, ${thicknessText(only?.nm ?? 0)}`;
  return layers in FILMS ? FILMS : { ...FILMS, [layers]: words };
}

/**
 * @param {Model[]} models
 * @param {readonly {id: string, title: string}[]} shortcuts for films
 * @returns {import('../controls/select.js').Options}
 */
function sidesOf(models, shortcuts) {
  /** @param {(model: Model) => boolean} holds */
  const titles = (holds) =>
    Object.fromEntries(models.filter(holds).map(({ id, title }) => [id, title]));
  const groups = Object.entries(GROUPS).map(([name, holds]) => [
    name,
    titles((m) => m.id !== "exact" && holds(m)),
  ]);
  return {
    ...titles((m) => m.id === "exact"),
    [NONE]: "No reflection",
    ...(shortcuts.length > 0 && {
      "Films as renderers shorten them": Object.fromEntries(
        shortcuts.map(({ id, title }) => [`${SHORTCUT}${id}`, title]),
      ),
    }),
    ...Object.fromEntries(groups),
  };
}

/** @param {ViewContext} context */
export function createControls(context) {
  const { catalog, state, actions } = context;
  const prefix = "preview-";
  const { rows, media } = createInterface({ ...context, prefix, manners: MANNERS });
  const choices = createChoices(actions, {
    left_by: ["How R is evaluated on the left", HOW],
    right_by: ["How R is evaluated on the right", HOW],
    scene: ["The media meet at", { ball: "the ball", water: "the water" }],
    body: [
      "Below the surface",
      {
        paint: ["paint", "a diffuse body under a clear coat"],
        clear: ["clear", "what is refracted is seen"],
      },
    ],
    sky: [
      "Light",
      {
        day: "sky and sun",
        even: ["even", "the same from everywhere: the ball shows R itself"],
      },
    ],
    colors: ["The material's color", { rgb: "R, G, B", single: "one wavelength" }],
  });
  const { scene, body, sky, colors } = choices.elements;

  const texels = createRow({
    parameter: { name: "texels", symbol: "N", ...BOUNDS.texels },
    prefix,
    preset: BOUNDS.texels.default,
    label: "texels",
    range: [2, 64],
    wide: [2, 1024],
    steps: { step: 1, fine: 1, page: 16 },
    onChange(value, moving) {
      const texels = Math.round(value ?? BOUNDS.texels.default);
      actions.set({ texels }, { history: moving ? "replace" : "push" });
    },
    onSettle: actions.settle,
    writing: {
      print: (v) => plain(v),
      end: (v) => plain(v),
      parse(text) {
        const value = evaluate(text);
        if (!Number.isInteger(value)) throw new ExpressionError("it is not whole");
        return value;
      },
      allowed: () => "a whole number from 2 to 4096",
    },
  });
  const parameters = createParameters({ models: catalog.models, state, actions, prefix });
  const paint = h("input", {
    type: "color",
    class: "paint-color",
    "aria-label": "Color of the paint",
    oninput: () => actions.set({ paint: paint.value }, { history: "replace" }),
    onchange: () => actions.settle(),
  });
  body.append(paint);

  /** @param {'left' | 'right'} side */
  const select = (side) =>
    createSelect(`Model on the ${side}`, (id) =>
      actions.set(side === "right" ? putRight(state(), id) : { left: id }),
    );
  const selects = { left: select("left"), right: select("right") };
  const film = createSelect("Film on the surface", (layers) => actions.set({ layers }));
  const thickness = createRow({
    parameter: { name: "film_nm", symbol: "d", minimum: 0, maximum: THICKEST },
    prefix,
    preset: 100,
    label: "thickness in nm",
    range: [0, 1000],
    wide: [0, 5000],
    steps: { step: 1, fine: 0.1, page: 10 },
    onChange(value, moving) {
      const [first, ...others] = readLayers(state().layers) ?? [];
      if (!first) return;
      const layers = printLayers([{ ...first, nm: value ?? 0 }, ...others]);
      actions.set({ layers }, { history: moving ? "replace" : "push" });
    },
    onSettle: actions.settle,
  });

  /** @param {'left' | 'right'} side @param {string} reason */
  const sideOf = (side, reason) => html`<section class="side-choice" aria-label=${side}>
    <h2>${side}</h2>
    ${selects[side].element}
    ${choices.elements[`${side}_by`]}
    <p class="reason">${reason}</p>
  </section>`;

  const panel = h("div.panel-body");
  const sheet = createSheet({ pages: rows, body: panel, first: "n_t" });
  return {
    element: sheet.element,
    stop() {
      media.stop();
      texels.stop();
      thickness.stop();
      parameters.stop();
      for (const { row } of rows) row.stop();
    },
    /**
     * @param {State} now
     * @param {{left: string, right: string}} reasons why a model is outside its domain here
     * @param {readonly {id: string, title: string}[]} shortcuts for films, where there are any
     * @param {readonly string[]} warnings of the films' colors
     */
    update(now, reasons, shortcuts, warnings) {
      media.update(now);
      for (const { name, row } of rows) row.update(now[name]);
      sheet.update();
      choices.update(now);
      const unnamed = [now.left, now.right].filter(
        (id) => isShortcut(id) && !shortcuts.some((s) => `${SHORTCUT}${s.id}` === id),
      );
      const named = unnamed.map((id) => id.slice(SHORTCUT.length));
      const known = [...shortcuts, ...named.map((id) => ({ id, title: id }))];
      for (const side of SIDES)
        selects[side].update(now[side], sidesOf(forMedium(catalog.models, now.k_t), known));
      const filmed = isFilmed(now);
      const [first] = readLayers(now.layers) ?? [];
      film.update(now.layers, filmsOf(now.layers));
      thickness.element.hidden = !filmed;
      if (first) thickness.update(first.nm);
      const textured = now.left_by === "texture" || now.right_by === "texture";
      texels.element.hidden = !textured;
      if (textured) texels.update(now.texels);
      parameters.update(now, [now.left, now.right]);
      const absorbs = now.k_t > 0;
      body.hidden = absorbs || now.scene !== "ball";
      paint.hidden = now.body !== "paint" || filmed;
      if (document.activeElement !== paint) paint.value = now.paint;
      sky.hidden = now.scene !== "ball";
      colors.hidden = coloredMaterial(now, catalog) === null;
      render(
        html`<div class="choices">
            ${SIDES.map((side) => sideOf(side, reasons[side]))}
            <div>${texels.element}${parameters.element}</div>
          </div>
          <div class="heading"><h2>Media</h2></div>
          ${media.element}
          <div class="heading"><h2>Film</h2></div>
          <div class="choices film-on">
            ${film.element}${thickness.element}
            <p class="reason" ?hidden=${warnings.length === 0}>${warnings.join("; ")}</p>
          </div>
          <div class="choices">
            ${colors} ${scene} ${body}
            <p class="reason">${
              absorbs
                ? "It absorbs: what enters does not come back."
                : isOpaque(now)
                  ? "Under a film it is black, since paint would hide the colors."
                  : ""
            }</p>
            ${sky}
          </div>
          <div class="rows">${rows.map((r) => r.row.element)}</div>`,
        panel,
      );
    },
  };
}
