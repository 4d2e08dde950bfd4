/**
 * Where the names of curves stand: at their curve, inside the frame, on no other curve or label.
 *
 * Curves are sampled once into columns of a few pixels, so that asking "does a curve pass through
 * this box" is a handful of comparisons, and placing four labels costs a fraction of a millisecond.
 */

import { grown, overlap, within } from "../draw/boxes.js";

/** @typedef {{id: string, width: number, height: number, x: readonly number[], y: readonly (number | null)[]}} LabelledCurve `x`, `y` in px */
const COLUMN = 3;
const CANDIDATES = 36;
const GAP = 3;
const CLEARANCE = 9;
const FAVOURITE = 0.72;
/** A place that costs less than this clashes with nothing and is near the favourite. */
const GOOD = 3.5;

/**
 * Lowest and highest pixel of a curve in each column; NaN where it is not.
 * @param {LabelledCurve} curve
 * @param {Box} frame
 * @returns {{low: Float64Array, high: Float64Array}}
 */
export function columns({ x, y }, frame) {
  const count = Math.ceil(frame.width / COLUMN) + 1;
  const low = new Float64Array(count).fill(Number.NaN);
  const high = new Float64Array(count).fill(Number.NaN);
  /** @param {number} column @param {number} value */
  const mark = (column, value) => {
    if (!((low[column] ?? 0) <= value)) low[column] = value;
    if (!((high[column] ?? 0) >= value)) high[column] = value;
  };
  for (let index = 1; index < x.length; index += 1) {
    const [y0, y1] = [y[index - 1], y[index]];
    if (y0 === null || y1 === null || y0 === undefined || y1 === undefined) continue;
    const x0 = ((x[index - 1] ?? 0) - frame.x) / COLUMN;
    const x1 = ((x[index] ?? 0) - frame.x) / COLUMN;
    const slope = x1 > x0 ? (y1 - y0) / (x1 - x0) : 0;
    const first = Math.max(0, Math.floor(x0));
    const last = Math.min(count - 1, Math.floor(x1));
    for (let column = first; column <= last; column += 1) {
      // the part of the segment inside this column, by its two ends
      mark(column, y0 + slope * (Math.max(x0, column) - x0));
      mark(column, x1 > x0 ? y0 + slope * (Math.min(x1, column + 1) - x0) : y1);
    }
  }
  return { low, high };
}

/**
 * The span of a curve over a stretch of the frame, or `null` where it is not defined.
 * @param {{low: Float64Array, high: Float64Array}} curve
 * @param {number} from px from the frame's left side
 * @param {number} to
 */
function span({ low, high }, from, to) {
  let top = Number.POSITIVE_INFINITY;
  let bottom = Number.NEGATIVE_INFINITY;
  const last = Math.min(low.length - 1, Math.floor(to / COLUMN));
  for (let column = Math.max(0, Math.floor(from / COLUMN)); column <= last; column += 1) {
    const here = low[column] ?? Number.NaN;
    if (here < top) top = here;
    const there = high[column] ?? Number.NaN;
    if (there > bottom) bottom = there;
  }
  return top <= bottom ? { top, bottom } : null;
}

/**
 * @param {{low: Float64Array, high: Float64Array}} curve
 * @param {Box} box
 * @param {Box} frame
 */
function passes(curve, box, frame) {
  const last = Math.min(curve.low.length - 1, Math.floor((box.x + box.width - frame.x) / COLUMN));
  for (
    let column = Math.max(0, Math.floor((box.x - frame.x) / COLUMN));
    column <= last;
    column += 1
  ) {
    const top = curve.low[column] ?? Number.NaN;
    const bottom = curve.high[column] ?? Number.NaN;
    if (top <= box.y + box.height && bottom >= box.y) return true;
  }
  return false;
}

/**
 * Place the labels of curves; a curve whose label fits nowhere gets none.
 * @param {object} task
 * @param {readonly LabelledCurve[]} task.curves
 * @param {Box} task.frame
 * @param {readonly Box[]} [task.obstacles] what labels must not cover
 * @param {readonly number[]} [task.uprights] px of upright lines, kept clear of where that is cheap
 * @param {ReadonlyMap<string, Place>} [task.previous] where they stood: they move only for a reason
 * @returns {Map<string, Place>}
 */
