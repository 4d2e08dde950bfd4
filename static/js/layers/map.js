/** Colors over thickness and angle, painted cell by cell; the crosshair is a slider in two directions. */

import { angle, clamp, plain } from "../numbers/format.js";
import { encoded } from "../numbers/srgb.js";
import { createChanged } from "../page/changed.js";
import { h, setText } from "../page/dom.js";
import { nearest } from "../plot/heatmap.js";
import { thicknessText } from "./layers.js";

/**
 * @typedef {{model: string, linear_srgb: number[][][], hex: string[][], lab: number[][][], delta_e: number[][] | null}} Colors
 * @typedef {{thickness_nm: number[], theta_i_deg: number[], layer: number, step_nm: number, colors: Colors[], warnings: string[]}} ColorMap
 */

/** As bytes by linear value: 4096 steps are finer than a byte can show. */
const BYTES = Uint8ClampedArray.from({ length: 4097 }, (_, i) =>
  Math.round(255 * encoded(i / 4096)),
);

/** Beyond it everything turns white, which is no measure of the rest. */
export const FITS_TO = 60;

/**
 * How much brighter colors may be shown without any channel above 1 up to 60 degrees.
 * @param {readonly number[][][]} rows a row each thickness, a color each angle
 * @param {readonly number[]} degrees
 */
export function brightening(rows, degrees) {
  const after = degrees.findIndex((deg) => deg > FITS_TO);
  const columns = after > 0 ? after : degrees.length;
  let most = 0;
  for (const row of rows)
    for (const color of row.slice(0, columns)) most = Math.max(most, ...color);
  return most > 0 ? Math.max(1, 1 / most) : 1;
}

/**
 * @param {readonly number[][][]} rows a row each thickness, a color each angle
 * @param {number | null} factor null makes each color as bright as it can be
 * @returns {{width: number, height: number, data: Uint8ClampedArray<ArrayBuffer>}} thickness to the right, normal incidence at the bottom
 */
export function pixels(rows, factor) {
  const [width, height] = [rows.length, rows[0]?.length ?? 0];
  const data = new Uint8ClampedArray(4 * width * height);
  rows.forEach((row, x) => {
    row.forEach((color, y) => {
      const at = 4 * ((height - 1 - y) * width + x);
      const times = factor ?? 1 / Math.max(...color, 1e-9);
      for (let c = 0; c < 3; c += 1)
        data[at + c] = BYTES[Math.round(4096 * clamp(times * (color[c] ?? 0), 0, 1))] ?? 0;
      data[at + 3] = 255;
    });
  });
  return { width, height, data };
}

const DEGREES = [0, 30, 60, 90];

/**
 * @param {string} name
 * @param {(nm: number, deg: number, settled: boolean) => void} onPick
 * @param {() => void} onSettle
 */
