/** All nodes of the diagram, made once; a drag only changes their attributes. */

import { svg, svgText } from "../draw/svg.js";
import { HEAD_PATH } from "./geometry.js";

/** Depths, in penetration depths, at which the decay's gradient has a stop. */
export const DECAY = [0, 0.25, 0.5, 0.75, 1, 1.33, 1.67, 2, 2.5, 3, 4, 5];
/** Most landmarks that the protractor can show. */
export const LANDMARKS = 4;

let scenes = 0;

/**
 * @param {SVGElement} parent
 * @param {string} className
 */
function arrow(parent, className) {
  const group = svg("g", { class: className }, parent);
  return {
    group,
    casing: svg("line", { class: "ray-casing" }, group),
    shaft: svg("line", { class: "ray-shaft" }, group),
    head: svg("path", { class: "ray-head", d: HEAD_PATH }, group),
  };
}

/**
 * The signs of polarization on a ray: a dot for s, a double arrow for p.
 * @param {SVGElement} parent
 */
function signs(parent) {
  const group = svg("g", { class: "ray-signs" }, parent);
  const s = svg("g", { class: "ray-sign-s" }, group);
  svg("circle", { r: 5, class: "ray-ring" }, s);
  svg("circle", { r: 1.7, class: "ray-core" }, s);
  const p = svg("g", { class: "ray-sign-p" }, group);
  // across the ray, which lies along x
  svg("path", { d: "M0,-10V10", class: "ray-bar" }, p);
  svg("path", { d: "M0,-12.5L3.2,-6.5H-3.2ZM0,12.5L3.2,6.5H-3.2Z", class: "ray-tips" }, p);
  return { group, s, p };
}

/**
 * @param {SVGElement} defs
 * @param {string} id
 * @param {(depths: number) => number} opacity
 */
function decay(defs, id, opacity) {
  const gradient = svg(
    "linearGradient",
    { id, gradientUnits: "userSpaceOnUse", x1: 0, x2: 0 },
    defs,
  );
  const deepest = DECAY[DECAY.length - 1] ?? 1;
  for (const depths of DECAY) {
    svg(
      "stop",
      {
        offset: depths / deepest,
        class: `ray-${id.replace(/-\d+$/u, "")}-stop`,
        "stop-opacity": opacity(depths).toFixed(4),
      },
      gradient,
    );
  }
  return gradient;
}

/**
 * @returns the root and everything that moves
 */
export function createScene() {
  scenes += 1;
  const own = scenes;
  const root = svg("svg", { class: "diagram-svg", "aria-hidden": "true", focusable: "false" });
  const defs = svg("defs", {}, root);
  const darkness = decay(defs, `darkness-${own}`, (depths) => 1 - Math.exp(-depths));
  const glow = decay(defs, `glow-${own}`, (depths) => Math.exp(-depths));

  const media = svg("g", {}, root);
  const upper = svg("rect", { class: "ray-medium ray-upper", x: 0, y: 0 }, media);
  const lower = svg("rect", { class: "ray-medium ray-lower", x: 0 }, media);
  const dark = svg("rect", { class: "ray-darkness", x: 0, fill: `url(#darkness-${own})` }, media);
  const light = svg("rect", { class: "ray-glow", x: 0, fill: `url(#glow-${own})` }, media);

  const guides = svg("g", { class: "ray-guides" }, root);
  const protractor = svg("path", { class: "ray-protractor" }, guides);
  const marks = Array.from({ length: LANDMARKS }, () => ({
    line: svg("line", { class: "ray-landmark" }, guides),
    name: svgText(guides, "ray-landmark-name"),
  }));
  const normal = svg("line", { class: "ray-normal" }, guides);
  const surface = svg("line", { class: "ray-surface", x1: 0 }, guides);
  const arcIncident = svg("path", { class: "ray-angle" }, guides);
  const arcRefracted = svg("path", { class: "ray-angle" }, guides);
  const pathReflected = svg("line", { class: "ray-direction" }, guides);
  const pathRefracted = svg("line", { class: "ray-direction" }, guides);

  const rays = svg("g", { class: "ray-arrows" }, root);
  const incident = arrow(rays, "ray-arrow ray-incident");
  const refracted = arrow(rays, "ray-arrow ray-refracted");
  const reflected = arrow(rays, "ray-arrow ray-reflected");
  const grip = svg("line", { class: "ray-grip" }, rays);
  const signsIncident = signs(rays);
  const signsReflected = signs(rays);
  const signsRefracted = signs(rays);

  const words = svg("g", { class: "ray-words" }, root);
  const text = (/** @type {string} */ className) => svgText(words, className);
  return {
    root,
    darkness,
    glow,
    upper,
    lower,
    dark,
    light,
    protractor,
    marks,
    normal,
    surface,
    arcIncident,
    arcRefracted,
    pathReflected,
    pathRefracted,
    incident,
    refracted,
    reflected,
    grip,
    signs: { incident: signsIncident, reflected: signsReflected, refracted: signsRefracted },
    words,
    upperName: text("ray-medium-name"),
    upperIndex: text("ray-medium-index"),
    lowerName: text("ray-medium-name"),
    lowerIndex: text("ray-medium-index"),
    depth: text("ray-medium-index"),
    total: text("ray-total"),
    totalRest: text("ray-total"),
    thetaIncident: text("ray-theta"),
    thetaRefracted: text("ray-theta"),
    shareReflected: text("ray-share"),
    shareRefracted: text("ray-share"),
    scaleBar: svg("path", { class: "ray-scale-bar" }, words),
    scaleText: text("ray-scale-text"),
  };
}

/** @typedef {ReturnType<typeof createScene>} Scene */
