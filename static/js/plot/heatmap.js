/**
 * A heat map on the plots' core: the same axes, faces and export, cells in place of curves.
 *
 * The element becomes a figure with a name; the crosshair is a slider that arrow keys move from cell
 * to cell, and Enter, like a click, goes to the place it stands on.
 */

import { createMeasure, plainText, put, px, show, svg } from "../draw/svg.js";
import { plain, unitSuffix } from "../numbers/format.js";
import { h } from "../page/dom.js";
import { arrange } from "./arrange.js";
import {
  contour,
  createCells,
  createOutlines,
  drawKey,
  putCells,
  regionShapes,
  scaleOf,
  stops,
} from "./cells.js";
import { captioned, imageOf, PRINT_PADDING, published } from "./export.js";
import { createHost, library } from "./figure.js";
import { CONFIG, plotlyLayout } from "./plotly.js";
import { gridCsv, gridTable } from "./table.js";

/** Beside an exported map, for the key of its colors, px. */
const KEY_WIDTH = 110;

/** @param {readonly number[]} values ascending, equally spaced @param {number} value */
export function nearest(values, value) {
  const [first = 0, last = 1] = [values[0], values.at(-1)];
  const at = Math.round(((value - first) / (last - first || 1)) * (values.length - 1));
  return Math.min(Math.max(at, 0), values.length - 1);
}

/** Whether any cell lies beyond a range. @param {Grid["z"]} z @param {readonly [number, number]} range */
function reaches(z, [low, high]) {
  return z.some((row) => row.some((v) => v !== null && (v < low || v > high)));
}

