/** All nodes of the diagram, made once; a drag only changes their attributes. */

import { svg } from "../draw/svg.js";
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
    casing: svg("line", { class: "casing" }, group),
    shaft: svg("line", { class: "shaft" }, group),
    head: svg("path", { class: "head", d: HEAD_PATH }, group),
  };
}

/**
 * The signs of polarization on a ray: a dot for s, a double arrow for p.
 * @param {SVGElement} parent
 */
function signs(parent) {
  const group = svg("g", { class: "signs" }, parent);
  const s = svg("g", { class: "sign-s" }, group);
  svg("circle", { r: 5, class: "ring" }, s);
  svg("circle", { r: 1.7, class: "core" }, s);
  const p = svg("g", { class: "sign-p" }, group);
  // across the ray, which lies along x
  svg("path", { d: "M0,-10V10", class: "bar" }, p);
  svg("path", { d: "M0,-12.5L3.2,-6.5H-3.2ZM0,12.5L3.2,6.5H-3.2Z", class: "tips" }, p);
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
        class: `${id.replace(/-\d+$/u, "")}-stop`,
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
  const upper = svg("rect", { class: "medium upper", x: 0, y: 0 }, media);
  const lower = svg("rect", { class: "medium lower", x: 0 }, media);
  const dark = svg("rect", { class: "darkness", x: 0, fill: `url(#darkness-${own})` }, media);
  const light = svg("rect", { class: "glow", x: 0, fill: `url(#glow-${own})` }, media);

  const guides = svg("g", { class: "guides" }, root);
  const protractor = svg("path", { class: "protractor" }, guides);
  const marks = Array.from({ length: LANDMARKS }, () => ({
    line: svg("line", { class: "landmark" }, guides),
    name: svg("text", { class: "landmark-name" }, guides),
  }));
  const normal = svg("line", { class: "normal" }, guides);
  const surface = svg("line", { class: "surface", x1: 0 }, guides);
  const arcIncident = svg("path", { class: "angle" }, guides);
  const arcRefracted = svg("path", { class: "angle" }, guides);
  const pathReflected = svg("line", { class: "direction" }, guides);
  const pathRefracted = svg("line", { class: "direction" }, guides);

  const rays = svg("g", { class: "rays" }, root);
  const incident = arrow(rays, "ray incident");
  const refracted = arrow(rays, "ray refracted");
  const reflected = arrow(rays, "ray reflected");
  const grip = svg("line", { class: "grip" }, rays);
  const signsIncident = signs(rays);
  const signsReflected = signs(rays);
  const signsRefracted = signs(rays);

  const words = svg("g", { class: "words" }, root);
  const text = (/** @type {string} */ className) => svg("text", { class: className }, words);
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
    upperName: text("medium-name"),
    upperIndex: text("medium-index"),
    lowerName: text("medium-name"),
    lowerIndex: text("medium-index"),
    depth: text("medium-index"),
    total: text("total"),
    totalRest: text("total"),
    thetaIncident: text("theta"),
    thetaRefracted: text("theta"),
    shareReflected: text("share"),
    shareRefracted: text("share"),
    scaleBar: svg("path", { class: "scale-bar" }, words),
    scaleText: text("scale-text"),
  };
}

/** @typedef {ReturnType<typeof createScene>} Scene */