export function placeLabels({
  curves,
  frame,
  obstacles = [],
  uprights = [],
  previous = new Map(),
}) {
  const sampled = curves.map((curve) => columns(curve, frame));
  /** @type {Map<string, Place>} */
  const placed = new Map();
  /** @type {Box[]} */
  const taken = [...obstacles];
  curves.forEach((curve, own) => {
    const { width, height } = curve;
    const before = previous.get(curve.id);
    /** @type {Box | null} */
    let best = null;
    let lowest = Number.POSITIVE_INFINITY;
    /** @param {number} middle px from the frame's left side; the better of above and below is kept */
    const consider = (middle) => {
      const here = span(
        /** @type {{low: Float64Array, high: Float64Array}} */ (sampled[own]),
        middle - width / 2,
        middle + width / 2,
      );
      if (!here) return;
      for (const above of [true, false]) {
        const box = {
          x: frame.x + middle - width / 2,
          y: above ? here.top - GAP - height : here.bottom + GAP,
          width,
          height,
        };
        if (!within(box, frame)) continue;
        if (taken.some((other) => overlap(box, other))) continue;
        let cost = Math.abs(middle / frame.width - FAVOURITE) * 10;
        // On a slope the corner of the box touches the curve and its middle is far from it.
        cost += ((here.bottom - here.top) / height) * 0.6;
        if (!above) cost += 0.4;
        const wide = grown(box, CLEARANCE);
        let hit = false;
        sampled.forEach((other, index) => {
          if (index === own || hit) return;
          if (passes(other, box, frame)) hit = true;
          else if (passes(other, wide, frame)) cost += 6;
        });
        if (hit) cost += 60;
        if (uprights.some((x) => x > wide.x && x < wide.x + wide.width)) cost += 5;
        if (taken.some((other) => overlap(wide, other))) cost += 4;
        if (before) {
          const moved = Math.hypot(
            box.x + width / 2 - before.x,
            (box.y + height / 2 - before.y) / 4,
          );
          cost += Math.min(3, moved / 30);
        }
        if (cost < lowest) {
          lowest = cost;
          best = box;
        }
      }
    };
    // Where it stood it can follow its curve straight up; if that is good, nothing else is tried.
    if (before) consider(before.x - frame.x);
    if (lowest > GOOD) {
      for (let step = 0; step < CANDIDATES; step += 1) {
        consider(frame.width * (0.06 + (0.92 * step) / (CANDIDATES - 1)));
      }
    }
    const found = /** @type {Box | null} */ (best);
    if (!found) return;
    taken.push(found);
    placed.set(curve.id, { x: found.x + width / 2, y: found.y + height / 2 });
  });
  return placed;
}

const ROW = 17;
const APART = 8;

/**
 * @param {object} task
 * @param {readonly {x: number, width: number}[]} task.marks `x` in px
 * @param {Box} task.frame
 * @param {number} [task.unit]
 * @param {number} task.reserved px at the left of the lower row that the axis title takes
 * @returns {({x: number, y: number} | null)[]} centre of each name, null where there is no room
 */
export function placeMarkNames({ marks, frame, reserved, unit = 1 }) {
  const height = ROW * unit;
  const left = frame.x - 8;
  const right = frame.x + frame.width + 14;
  /** @type {Box[]} */
  const taken = [{ x: 0, y: frame.y - height - 4, width: reserved + APART, height }];
  return marks.map(({ x, width }) => {
    const most = right - width;
    for (const row of [0, 1]) {
      const y = frame.y - height * (row + 1) - 3;
      // centred, then to the left of the line, then to its right
      for (const start of [x - width / 2, x - width + 4, x - 4]) {
        const box = { x: Math.min(Math.max(start, left), most), y, width, height };
        const free = taken.every(
          (other) => !overlap({ ...box, x: box.x - APART, width: width + 2 * APART }, other),
        );
        if (free && box.x >= left) {
          taken.push(box);
          return { x: box.x + width / 2, y: y + height / 2 };
        }
      }
    }
    return null;
  });
}
