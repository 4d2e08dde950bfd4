/**
 * What lies over the curves and moves with the pointer: names, marks, and the marker with its dots.
 *
 * All of it is SVG that is made once and then only changes attributes, coloured by the page's CSS
 * variables, so that neither a drag nor a change of theme asks Plotly for anything.
 */

import { createMeasure, moveText, put, px, setLabel, show, svg, svgText } from "../draw/svg.js";
import { placeLabels, placeMarkNames } from "./labels.js";

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

  /** @param {Theme} theme */
  const useFaces = ({ family, symbolFamily, unit }) => {
    /** @param {number} size @param {number} symbolSize @param {number} [weight] */
    const face = (size, symbolSize, weight = 400) =>
      createMeasure({
        family,
        symbolFamily,
        size: size * unit,
        symbolSize: symbolSize * unit,
        weight,
      });
    measures = {
      // the sizes of plot.css
      label: face(13, LABEL_SIZE, 500),
      text: face(12, 12),
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