export function createMap(name, onPick, onSettle) {
  const canvas = h("canvas.film-canvas", { "aria-hidden": "true" });
  const cross = h("div.film-cross", { "aria-hidden": "true" });
  const handle = h("div.map-handle", { tabindex: "0", role: "slider", "aria-label": name });
  const area = h("div.film-area", canvas, cross, handle);
  const xTicks = h("div.film-ticks.below", { "aria-hidden": "true" });
  const yTicks = h("div.film-ticks.beside", { "aria-hidden": "true" });
  const title = h("p.film-axis", { "aria-hidden": "true" });
  const element = h("div.film-map", { hidden: true }, yTicks, area, xTicks, title);
  /** @type {ColorMap | null} */
  let shown = null;
  let at = { nm: 0, deg: 0 };
  let dragging = false;
  const changed = createChanged();
  const newTicks = createChanged();
  /** What stands at the axes. */
  let words = {
    x: /** @type {{share: number, text: string}[]} */ ([]),
    y: /** @type {{share: number, text: string}[]} */ ([]),
    title: "",
  };

  const ends = () => ({ low: shown?.thickness_nm[0] ?? 0, high: shown?.thickness_nm.at(-1) ?? 1 });

  /** @param {PointerEvent} event */
  function pick(event) {
    const box = canvas.getBoundingClientRect();
    const { low, high } = ends();
    const across = clamp((event.clientX - box.left) / box.width, 0, 1);
    const up = clamp((box.bottom - event.clientY) / box.height, 0, 1);
    const nm = low + across * (high - low);
    const digits = Math.max(0, 3 - Math.floor(Math.log10(high)));
    onPick(Number(nm.toFixed(digits)), Number((90 * up).toFixed(1)), false);
  }
  area.addEventListener("pointerdown", (event) => {
    if (!shown) return;
    dragging = true;
    area.setPointerCapture(event.pointerId);
    pick(event);
  });
  area.addEventListener("pointermove", (event) => {
    if (dragging) pick(event);
  });
  for (const kind of /** @type {const} */ (["pointerup", "pointercancel"]))
    area.addEventListener(kind, () => {
      if (dragging) onSettle();
      dragging = false;
    });
  handle.addEventListener("keydown", (event) => {
    const { low, high } = ends();
    const cell = (high - low) / 100;
    const [x, y] = event.shiftKey ? [cell / 10, 0.1] : [cell, 1];
    /** @type {Record<string, [number, number]>} */
    const keys = {
      ArrowRight: [x, 0],
      ArrowLeft: [-x, 0],
      ArrowUp: [0, y],
      ArrowDown: [0, -y],
      PageUp: [0, 10],
      PageDown: [0, -10],
    };
    const step = keys[event.key];
    if (!step || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    const nm = clamp(at.nm + step[0], low, Math.max(high, at.nm));
    // At once: the next press may come before the next frame.
    at = {
      nm: Number(nm.toPrecision(9)),
      deg: Number(clamp(at.deg + step[1], 0, 90).toFixed(4)),
    };
    onPick(at.nm, at.deg, false);
  });
  handle.addEventListener("keyup", onSettle);

  /** @param {Node} parent @param {readonly {share: number, text: string}[]} ticks */
  const place = (/** @type {HTMLElement} */ parent, ticks) =>
    parent.replaceChildren(
      ...ticks.map(({ share, text }) => {
        const tick = h("span", text);
        tick.style.setProperty("--at", share.toFixed(4));
        return tick;
      }),
    );

  return {
    element,
    /** @param {'png' | 'svg' | 'csv'} format @param {string} caption */
    async file(format, caption) {
      if (!shown) throw new Error("there is no map yet");
      const { mapFile } = await import("./map-file.js");
      return mapFile(format, canvas, shown, { ...words, caption });
    },
    /** The cell where the state is. @param {State} now @param {number} nm @returns {{row: number, column: number} | null} */
    cell(now, nm) {
      if (!shown) return null;
      return {
        row: nearest(shown.thickness_nm, nm),
        column: nearest(shown.theta_i_deg, now.theta_i_deg),
      };
    },
    /**
     * @param {State} now
     * @param {number} nm
     * @param {ColorMap} map
     * @param {Colors} colors
     * @param {number | null} factor
     */
    update(now, nm, map, colors, factor) {
      shown = map;
      at = { nm, deg: now.theta_i_deg };
      element.hidden = false;
      if (changed(colors, factor)) {
        const image = pixels(colors.linear_srgb, factor);
        canvas.width = image.width;
        canvas.height = image.height;
        canvas
          .getContext("2d")
          ?.putImageData(new ImageData(image.data, image.width, image.height), 0, 0);
      }
      const { low, high } = ends();
      if (newTicks(high, now.angle)) {
        const unit = /[^\d.]+$/u.exec(thicknessText(high))?.[0].trim() ?? "nm";
        const size = { nm: 1, µm: 1e3, mm: 1e6 }[unit] ?? 1;
        const shares = [0, 0.25, 0.5, 0.75, 1];
        words = {
          x: shares.map((share) => ({
            share,
            text: plain((low + share * (high - low)) / size, 3),
          })),
          y: DEGREES.map((deg) => ({ share: deg / 90, text: angle(deg, now.angle, 0) })),
          title: `thickness of layer ${map.layer} (${unit})`,
        };
        place(xTicks, words.x);
        place(yTicks, words.y);
        setText(title, words.title);
      }
      const x = clamp((nm - low) / (high - low), 0, 1);
      const y = 1 - clamp(now.theta_i_deg / 90, 0, 1);
      for (const part of [cross, handle]) {
        part.style.setProperty("--x", x.toFixed(5));
        part.style.setProperty("--y", y.toFixed(5));
      }
      const row = nearest(map.thickness_nm, nm);
      const column = nearest(map.theta_i_deg, now.theta_i_deg);
      handle.setAttribute("aria-valuemin", String(low));
      handle.setAttribute("aria-valuemax", String(high));
      handle.setAttribute("aria-valuenow", String(nm));
      handle.setAttribute(
        "aria-valuetext",
        `${thicknessText(nm)}, ${angle(now.theta_i_deg, now.angle)}: ${colors.hex[row]?.[column] ?? ""}`,
      );
    },
  };
}
