/** All nodes of the diagram, made once; a drag only changes their attributes. */

import { boxOf } from "../draw/boxes.js";
import { moveText, put, px, setLabel, show, svg, svgText } from "../draw/svg.js";
import { arrowSize, at, direction, HEAD_PATH, signPlaces } from "./geometry.js";

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

/** @typedef {Scene["incident"]} Arrow */

/** A sign this small beside the incident one could not be told from dust. */
const SMALLEST_SIGN = 0.12;

/**
 * @param {SVGLineElement} line
 * @param {Place} from
 * @param {Place} to
 */
export function setLine(line, from, to) {
  put(line, "x1", px(from.x));
  put(line, "y1", px(from.y));
  put(line, "x2", px(to.x));
  put(line, "y2", px(to.y));
}

/**
 * @param {SVGElement} node
 * @param {Place} tip
 * @param {Place} along
 * @param {number} size
 */
function setHead(node, tip, along, size) {
  const turn = (Math.atan2(along.y, along.x) * 180) / Math.PI;
  put(
    node,
    "transform",
    `translate(${px(tip.x)},${px(tip.y)})rotate(${px(turn)})scale(${px(size)})`,
  );
}

/**
 * An arrow that leaves the point of incidence, as long as its share of the light.
 * @param {Arrow} arrow
 * @param {Stage} stage
 * @param {Place} along
 * @param {number} share
 */
export function setArrow(arrow, stage, along, share) {
  const { length, width, head, visible } = arrowSize(share, stage);
  show(arrow.group, visible);
  if (!visible) return;
  const tip = at(stage, along, length);
  // the shaft ends inside the head, so that its square end does not blunt the tip
  const end = at(stage, along, length - head * 0.7);
  setLine(arrow.shaft, stage, end);
  setLine(arrow.casing, stage, end);
  put(arrow.shaft, "stroke-width", px(width));
  put(arrow.casing, "stroke-width", px(width + 3));
  setHead(arrow.head, tip, along, head);
}

/**
 * The incident ray: all of the light, its head half way so that the point of incidence stays clear.
 * @param {Arrow} arrow
 * @param {Stage} stage
 * @param {Place} back unit vector from the point of incidence to the source
 */
export function setIncident(arrow, stage, back) {
  const { width, head } = arrowSize(1, stage);
  setLine(arrow.shaft, at(stage, back, stage.length), stage);
  put(arrow.shaft, "stroke-width", px(width * 0.8));
  setHead(
    arrow.head,
    at(stage, back, stage.length * 0.54 - head / 2),
    { x: -back.x, y: -back.y },
    head,
  );
}

/**
 * The signs of polarization, each as large as its field amplitude beside the incident one.
 * @param {Scene["signs"]["incident"]} signs
 * @param {Stage} stage
 * @param {Place} along
 * @param {{s: number, p: number}} shares of the incident power of that polarization; 0 hides the sign
 * @param {boolean} both
 * @param {number | null} share that the ray's arrow carries; null on the incident ray
 * @param {number | null} [depth] at which an absorber has taken all but 1/e, px
 * @returns {Box[]} what they cover
 */
export function setSigns(signs, stage, along, shares, both, share, depth = null) {
  const turn = (Math.atan2(along.y, along.x) * 180) / Math.PI;
  const arrow = share === null ? null : arrowSize(share, stage);
  const head = arrow && { from: arrow.length - arrow.head, to: arrow.length };
  const places = signPlaces(stage, head, both);
  /** @type {Box[]} */
  const covered = [];
  for (const which of /** @type {const} */ (["s", "p"])) {
    const place = at(stage, along, places[which]);
    const left = depth === null ? 1 : Math.exp(-(place.y - stage.y) / depth);
    const size = Math.sqrt(shares[which] * left);
    const node = signs[which];
    show(node, size > SMALLEST_SIGN);
    if (size <= SMALLEST_SIGN) continue;
    const extent = 24 * size * stage.unit;
    covered.push(boxOf(place, { width: extent, height: extent }));
    put(
      node,
      "transform",
      `translate(${px(place.x)},${px(place.y)})rotate(${px(turn)})scale(${Math.round(size * stage.unit * 100) / 100})`,
    );
  }
  return covered;
}

/**
 * The bar that says how many px a wavelength of depth is.
 * @param {Scene} scene
 * @param {Stage} stage
 */
export function setScale({ scaleBar, scaleText }, { width, height, inset, wavelength, unit }) {
  const bottom = height - inset;
  const right = width - inset;
  const top = bottom - wavelength;
  const half = 3 * unit;
  put(
    scaleBar,
    "d",
    `M${right - 2 * half},${top}H${right}M${right - half},${top}V${bottom}M${right - 2 * half},${bottom}H${right}`,
  );
  moveText(scaleText, right - 4 * half, (top + bottom) / 2);
  setLabel(scaleText, "1 λ");
}

/**
 * The decay below the surface: an absorber grows dark, an evanescent field glows out.
 * @param {SVGRectElement} rect
 * @param {SVGLinearGradientElement} gradient
 * @param {Stage} stage
 * @param {number | null} depth in vacuum wavelengths
 */
export function setDecay(rect, gradient, stage, depth) {
  show(rect, depth !== null);
  if (depth === null) return;
  const deepest = DECAY[DECAY.length - 1] ?? 1;
  put(gradient, "y1", stage.y);
  put(gradient, "y2", (stage.y + Math.max(deepest * depth * stage.wavelength, 0.01)).toFixed(2));
}

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
