/** Rectangles outlined on a heat map, such as what a formula was made for. */

import { put, px, show, svg } from "../draw/svg.js";

/**
 * @typedef {{x: readonly [number, number], y: readonly [number, number]}} Region in the units of the axes
 * @typedef {import("./layout.js").Arrangement} Arrangement
 */

/**
 * The part of a region that lies on the map; null where there is none.
 * @param {Region} region
 * @param {{x: readonly [number, number], y: readonly [number, number]}} ranges
 */
export function clipped({ x, y }, ranges) {
  const [left, right] = [Math.max(x[0], ranges.x[0]), Math.min(x[1], ranges.x[1])];
  const [low, high] = [Math.max(y[0], ranges.y[0]), Math.min(y[1], ranges.y[1])];
  return left > right || low > high ? null : { x: [left, right], y: [low, high] };
}

/** @param {SVGElement} root */
export function createOutlines(root) {
  const casing = svg("path", { class: "map-region-casing" }, root);
  const line = svg("path", { class: "map-region" }, root);
  return {
    /** @param {readonly Region[]} regions @param {Arrangement} arrangement */
    place(regions, { ranges, xPixel, yPixel }) {
      const path = regions
        .map((region) => {
          const part = clipped(region, ranges);
          if (!part) return "";
          const [left, right] = part.x.map((v) => px(xPixel(v)));
          const [bottom, top] = part.y.map((v) => px(yPixel(v)));
          return `M${left},${bottom}H${right}V${top}H${left}Z`;
        })
        .join("");
      for (const node of [casing, line]) {
        show(node, path !== "");
        put(node, "d", path);
      }
    },
  };
}

/**
 * The same as shapes of an exported picture.
 * @param {readonly Region[]} regions
 * @param {string} color
 */
export function regionShapes(regions, color) {
  return regions.map(({ x, y }) => ({
    type: "rect",
    xref: "x",
    yref: "y",
    x0: x[0],
    x1: x[1],
    y0: y[0],
    y1: y[1],
    line: { color, width: 1.5, dash: "5px,4px" },
  }));
}
