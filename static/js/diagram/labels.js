/**
 * Where the diagram's labels stand: near what they name, off every ray, arc and other label, inside
 * the frame, and where they stood before unless that has become worse.
 */

import { boxOf, crosses, grown, overlap, reach, within } from "../draw/boxes.js";
import { at, direction } from "./geometry.js";

const GAP = 6;
const BLOCKED = 1000;
const LOYALTY = 1.2;
/** Closer than this to anything is in the way; closer than that is a little worse. */
const CLEAR = 2.5;
const AIRY = 6;
const TIGHT = 0.7;
/** A place that costs less than this is near what it names. */
const GOOD = 1.2;

/**
 * Whether a label lies in the quadrant of what it names.
 * @param {Place} place
 * @param {Size} size
 * @param {Stage} stage
 * @param {"incident" | "reflected" | "refracted"} ray
 */
function inQuadrant(place, size, stage, ray) {
  const right = place.x - stage.x;
  const down = place.y - stage.y;
  return (
    (ray === "incident" ? -right : right) > size.width / 2 &&
    (ray === "refracted" ? down : -down) > size.height / 2
  );
}

/**
 * Places for the name of an angle: outside its arc, inside it, or on the far side of the ray where
 * the angle is too small to hold it.
 * @param {Stage} stage
 * @param {number} degrees
 * @param {"incident" | "refracted"} ray
 * @param {Size} size
 * @returns {Candidate[]}
 */
export function angleCandidates(stage, degrees, ray, size) {
  /** @type {Candidate[]} */
  const out = [];
  const gap = GAP * stage.unit;
  for (const share of [0.5, 0.62, 0.38, 0.74, 0.26]) {
    const along = direction(degrees * share, ray);
    const half = reach(size, along.x, along.y);
    const away = Math.abs(share - 0.5) * 4;
    const outside = at(stage, along, stage.arc + gap + half);
    out.push({ slot: `outside ${share}`, ...outside, cost: away });
    const inside = at(stage, along, stage.arc - gap - half);
    out.push({ slot: `inside ${share}`, ...inside, cost: 1 + away });
    const far = at(stage, along, stage.arc + 2.2 * gap + 2 * half);
    out.push({ slot: `far ${share}`, ...far, cost: 2.2 + away });
  }
  const along = direction(degrees, ray);
  // away from the normal, at right angles to the ray
  const beside = { x: along.y, y: -along.x };
  for (const share of [1, 0.85, 0.7, 0.5, 1.15, 1.35, 1.7, 2.1]) {
    const distance = stage.arc * share;
    const slot = `beside ${share}`;
    const point = at(at(stage, along, distance), beside, gap + reach(size, beside.x, beside.y));
    out.push({ slot, ...point, cost: 1.8 + Math.abs(distance - stage.arc) / 40 });
  }
  return out.filter((place) => inQuadrant(place, size, stage, ray));
}

/**
 * Places for the name of an arrow: to either side of its direction, from the tip on.
 * @param {Stage} stage
 * @param {Place} along unit vector of the arrow
 * @param {number} length px of the arrow
 * @param {Size} size
 * @param {number} clearance px from the arrow's middle line
 * @param {"reflected" | "refracted"} ray
 * @returns {Candidate[]}
 */
export function arrowCandidates(stage, along, length, size, clearance, ray) {
  /** @type {Candidate[]} */
  const out = [];
  for (const [side, sign] of /** @type {["right" | "left", number][]} */ ([
    ["right", 1],
    ["left", -1],
  ])) {
    // "right" is away from the normal for both arrows, which leave to the right
    const away = ray === "reflected" ? sign : -sign;
    const beside = { x: -along.y * away, y: along.x * away };
    for (const lift of [0, 8, 18]) {
      const offset = clearance + lift * stage.unit + reach(size, beside.x, beside.y);
      for (let step = 0; step <= 16; step += 1) {
        const distance = (stage.length * step) / 14;
        const point = at(at(stage, along, distance), beside, offset);
        const far = Math.abs(distance - length) / (28 * stage.unit);
        const cost = far + lift / 12 + (side === "right" ? 0 : 0.8);
        out.push({ slot: `${side} ${step} ${lift}`, ...point, cost });
      }
    }
  }
  // straight ahead of the tip
  const ahead = at(stage, along, length + GAP * stage.unit + reach(size, along.x, along.y));
  out.push({ slot: "ahead", ...ahead, cost: 1.5 });
  return out.filter((place) => inQuadrant(place, size, stage, ray));
}

/**
 * Choose a place for each label, in the order given; where that leaves one in the way of another,
 * in the opposite order.
 * @param {object} task
 * @param {readonly Wish[]} task.wishes
 * @param {Box} task.frame
 * @param {readonly Segment[]} task.segments
 * @param {readonly Box[]} task.boxes
 * @param {ReadonlyMap<string, Placed>} [task.previous]
 * @returns {Map<string, Placed>}
 */
export function placeAll({ wishes, frame, segments, boxes, previous = new Map() }) {
  const needed = wishes.filter((wish) => !wish.optional);
  const optional = wishes.filter((wish) => wish.optional);
  /** @param {readonly Wish[]} order */
  const inOrder = (order) => {
    const taken = [...boxes];
    /** @type {Map<string, Placed>} */
    const placed = new Map();
    let blocked = 0;
    for (const wish of order) {
      const found = placeOne(wish, { frame, segments, taken, before: previous.get(wish.id)?.slot });
      if (!found || (wish.optional && !found.clear)) continue;
      if (!found.clear) blocked += 1;
      taken.push(boxOf(found, wish.size));
      placed.set(wish.id, found);
    }
    return { placed, blocked };
  };
  const first = inOrder([...needed, ...optional]);
  if (first.blocked === 0) return first.placed;
  const second = inOrder([...needed.reverse(), ...optional]);
  return second.blocked < first.blocked ? second.placed : first.placed;
}

/**
 * @param {Wish} wish
 * @param {{frame: Box, segments: readonly Segment[], taken: readonly Box[], before: string | undefined}} place
 * @returns {Placed | null}
 */
function placeOne({ id, size, candidates }, { frame, segments, taken, before }) {
  // Where it stood, if that is good and airy: then nothing else is tried.
  const stood = candidates.find(({ slot }) => slot === before);
  if (stood && stood.cost < GOOD) {
    const box = boxOf(stood, size);
    const airy = grown(box, AIRY);
    const free =
      within(box, frame) &&
      !taken.some((other) => overlap(airy, other)) &&
      !segments.some((segment) => crosses(segment, airy));
    if (free) return { id, slot: stood.slot, x: stood.x, y: stood.y, clear: true };
  }
  /** @type {Candidate | null} */
  let best = null;
  let lowest = Number.POSITIVE_INFINITY;
  for (const candidate of candidates) {
    let cost = candidate.cost - (candidate.slot === before ? LOYALTY : 0);
    if (cost >= lowest) continue;
    const box = boxOf(candidate, size);
    if (!within(box, frame)) continue;
    const near = grown(box, CLEAR);
    const airy = grown(box, AIRY);
    for (const other of taken) {
      if (overlap(airy, other)) cost += overlap(near, other) ? BLOCKED : TIGHT;
    }
    if (cost >= lowest) continue;
    for (const segment of segments) {
      if (crosses(segment, airy)) cost += crosses(segment, near) ? BLOCKED : TIGHT;
    }
    if (cost >= lowest) continue;
    lowest = cost;
    best = candidate;
  }
  if (!best) return null;
  return { id, slot: best.slot, x: best.x, y: best.y, clear: lowest < BLOCKED / 2 };
}
