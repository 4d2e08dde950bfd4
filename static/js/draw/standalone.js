/** An SVG of the page as a file that stands alone: with the paint that the style sheets give it, and its letters. */

import { fontFaces, withStyle } from "../plot/image.js";
import { svg } from "./svg.js";

/** Properties that a picture carries with it. */
const PAINT = [
  ..."fill fill-opacity stroke stroke-width stroke-dasharray stroke-linecap stroke-opacity".split(
    " ",
  ),
  ..."opacity stop-color stop-opacity text-anchor dominant-baseline".split(" "),
  ..."font-family font-size font-style font-weight".split(" "),
];
const LEFT_TO_CSS = /^(color|oklab|oklch|lab|lch|color-mix)\(/u;

/** @type {CanvasRenderingContext2D | null} */
let context = null;

/** A color that only browsers know, as all programs do. @param {string} value */
function common(value) {
  if (!LEFT_TO_CSS.test(value)) return value;
  context ??= document.createElement("canvas").getContext("2d", { willReadFrequently: true });
  if (!context) return value;
  context.clearRect(0, 0, 1, 1);
  context.fillStyle = value;
  context.fillRect(0, 0, 1, 1);
  const [r = 0, g = 0, b = 0, a = 255] = context.getImageData(0, 0, 1, 1).data;
  return a === 255 ? `rgb(${r}, ${g}, ${b})` : `rgba(${r}, ${g}, ${b}, ${(a / 255).toFixed(3)})`;
}

/**
 * @param {SVGElement} root in the document, as its styles are read there
 * @param {{width: number, height: number, ground: string}} picture px, and the color behind it
 * @returns {Promise<string>} source of a file
 */
export async function standalone(root, { width, height, ground }) {
  const copy = /** @type {SVGElement} */ (root.cloneNode(true));
  const originals = [...root.querySelectorAll("*")];
  const families = new Set([getComputedStyle(root).fontFamily]);
  [...copy.querySelectorAll("*")].forEach((node, i) => {
    const style = getComputedStyle(/** @type {Element} */ (originals[i]));
    if (style.visibility === "hidden" || style.display === "none") {
      node.remove();
      return;
    }
    if (node.tagName === "text" || node.tagName === "tspan") families.add(style.fontFamily);
    // What a url() points to is an address in this page, and stands in the attribute already.
    for (const name of PAINT) {
      const value = style.getPropertyValue(name);
      if (!value.includes("url(")) node.setAttribute(name, common(value));
    }
    for (const name of ["class", "style"]) node.removeAttribute(name);
  });
  for (const name of ["class", "aria-hidden", "focusable"]) copy.removeAttribute(name);
  for (const [name, value] of Object.entries({ width, height, viewBox: `0 0 ${width} ${height}` }))
    copy.setAttribute(name, String(value));
  copy.prepend(svg("rect", { width, height, fill: common(ground) }));
  // What templates leave between the elements belongs to no file.
  const source = new XMLSerializer().serializeToString(copy).replace(/<!--.*?-->/gu, "");
  const faces = await Promise.all([...families].map(fontFaces));
  return withStyle(source, faces.join(""));
}
