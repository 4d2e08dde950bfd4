/** The two media: a preset for each side, and the button that swaps them. */

import { put } from "../draw/svg.js";
import { isDispersive, knownRange, NEGLIGIBLE } from "../media/constants.js";
import { plain, significant, stretch } from "../numbers/format.js";
import { h, setText } from "../page/dom.js";
import { createPicker } from "./picker.js";
import { createRow } from "./row.js";

/** @param {string} word */
function capital(word) {
  return word.charAt(0).toUpperCase() + word.slice(1);
}

/** @param {Material} material */
function indices(material) {
  return (material.k ?? 0) >= NEGLIGIBLE
    ? `${plain(material.n, 4)} + ${plain(material.k ?? 0, 4)}i`
    : plain(material.n);
}

/** What tells media of one name apart. @param {Material} material */
function origin({ id, kind, n_range_nm }) {
  if (kind === "spectrum" && n_range_nm) return stretch(n_range_nm);
  return `${capital(/-([a-z]+)$/.exec(id)?.[1] ?? "")}'s table`;
}

/** @param {Material} material @returns {string} */
function groupOf({ id, category }) {
  return id.endsWith("-shirley") ? "Shirley's table, 589 nm" : capital(category);
}

/** Whether a medium absorbs, but too little to see. @param {Material | undefined} material */
function isFaint(material) {
  return (material?.k ?? 0) > 0 && (material?.k ?? 0) < NEGLIGIBLE;
}

/** Whether a medium can be on the incident side, where the index is real. @param {Material} material */
export function canBeIncident({ k }) {
  return (k ?? 0) < NEGLIGIBLE;
}

/**
 * @param {object} options
 * @param {Material[]} options.materials
 * @param {() => Promise<void>} options.describe completes what media are found by
 * @param {(side: 'incident' | 'material', id: string) => void} options.onPick
 * @param {() => void} options.onSwap
 * @param {Actions} options.actions
 * @param {string} [options.prefix] of ids
 */
export function createMedia({ materials, describe, onPick, onSwap, actions, prefix = "" }) {
  const wavelength = createWavelength({ materials, actions, prefix });
  const shared = { materials, groupOf, note: indices, origin, describe };
  const from = createPicker({
    ...shared,
    label: "Incident medium",
    refusal: (m) =>
      canBeIncident(m) ? null : "n_i is real: an absorbing medium cannot be on this side",
    onPick: (id) => onPick("incident", id),
  });
  const into = createPicker({
    ...shared,
    label: "Second medium",
    refusal: () => null,
    onPick: (id) => onPick("material", id),
  });
  const reason = h("p", { class: "reason", id: "swap-reason" });
  const swap = h(
    "button",
    {
      type: "button",
      class: "swap",
      "aria-label": "Swap the media",
      "aria-describedby": "swap-reason",
    },
    "⇅",
  );
  swap.addEventListener("click", () => {
    if (swap.getAttribute("aria-disabled") !== "true") onSwap();
  });
  const element = h(
    "div",
    { class: "media" },
    h("div", { class: "side" }, h("span", {}, "from"), from.element),
    h("div", { class: "side" }, h("span", {}, "into"), into.element),
    swap,
    reason,
    wavelength.element,
  );
  let shown = "";
  return {
    element,
    stop: () => wavelength.stop(),
    /** @param {State} now */
    update(now) {
      wavelength.update(now);
      const { incident, material, n_i, n_t, k_t } = now;
      const state = JSON.stringify([incident, material, n_i, n_t, k_t]);
      if (state === shown) return;
      shown = state;
      from.show(nameable(materials, incident, n_i, 0));
      into.show(nameable(materials, material, n_t, k_t));
      const absorbing = k_t > 0;
      put(swap, "aria-disabled", String(absorbing));
      const left = materials.find((m) => m.id === incident)?.k;
      const why = [
        left ? `n_i is real: k = ${significant(left, 2)} is left out.` : "",
        isFaint(materials.find((m) => m.id === material)) ? "k < 10⁻⁶ is left out." : "",
        absorbing ? "No swap: n_i is real, and the second medium absorbs." : "",
      ]
        .filter(Boolean)
        .join(" ");
      setText(reason, why);
    },
  };
}

/**
 * The preset that the state names, else the first one with exactly these indices.
 * @param {Material[]} materials
 * @param {string | null} id
 * @param {number} n
 * @param {number} k
 * @returns {string | null}
 */
export function nameable(materials, id, n, k) {
  if (id !== null) return id;
  let known = named.get(materials);
  if (!known) {
    // from the end, so that the first of several with the same indices stays
    known = new Map(
      materials.map((m) => /** @type {const} */ ([indexKey(m.n, m.k), m.id])).reverse(),
    );
    named.set(materials, known);
  }
  return known.get(indexKey(n, k)) ?? null;
}

