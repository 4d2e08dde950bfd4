/**
 * What lies over the curves and moves with the pointer: names, marks, and the marker with its dots,
 * as SVG that only changes attributes, so that neither a drag nor a theme asks Plotly for anything.
 * Names stand on no curve and no other name; curves are sampled into columns of a few pixels for that.
 */

import {
  createMeasure,
  grown,
  moveText,
  overlap,
  put,
  px,
  setLabel,
  show,
  svg,
  svgText,
  within,
} from "../draw/svg.js";

/** Above this many curves a legend names them, not labels at the curves. */
export const MOST_LABELS = 4;
const LABEL_SIZE = 17;

/**
 * @template {SVGElement} T
 * @param {() => T} make
 */
function pool(make) {
  /** @type {T[]} */
  const nodes = [];
  return {
    /** @param {number} index */
    at: (index) => {
      while (nodes.length <= index) nodes.push(make());
      const node = /** @type {T} */ (nodes[index]);
      show(node, true);
      return node;
    },
    /** @param {number} count nodes from here on are not needed */
    rest: (count) => {
      for (const node of nodes.slice(count)) show(node, false);
    },
  };
}

/**
 * @param {SVGLineElement} line
 * @param {number} x px
 * @param {Arrangement} arrangement
 */
function upright(line, x, { frame }) {
  put(line, "x1", x);
  put(line, "x2", x);
  put(line, "y1", frame.y);
  put(line, "y2", frame.y + frame.height + 4);
}

/**
 * @param {ReturnType<typeof pool<SVGCircleElement>>} dots
 * @param {number} x
 * @param {readonly Reached[]} points
 * @param {readonly Trace[]} traces
 * @param {Arrangement} arrangement
 */
function placeDots(dots, x, points, traces, arrangement) {
  const { frame } = arrangement;
  let count = 0;
  for (const { id, y } of points) {
    const trace = traces.find((candidate) => candidate.id === id);
    if (!trace || y === null || !Number.isFinite(y)) continue;
    const pixel = arrangement.yPixel(y, trace.axis);
    if (pixel < frame.y - 1 || pixel > frame.y + frame.height + 1) continue;
    const dot = dots.at(count);
    put(dot, "cx", px(arrangement.xPixel(x)));
    put(dot, "cy", px(pixel));
    put(dot, "style", `--dot: var(${trace.color})`);
    count += 1;
  }
  dots.rest(count);
}

/**
 * @param {HTMLElement} area
 */
