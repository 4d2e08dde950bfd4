/**
 * What plots and maps stand on: the page's theme as plain values, Plotly, and news of their size; and
 * a plot as Plotly's data and layout, on the page and for export alike: ranges, ticks, frame, curves.
 */

import { plotlyText } from "../draw/svg.js";
import { plain } from "../numbers/format.js";
import { h } from "../page/dom.js";

/** A line at the very end of a range would lose half its width to the frame's edge. */
const EDGE = 3;
const NARROW = 420;
const X_SPACING = 40;
const Y_SPACING = 44;

/**
 * @param {Axis} axis
 * @param {readonly Trace[]} traces
 * @returns {Span}
 */
export function axisRange(axis, traces) {
  const [low, high] = axis.range ?? roundRange(traces.map((trace) => trace.y));
  return [low ?? 0, high ?? 1];
}

/**
 * @param {Span} range
 * @param {number} length px
 * @returns {Span}
 */
function padded([low, high], length) {
  const more = ((high - low) / Math.max(length - 2 * EDGE, 1)) * EDGE;
  return [low - more, high + more];
}

/** The size of what stands at the axes, px. @param {number} width of the plot @param {number} [unit] */
export function textSize(width, unit = 1) {
  return (width < NARROW * unit ? 11 : 12) * unit;
}

/** @param {ArrangeOptions} task @returns {Arrangement} */
export function arrange({
  size,
  axes,
  traces,
  measure,
  marksRow,
  unit = 1,
  header = 0,
  padding = 0,
}) {
  const narrow = size.width < NARROW * unit;
  const fontSize = textSize(size.width, unit);
  const second = traces.some((trace) => trace.axis === "y2") ? axes.y2 : null;
  const top = padding + header + (marksRow ? 42 : 26) * unit;
  const bottom = padding + (axes.x.title ? 50 : 28) * unit;
  const height = Math.max(size.height - top - bottom, 20);

  const yRange = axisRange(
    axes.y,
    traces.filter((trace) => trace.axis !== "y2"),
  );
  const y2Range =
    second &&
    axisRange(
      second,
      traces.filter((trace) => trace.axis === "y2"),
    );
  const yTicks = axisTicks(
    axes.y,
    yRange,
    height,
    Math.min(Y_SPACING * unit, Math.max(26 * unit, height / 6)),
  );
  const y2Ticks = second && y2Range ? axisTicks(second, y2Range, height, Y_SPACING * unit) : [];
  /** @param {Tick[]} ticks */
  const widest = (ticks) => Math.max(0, ...ticks.map((tick) => measure(tick.label)));
  const left =
    padding + Math.ceil(Math.max(widest(yTicks), (axes.y.labels ?? 0) * unit)) + 12 * unit;
  const right = padding + (second ? Math.ceil(widest(y2Ticks)) + 14 * unit : 18 * unit);
  const width = Math.max(size.width - left - right, 20);
  const xRange = axisRange(axes.x, []);
  const log = axes.x.scale === "log";
  const xSpacing = (narrow ? X_SPACING - 6 : X_SPACING) * unit;
  const xTicks =
    log && !axes.x.ticks
      ? logTicks(xRange, width, xSpacing)
      : axisTicks(axes.x, xRange, width, xSpacing);
  const [xLow, xHigh] = log ? xRange.map(Math.log10) : xRange;
  const xSpan = (xHigh ?? 1) - (xLow ?? 0);

  const frame = { x: left, y: top, width, height };
  const ranges = {
    x: xRange,
    y: padded(yRange, height),
    y2: y2Range && padded(y2Range, height),
  };
  return {
    size,
    margins: { left, right, top, bottom },
    frame,
    ranges,
    ticks: { x: xTicks, y: yTicks, y2: y2Ticks },
    fontSize,
    unit,
    padding,
    marksRow,
    xPixel: (value) =>
      frame.x + (((log ? Math.log10(value) : value) - (xLow ?? 0)) / xSpan) * frame.width,
    yPixel: (value, axis = "y") => {
      const [low, high] = (axis === "y2" && ranges.y2) || ranges.y;
      return frame.y + ((high - value) / (high - low)) * frame.height;
    },
    xValue: (pixel) => {
      const value = (xLow ?? 0) + ((pixel - frame.x) / frame.width) * xSpan;
      return log ? 10 ** value : value;
    },
  };
}