/** The presets by their indices: every frame of a drag asks. @type {WeakMap<Material[], Map<string, string>>} */
const named = new WeakMap();

/** @param {number | null} n @param {number | null} k */
function indexKey(n, k) {
  return `${n} ${k ?? 0}`;
}

/** From the far ultraviolet to radio, whatever a source covers. */
export const WAVELENGTH = {
  name: "wavelength_nm",
  symbol: "\\lambda",
  minimum: 1,
  maximum: 1e9,
};

/**
 * @param {object} options
 * @param {Material[]} options.materials
 * @param {Actions} options.actions
 * @param {string} [options.prefix] of ids
 */
export function createWavelength({ materials, actions, prefix = "" }) {
  /** @type {[number, number] | null} */
  let range = null;
  const row = createRow({
    parameter: WAVELENGTH,
    prefix,
    preset: null,
    label: "wavelength, nm",
    range: [380, 780],
    wide: [200, 2500],
    steps: { step: 5, fine: 0.5, page: 50 },
    onChange(value, moving) {
      // Out of range a slider stops at the end of what is known; the box is told so.
      const known = value === null || !moving || !range ? value : within(value, range);
      actions.set({ wavelength_nm: known }, { history: moving ? "replace" : "push" });
    },
    onSettle: actions.settle,
  });
  const note = h("p", { class: "reason" });
  const wrong = h("p", { class: "row-error", role: "alert" });
  const element = h("div", { class: "wavelength", hidden: true }, row.element, wrong, note);
  let shown = "";
  return {
    element,
    stop: () => row.stop(),
    /** @param {State} state */
    update(state) {
      const { incident, material, wavelength_nm } = state;
      const now = JSON.stringify([incident, material, wavelength_nm]);
      if (now === shown) return;
      shown = now;
      range = knownRange(materials, state);
      element.hidden = range === null;
      if (!range) return;
      row.update(wavelength_nm);
      const known = range[0] <= range[1] ? `known ${stretch(range)}` : "not known of both media";
      const outside =
        wavelength_nm !== null && (wavelength_nm < range[0] || wavelength_nm > range[1]);
      setText(wrong, outside ? `λ = ${plain(wavelength_nm, 8)}\u00a0nm: ${known}.` : "");
      const own = [material, incident]
        .map((id) => materials.find((m) => m.id === id))
        .find(isDispersive);
      setText(
        note,
        outside ? "" : wavelength_nm === null ? `${own?.wavelength_nm}\u00a0nm; ${known}` : known,
      );
    },
  };
}

/** @param {number} value @param {readonly [number, number]} range */
function within(value, [low, high]) {
  return Math.min(Math.max(value, low), high);
}

/**
 * @typedef {Pick<import("./row.js").RowOptions, 'label' | 'range' | 'wide'>} Manner
 */

const STEPS = { step: 0.01, fine: 0.001, page: 0.1 };
/** A value of one's own is no preset any more. @type {Record<string, string>} */
const PRESETS = { n_i: "incident", n_t: "material", k_t: "material" };

/**
 * @param {object} options
 * @param {Catalog} options.catalog
 * @param {State} options.presets
 * @param {() => State} options.state
 * @param {Actions} options.actions
 * @param {string} options.prefix of the ids
 * @param {Record<string, Manner>} options.manners how each index is shown, in this order
 * @param {() => Promise<void>} options.describeMedia
 */
export function createInterface({
  catalog,
  presets,
  state,
  actions,
  prefix,
  manners,
  describeMedia,
}) {
  const rows = Object.entries(manners).flatMap(([name, manner]) => {
    const parameter = catalog.parameters.find((p) => p.name === name);
    if (!parameter) return [];
    const row = createRow({
      parameter,
      prefix,
      preset: presets[name],
      ...manner,
      steps: STEPS,
      onChange: (value, moving) =>
        actions.set(
          { [name]: value, [/** @type {string} */ (PRESETS[name])]: null },
          { history: moving ? "replace" : "push" },
        ),
      onSettle: actions.settle,
    });
    return [{ name, symbol: parameter.symbol, row, print: () => plain(state()[name], 4) }];
  });

  const media = createMedia({
    materials: catalog.materials,
    describe: describeMedia,
    actions,
    prefix,
    onPick(side, id) {
      if (catalog.materials.some((m) => m.id === id)) actions.set({ [side]: id });
    },
    onSwap() {
      const { n_i, n_t, incident, material } = state();
      actions.set({ n_i: n_t, n_t: n_i, incident: material, material: incident });
    },
  });

  return { rows, media };
}