export function createOverlay(area) {
  const root = svg("svg", { class: "plot-overlay", "aria-hidden": "true", focusable: "false" });
  const behind = svg("g", {}, root);
  const names = svg("g", {}, root);
  const front = svg("g", { class: "plot-marker" }, root);
  area.append(root);

  const markLines = pool(() => svg("line", { class: "plot-mark" }, behind));
  const markNames = pool(() => svgText(behind, "plot-mark-name"));
  const labels = pool(() => svgText(names, "plot-label"));
  const markerLine = svg("line", { class: "plot-marker-line", visibility: "hidden" }, front);
  const dots = pool(() => svg("circle", { class: "plot-dot", r: 4.5 }, front));
  const hoverLine = svg("line", { class: "plot-hover-line", visibility: "hidden" }, behind);
  const rings = pool(() => svg("circle", { class: "plot-ring", r: 3.5 }, front));

  /** @type {{label: Measure, text: Measure} | null} */
  let measures = null;
  /** @type {Map<string, Place>} */
  let standing = new Map();
  /** @type {Map<string, number>} */
  const widths = new Map();

  /** @type {Theme | null} */
  let faces = null;
  /** @param {Theme} theme */
  const useFaces = (theme) => {
    if (theme === faces) return;
    faces = theme;
    // the sizes of explore.css
    measures = {
      label: createMeasure(theme, 13, LABEL_SIZE, 500),
      text: createMeasure(theme, 12),
    };
  };

  /**
   * @param {readonly Trace[]} all
   * @param {Arrangement} arrangement
   * @param {readonly number[]} uprights abscissas of lines, which names keep clear of
   * @param {number} [most] names; more curves are left to a legend
   */
  const placeNames = (all, arrangement, uprights, most = MOST_LABELS) => {
    const traces = all.filter((trace) => !trace.bare);
    if (!measures || traces.length > most) {
      standing = new Map();
      labels.rest(0);
      return;
    }
    const { label } = measures;
    /** @type {readonly number[] | null} */
    let abscissa = null;
    /** @type {number[]} */
    let xPixels = [];
    standing = placeLabels({
      frame: arrangement.frame,
      previous: standing,
      uprights: uprights.map(arrangement.xPixel),
      curves: traces.map((trace) => {
        if (trace.x !== abscissa) {
          abscissa = trace.x;
          xPixels = trace.x.map(arrangement.xPixel);
        }
        const width = label(trace.label) + 4;
        widths.set(trace.id, width);
        return {
          id: trace.id,
          width,
          height: (LABEL_SIZE + 2) * arrangement.unit,
          x: xPixels,
          y: trace.y.map((value) =>
            value === null ? null : arrangement.yPixel(value, trace.axis),
          ),
        };
      }),
    });
    traces.forEach((trace, index) => {
      const node = labels.at(index);
      const place = standing.get(trace.id);
      show(node, Boolean(place));
      if (!place) return;
      setLabel(node, trace.label);
      put(node, "fill", `var(${trace.color})`);
      moveText(node, place.x, place.y);
    });
    labels.rest(traces.length);
  };

  /**
   * @param {readonly Mark[]} marks
   * @param {Arrangement} arrangement
   * @param {string} yTitle
   */
  const placeMarks = (marks, arrangement, yTitle) => {
    // A size of its own: one that follows the host's is laid out anew in each pass over the page.
    put(root, "width", arrangement.size.width);
    put(root, "height", arrangement.size.height);
    const { frame, xPixel, ranges } = arrangement;
    const inside = marks.filter(
      (mark) => mark.kind === "landmark" && mark.x >= ranges.x[0] && mark.x <= ranges.x[1],
    );
    const places = measures
      ? placeMarkNames({
          frame,
          unit: arrangement.unit,
          reserved: measures.text(yTitle),
          marks: inside.map((mark) => ({
            x: xPixel(mark.x),
            width: measures?.text(mark.label) ?? 0,
          })),
        })
      : [];
    inside.forEach((mark, index) => {
      const line = markLines.at(index);
      const name = markNames.at(index);
      const at = px(xPixel(mark.x));
      const place = places[index];
      put(line, "x1", at);
      put(line, "x2", at);
      put(line, "y1", frame.y - 1);
      put(line, "y2", frame.y + frame.height);
      show(name, Boolean(place));
      if (!place) return;
      setLabel(name, mark.label);
      moveText(name, place.x, place.y);
    });
    markLines.rest(inside.length);
    markNames.rest(inside.length);
  };

  return {
    useFaces,
    /** @param {string} label */
    tickWidth: (label) => measures?.text(label) ?? 7 * label.length,
    placeNames,
    placeMarks,
    /**
     * Whether an upright line runs through a name.
     * @param {number} pixel
     */
    inTheWay: (pixel) =>
      [...standing].some(([id, { x }]) => Math.abs(pixel - x) < (widths.get(id) ?? 0) / 2 + 2),
    hideHover: () => {
      show(hoverLine, false);
      rings.rest(0);
    },
    /**
     * @param {number} x
     * @param {readonly Reached[]} points
     * @param {readonly Trace[]} traces
     * @param {Arrangement} arrangement
     */
    placeHover: (x, points, traces, arrangement) => {
      show(hoverLine, true);
      upright(hoverLine, px(arrangement.xPixel(x)), arrangement);
      placeDots(rings, x, points, traces, arrangement);
    },
    /**
     * @param {number | null} x
     * @param {readonly Reached[]} points
     * @param {readonly Trace[]} traces
     * @param {Arrangement} arrangement
     */
    placeMarker: (x, points, traces, arrangement) => {
      show(markerLine, x !== null);
      if (x === null) {
        dots.rest(0);
        return;
      }
      upright(markerLine, px(arrangement.xPixel(x)), arrangement);
      placeDots(dots, x, points, traces, arrangement);
    },
  };
}

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
 * @param {PlaceLabelsOptions} task
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
 * @param {PlaceMarkNamesOptions} task
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