const DEGREE_STEPS = [15, 30, 45, 90, 180];

/**
 * The smallest of 1, 2, 5 times a power of ten that is at least `least`.
 * @param {number} least
 */
export function roundStep(least) {
  const power = 10 ** Math.floor(Math.log10(least));
  const factor = [1, 2, 5, 10].find((candidate) => candidate * power >= least * (1 - 1e-9)) ?? 10;
  return factor * power;
}

/**
 * Multiples of a step inside a range.
 * @param {number} low
 * @param {number} high
 * @param {number} step
 */
function multiples(low, high, step) {
  const values = [];
  const slack = step * 1e-9;
  for (let n = Math.ceil((low - slack) / step); n * step <= high + slack; n += 1) {
    values.push(Number((n * step).toPrecision(12)));
  }
  return values;
}

/**
 * Every second, third … of the ticks, so that they stand at least `spacing` px apart.
 * @param {Tick[]} ticks ascending, equally spaced
 * @param {number} apart px from one to the next
 * @param {number} spacing px
 */
function thinned(ticks, apart, spacing) {
  const every = Math.max(1, Math.ceil(spacing / apart - 1e-9));
  const last = ticks.length - 1;
  // The ends of a range are kept where the count allows: 0, 30, 60, 90 and not 0, 45.
  const kept = [every, every + 1, every + 2].find((n) => last % n === 0) ?? every;
  return ticks.filter((_, index) => index % kept === 0);
}

/**
 * Ticks of an axis of a length.
 * @param {Pick<Axis, "ticks" | "unit" | "scale">} axis
 * @param {readonly [number, number]} range
 * @param {number} length px
 * @param {number} spacing smallest distance of two ticks in px
 * @returns {Tick[]}
 */
export function axisTicks(axis, range, length, spacing) {
  const low = Math.min(...range);
  const high = Math.max(...range);
  const span = high - low || 1;
  const suffix = axis.unit === "°" ? "°" : "";
  if (axis.ticks) {
    // an array has a method called `values`, so that is no way to tell them apart
    const { values, text } =
      "text" in axis.ticks
        ? axis.ticks
        : { values: axis.ticks, text: /** @type {string[]} */ ([]) };
    const given = values.map((value, index) => ({
      value,
      label: text[index] ?? plain(value, 12) + suffix,
    }));
    const place = axis.scale === "log" ? Math.log10 : Number;
    const whole = place(high) - place(low) || 1;
    const apart = (Math.abs(place(values[1] ?? high) - place(values[0] ?? low)) / whole) * length;
    return thinned(given, apart, spacing);
  }
  const least = (spacing / Math.max(length, 1)) * span;
  const step =
    (suffix && span >= 45 && DEGREE_STEPS.find((candidate) => candidate >= least * (1 - 1e-9))) ||
    roundStep(least);
  return multiples(low, high, step).map((value) => ({ value, label: plain(value, 12) + suffix }));
}

/**
 * Ticks of a logarithmic axis: 1, 2 and 5 of each decade, or 1 alone, or every second decade ...
 * @param {readonly [number, number]} range
 * @param {number} length px
 * @param {number} spacing smallest distance of two ticks in px
 * @returns {Tick[]}
 */
