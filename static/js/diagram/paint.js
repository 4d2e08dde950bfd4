/** Writing values into the scene: media, rays, signs. Attributes only, nothing is made here. */

import { boxOf } from "../draw/boxes.js";
import { moveText, put, px, show } from "../draw/svg.js";
import { setLabel } from "../draw/symbols.js";
import { arrowSize, at, signPlaces } from "./geometry.js";
import { DECAY } from "./scene.js";

/** @typedef {import("./scene.js").Scene} Scene */
/** @typedef {import("./geometry.js").Stage} Stage */
/** @typedef {import("./geometry.js").Point} Point */
/** @typedef {Scene["incident"]} Arrow */

/** A sign this small beside the incident one could not be told from dust. */
const SMALLEST_SIGN = 0.12;

/**
 * @param {SVGLineElement} line
 * @param {Point} from
 * @param {Point} to
 */
export function setLine(line, from, to) {
  put(line, "x1", px(from.x));
  put(line, "y1", px(from.y));
  put(line, "x2", px(to.x));
  put(line, "y2", px(to.y));
}

/**
 * @param {SVGElement} node
 * @param {Point} tip
 * @param {Point} along
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
 * @param {Point} along
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
 * @param {Point} back unit vector from the point of incidence to the source
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
 * @param {Point} along
 * @param {{s: number, p: number}} shares of the incident power of that polarization; 0 hides the sign
 * @param {boolean} both
 * @param {number | null} share that the ray's arrow carries; null on the incident ray
 * @param {number | null} [depth] at which an absorber has taken all but 1/e, px
 * @returns {import("../draw/boxes.js").Box[]} what they cover
 */
export function setSigns(signs, stage, along, shares, both, share, depth = null) {
  const turn = (Math.atan2(along.y, along.x) * 180) / Math.PI;
  const arrow = share === null ? null : arrowSize(share, stage);
  const head = arrow && { from: arrow.length - arrow.head, to: arrow.length };
  const places = signPlaces(stage, head, both);
  /** @type {import("../draw/boxes.js").Box[]} */
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
