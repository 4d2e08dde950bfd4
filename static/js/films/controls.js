/** The controls of the films: the media, the angle, the layers and the one at hand, and what is shown. */

import {
  ANGLE_STEPS,
  angleWriting,
  createChoice,
  createChoices,
  createRow,
  createSheet,
} from "../controls/panel.js";
import {
  MOST_LAYERS,
  placeOf,
  printLayers,
  readLayers,
  shortMedium,
  THICKEST,
  thicknessText,
  withThickness,
} from "../layers/layers.js";
import { become, findPages, isPage } from "../media/brought.js";
import { createInterface } from "../media/media.js";
import { angle } from "../numbers/format.js";
import { createChanged } from "../page/changed.js";
import { h, symbol } from "../page/dom.js";
import { html, render } from "../page/lit.js";
import { NM_PER_VOLT, TITANIA } from "./examples.js";
import { QUANTITIES } from "./fields.js";

/** @typedef {import('../layers/layers.js').Layer} Layer */

const MOST_VOLTS = 120;
const PAUSE = 300; // ms after a key until pages are searched

/** @param {ViewContext} context */
export function createControls({ catalog, presets, state, actions, describeMedia }) {
  const { rows, media } = createInterface({
    catalog,
    presets,
    state,
    actions,
    prefix: "films-",
    describeMedia,
  });
  const history = (/** @type {boolean} */ moving) =>
    /** @type {const} */ ({ history: moving ? "replace" : "push" });
  const unit = () => state().angle;
  const theta = createRow({
    parameter: { name: "theta_i_deg", symbol: "\\theta_i", minimum: 0, maximum: 90 },
    prefix: "films-",
    preset: presets.theta_i_deg,
    label: "angle of incidence",
    range: [0, 90],
    steps: ANGLE_STEPS,
    onChange: (value, moving) => actions.set({ theta_i_deg: value }, history(moving)),
    onSettle: actions.settle,
    writing: angleWriting(() => `${angle(0, unit())} to ${angle(90, unit())}`, unit),
  });
  const thickness = createRow({
    parameter: { name: "film_nm", symbol: "d", minimum: 0, maximum: THICKEST },
    prefix: "films-",
    preset: 100,
    label: "thickness in nm",
    range: [0, 1000],
    wide: [0, 5000],
    steps: { step: 1, fine: 0.1, page: 10 },
    onChange: (value, moving) => actions.set(withThickness(state(), value ?? 0), history(moving)),
    onSettle: actions.settle,
  });
  const voltage = createRow({
    parameter: { name: "film_volts", symbol: "U", minimum: 0, maximum: MOST_VOLTS },
    prefix: "films-",
    preset: 25,
    label: "volts, 2.4 nm each",
    range: [0, MOST_VOLTS],
    steps: { step: 1, fine: 0.1, page: 10 },
    onChange: (value, moving) =>
      actions.set(withThickness(state(), (value ?? 0) * NM_PER_VOLT), history(moving)),
    onSettle: actions.settle,
  });
  const source = h(
    "p.reason",
    "Ohtsuka, Masuda and Sato measured 2.4 nm a volt in sulfuric acid below 7.5 V; thicker oxides deviate.",
  );

  /** @param {(layers: Layer[], place: number) => [Layer[], number]} change */
  function edit(change) {
    const layers = readLayers(state().layers) ?? [];
    const [next, place] = change([...layers], placeOf(state(), layers));
    actions.set({ layers: printLayers(next), film_layer: place + 1 });
  }

  const names = h(
    "datalist",
    { id: "film-media" },
    ...catalog.materials
      .filter((m) => m.kind === "spectrum")
      .map((m) => h("option", { value: m.id }, m.name)),
  );
  const medium = h("input.preset", {
    type: "text",
    list: "film-media",
    autocomplete: "off",
    spellcheck: "false",
    "aria-label": "Medium of the layer: a material or an index",
    oninput: () => offerPages(),
    onchange() {
      const typed = medium.value.trim();
      if (!typed || /[,]/u.test(typed) || !readLayers(`${typed}:1`)) medium.value = shownMedium;
      else void make(typed);
    },
  });
  let shownMedium = "";
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let offering;

  /** Pages of refractiveindex.info below the presets, once somebody types. */
  function offerPages() {
    clearTimeout(offering);
    const text = medium.value.trim();
    if (text === "" || Number(text) > 0 || isPage(text)) return;
    offering = setTimeout(async () => {
      const known = new Set([...names.options].map(({ value }) => value));
      const { rows } = await findPages(text).catch(() => ({ rows: [] }));
      for (const { id, name } of rows)
        if (!known.has(id)) names.append(h("option", { value: id }, name));
    }, PAUSE);
  }

  /** The layer at hand of another medium, which is made known where the page does not start with it. @param {string} id */
  async function make(id) {
    if (isPage(id)) await become(catalog.materials, id).catch(() => {}); // what is wrong is the server's to say
    edit((layers, place) => {
      const old = /** @type {Layer} */ (layers[place]);
      layers[place] = { ...old, medium: id };
      return [layers, place];
    });
  }

  /** @param {Event} event of the sheet */
  const ownComes = (event) => void make(/** @type {CustomEvent<string>} */ (event).detail);
  const bring = h(
    "button.quiet",
    {
      type: "button",
      onclick() {
        window.addEventListener("ownlayer", ownComes, { once: true });
        window.dispatchEvent(new CustomEvent("ownmaterial", { detail: "layer" }));
      },
    },
    "your own…",
  );
  const incoherent = h("input", {
    type: "checkbox",
    onchange: () =>
      edit((layers, place) => {
        const old = /** @type {Layer} */ (layers[place]);
        layers[place] = { ...old, incoherent: incoherent.checked };
        return [layers, place];
      }),
  });
  /** @param {string} words @param {(layers: Layer[], place: number) => [Layer[], number]} change */
  const button = (words, change) =>
    h("button.quiet", { type: "button", onclick: () => edit(change) }, words);
  const add = button("add below", (layers, place) => {
    layers.splice(place + 1, 0, { medium: "1.38", nm: 100, incoherent: false });
    return [layers, place + 1];
  });
  const remove = button("remove", (layers, place) => {
    layers.splice(place, 1);
    return [layers, Math.min(place, layers.length - 1)];
  });
  const up = button("move up", (layers, place) => {
    layers.splice(place - 1, 0, ...layers.splice(place, 1));
    return [layers, place - 1];
  });
  const listed = h("div.film-list", { role: "group", "aria-label": "Layers" });
  const choices = createChoices(actions, {
    film_side: ["Colors of the light", { R: "reflected", T: "transmitted" }],
    film_light: [
      "Shown",
      {
        bright: ["brightened", "all alike, until the brightest below 60° just fits"],
        true: ["as they are", "beside a perfectly white sheet of paper"],
        each: ["each", "each color as bright as a screen can show it: its hue alone"],
      },
    ],
    angle: ["Angles", { deg: "degrees", rad: "radians" }],
  });
  const show = createChoice({
    legend: "Curves",
    several: true,
    items: QUANTITIES.map((value) => ({
      value,
      label: value,
      content: symbol(value.length > 1 ? `${value[0]}_${value[1]}` : value),
    })),
    onChange: (film_show) => actions.set({ film_show: Object.freeze(film_show) }),
  });
  const body = h(
    "div.panel-body",
    h("div.heading", h("h2", "Layers")),
    h("div.film-layer", listed, h("div.film-named", h("span.picker", medium), bring), names),
    thickness.element,
    voltage.element,
    h(
      "div.film-layer",
      source,
      h("label.film-thick", incoherent, h("span", "thick: no interference")),
      h("div.film-edit", { role: "group", "aria-label": "This layer" }, up, add, remove),
    ),
    h("div.heading", h("h2", "Media")),
    media.element,
    h("div.rows", ...rows.map((r) => r.row.element), theta.element),
    h(
      "div.choices",
      show.element,
      choices.elements.film_side,
      choices.elements.film_light,
      choices.elements.angle,
    ),
  );
  const sheet = createSheet({
    pages: [
      { name: "film_nm", symbol: "d", row: thickness, print: () => thickness.print() },
      {
        name: "theta_i_deg",
        symbol: "\\theta_i",
        row: theta,
        print: () => angle(state().theta_i_deg, unit(), unit() === "deg" ? 1 : 3),
      },
      ...rows,
    ],
    body,
    first: "film_nm",
  });
  const newLayers = createChanged();

  return {
    element: sheet.element,
    /** @param {State} now */
    update(now) {
      const layers = readLayers(now.layers) ?? [];
      const place = placeOf(now, layers);
      const layer = layers[place];
      if (!layer) return;
      media.update(now);
      for (const { name, row } of rows) row.update(now[name]);
      theta.update(now.theta_i_deg);
      thickness.update(layer.nm);
      const anodized = now.material === "Ti" && layers.length === 1 && layer.medium === TITANIA;
      for (const part of [voltage.element, source]) part.hidden = !anodized;
      if (anodized) voltage.update(Number((layer.nm / NM_PER_VOLT).toPrecision(6)));
      if (shownMedium !== layer.medium || document.activeElement !== medium)
        medium.value = layer.medium;
      shownMedium = layer.medium;
      incoherent.checked = layer.incoherent;
      remove.disabled = layers.length < 2;
      up.disabled = place === 0;
      add.disabled = layers.length >= MOST_LAYERS;
      if (newLayers(now.layers, place))
        render(
          layers.map(
            (each, i) => html`<button
              type="button"
              aria-pressed=${i === place}
              @click=${() => actions.set({ film_layer: i + 1 })}
            >${shortMedium(each.medium)} <b>${thicknessText(each.nm)}</b></button>`,
          ),
          listed,
        );
      choices.update(now);
      show.update(now.film_show);
      sheet.update();
    },
    stop() {
      media.stop();
      for (const row of [theta, thickness, voltage, ...rows.map((r) => r.row)]) row.stop();
    },
  };
}