export function logTicks(range, length, spacing) {
  const [low, high] = [Math.min(...range), Math.max(...range)];
  const decades = Math.log10(high / low) || 1;
  const decade = length / decades;
  /** @param {readonly number[]} factors @param {number} every */
  const at = (factors, every) => {
    const values = [];
    const first = Math.floor(Math.log10(low));
    for (let power = first; power <= Math.log10(high); power += 1) {
      if (power % every !== 0) continue;
      for (const factor of factors) {
        const value = Number((factor * 10 ** power).toPrecision(6));
        if (value >= low * (1 - 1e-9) && value <= high * (1 + 1e-9)) values.push(value);
      }
    }
    return values;
  };
  const sets = [
    { factors: [1, 2, 3, 4, 5, 6, 7, 8, 9], apart: Math.log10(10 / 9) },
    { factors: [1, 2, 3, 5, 7], apart: Math.log10(7 / 5) },
    { factors: [1, 2, 5], apart: Math.log10(2) },
    { factors: [1, 3], apart: Math.log10(3) },
  ];
  const dense = sets.find(({ apart }) => apart * decade >= spacing);
  const every = dense ? 1 : Math.max(1, Math.ceil(spacing / decade - 1e-9));
  return at(dense?.factors ?? [1], every).map((value) => ({ value, label: plain(value, 12) }));
}

/**
 * A range that holds all values and ends at round numbers.
 * @param {Iterable<readonly (number | null)[]>} series
 * @returns {[number, number]}
 */
export function roundRange(series) {
  let low = Number.POSITIVE_INFINITY;
  let high = Number.NEGATIVE_INFINITY;
  for (const values of series) {
    for (const value of values) {
      if (value === null || !Number.isFinite(value)) continue;
      if (value < low) low = value;
      if (value > high) high = value;
    }
  }
  if (low > high) return [0, 1];
  if (low === high) {
    const around = Math.abs(low) || 1;
    return low === 0 ? [0, 1] : [low - around / 2, high + around / 2];
  }
  const step = roundStep((high - low) / 8);
  return [
    Number((Math.floor(low / step + 1e-9) * step).toPrecision(12)),
    Number((Math.ceil(high / step - 1e-9) * step).toPrecision(12)),
  ];
}

/** Nothing of a plot leaves the page, and what can be done with it stands beside it, not on it. */
export const CONFIG = Object.freeze({
  displayModeBar: false,
  displaylogo: false,
  doubleClick: false,
  plotlyServerURL: "",
  responsive: false,
  scrollZoom: false,
  showSendToCloud: false,
  showTips: false,
});

const TRANSPARENT = "rgba(0,0,0,0)";

/**
 * A unit as it stands behind a number: degrees close up, others keep a space.
 * @param {string | undefined} unit
 */
export function unitSuffix(unit) {
  if (!unit) return "";
  return unit === "°" ? unit : ` ${unit.trim()}`;
}

/**
 * The symbol of a title when it has one ("angle of incidence θ_i (degrees)" is "θ_i"), else all of it.
 * @param {string} title
 */
export function shortTitle(title) {
  return title.match(/\p{L}(?:_\{[^}]*\}|_[\p{L}\p{N}]|[₀₁₂ᵢₚₛₜ])/u)?.[0] ?? title;
}

/**
 * @param {readonly Trace[]} traces
 * @param {Theme} theme
 * @returns {Plotly.Trace[]}
 */
export function plotlyTraces(traces, theme) {
  return traces.map((trace, index) => ({
    type: "scatter",
    mode: "lines",
    uid: traceUid(index),
    name: plotlyText(trace.label),
    x: trace.x,
    y: trace.y,
    xaxis: "x",
    yaxis: trace.axis ?? "y",
    connectgaps: false,
    hovertemplate: `%{y:.6g}${unitSuffix(trace.unit)}<extra>${plotlyText(trace.label)}</extra>`,
    line: {
      color: theme.color(trace.color),
      width: trace.width ?? 2,
      dash: trace.dash ?? "solid",
      shape: "linear",
      // Every sample stays a point of the path, as the fast path writes it.
      simplify: false,
    },
  }));
}

/** @param {number} index */
export function traceUid(index) {
  return `curve${index}`;
}

