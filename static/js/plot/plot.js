/**
 * Plots of curves over an abscissa, drawn by Plotly when things stand still and by writing the
 * paths directly while a pointer is down (a tenth of the cost).
 *
 * What the first picture does without (legend, table, files) is loaded when it is asked for.
 *
 * The element becomes a figure with a name; its SVG is hidden from readers, who get the data table
 * and, where an abscissa can be picked, a slider on the axis.
 */

import { plainText, put } from "../draw/svg.js";
import { plain } from "../numbers/format.js";
import { arrange } from "./axes.js";
import {
  bandShapes,
  CONFIG,
  createFastPath,
  plotlyLayout,
  plotlyTraces,
  unitSuffix,
} from "./figure.js";
import { readTheme } from "./host.js";
import { createOverlay, MOST_LABELS } from "./overlay.js";
import { listenForPicks } from "./pick.js";

const SMALLEST = 40;

/**
 * @param {HTMLElement} parent
 * @param {string} className
 * @param {keyof HTMLElementTagNameMap} [tag]
 */
function child(parent, className, tag = "div") {
  const node = document.createElement(tag);
  node.className = className;
  parent.append(node);
  return node;
}

/**
 * The library, once its script has run.
 * @returns {Promise<Plotly.Library>}
 */
async function library() {
  if (window.Plotly) return window.Plotly;
  const script = document.querySelector('script[src*="plotly"]');
  if (!script) throw new Error("Plotly's script is not on the page");
  await new Promise((resolve, reject) => {
    script.addEventListener("load", resolve, { once: true });
    script.addEventListener("error", () => reject(new Error("Plotly could not be loaded")), {
      once: true,
    });
  });
  return library();
}

/**
 * @param {Axis} axis
 * @param {number} value
 */
function axisValue(axis, value) {
  // 0.01 degrees and 0.0001 radians: what an eye or a hand can tell apart
  const decimals = { "°": 2, rad: 4 }[axis.unit?.trim() ?? ""];
  const text = decimals === undefined ? plain(value) : value.toFixed(decimals);
  return text + unitSuffix(axis.unit);
}

/**
 * A mark says where it stands, unless its label does already.
 * @param {readonly Mark[]} marks
 * @param {Axis} axis
 */
function valued(marks, axis) {
  return marks.map((mark) =>
    /\d/u.test(mark.label) ? mark : { ...mark, label: `${mark.label} ${axisValue(axis, mark.x)}` },
  );
}

/**
 * @param {HTMLElement} element
 * @param {PlotOptions} options
 * @returns {Plot}
 */
