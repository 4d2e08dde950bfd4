/**
 * The diagram's geometry in pixels: y grows downward, the surface is level, the ray comes from the
 * upper left. Nothing here knows optics; angles and shares come from the server.
 */

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
 * Where the signs of polarization stand on a ray, clear of its arrow's head and of each other.
 * @param {Stage} stage
 * @param {{from: number, to: number} | null} head px from the point of incidence; none on the incident ray
 * @param {boolean} both
 * @returns {{s: number, p: number}} px from the point of incidence
 */
export function signPlaces({ length, arc, unit }, head, both) {
  if (!head)
    return both ? { s: length * 0.69, p: length * 0.83 } : { s: length * 0.76, p: length * 0.76 };
  const clear = 13 * unit;
  const apart = Math.min(22 * unit, length * 0.18);
  const before = head.from - clear;
  const behind = head.to + clear;
  /** @param {number} place */
  const free = (place) => place > arc + 6 * unit && (place <= before || place >= behind);
  if (!both) {
    const only = [length * 0.62, before, behind].find(free) ?? behind;
    return { s: only, p: only };
  }
  const [s, p] = [length * 0.54, length * 0.72];
  /** @type {[number, number][]} */
  const pairs = [
    [s, p],
    [before - apart, before],
    [Math.min(s, before), Math.max(p, behind)],
  ];
  const found = pairs.find((pair) => free(pair[0]) && free(pair[1]) && pair[1] - pair[0] >= apart);
  return found ? { s: found[0], p: found[1] } : { s: behind, p: behind + apart };
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