/**
 * @param {Axis} axis
 * @param {[number, number]} range
 * @param {Tick[]} ticks
 * @param {Arrangement} arrangement
 * @param {Theme} theme
 * @returns {Plotly.Axis}
 */
function plotlyAxis(axis, range, ticks, arrangement, theme) {
  return {
    type: axis.scale ?? "linear",
    range: axis.scale === "log" ? [Math.log10(range[0]), Math.log10(range[1])] : range,
    autorange: false,
    automargin: false,
    fixedrange: true,
    tickmode: "array",
    tickvals: ticks.map((tick) => tick.value),
    ticktext: ticks.map((tick) => tick.label),
    tickangle: 0,
    tickfont: { size: arrangement.fontSize, color: theme.muted },
    ticks: "",
    ticklabelstandoff: 3,
    gridcolor: theme.rule,
    gridwidth: 1,
    showgrid: true,
    showline: false,
    zeroline: false,
    hoverformat: axis.unit === "°" ? ".2f" : ".6~g",
  };
}

/**
 * The title of a vertical axis stands level above it: nobody turns the head to read it.
 * @param {Axis} axis
 * @param {"left" | "right"} side
 * @param {Arrangement} arrangement
 * @param {Theme} theme
 */
function levelTitle(axis, side, arrangement, theme) {
  const { margins, fontSize, padding } = arrangement;
  const left = side === "left";
  return {
    text: plotlyText(axis.title),
    xref: "paper",
    yref: "paper",
    x: left ? 0 : 1,
    y: 1,
    xanchor: side,
    yanchor: "bottom",
    xshift: left ? padding - margins.left : margins.right - padding,
    yshift: 6,
    showarrow: false,
    borderpad: 0,
    font: { size: fontSize, color: theme.muted },
  };
}

/**
 * @param {Axes} axes
 * @param {Arrangement} arrangement
 * @param {Theme} theme
 * @returns {Plotly.Layout}
 */
export function plotlyLayout(axes, arrangement, theme) {
  const { size, margins, ranges, ticks, fontSize } = arrangement;
  const x = plotlyAxis(axes.x, ranges.x, ticks.x, arrangement, theme);
  const annotations = [levelTitle(axes.y, "left", arrangement, theme)];
  /** @type {Plotly.Layout} */
  const layout = {
    width: size.width,
    height: size.height,
    autosize: false,
    margin: { l: margins.left, r: margins.right, t: margins.top, b: margins.bottom, pad: 0 },
    paper_bgcolor: TRANSPARENT,
    plot_bgcolor: TRANSPARENT,
    font: { family: theme.family, size: fontSize, color: theme.muted },
    showlegend: false,
    dragmode: false,
    hovermode: "x unified",
    hoverlabel: {
      bgcolor: theme.panel,
      bordercolor: theme.rule,
      font: { family: theme.family, size: 12 * arrangement.unit, color: theme.ink },
    },
    xaxis: {
      ...x,
      title: {
        text: plotlyText(axes.x.title),
        standoff: 10 * arrangement.unit,
        font: { size: fontSize, color: theme.muted },
      },
      // The overlay draws the hovered abscissa itself: Plotly's spike is three lines thick.
      showspikes: false,
      unifiedhovertitle: {
        text: `${plotlyText(shortTitle(axes.x.title || axes.x.short || "x"))} = %{x:${axes.x.unit === "°" ? ".2f" : ".6~g"}}${unitSuffix(axes.x.unit)}`,
      },
    },
    yaxis: plotlyAxis(axes.y, ranges.y, ticks.y, arrangement, theme),
    annotations,
  };
  if (axes.y2 && ranges.y2) {
    layout.yaxis2 = {
      ...plotlyAxis(axes.y2, ranges.y2, ticks.y2, arrangement, theme),
      overlaying: "y",
      side: "right",
      showgrid: false,
    };
    annotations.push(levelTitle(axes.y2, "right", arrangement, theme));
  }
  return layout;
}

