/** How a model looks, the same in every view: its color and dash, its traces, the key beside its name. */

import { svg } from "../draw/svg.js";

const COLORS = 8;
const DASHES = [
  "dash",
  "dot",
  "dashdot",
  "longdash",
  "longdashdot",
  "8px 3px 2px 3px",
  "3px 6px",
  "12px 4px",
];

/**
 * Models often seen together keep a look that tells them apart, as d'Eon's figure has them.
 * @type {Record<string, [number, string]>}
 */
const OWN = {
  schlick: [1, "dash"],
  pharr_humphreys: [4, "dashdot"],
  complex_dielectric: [5, "12px 4px"],
  lazanyi2005: [2, "longdash"],
  schlick_tir: [3, "dashdot"],
  spherical_gaussian: [6, "dashdot"],
  generalized_schlick: [3, "longdash"],
  hoffman_f82: [4, "8px 3px 2px 3px"],
  f82_tint: [2, "dot"],
  one_minus_cos: [7, "dot"],
  cook_torrance: [7, "longdashdot"],
};

/** @param {readonly [number, string]} look */
const styled = ([color, dash]) => ({ color: `--model-${color}`, dash });

/**
 * @param {{id: string}[]} models in the order of the registry
 * @param {string} id
 * @returns {{color: string, dash: string}} a css custom property's name and a dash
 */
export function modelStyle(models, id) {
  if (id === "exact") return { color: "--R", dash: "solid" };
  const own = OWN[id];
  if (own) return styled(own);
  const taken = new Set(models.flatMap((m) => (OWN[m.id] ? [String(OWN[m.id])] : [])));
  let place = models.filter((m) => m.id !== "exact" && !OWN[m.id]).findIndex((m) => m.id === id);
  for (let i = 0; ; i += 1) {
    // After eight models the colours come again with another dash.
    const dash = DASHES[(i + Math.floor(i / COLORS)) % DASHES.length] ?? "dash";
    const look = /** @type {const} */ ([(i % COLORS) + 1, dash]);
    if (i < COLORS * DASHES.length && taken.has(String(look))) continue;
    if (place <= 0) return styled(look);
    place -= 1;
  }
}

/** @type {Record<string, {color: string, label: string}>} */
export const CHANNELS = {
  R_red: { color: "--red", label: "R" },
  R_green: { color: "--green", label: "G" },
  R_blue: { color: "--blue", label: "B" },
};

/** @param {string} model @param {string} quantity */
export function traceName(model, quantity) {
  return quantity === "R" ? model : `${model}.${quantity}`;
}

/** @param {string} title without what stands in parentheses, for the label at a curve */
export function shortTitle(title) {
  return title.replace(/\s*\(.*\)$/, "").replace(/:.*$/, "");
}

/**
 * @param {Curves} curves
 * @param {readonly string[]} ids
 * @param {Model[]} models
 * @param {number[]} x
 * @returns {Trace[]}
 */
export function modelTraces(curves, ids, models, x) {
  return ids.flatMap((id) =>
    curves.curves
      .filter((c) => c.model === id && c.quantity in { R: 0, ...CHANNELS })
      .map((curve) => {
        const channel = CHANNELS[curve.quantity];
        const style = modelStyle(models, id);
        const title = shortTitle(models.find((m) => m.id === id)?.title ?? id);
        return {
          id: traceName(id, curve.quantity),
          label: channel ? `${title} ${channel.label}` : title,
          x,
          y: curve.values,
          width: 1.9,
          dash: style.dash,
          color: channel ? channel.color : style.color,
        };
      }),
  );
}

/** Dashes of a short piece of a curve. @type {Record<string, string>} */
export const SAMPLE_DASHES = {
  solid: "",
  dash: "7 4",
  dot: "2 3",
  dashdot: "7 3 2 3",
  longdash: "11 4",
  longdashdot: "11 3 2 3",
};

/** A short piece of a curve, as a key beside its name. @param {{color: string, dash: string}} style */
export function sample({ color, dash }) {
  const root = svg("svg", { class: "sample", viewBox: "0 0 26 8", "aria-hidden": "true" });
  const line = svg("path", { d: "M0 4H26" }, root);
  line.style.stroke = `var(${color})`;
  line.style.strokeDasharray = SAMPLE_DASHES[dash] ?? dash;
  return root;
}
