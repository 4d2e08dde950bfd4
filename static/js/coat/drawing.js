/** The picture of the paint, drawn from its geometry, and as a file with the paint that the page gives it. */

import { onResize } from "../draw/resized.js";
import { standalone } from "../draw/standalone.js";
import { percent } from "../numbers/format.js";
import { h } from "../page/dom.js";
import { html, render, svg } from "../page/lit.js";
import { rasterized } from "../plot/image.js";
import { coatPicture, outline } from "./picture.js";

/** @typedef {import('./fields.js').Coat} Coat */

const SMALLEST = 60;

/** @param {Coat} coat */
function csv({ interface: media, body_albedo, theta_i_deg, external, internal, ...shares }) {
  const { surface, body, absorbed } = shares;
  const { n_t } = media;
  const row = { n_t, body_albedo, theta_i_deg, external, internal, surface, body, absorbed };
  return `${Object.keys(row).join(",")}\r\n${Object.values(row)
    .map((v) => v ?? "")
    .join(",")}\r\n`;
}

export function createDrawing() {
  const frame = h("div.coat-frame", { role: "figure" });
  /** @type {Coat | null} */
  let shown = null;

  function draw() {
    const { width, height } = size;
    if (!shown || width < SMALLEST || height < SMALLEST) return;
    const line = Number.parseFloat(getComputedStyle(frame).fontSize) * 1.35;
    const picture = coatPicture(shown, { width, height, line });
    const { surface, body, floor, labels, loop, head } = picture;
    /** @param {{x: number, y: number}} at @param {[kind: string, words: string][]} lines */
    const written = ({ x, y }, ...lines) =>
      lines.map(
        ([kind, words], i) =>
          svg`<text class="coat-${kind}" x=${x} y=${y + i * line}>${words}</text>`,
      );
    /** @param {number} y */
    const across = (y) => svg`<line class="coat-line" x1="0" x2=${width} y1=${y} y2=${y}></line>`;
    /** @param {string} kind @param {number} y @param {number} to */
    const layer = (kind, y, to) =>
      svg`<rect class="${kind}-layer" x="0" y=${y} width=${width} height=${Math.max(0, to - y)}></rect>`;
    render(
      html`<svg
        class="coat-svg"
        aria-hidden="true"
        focusable="false"
        width=${width}
        height=${height}
        viewBox="0 0 ${width} ${height}"
      >
        ${layer("coat", surface, body)}${layer("body", body, floor)}${across(surface)}${across(body)}
        <g>${picture.bands.map((band) => svg`<path class="coat-band ${band.name}" d=${outline(band)}></path>`)}</g>
        <path class="coat-loop" d=${loop}></path>
        <path class="coat-loop-head" d=${head}></path>
        ${written(labels.incoming, ["name", "light"], ["value", "100 %"])}
        ${written(labels.surface, ["name", "surface"], ["value", percent(shown.surface)])}
        ${written(labels.body, ["name", "body"], ["value", percent(shown.body)])}
        ${written(labels.absorbed, ["name start", "absorbed"], ["value start", percent(shown.absorbed)])}
        ${written(
          labels.internal,
          ["note", width < 330 ? "back" : "thrown back"],
          ["note", percent(shown.internal)],
        )}
        ${written({ x: 0.6 * line, y: surface + 1.2 * line }, ["word", "coat"])}
        ${written({ x: 0.6 * line, y: body + 1.2 * line }, ["word", "body"])}
      </svg>`,
      frame,
    );
  }

  const { size, stop } = onResize(frame, draw);

  return {
    element: frame,
    /** @param {Coat} coat @param {string} label */
    update(coat, label) {
      shown = coat;
      frame.ariaLabel = label;
      draw();
    },
    /** @param {'png' | 'svg' | 'csv'} format */
    async make(format) {
      const root = frame.querySelector("svg");
      if (!shown || !root) throw new Error("there is no picture yet");
      if (format === "csv") return new Blob([csv(shown)], { type: "text/csv;charset=utf-8" });
      const { width, height } = size;
      const ground = getComputedStyle(document.documentElement).backgroundColor;
      const source = await standalone(root, { width, height, ground });
      const blob = new Blob([source], { type: "image/svg+xml;charset=utf-8" });
      return format === "svg" ? blob : rasterized(blob, 2 * width, 2 * height);
    },
    destroy: stop,
  };
}
