/** The refracted rays of white light, one for each of several wavelengths, thin and to scale. */

import { put, px, show, svg } from "../draw/svg.js";
import { at, direction, setLine } from "./scene.js";

/** px from the point of incidence along a direction to the edge of the picture. @param {Stage} stage @param {{x: number, y: number}} along */
function reach({ x, y, width, height }, along) {
  const down = along.y > 1e-9 ? (height - y) / along.y : Number.POSITIVE_INFINITY;
  const aside = along.x > 1e-9 ? (width - x) / along.x : Number.POSITIVE_INFINITY;
  return Math.min(down, aside, width + height);
}

/**
 * @param {SVGElement} before what lies above the rays
 */
export function createFan(before) {
  const group = svg("g", { class: "ray-fan" });
  before.before(group);
  /** @type {SVGLineElement[]} */
  const lines = [];
  return {
    /** @param {Stage} stage @param {readonly {nm: number, theta_t_deg: number | null, color: string}[]} rays */
    update(stage, rays) {
      rays.forEach(({ theta_t_deg, color }, index) => {
        const line = lines[index] ?? svg("line", {}, group);
        lines[index] = line;
        show(line, theta_t_deg !== null);
        if (theta_t_deg === null) return;
        const along = direction(theta_t_deg, "refracted");
        setLine(line, stage, at(stage, along, reach(stage, along)));
        put(line, "style", `stroke: ${color}; stroke-width: ${px(1.6 * stage.unit)}`);
      });
      for (const line of lines.slice(rays.length)) show(line, false);
    },
  };
}
