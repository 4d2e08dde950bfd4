/** How a model looks, the same in every view: its color and dash, its traces, the key beside its name. */

import { svg } from "../draw/svg.js";

/**
 * @param {readonly {id: string, look?: Look}[]} models as the server describes them
 * @param {string} id
 * @returns {{color: string, dash: string}} a css custom property's name and a dash
 */
export function modelStyle(models, id) {
  const { color, dash } = models.find((m) => m.id === id)?.look ?? { color: "muted", dash: "dot" };
  return { color: `--${color}`, dash };
}

/**
 * Models in the server's order; of a metal those that are made for metals alone come first.
 * @template {Pick<Model, "applies_to" | "trap">} M
 * @param {readonly M[]} models
 * @param {number} k_t of the medium
 * @returns {M[]}
 */
export function forMedium(models, k_t) {
  const own = (/** @type {M} */ { applies_to, trap }) =>
    k_t > 0 && !trap && applies_to.join() === "conductor";
  return [...models.filter(own), ...models.filter((m) => !own(m))];
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