/** Plotly clips points further than this many frames away; such a curve is left to Plotly. */
const FRAMES_AWAY = 20;

/**
 * Path of a curve with gaps at `null`, or `null` itself when Plotly would clip it. Its pieces, each an
 * element of its own in Plotly, are joined by an `M`, so that their number need not follow the data.
 * @param {readonly number[]} xPixels
 * @param {readonly (number | null)[]} y
 * @param {PixelAxis} axis
 * @returns {string | null}
 */
export function curvePath(xPixels, y, axis) {
  const lowest = axis._length * (FRAMES_AWAY + 1);
  const highest = -axis._length * FRAMES_AWAY;
  let path = "";
  let pen = "M";
  for (let index = 0; index < xPixels.length; index += 1) {
    const value = y[index];
    if (value === null || value === undefined || !Number.isFinite(value)) {
      pen = "M";
      continue;
    }
    const pixel = axis.l2p(value);
    if (pixel > lowest || pixel < highest) return null;
    path += `${pen}${xPixels[index]},${pixel}`;
    pen = "L";
  }
  return path;
}

/**
 * A memory of the pixels of an abscissa, which is the same for all curves and between frames.
 * @param {PixelAxis} axis
 */
export function createPixels(axis) {
  /** @type {readonly number[]} */
  let known = [];
  /** @type {number[]} */
  let pixels = [];
  return (/** @type {readonly number[]} */ x) => {
    if (x === known) return pixels;
    if (x.length !== known.length || x.some((value, index) => value !== known[index])) {
      pixels = x.map((value) => axis.l2p(value));
    }
    known = x;
    return pixels;
  };
}

/** @param {Trace} trace */
const axisOf = (trace) => trace.axis ?? "y";

/** @param {HTMLElement} canvas where Plotly draws */
export function createFastPath(canvas) {
  /** @type {DrawnLine[] | null} */
  let lines = null;
  /** @type {((x: readonly number[]) => readonly number[]) | null} */
  let pixels = null;

  return {
    /**
     * Find the elements of what has just been drawn.
     * @param {readonly Trace[]} traces
     */
    find(traces) {
      const full = /** @type {Plotly.PlotElement} */ (canvas)._fullLayout;
      pixels = createPixels(full.xaxis);
      lines = [];
      for (const [index, trace] of traces.entries()) {
        const group = canvas.getElementsByClassName(`trace${traceUid(index)}`)[0];
        const [path, ...rest] = group?.querySelectorAll("path.js-line") ?? [];
        const scale = axisOf(trace) === "y2" ? full.yaxis2 : full.yaxis;
        if (!path) {
          // nothing was drawn of this curve, so there is nothing to write to
          lines = null;
          return;
        }
        lines.push({
          id: trace.id,
          axis: axisOf(trace),
          path,
          rest,
          scale: /** @type {Plotly.FullAxis} */ (scale),
        });
      }
    },

    /**
     * Write the curves, all or none.
     * @param {readonly Trace[]} traces
     * @returns {boolean} whether they were written; if not, they have to be drawn
     */
    write(traces) {
      if (!lines || !pixels || traces.length !== lines.length) return false;
      /** @type {string[]} */
      const paths = [];
      for (const [index, line] of lines.entries()) {
        const trace = traces[index];
        if (!trace || trace.id !== line.id || axisOf(trace) !== line.axis) return false;
        const path = curvePath(pixels(trace.x), trace.y, line.scale);
        if (path === null) return false;
        paths.push(path);
      }
      for (const [index, line] of lines.entries()) {
        line.path.setAttribute("d", paths[index] ?? "");
        for (const other of line.rest) other.removeAttribute("d");
      }
      return true;
    },
  };
}

/** The page's text at a desk, px; every size below is given for it. */
const BASE = 14;

/**
 * @param {HTMLElement} element
 * @returns {Theme}
 */
