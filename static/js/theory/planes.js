/** The wave in an absorber: planes of equal phase, which lean, and of equal strength, which do not. */

import { put, svg } from "../draw/svg.js";
import { h } from "../page/dom.js";
import { leaning } from "./lesson.js";

const WIDTH = 420;
const HEIGHT = 250;
const SURFACE = 105;
const WAVELENGTH = 64; // px of one in vacuum
const REACH = 900; // px: longer than the picture is wide, at any slant
const MOST_LEVELS = 4;

let pictures = 0;

/**
 * Lines of equal phase of a wave that meets the middle of the surface with one.
 * @param {number} deg direction of the wave from the normal
 * @param {number} spacing px
 */
export function phaseLines(deg, spacing) {
  const [sin, cos] = [Math.sin((deg * Math.PI) / 180), Math.cos((deg * Math.PI) / 180)];
  const count = Math.ceil(REACH / Math.max(spacing, 2));
  const lines = [];
  for (let m = -count; m <= count; m += 1) {
    const [x, y] = [WIDTH / 2 + m * spacing * sin, SURFACE + m * spacing * cos];
    lines.push(
      `M${(x - REACH * cos).toFixed(2)} ${(y + REACH * sin).toFixed(2)}L${(x + REACH * cos).toFixed(2)} ${(y - REACH * sin).toFixed(2)}`,
    );
  }
  return lines.join("");
}

export function createPlanes() {
  pictures += 1;
  const name = `planes-${pictures}`;
  const root = svg("svg", {
    class: "planes",
    viewBox: `0 0 ${WIDTH} ${HEIGHT}`,
    "aria-hidden": "true",
    focusable: "false",
  });
  const defs = svg("defs", {}, root);
  const upper = svg("clipPath", { id: `${name}-upper` }, defs);
  svg("rect", { width: WIDTH, height: SURFACE }, upper);
  const fade = svg(
    "linearGradient",
    { id: `${name}-fade`, x1: 0, y1: SURFACE, x2: 0, y2: HEIGHT, gradientUnits: "userSpaceOnUse" },
    defs,
  );
  const stops = Array.from({ length: 13 }, (_, i) =>
    svg("stop", { offset: i / 12, "stop-color": "#fff" }, fade),
  );
  const mask = svg("mask", { id: `${name}-mask` }, defs);
  svg(
    "rect",
    { y: SURFACE, width: WIDTH, height: HEIGHT - SURFACE, fill: `url(#${name}-fade)` },
    mask,
  );
  svg("rect", { class: "planes-medium", y: SURFACE, width: WIDTH, height: HEIGHT - SURFACE }, root);
  const above = svg("path", { class: "planes-phase", "clip-path": `url(#${name}-upper)` }, root);
  const below = svg("path", { class: "planes-phase", mask: `url(#${name}-mask)` }, root);
  const levels = svg("path", { class: "planes-strength" }, root);
  svg("path", { class: "planes-surface", d: `M0 ${SURFACE}H${WIDTH}` }, root);
  const element = h(
    "figure.planes-figure",
    root,
    h(
      "figcaption.hint",
      "Solid: equal phase, a plane each wavelength. Dashed: equal strength, each 1/e of the field above it.",
    ),
  );

  return {
    element,
    /** @param {Reading} reading */
    update({ interface: media, theta_i_deg, theta_t_deg, field_penetration_depth_wavelengths }) {
      const deep = field_penetration_depth_wavelengths;
      const leans = leaning(theta_t_deg);
      // Along the surface both waves keep step, which gives the distance of the planes beyond it.
      const [along, beyond] = [theta_i_deg, leans].map((deg) => Math.sin((deg * Math.PI) / 180));
      const spacing =
        along && along > 1e-3 && beyond ? beyond / (media.n_i * along) : 1 / media.n_t;
      put(above, "d", phaseLines(theta_i_deg, WAVELENGTH / media.n_i));
      put(below, "d", phaseLines(leans, WAVELENGTH * spacing));
      const px = deep === null ? Number.POSITIVE_INFINITY : deep * WAVELENGTH;
      stops.forEach((stop, i) => {
        const depth = (i / 12) * (HEIGHT - SURFACE);
        put(stop, "stop-opacity", Math.exp(-depth / px).toFixed(3));
      });
      const count = Number.isFinite(px) ? MOST_LEVELS : 0;
      const at = Array.from({ length: count }, (_, m) => SURFACE + (m + 1) * px);
      const within = at.filter((y) => y < HEIGHT);
      put(levels, "d", within.map((y) => `M0 ${y.toFixed(2)}H${WIDTH}`).join(""));
    },
  };
}