/** @param {HTMLElement} element @param {MapOptions} options */
export function createHeatmap(element, options) {
  let { name, x: xAxis, y: yAxis, z: values, regions = [], ids = [] } = options;
  element.classList.add("heatmap");
  const host = createHost(element, () => {
    if (grid) placeKey();
    void settle();
  });
  const { area, canvas } = host;
  const root = svg("svg", { class: "plot-overlay", "aria-hidden": "true", focusable: "false" });
  const line = svg("path", { class: "map-level" }, root);
  const lineCasing = svg("path", { class: "map-level-casing" }, root);
  root.insertBefore(lineCasing, line);
  const outlines = createOutlines(root);
  const crossX = svg("line", { class: "plot-marker-line" }, root);
  const crossY = svg("line", { class: "plot-marker-line" }, root);
  const handle = h("div.map-handle", { tabindex: "0", role: "slider" });
  const tip = h("div.map-tip", { hidden: true, "aria-hidden": "true" });
  const key = h("div.map-key");
  area.append(root, handle, tip);
  element.append(key);

  /** @type {Grid | null} */
  let grid = null;
  /** @type {Arrangement | null} */
  let arrangement = null;
  /** @type {MapScale} */
  let scale = { kind: "size", low: 0, high: 1, capped: false };
  let current = { x: Number.NaN, y: Number.NaN };
  /** @type {{column: number, row: number} | null} the cell that the keyboard stands on, if it has left the current place */
  let probe = null;
  const cells = createCells();
  let framed = ""; // what stands around the cells that Plotly has drawn

  const axes = () => ({ x: xAxis, y: yAxis, y2: null });

  /** @param {number} column @param {number} row */
  function words(column, row) {
    const [x = 0, y = 0] = [grid?.x[column], grid?.y[row]];
    const value = grid?.z[row]?.[column] ?? null;
    const symbol = (/** @type {Axis} */ axis) => plainText(axis.short ?? axis.title);
    return `${symbol(xAxis)} ${plain(x, 4)}${unitSuffix(xAxis.unit)}, ${symbol(yAxis)} ${plain(y, 4)}${unitSuffix(yAxis.unit)}: ${values.print(value)}`;
  }

  function placeCross() {
    if (!arrangement || !grid) return;
    const { frame, ranges, xPixel, yPixel } = arrangement;
    const at = probe ? { x: grid.x[probe.column] ?? 0, y: grid.y[probe.row] ?? 0 } : current;
    const inX = at.x >= ranges.x[0] && at.x <= ranges.x[1];
    const inY = at.y >= ranges.y[0] && at.y <= ranges.y[1];
    const [left, top] = [px(xPixel(at.x)), px(yPixel(at.y))];
    show(crossX, inX);
    show(crossY, inY);
    if (inX) {
      for (const side of ["x1", "x2"]) put(crossX, side, left);
      put(crossX, "y1", frame.y);
      put(crossX, "y2", frame.y + frame.height);
    }
    if (inY) {
      for (const side of ["y1", "y2"]) put(crossY, side, top);
      put(crossY, "x1", frame.x);
      put(crossY, "x2", frame.x + frame.width);
    }
    handle.toggleAttribute("data-away", !(inX && inY));
    const [hx, hy] = inX && inY ? [left, top] : [frame.x, frame.y + frame.height];
    handle.style.transform = `translate(${hx}px, ${hy}px) translate(-50%, -50%)`;
    const column = probe ? probe.column : nearest(grid.x, at.x);
    const row = probe ? probe.row : nearest(grid.y, at.y);
    handle.setAttribute("aria-label", `${name}, place`);
    handle.setAttribute("aria-valuemin", String(grid.x[0]));
    handle.setAttribute("aria-valuemax", String(grid.x.at(-1)));
    handle.setAttribute("aria-valuenow", String(grid.x[column]));
    handle.setAttribute("aria-valuetext", words(column, row));
  }

  function placeLevel() {
    const { level } = values;
    if (!arrangement || !grid || !level) {
      show(line, false);
      show(lineCasing, false);
      return;
    }
    const { xPixel, yPixel } = arrangement;
    const levels = values.kind === "signed" ? [-level, level] : [level];
    const path = levels
      .flatMap((l) => contour(grid?.x ?? [], grid?.y ?? [], grid?.z ?? [], l))
      .map(
        ([a, b]) =>
          `M${px(xPixel(a[0]))},${px(yPixel(a[1]))}L${px(xPixel(b[0]))},${px(yPixel(b[1]))}`,
      )
      .join("");
    for (const node of [line, lineCasing]) {
      show(node, path !== "");
      node.setAttribute("d", path);
    }
  }

  const placeKey = () => drawKey(key, scale, values, host.theme().color);

  /** @param {Theme} [inks] */
  function traces(inks = host.theme()) {
    return [
      {
        type: /** @type {const} */ ("heatmap"),
        x: grid?.x,
        y: grid?.y,
        z: grid?.z,
        zmin: scale.low,
        zmax: scale.high,
        zauto: false,
        zsmooth: false,
        colorscale: stops(scale.kind, inks.color),
        showscale: false,
        hoverinfo: "skip",
      },
    ];
  }

  /** @param {Arrangement} layout @param {Theme} [inks] */
  function bareLayout(layout, inks = host.theme()) {
    const full = plotlyLayout(axes(), layout, inks);
    const still = { showgrid: false };
    return {
      ...full,
      hovermode: false,
      xaxis: { ...full.xaxis, ...still },
      yaxis: { ...full.yaxis, ...still, range: layout.ranges.y },
    };
  }

  /** @param {{width: number, height: number}} size @param {{header?: number, padding?: number}} [around] @param {Theme} [inks] */
  function arranged(size, around = {}, inks = host.theme()) {
    const measure = createMeasure(inks, 12);
    return arrange({
      size,
      axes: axes(),
      traces: [],
      measure,
      marksRow: false,
      unit: inks.unit,
      ...around,
    });
  }

  /**
   * The map with its colors' key, to stand alone.
   * @param {Size} size without the caption
   * @param {Theme} inks
   * @param {string} title above it, unless it is empty
   * @param {readonly string[]} [caption]
   * @returns {Plotly.Figure}
   */
  function framedFigure(size, inks, title, caption = []) {
    const around = title ? { header: 40 } : { padding: PRINT_PADDING };
    const layout = arranged({ ...size, width: size.width - KEY_WIDTH }, around, inks);
    const bare = bareLayout(layout, inks);
    const below = captioned(caption, { ...layout, size }, 0, inks);
    const bar = {
      title: { text: plainText(values.title), side: "right" },
      outlinewidth: 0,
      thickness: 16,
    };
    const { margins } = layout;
    return {
      data: traces(inks).map((t) => ({ ...t, showscale: true, colorbar: bar })),
      layout: {
        ...bare,
        width: size.width,
        height: size.height + below.height,
        shapes: regionShapes(regions, inks.ink),
        annotations: [...(bare.annotations ?? []), ...below.annotations],
        margin: { ...bare.margin, r: margins.right + KEY_WIDTH, b: margins.bottom + below.height },
        title: title && {
          text: `<b>${title}</b>`,
          x: 0.01,
          xanchor: "left",
          font: { size: 16, color: inks.ink },
        },
        paper_bgcolor: inks.paper,
        plot_bgcolor: inks.paper,
      },
      config: { ...CONFIG, staticPlot: true },
    };
  }

  async function settle() {
    if (!window.Plotly) await library();
    const size = host.size();
    if (!size || !grid) return;
    arrangement = arranged(size);
    const layout = bareLayout(arrangement);
    const frame = JSON.stringify([layout, grid.x, grid.y]);
    const inPlace =
      frame === framed &&
      putCells(canvas, cells(grid.z, scale, stops(scale.kind, host.theme().color)));
    framed = frame;
    const drawn = inPlace
      ? null
      : Plotly.react(canvas, /** @type {any} */ (traces()), layout, CONFIG);
    placeLevel();
    outlines.place(regions, arrangement);
    placeCross();
    await drawn;
  }

  /** @param {PointerEvent} event */
  function cellAt(event) {
    if (!arrangement || !grid) return null;
    const bounds = area.getBoundingClientRect();
    const [x, y] = [event.clientX - bounds.left, event.clientY - bounds.top];
    const { frame, ranges } = arrangement;
    if (x < frame.x || x > frame.x + frame.width || y < frame.y || y > frame.y + frame.height)
      return null;
    const down = (y - frame.y) / frame.height;
    return {
      x,
      y,
      column: nearest(grid.x, arrangement.xValue(x)),
      row: nearest(grid.y, ranges.y[1] - down * (ranges.y[1] - ranges.y[0])),
    };
  }

  /** @param {{column: number, row: number}} cell */
  function go({ column, row }) {
    probe = null;
    const [x, y] = [grid?.x[column], grid?.y[row]];
    if (x !== undefined && y !== undefined)
      options.onPick(Number(x.toPrecision(6)), Number(y.toPrecision(6)));
  }

  area.addEventListener("pointermove", (event) => {
    const cell = cellAt(event);
    tip.hidden = cell === null;
    if (!cell || !arrangement) return;
    tip.textContent = words(cell.column, cell.row);
    const left = cell.x > arrangement.frame.x + arrangement.frame.width / 2;
    tip.style.transform = `translate(${cell.x + (left ? -10 : 10)}px, ${cell.y - 12}px) translate(${left ? -100 : 0}%, -100%)`;
  });
  area.addEventListener("pointerleave", () => {
    tip.hidden = true;
  });
  area.addEventListener("click", (event) => {
    const cell = cellAt(/** @type {PointerEvent} */ (event));
    if (cell) go(cell);
  });
  handle.addEventListener("keydown", (event) => {
    if (!grid || event.ctrlKey || event.metaKey) return;
    const at = probe ?? { column: nearest(grid.x, current.x), row: nearest(grid.y, current.y) };
    if (event.key === "Enter" || event.key === " ") {
      event.preventDefault();
      go(at);
      return;
    }
    if (event.key === "Escape") {
      probe = null;
      placeCross();
      return;
    }
    const far = event.shiftKey ? 10 : 1;
    const step = {
      ArrowRight: [far, 0],
      ArrowLeft: [-far, 0],
      ArrowUp: [0, far],
      ArrowDown: [0, -far],
      PageUp: [0, 10],
      PageDown: [0, -10],
      Home: [-grid.x.length, 0],
      End: [grid.x.length, 0],
    }[event.key];
    if (!step) return;
    const [dx = 0, dy = 0] = step;
    event.preventDefault();
    probe = {
      column: Math.min(Math.max(at.column + dx, 0), grid.x.length - 1),
      row: Math.min(Math.max(at.row + dy, 0), grid.y.length - 1),
    };
    placeCross();
    tip.hidden = false;
    tip.textContent = `${words(probe.column, probe.row)} · Enter goes there`;
    tip.style.transform = `translate(${arrangement?.frame.x ?? 0}px, ${arrangement?.frame.y ?? 0}px)`;
  });
  handle.addEventListener("blur", () => {
    probe = null;
    tip.hidden = true;
    placeCross();
  });

  return {
    /** @param {Grid} next @param {Partial<Pick<MapOptions, "name" | "x" | "y" | "z" | "regions" | "ids">>} [changes] */
    draw(next, changes = {}) {
      grid = next;
      name = changes.name ?? name;
      xAxis = changes.x ?? xAxis;
      yAxis = changes.y ?? yAxis;
      values = changes.z ?? values;
      regions = changes.regions ?? regions;
      ids = changes.ids ?? ids;
      probe = null;
      scale = values.range
        ? {
            kind: values.kind,
            low: values.range[0],
            high: values.range[1],
            capped: reaches(grid.z, values.range),
          }
        : scaleOf(grid.z, values.kind);
      element.setAttribute("aria-label", name);
      placeKey();
      return settle();
    },
    /** @param {number} x @param {number} y */
    marker(x, y) {
      current = { x, y };
      placeCross();
    },
    about: () => ({ name, ids }),
    beside: KEY_WIDTH,
    /** @param {'png' | 'svg' | 'csv'} format @param {Publication} [publication] */
    async exportAs(format, publication) {
      if (!grid) throw new Error("there is no map yet");
      if (format === "csv")
        return new Blob([gridCsv(grid, xAxis, yAxis, plainText(values.title))], {
          type: "text/csv;charset=utf-8",
        });
      if (publication)
        return published(element, publication, format, ({ size, theme, caption }) =>
          framedFigure(size, theme, "", caption),
        );
      return imageOf(framedFigure({ width: 960, height: 720 }, host.theme(), name), format);
    },
    table: () => gridTable(name, grid, xAxis, yAxis, values.print),
    theme: host.refresh,
    destroy: host.destroy,
  };
}
