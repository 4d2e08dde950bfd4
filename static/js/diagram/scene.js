/**
 * The diagram in pixels: where things are, its nodes, made once, and how values are written into
 * them. y grows downward; the ray comes from the upper left.
 */

import { boxOf, moveText, put, px, setLabel, show, svg, svgText } from "../draw/svg.js";

const RADIAN = Math.PI / 180;

/**
 * @param {number} width
 * @param {number} height
 * @param {number} [unit]
 * @returns {Stage}
 */
export function stageOf(width, height, unit = 1) {
  const length = Math.min(width, height) * 0.42;
  const y = Math.round(height / 2);
  const inset = (width < 400 ? 12 : 16) * unit;
  return {
    width,
    height,
    x: Math.round(width / 2),
    y,
    length,
    arc: length * 0.4,
    wavelength: Math.round(height / 8),
    inset,
    unit,
    normal: {
      top: Math.max(inset, y - length * 1.12),
      bottom: Math.min(height - inset, y + length * 1.12),
    },
  };
}

/**
 * Unit vectors from the point of incidence: back along the incident ray, along the reflected ray,
 * along the refracted ray. Exactly upright and level at 0 and 90 degrees.
 * @param {number} degrees from the normal
 * @param {"incident" | "reflected" | "refracted"} ray
 * @returns {Place}
 */
export function direction(degrees, ray) {
  const sine = degrees === 90 ? 1 : Math.sin(degrees * RADIAN);
  const cosine = degrees === 90 ? 0 : Math.cos(degrees * RADIAN);
  return {
    x: ray === "incident" ? -sine : sine,
    y: ray === "refracted" ? cosine : -cosine,
  };
}

/**
 * @param {Place} from
 * @param {Place} along unit vector
 * @param {number} distance
 * @returns {Place}
 */
export function at(from, along, distance) {
  return { x: from.x + along.x * distance, y: from.y + along.y * distance };
}

/** @param {number} value */
const short = (value) => Number(value.toFixed(2));

/**
 * Path of the arc from the normal to a ray.
 * @param {Place} origin
 * @param {number} radius
 * @param {number} degrees
 * @param {"incident" | "refracted"} ray
 */
export function arcPath(origin, radius, degrees, ray) {
  const start = at(origin, direction(0, ray), radius);
  const end = at(origin, direction(degrees, ray), radius);
  // both arcs run counterclockwise on the screen
  return `M${short(start.x)},${short(start.y)}A${short(radius)},${short(radius)} 0 0 0 ${short(end.x)},${short(end.y)}`;
}

/**
 * The same arc as a chain of chords, for labels to keep clear of.
 * @param {Place} origin
 * @param {number} radius
 * @param {number} degrees
 * @param {"incident" | "refracted"} ray
 * @returns {Segment[]}
 */
export function arcChords(origin, radius, degrees, ray) {
  const count = Math.max(1, Math.ceil(degrees / 10));
  /** @type {Segment[]} */
  const chords = [];
  let from = at(origin, direction(0, ray), radius);
  for (let n = 1; n <= count; n += 1) {
    const to = at(origin, direction((degrees * n) / count, ray), radius);
    chords.push({ x1: from.x, y1: from.y, x2: to.x, y2: to.y });
    from = to;
  }
  return chords;
}

/**
 * The arrow for a share of the light: as long as the share, and as heavy. A head longer than its
 * arrow would lie about the length, so the head gives way.
 * @param {number} share 0 … 1
 * @param {{length: number, unit: number}} stage
 */
export function arrowSize(share, stage) {
  const length = share * stage.length;
  const width = (1.25 + 2 * share) * stage.unit;
  const head = Math.min(length, (7 + 8 * share) * stage.unit);
  return { length, width, head, visible: length >= 0.75 };
}

/**
 * Where the signs of polarization stand on a ray, clear of its arrow's head and of each other, in px.
 * @param {Stage} stage
 * @param {{from: number, to: number} | null} head none on the incident ray
 * @param {boolean} both
 * @returns {{s: number, p: number}}
 */
export function signPlaces({ length, arc, unit }, head, both) {
  if (!head)
    return both ? { s: length * 0.69, p: length * 0.83 } : { s: length * 0.76, p: length * 0.76 };
  const clear = 13 * unit;
  const apart = Math.min(22 * unit, length * 0.18);
  const before = head.from - clear;
  const behind = head.to + clear;
  /** @param {number} place */
  const free = (place) =>
    place > arc + 6 * unit && place <= length && (place <= before || place >= behind);
  if (!both) {
    const only = [length * 0.62, before, behind].find(free);
    if (only !== undefined) return { s: only, p: only };
    // Where the picture is small, on the shaft rather than beyond the ray.
    const on = behind > length && before > clear ? before : behind;
    return { s: on, p: on };
  }
  const [s, p] = [length * 0.54, length * 0.72];
  /** @type {[number, number][]} */
  const pairs = [
    [s, p],
    [before - apart, before],
    [Math.min(s, before), Math.max(p, behind)],
  ];
  const found = pairs.find((pair) => free(pair[0]) && free(pair[1]) && pair[1] - pair[0] >= apart);
  if (found) return { s: found[0], p: found[1] };
  return behind + apart > length && before - apart > clear / 2
    ? { s: before - apart, p: before }
    : { s: behind, p: behind + apart };
}