export function createPlot(element, options) {
  const axes = { x: options.x, y: options.y, y2: options.y2 ?? null };
  let name = options.name;
  const most = options.names ?? MOST_LABELS;
  element.classList.add("plot");
  element.setAttribute("role", "figure");
  element.setAttribute("aria-label", name);

  const area = child(element, "plot-area");
  const canvas = child(area, "plot-canvas");
  canvas.setAttribute("aria-hidden", "true");
  const overlay = createOverlay(area);
  const handle = child(area, "plot-handle");
  handle.hidden = true;
  const legend = child(element, "plot-legend", "ul");
  legend.hidden = true;

  let theme = readTheme(element);
  overlay.useFaces(theme);
  void document.fonts.ready.then(() => {
    overlay.useFaces(theme);
    void settle();
  });
  /** @type {readonly Trace[]} */
  let traces = [];
  /** @type {readonly Mark[]} */
  let marks = [];
  /** @type {readonly Band[]} */
  let bands = [];
  /** @type {{x: number | null, points: readonly Reached[]}} */
  let marker = { x: null, points: [] };
  /** @type {Arrangement | null} */
  let arrangement = null;
  const fastPath = createFastPath(canvas);
  let marksRow = Boolean(options.onPick);
  let destroyed = false;

  const uprights = () => {
    const landmarks = marks.filter((mark) => mark.kind === "landmark").map((mark) => mark.x);
    return marker.x === null ? landmarks : [...landmarks, marker.x];
  };

  const placeMarker = () => {
    if (!arrangement) return;
    const { x, points } = marker;
    overlay.placeMarker(x, points, traces, arrangement);
    if (x !== null && overlay.inTheWay(arrangement.xPixel(x))) {
      overlay.placeNames(traces, arrangement, uprights(), most);
    }
    const { ranges, frame } = arrangement;
    const visible = x !== null && x >= ranges.x[0] && x <= ranges.x[1];
    handle.hidden = !visible;
    if (!visible || x === null) return;
    const value = axisValue(axes.x, x);
    if (handle.textContent !== value) handle.textContent = value;
    handle.style.transform = `translate(${arrangement.xPixel(x)}px, ${frame.y + frame.height + 4}px) translateX(-50%)`;
    if (!options.onPick) return;
    put(handle, "aria-valuenow", x);
    const said = points
      .filter(({ y }) => y !== null)
      .map(({ id, y }) => {
        const trace = traces.find((candidate) => candidate.id === id);
        return trace ? `${plainText(trace.label)} ${(y ?? 0).toPrecision(6)}` : "";
      });
    put(handle, "aria-valuetext", [value, ...said].filter(Boolean).join(", "));
  };

  const decorate = () => {
    if (!arrangement) return;
    overlay.placeMarks(valued(marks, axes.x), arrangement, axes.y.title);
    overlay.placeNames(traces, arrangement, uprights(), most);
    overlay.hideHover();
    placeMarker();
  };

  let turn = 0;
  const settle = async () => {
    turn += 1;
    const own = turn;
    if (!window.Plotly) {
      await library();
      if (own !== turn) return;
    }
    const size = { width: area.clientWidth, height: area.clientHeight };
    if (destroyed || traces.length === 0 || size.width < SMALLEST || size.height < SMALLEST) return;
    marksRow ||= marks.some((mark) => mark.kind === "landmark");
    arrangement = arrange({
      size,
      axes,
      traces,
      measure: overlay.tickWidth,
      marksRow,
      unit: theme.unit,
    });
    const drawn = Plotly.react(
      canvas,
      plotlyTraces(traces, theme),
      // The fast path changes what is on the page behind Plotly's back: never let it compare.
      {
        ...plotlyLayout(axes, arrangement, theme),
        shapes: bandShapes(bands, theme),
        datarevision: own,
      },
      CONFIG,
    );
    delete element.dataset.fast;
    decorate();
    fastPath.find(traces);
    listenForHover();
    await drawn;
  };

  let hovering = false;
  const listenForHover = () => {
    if (hovering) return;
    hovering = true;
    const plot = /** @type {Plotly.PlotElement} */ (canvas);
    plot.on("plotly_hover", ({ points }) => {
      if (!arrangement) return;
      overlay.placeHover(
        points[0].x,
        points.map((/** @type {{curveNumber: number, y: number}} */ { curveNumber, y }) => ({
          id: traces[curveNumber]?.id ?? "",
          y,
        })),
        traces,
        arrangement,
      );
    });
    plot.on("plotly_unhover", () => overlay.hideHover());
  };

  /** @param {readonly Trace[]} next an axis that follows its data may have to grow */
  const staysInRange = (next) =>
    next.every((trace) => {
      const axis = trace.axis === "y2" ? axes.y2 : axes.y;
      const range = trace.axis === "y2" ? arrangement?.ranges.y2 : arrangement?.ranges.y;
      if (!axis || axis.range || !range) return true;
      return trace.y.every((value) => value === null || (value >= range[0] && value <= range[1]));
    });

  const showLegend = () => {
    const wanted = traces.filter((trace) => !trace.bare).length > most;
    legend.hidden = !wanted;
    if (wanted) void import("./legend.js").then(({ drawLegend }) => drawLegend(legend, traces));
  };

  /** @type {Plot["draw"]} */
  const draw = (next, nextMarks = [], nextBands = []) => {
    traces = next;
    marks = nextMarks;
    bands = nextBands;
    const now = marks.find((mark) => mark.kind === "current");
    if (now) marker = { ...marker, x: now.x };
    showLegend();
    return settle();
  };

  let waiting = 0;
  const resize = () => {
    cancelAnimationFrame(waiting);
    waiting = requestAnimationFrame(() => {
      const { width, height } = arrangement?.size ?? { width: 0, height: 0 };
      if (area.clientWidth === width && area.clientHeight === height) return;
      theme = readTheme(element); // letters grow with the window, too
      overlay.useFaces(theme);
      void settle();
    });
  };
  const observer = new ResizeObserver(resize);
  observer.observe(area);

  const stopPicking = options.onPick
    ? listenForPicks({
        area,
        handle,
        arrangement: () => arrangement,
        current: () => marker.x,
        steps: () => {
          if (axes.x.steps) return axes.x.steps;
          const [low = 0, high = 1] = axes.x.range ?? [];
          const span = Math.abs(high - low);
          return { step: span / 180, fine: span / 1800, page: span / 18 };
        },
        onPick: options.onPick,
        onActive: (active) => {
          element.toggleAttribute("data-picking", active);
        },
      })
    : () => {};

  const describeHandle = () => {
    if (!options.onPick) {
      handle.setAttribute("aria-hidden", "true");
      return;
    }
    const [low = 0, high = 1] = axes.x.range ?? [];
    handle.setAttribute("role", "slider");
    handle.tabIndex = 0;
    handle.setAttribute("aria-label", plainText(axes.x.title || axes.x.short || "abscissa"));
    handle.setAttribute("aria-valuemin", String(low));
    handle.setAttribute("aria-valuemax", String(high));
    element.dataset.pick = "";
  };
  describeHandle();

  return {
    draw,
    fast: (next, nextMarks) => {
      if (!staysInRange(next) || !fastPath.write(next)) {
        void draw(next, nextMarks ?? marks, bands);
        return;
      }
      if (!("fast" in element.dataset)) element.dataset.fast = "";
      traces = next;
      if (nextMarks) marks = nextMarks;
      decorate();
    },
    marker: (x, points = []) => {
      marker = { x, points };
      placeMarker();
    },
    axes: (changes) => {
      axes.x = changes.x ?? axes.x;
      axes.y = changes.y ?? axes.y;
      if (changes.y2 !== undefined) axes.y2 = changes.y2;
      name = changes.name ?? name;
      element.setAttribute("aria-label", name);
      describeHandle();
    },
    about: () => ({ name, ids: traces.map((trace) => trace.id) }),
    exportAs: async (format, publication) => {
      if (format === "csv") {
        const { toCsv } = await import("./table.js");
        return new Blob([toCsv(axes.x.column ?? plainText(axes.x.title), traces)], {
          type: "text/csv;charset=utf-8",
        });
      }
      const { exportPlot } = await import("./export.js");
      const shown = valued(marks, axes.x);
      const size = arrangement?.size;
      const picture = { traces, marks: shown, bands, most, axes, size, theme, at: marker.x };
      return exportPlot(element, { ...picture, title: name }, format, publication);
    },
    filename: (format) => `${options.filename ?? "plot"}.${format}`,
    table: () => {
      const table = document.createElement("table");
      const shown = /** @type {const} */ ([name, axes.x, traces]);
      void import("./table.js").then(({ fillTable }) => fillTable(table, ...shown));
      return table;
    },
    theme: () => {
      theme = readTheme(element);
      overlay.useFaces(theme);
      void settle();
    },
    resize,
    destroy: () => {
      destroyed = true;
      cancelAnimationFrame(waiting);
      observer.disconnect();
      stopPicking();
      Plotly.purge(canvas);
      element.replaceChildren();
    },
  };
}
