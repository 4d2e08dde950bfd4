/** What the colours of a heat map stand for, below it. */

import { plainText } from "../draw/symbols.js";
import { plain } from "../numbers/format.js";
import { stops } from "./colors.js";

/** @param {string} className @param {...(Node | string)} children */
function span(className, ...children) {
  const node = document.createElement("span");
  node.className = className;
  node.append(...children);
  return node;
}

/**
 * @param {HTMLElement} element
 * @param {import("./colors.js").Scale} scale
 * @param {import("./heatmap.js").Values} values
 * @param {(property: string) => string} color
 */
export function drawKey(element, scale, values, color) {
  const colors = stops(scale.kind, color).map(([at, c]) => `${c} ${100 * at}%`);
  const bar = span("map-bar");
  bar.style.background = `linear-gradient(90deg, ${colors.join(", ")})`;
  const signed = scale.kind === "signed";
  const ends = [
    signed ? `${scale.capped ? "≤ " : ""}${plain(scale.low)}` : "0",
    ...(signed ? ["0"] : []),
    `${scale.capped ? "≥ " : ""}${plain(scale.high)}`,
  ].map((text) => span("", text));
  element.replaceChildren(
    span("map-title", plainText(values.title)),
    span("map-scale", bar, span("map-ends", ...ends)),
  );
  if (values.level)
    element.append(span("map-note", `line at ${signed ? "±" : ""}${plain(values.level)}`));
}
