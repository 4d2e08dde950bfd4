/** The panel of the Preview view: media, what stands on either side and how it is evaluated, the scene. */

import { createInterface } from "../controls/media.js";
import { createChoice, createSheet } from "../controls/panel.js";
import { createParameters } from "../controls/parameters.js";
import { createRow } from "../controls/row.js";
import { ExpressionError, evaluate } from "../numbers/entry.js";
import { plain } from "../numbers/format.js";
import { h, setText } from "../page/dom.js";
import { BOUNDS, isOpaque, NONE } from "./fields.js";
import { coloredMaterial, SIDES } from "./queries.js";

/** @type {Record<string, {label: string, range: [number, number], wide: [number, number]}>} */
const MANNERS = {
  n_i: { label: "incident index", range: [1, 3], wide: [0.1, 10] },
  n_t: { label: "second index", range: [1, 3], wide: [0.1, 10] },
  k_t: { label: "extinction", range: [0, 5], wide: [0, 20] },
};

/** @param {Model} model */
const isTrap = ({ trap }) => trap === true;

/** @param {Model[]} models @param {string} label @param {(id: string) => void} onPick */
function modelSelect(models, label, onPick) {
  /** @param {Model[]} some */
  const options = (some) => some.map((m) => h("option", { value: m.id }, m.title));
  const others = models.filter((m) => m.id !== "exact");
  const select = h(
    "select",
    { class: "preset", "aria-label": label, onchange: () => onPick(select.value) },
    ...options(models.filter((m) => m.id === "exact")),
    h("option", { value: NONE }, "No reflection"),
    h(
      "optgroup",
      { label: "Approximations" },
      ...options(others.filter((m) => m.kind !== "exact" && !isTrap(m))),
    ),
    h("optgroup", { label: "Traps" }, ...options(others.filter(isTrap))),
    h(
      "optgroup",
      { label: "Exact forms" },
      ...options(others.filter((m) => m.kind === "exact" && !isTrap(m))),
    ),
  );
  return select;
}

/**
 * @param {object} options
 * @param {Catalog} options.catalog
 * @param {State} options.presets
 * @param {() => State} options.state
 * @param {Actions} options.actions
 * @param {() => Promise<void>} options.describeMedia
 */
export function createControls({ catalog, presets, state, actions, describeMedia }) {
  const { rows, media } = createInterface({
    catalog,
    presets,
    state,
    actions,
    prefix: "preview-",
    manners: MANNERS,
    describeMedia,
  });

  const sides = SIDES.map((side) => {
    const select = modelSelect(catalog.models, `Model on the ${side}`, (id) =>
      actions.set({ [side]: id }),
    );
    const how = createChoice({
      legend: `How R is evaluated on the ${side}`,
      items: [
        { value: "pixel", label: "per pixel" },
        { value: "vertex", label: "per vertex", note: "R at the corners of a coarse mesh" },
        { value: "texture", label: "8-bit texture", note: "R from a table over the cosine" },
      ],
      onChange: ([value]) => actions.set({ [`${side}_by`]: value }),
    });
    const reason = h("p", { class: "reason" });
    const element = h(
      "section",
      { class: "side-choice", "aria-label": side },
      h("h2", {}, side),
      h("span", { class: "picker" }, select),
      how.element,
      reason,
    );
    return { side, select, how, reason, element };
  });

  const texels = createRow({
    parameter: { name: "texels", symbol: "N", ...BOUNDS.texels },
    prefix: "preview-",
    preset: BOUNDS.texels.default,
    label: "texels",
    range: [2, 64],
    wide: [2, 1024],
    steps: { step: 1, fine: 1, page: 16 },
    onChange: (value, moving) =>
      actions.set(
        { texels: value === null ? BOUNDS.texels.default : Math.round(value) },
        { history: moving ? "replace" : "push" },
      ),
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
  const parameters = createParameters({
    models: catalog.models,
    state,
    actions,
    prefix: "preview-",
  });

  const scene = createChoice({
    legend: "The media meet at",
    items: [
      { value: "ball", label: "the ball" },
      { value: "water", label: "the water" },
    ],
    onChange: ([value]) => actions.set({ scene: value }),
  });
  const body = createChoice({
    legend: "Below the surface",
    items: [
      { value: "paint", label: "paint", note: "a diffuse body under a clear coat" },
      { value: "clear", label: "clear", note: "what is refracted is seen" },
    ],
    onChange: ([value]) => actions.set({ body: value }),
  });
  const paint = h("input", {
    type: "color",
    class: "paint-color",
    "aria-label": "Color of the paint",
    oninput: () => actions.set({ paint: paint.value }, { history: "replace" }),
    onchange: () => actions.settle(),
  });
  body.element.append(paint);
  const opaque = h("p", { class: "reason" });
  const sky = createChoice({
    legend: "Light",
    items: [
      { value: "day", label: "sky and sun" },
      { value: "even", label: "even", note: "the same from everywhere: the ball shows R itself" },
    ],
    onChange: ([value]) => actions.set({ sky: value }),
  });
  const colors = createChoice({
    legend: "The material's color",
    items: [
      { value: "rgb", label: "R, G, B" },
      { value: "single", label: "one wavelength" },
    ],
    onChange: ([value]) => actions.set({ colors: value }),
  });

  const panel = h(
    "div",
    { class: "panel-body" },
    h(
      "div",
      { class: "choices" },
      ...sides.map((s) => s.element),
      h("div", {}, texels.element, parameters.element),
    ),
    h("div", { class: "heading" }, h("h2", {}, "Media")),
    media.element,
    h(
      "div",
      { class: "choices" },
      colors.element,
      scene.element,
      body.element,
      opaque,
      sky.element,
    ),
    h("div", { class: "rows" }, ...rows.map((r) => r.row.element)),
  );
  const sheet = createSheet({ pages: rows, body: panel, first: "n_t" });

  return {
    element: sheet.element,
    stop() {
      media.stop();
      texels.stop();
      parameters.stop();
      for (const { row } of rows) row.stop();
    },
    /**
     * @param {State} now
     * @param {{left: string, right: string}} reasons why a model is outside its domain here
     */
    update(now, reasons) {
      media.update(now);
      for (const { name, row } of rows) row.update(now[name]);
      sheet.update();
      for (const { side, select, how, reason } of sides) {
        if (select.value !== now[side]) select.value = now[side];
        how.update([now[`${side}_by`]]);
        setText(reason, reasons[side]);
      }
      const textured = now.left_by === "texture" || now.right_by === "texture";
      texels.element.hidden = !textured;
      if (textured) texels.update(now.texels);
      parameters.update(now, [now.left, now.right]);
      scene.update([now.scene]);
      body.update([now.body]);
      const dark = isOpaque(now);
      body.element.hidden = dark || now.scene !== "ball";
      setText(opaque, dark ? "It absorbs: what enters does not come back." : "");
      paint.hidden = now.body !== "paint";
      if (document.activeElement !== paint) paint.value = now.paint;
      sky.update([now.sky]);
      sky.element.hidden = now.scene !== "ball";
      colors.update([now.colors]);
      colors.element.hidden = coloredMaterial(now, catalog) === null;
    },
  };
}
