/** The curves of models as traces: one of each, or three where a parameter differs in R, G and B. */

import { modelStyle } from "./look.js";

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
