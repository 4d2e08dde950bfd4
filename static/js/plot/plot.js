/**
 * Plots of curves over an abscissa: drawn by Plotly when things stand still, by writing the paths
 * directly while something moves (a tenth of the cost). Legend, table and files are loaded when asked
 * for. Readers get the data table and, where an abscissa can be picked, a slider on the axis.
 */

import { plainText, put } from "../draw/svg.js";
import { plain, unitSuffix } from "../numbers/format.js";
import { h, listen } from "../page/dom.js";
import { arrange } from "./arrange.js";
import { createFastPath } from "./fast.js";
import { createHost, library, seen } from "./figure.js";
import { createOverlay, MOST_LABELS } from "./overlay.js";
import { CONFIG, plotlyLayout, plotlyTraces } from "./plotly.js";

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
  element.setAttribute("aria-label", name);
  const host = createHost(element, () => void settle());
  const { area, canvas } = host;
  const overlay = createOverlay(area);
  const handle = h("div.plot-handle", { hidden: true });
  area.append(handle);
  const legend = h("ul.plot-legend", { hidden: true });
  element.append(legend);
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
  /** @type {Promise<void> | null} */
  let looking = null;
  const settle = async () => {
    turn += 1;
    const own = turn;
    if (!window.Plotly) {
      if (options.meanwhile?.isConnected) {
        looking ??= seen(area);
        await looking;
      }
      await library();
      if (own !== turn) return;
    }
    const size = host.size();
    if (!size || traces.length === 0) return;
    const theme = host.theme();
    overlay.useFaces(theme);
    const shapes = bands.length ? (await import("./bands.js")).bandShapes(bands, theme) : [];
    if (own !== turn) return;
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
        shapes,
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
        onPick(x, how) {
          marker = { ...marker, x }; // at once: the next press may come before the next frame
          options.onPick?.(x, how);
        },
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
      const picture = {
        traces,
        marks: shown,
        bands,
        most,
        axes,
        size,
        theme: host.theme(),
        at: marker.x,
      };
      return exportPlot(element, { ...picture, title: name }, format, publication);
    },
    filename: (format) => `${options.filename ?? "plot"}.${format}`,
    table: () => {
      const table = h("table");
      const shown = /** @type {const} */ ([name, axes.x, traces]);
      void import("./table.js").then(({ fillTable }) => fillTable(table, ...shown));
      return table;
    },
    theme: host.refresh,
    resize: host.resize,
    destroy: () => {
      stopPicking();
      host.destroy();
    },
  };
}

const SIDEWAYS = 6;
const BESIDE = 12;

/** @param {PicksOptions} task @returns {() => void} stop listening */
export function listenForPicks({ area, handle, arrangement, current, steps, onPick, onActive }) {
  /** @type {{id: number, x: number, y: number, waiting: boolean} | null} */
  let grip = null;

  /** @param {number} value @param {Arrangement} layout */
  const inRange = (value, { ranges }) =>
    Math.min(Math.max(value, Math.min(...ranges.x)), Math.max(...ranges.x));

  let lastX = 0;
  /** @param {PointerEvent} event @param {boolean} settled */
  const pick = (event, settled) => {
    const layout = arrangement();
    if (!layout) return;
    // a cancelled pointer has no position of its own
    if (event.type !== "pointercancel") lastX = event.clientX;
    const value = layout.xValue(lastX - area.getBoundingClientRect().left);
    onPick(inRange(value, layout), { settled, fine: event.shiftKey, free: event.altKey });
  };

  /** @param {PointerEvent} event */
  const release = (event) => {
    if (!grip || event.pointerId !== grip.id) return;
    const scrolled = grip.waiting && event.type !== "pointerup";
    grip = null;
    onActive(false);
    if (!scrolled) pick(event, true);
  };
  const listening = new AbortController();
  listen(area, listening.signal, {
    pointerdown(event) {
      const layout = arrangement();
      if (!layout || !event.isPrimary || event.button !== 0) return;
      const bounds = area.getBoundingClientRect();
      const x = event.clientX - bounds.left;
      const { frame } = layout;
      const y = event.clientY - bounds.top;
      if (x < frame.x - BESIDE || x > frame.x + frame.width + BESIDE || y < frame.y - BESIDE)
        return;
      const waiting = event.pointerType === "touch" && event.target !== handle;
      grip = { id: event.pointerId, x: event.clientX, y: event.clientY, waiting };
      if (waiting) return;
      area.setPointerCapture(event.pointerId);
      onActive(true);
      handle.focus({ preventScroll: true });
      event.preventDefault();
      pick(event, false);
    },
    pointermove(event) {
      if (!grip || event.pointerId !== grip.id) return;
      if (grip.waiting) {
        if (Math.abs(event.clientX - grip.x) < SIDEWAYS) return;
        grip.waiting = false;
        area.setPointerCapture(event.pointerId);
        onActive(true);
      }
      pick(event, false);
    },
    pointerup: release,
    pointercancel: release,
  });
  listen(handle, listening.signal, {
    keydown(event) {
      const layout = arrangement();
      const from = current();
      if (!layout || from === null || event.ctrlKey || event.metaKey) return;
      const { step, fine, page } = steps();
      const arrow = event.shiftKey ? fine : step;
      /** @type {Record<string, number>} */
      const targets = {
        ArrowLeft: from - arrow,
        ArrowDown: from - arrow,
        ArrowRight: from + arrow,
        ArrowUp: from + arrow,
        PageDown: from - page,
        PageUp: from + page,
        Home: Number.NEGATIVE_INFINITY,
        End: Number.POSITIVE_INFINITY,
      };
      const target = targets[event.key];
      if (target === undefined) return;
      event.preventDefault();
      const value = Number(inRange(target, layout).toPrecision(12));
      onPick(value, { settled: true, fine: event.shiftKey, free: true });
    },
  });
  return () => listening.abort();
}