/** Head of an arrow one px long with its tip at the origin, pointing along +x. */
export const HEAD_PATH = "M0,0L-1,-.4L-.78,0L-1,.4Z";

/**
 * Angle of incidence of a ray through a point of the screen: the upper left quadrant, and beyond
 * its sides the nearest end.
 * @param {Place} origin
 * @param {Place} point
 * @returns {number} degrees, 0 … 90
 */
export function angleAt(origin, point) {
  const left = origin.x - point.x;
  const up = origin.y - point.y;
  if (left <= 0) return up >= 0 ? 0 : 90;
  if (up <= 0) return 90;
  return Math.atan2(left, up) / RADIAN;
}

/**
 * How strongly a medium is tinted: nothing at 1 and below, more with each doubling of the index.
 * @param {number} n
 * @returns {number} 0 … 1
 */
export function tint(n) {
  return n <= 1 ? 0 : Math.min(1, Math.log2(n) / 3);
}

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

  // Its nodes in the order in which they are painted.
  const media = svg("g", {}, root);
  const guides = svg("g", { class: "ray-guides" }, root);
  const names = svg("g", {}, root); // letters are never turned over
  const rays = svg("g", { class: "ray-arrows" }, root);
  const words = svg("g", { class: "ray-words" }, root);
  const guide = (/** @type {string} */ name) => svg("line", { class: `ray-${name}` }, guides);
  const text = (/** @type {string} */ name) => svgText(words, `ray-${name}`);
  return {
    root,
    turned: [media, guides, rays],
    darkness,
    glow,
    upper: svg("rect", { class: "ray-medium ray-upper", x: 0, y: 0 }, media),
    lower: svg("rect", { class: "ray-medium ray-lower", x: 0 }, media),
    dark: svg("rect", { class: "ray-darkness", x: 0, fill: `url(#darkness-${own})` }, media),
    light: svg("rect", { class: "ray-glow", x: 0, fill: `url(#glow-${own})` }, media),

    protractor: svg("path", { class: "ray-protractor" }, guides),
    marks: Array.from({ length: LANDMARKS }, () => ({
      line: guide("landmark"),
      name: svgText(names, "ray-landmark-name"),
    })),
    normal: guide("normal"),
    surface: svg("line", { class: "ray-surface", x1: 0 }, guides),
    arcIncident: svg("path", { class: "ray-angle" }, guides),
    arcRefracted: svg("path", { class: "ray-angle" }, guides),
    rightAngle: svg("path", { class: "ray-angle ray-right" }, guides),
    pathReflected: guide("direction"),
    pathRefracted: guide("direction"),

    incident: arrow(rays, "ray-arrow ray-incident"),
    refracted: arrow(rays, "ray-arrow ray-refracted"),
    reflected: arrow(rays, "ray-arrow ray-reflected"),
    grip: svg("line", { class: "ray-grip" }, rays),
    signs: { incident: signs(rays), reflected: signs(rays), refracted: signs(rays) },

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
    scaleBar: svg("path", { class: "ray-scale-bar" }, words),
    scaleText: text("scale-text"),
  };
}

/** @typedef {ReturnType<typeof createScene>} Scene */

/**
 * Where a place of the scene is seen: the light comes from above in all that is worked out, and is
 * turned over where it comes from below.
 * @param {Stage} stage
 * @param {number} y
 */
export const seenAt = ({ height, mirror }, y) => (mirror ? height - y : y);

/**
 * Turn the scene over, or back; its surface is half way up.
 * @param {Scene} scene
 * @param {Stage} stage
 */
export function setMirror({ turned }, { height, mirror }) {
  for (const group of turned)
    put(group, "transform", mirror ? `matrix(1 0 0 -1 0 ${height})` : null);
}

/** Of the mark of a right angle, beside the arcs of the angles. */
export const RIGHT_SIZE = 0.32;
/** How near to a right angle is one, degrees. */
const RIGHT = 0.02;

/** Whether the reflected and the refracted ray are at right angles, as at Brewster's angle. @param {{theta_i_deg: number, theta_t_deg: number | null, interface: {k_t: number}}} values */
export const isRight = ({ theta_i_deg, theta_t_deg, interface: { k_t } }) =>
  k_t === 0 && theta_t_deg !== null && Math.abs(theta_i_deg + theta_t_deg - 90) < RIGHT;

/**
 * The mark of a right angle between two rays.
 * @param {Stage} stage
 * @param {Place} up
 * @param {Place} down
 */
export function rightAnglePath(stage, up, down) {
  const size = stage.arc * RIGHT_SIZE;
  const [one, two] = [at(stage, up, size), at(stage, down, size)];
  const corner = at(one, down, size);
  return `M${short(one.x)},${short(one.y)}L${short(corner.x)},${short(corner.y)}L${short(two.x)},${short(two.y)}`;
}

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
 * @param {number | null} share of the ray's arrow; null on the incident ray
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
export function setScale(
  { scaleBar, scaleText },
  { width, height, inset, wavelength, unit, mirror },
) {
  const top = mirror ? inset : height - inset - wavelength;
  const right = width - inset;
  const bottom = top + wavelength;
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
