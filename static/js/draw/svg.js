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
 * Round to a tenth of a pixel, enough for the eye and short in the markup.
 * @param {number} value
 */
export function px(value) {
  return Math.round(value * 10) / 10;
}