export function readTheme(element) {
  const style = getComputedStyle(element);
  const root = Number.parseFloat(getComputedStyle(document.documentElement).fontSize);
  /** @param {string} property @param {string} otherwise */
  const read = (property, otherwise) => style.getPropertyValue(property).trim() || otherwise;
  const ink = read("--ink", "#14181f");
  return {
    ink,
    paper: read("--paper", "#ffffff"),
    panel: read("--panel", "#ffffff"),
    muted: read("--muted", "#5a6472"),
    rule: read("--rule", "#e3e5e8"),
    accent: read("--accent", "#2456c8"),
    unit: root > 0 ? root / BASE : 1,
    family: style.fontFamily || "sans-serif",
    symbolFamily: read("--serif", "serif"),
    color: (property) => read(property, ink),
  };
}

/** @type {Promise<void> | null} */
let asked = null;

/** Plotly, asked for once. @returns {Promise<void>} once its script has run */
export function library() {
  asked ??= new Promise((run, refuse) => {
    const { href } = /** @type {HTMLLinkElement} */ (document.getElementById("plotly"));
    const script = h("script", { src: href });
    script.addEventListener("load", () => run());
    script.addEventListener("error", () => {
      asked = null;
      script.remove();
      refuse(new Error("Plotly could not be loaded"));
    });
    document.head.append(script);
  });
  return asked;
}

/**
 * Whether some of an element is seen: on the screen, and not behind the sheet that holds a phone's controls.
 * @param {HTMLElement} element
 * @returns {Promise<void>} once it is
 */
export function seen(element) {
  const sheet = element.closest(".view")?.querySelector(".panel");
  const fixed = sheet && getComputedStyle(sheet).position === "fixed";
  const rootMargin = `0px 0px ${fixed ? -sheet.clientHeight : 0}px`;
  return new Promise((done) => {
    const watching = new IntersectionObserver(
      (entries) => {
        if (!entries.some((entry) => entry.isIntersecting)) return;
        watching.disconnect();
        done();
      },
      { rootMargin },
    );
    watching.observe(element);
  });
}

/** The smallest area that is worth drawing into; a hidden one has no size. */
const SMALLEST = 40;

/**
 * Draw anew when the size, the letters or the colors of what is drawn into change.
 * @param {HTMLElement} element whose colors they are
 * @param {HTMLElement} area
 * @param {() => void} draw
 */
export function watchSize(element, area, draw) {
  let theme = readTheme(element);
  /** @type {Size} */
  let drawn = { width: 0, height: 0 };
  let waiting = 0;

  function refresh() {
    theme = readTheme(element); // letters grow with the window, too
    draw();
  }
  function resize() {
    cancelAnimationFrame(waiting);
    waiting = requestAnimationFrame(() => {
      if (area.clientWidth !== drawn.width || area.clientHeight !== drawn.height) refresh();
    });
  }
  const observer = new ResizeObserver(resize);
  observer.observe(area);
  void document.fonts.ready.then(refresh);

  return {
    theme: () => theme,
    /** What can be drawn into now. @returns {Size | null} */
    size() {
      const { clientWidth: width, clientHeight: height, isConnected } = area;
      if (!isConnected || width < SMALLEST || height < SMALLEST) return null;
      drawn = { width, height };
      return drawn;
    },
    refresh,
    resize,
    stop() {
      cancelAnimationFrame(waiting);
      observer.disconnect();
    },
  };
}

/** Make a figure of an element: an area in it for Plotly to draw into. @param {HTMLElement} element @param {() => void} draw */
export function createHost(element, draw) {
  element.classList.add("plot");
  element.setAttribute("role", "figure");
  /** @type {HTMLElement} */
  const canvas = h("div.plot-canvas", { "aria-hidden": "true" });
  const area = h("div.plot-area", canvas);
  element.append(area);
  const { stop, ...watched } = watchSize(element, area, draw);
  return {
    ...watched,
    area,
    canvas,
    destroy() {
      stop();
      window.Plotly?.purge(canvas);
      element.replaceChildren();
    },
  };
}
