/** Small tools for SVG elements that are made once and then only change attributes. */

const SVG = "http://www.w3.org/2000/svg";

/**
 * Make an SVG element.
 * @template {keyof SVGElementTagNameMap} K
 * @param {K} tag
 * @param {Record<string, string | number>} [attributes]
 * @param {SVGElement} [parent] appended to it when given
 * @returns {SVGElementTagNameMap[K]}
 */
export function svg(tag, attributes = {}, parent) {
  const node = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, String(value));
  parent?.append(node);
  return node;
}

/** What each element was last given; the DOM is not asked, because asking costs as much as writing.
 * @type {WeakMap<Element, Map<string, string>>} */
const written = new WeakMap();

/**
 * Set an attribute only when it changes; `null` removes it.
 * @param {Element} node
 * @param {string} name
 * @param {string | number | null} value
 */
export function put(node, name, value) {
  let known = written.get(node);
  if (!known) {
    known = new Map();
    written.set(node, known);
  }
  const text = value === null ? "" : String(value);
  if (known.get(name) === text) return;
  known.set(name, text);
  if (value === null) node.removeAttribute(name);
  else node.setAttribute(name, text);
}

/**
 * Show or hide an SVG element without taking it out of the tree.
 * @param {SVGElement} node
 * @param {boolean} visible
 */
export function show(node, visible) {
  put(node, "visibility", visible ? null : "hidden");
}

/**
 * Make an SVG text in a group of its own, by which it is moved: a text that is itself transformed is
 * laid out anew at each step.
 * @param {SVGElement} parent
 * @param {string} className
 * @returns {SVGTextElement}
 */
export function svgText(parent, className) {
  return svg("text", { class: className }, svg("g", {}, parent));
}

/**
 * @param {SVGTextElement} node made by `svgText`
 * @param {number} x
 * @param {number} y
 */
export function moveText(node, x, y) {
  const group = /** @type {Element} */ (node.parentNode);
  put(group, "transform", `translate(${px(x)},${px(y)})`);
}

/**
 * Round to a tenth of a pixel, enough for the eye and short in the markup.
 * @param {number} value
 */
export function px(value) {
  return Math.round(value * 10) / 10;
}
