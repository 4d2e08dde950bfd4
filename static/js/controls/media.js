/** The two media: a preset for each side, and the button that swaps them. */

import { NEGLIGIBLE } from "../constants.js";
import { h, setText } from "../dom.js";
import { plain, significant } from "../format.js";
import { createWavelength } from "./wavelength.js";

/** @typedef {import('../types.js').Material} Material */

/** @param {string} word */
function capital(word) {
  return word.charAt(0).toUpperCase() + word.slice(1);
}

/** @param {Material} material */
function indices(material) {
  return (material.k ?? 0) >= NEGLIGIBLE
    ? `${plain(material.n)} + ${plain(material.k ?? 0)}i`
    : plain(material.n);
}

/** @param {Material} material @returns {string} */
function groupOf({ id, category }) {
  return id.endsWith("-shirley") ? "Shirley's table, 589 nm" : capital(category);
}

/**
 * @param {string} label
 * @param {Material[]} materials
 * @param {(material: Material) => string | null} refusal why a medium cannot stand on this side
 * @param {(id: string) => void} onPick
 */
function createPicker(label, materials, refusal, onPick) {
  const select = h(
    "select",
    { class: "preset", "aria-label": label },
    h("option", { value: "", hidden: true }, "own value"),
  );
  for (const group of new Set(materials.map(groupOf))) {
    select.append(
      h(
        "optgroup",
        { label: group },
        ...materials
          .filter((m) => groupOf(m) === group)
          .map((m) =>
            h(
              "option",
              { value: m.id, disabled: refusal(m) !== null, title: refusal(m) },
              `${m.name}\u2003${indices(m)}`,
            ),
          ),
      ),
    );
  }
  select.addEventListener("change", () => onPick(select.value));
  return { element: h("span", { class: "picker" }, select), select };
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
 * @param {(side: 'incident' | 'material', id: string) => void} options.onPick
 * @param {() => void} options.onSwap
 * @param {import('./wavelength.js').Actions} options.actions
 * @param {string} [options.prefix] of ids
 */
export function createMedia({ materials, onPick, onSwap, actions, prefix = "" }) {
  const wavelength = createWavelength({ materials, actions, prefix });
  const from = createPicker(
    "Incident medium",
    materials,
    (m) => (canBeIncident(m) ? null : "n_i is real: an absorbing medium cannot be on this side"),
    (id) => onPick("incident", id),
  );
  const into = createPicker(
    "Second medium",
    materials,
    () => null,
    (id) => onPick("material", id),
  );
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
    h("label", { class: "side" }, h("span", {}, "from"), from.element),
    h("label", { class: "side" }, h("span", {}, "into"), into.element),
    swap,
    reason,
    wavelength.element,
  );
  let shown = "";
  return {
    element,
    stop: () => wavelength.stop(),
    /** @param {import('../types.js').State} now */
    update(now) {
      wavelength.update(now);
      const { incident, material, n_i, n_t, k_t } = now;
      const state = JSON.stringify([incident, material, n_i, n_t, k_t]);
      if (state === shown) return;
      shown = state;
      pick(from.select, nameable(materials, incident, n_i, 0));
      pick(into.select, nameable(materials, material, n_t, k_t));
      const absorbing = k_t > 0;
      swap.setAttribute("aria-disabled", String(absorbing));
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

/** Choosing again what is chosen would lay out the page. @param {HTMLSelectElement} select @param {string | null} id */
function pick(select, id) {
  if (select.value !== (id ?? "")) select.value = id ?? "";
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
  return id ?? materials.find((m) => m.n === n && (m.k ?? 0) === k)?.id ?? null;
}
