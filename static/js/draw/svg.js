/** SVG elements that are made once and then only change attributes, the labels in them, and what labels must not cover. */

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

/** Unicode's small letters lack most of the alphabet, so they are only read, never written. */
const SUBSCRIPT_SIGNS = "₀₁₂ᵢₚₛₜ";
const SUBSCRIPT_LETTERS = "012ipst";
/** A letter with a subscript, or a Greek letter that stands alone. */
const SYMBOL = /(\p{L})_(?:\{([^}]*)\}|([\p{L}\p{N}]))|(?<!\p{L})(\p{Script=Greek})(?!\p{L})/gu;

/** How large a subscript is beside its symbol. */
export const SUBSCRIPT_SCALE = 0.72;

/**
 * Split a label into runs of one style.
 * @param {string} label
 * @returns {Run[]}
 */
export function runs(label) {
  const plain = label
    .replace(/<sub>(.*?)<\/sub>/gu, "_{$1}")
    .replace(/[₀₁₂ᵢₚₛₜ]/gu, (sign) => `_{${SUBSCRIPT_LETTERS[SUBSCRIPT_SIGNS.indexOf(sign)]}}`);
  if (/^\p{L}$/u.test(plain)) return [{ text: plain, italic: true, sub: false }];
  /** @type {Run[]} */
  const out = [];
  let end = 0;
  for (const match of plain.matchAll(SYMBOL)) {
    const before = plain.slice(end, match.index);
    if (before) out.push({ text: before, italic: false, sub: false });
    out.push({ text: match[1] ?? match[4] ?? "", italic: true, sub: false });
    if (!match[4]) out.push({ text: match[2] ?? match[3] ?? "", italic: true, sub: true });
    end = match.index + match[0].length;
  }
  const rest = plain.slice(end);
  if (rest) out.push({ text: rest, italic: false, sub: false });
  return out;
}

/**
 * The label as plain text, for readers and file names: `R_s` is "Rs".
 * @param {string} label
 */
export function plainText(label) {
  return runs(label)
    .map((run) => run.text)
    .join("");
}

/** @param {string} text */
function escaped(text) {
  return text.replace(/&/gu, "&amp;").replace(/</gu, "&lt;").replace(/>/gu, "&gt;");
}

/**
 * The label in the markup that Plotly's texts understand.
 * @param {string} label
 */
export function plotlyText(label) {
  return runs(label)
    .map(({ text, italic, sub }) => {
      const inner = italic ? `<i>${escaped(text)}</i>` : escaped(text);
      return sub ? `<sub>${inner}</sub>` : inner;
    })
    .join("");
}

/** @type {WeakMap<SVGTextElement, string>} */
const shown = new WeakMap();

/**
 * Write a label into an SVG text. While only its words change, the nodes stay.
 * @param {SVGTextElement} node
 * @param {string} label
 */
export function setLabel(node, label) {
  if (shown.get(node) === label) return;
  shown.set(node, label);
  const parts = runs(label);
  while (node.childElementCount > parts.length) node.lastElementChild?.remove();
  while (node.childElementCount < parts.length) svg("tspan", {}, node);
  let lowered = false;
  parts.forEach((run, index) => {
    const span = node.children[index];
    const words = span.firstChild;
    // the node stays, which spares the page a change of its tree
    if (words instanceof Text) {
      if (words.data !== run.text) words.data = run.text;
    } else {
      span.textContent = run.text;
    }
    put(span, "class", run.sub ? "symbol-run symbol-sub" : run.italic ? "symbol-run" : "");
    // `dy` moves all that follows, so the run after a subscript climbs back.
    put(span, "dy", run.sub && !lowered ? "0.22em" : !run.sub && lowered ? "-0.16em" : null);
    lowered = run.sub;
  });
}

/** @type {CanvasRenderingContext2D | null} */
let context = null;

/**
 * @param {string} font a CSS font shorthand
 * @returns {(character: string) => number}
 */
export function advances(font) {
  /** @type {Map<string, number>} */
  const known = new Map();
  return (character) => {
    let width = known.get(character);
    if (width === undefined) {
      context ??= document.createElement("canvas").getContext("2d");
      if (context) context.font = font;
      width = context ? context.measureText(character).width : 8;
      known.set(character, width);
    }
    return width;
  };
}

/**
 * A function that gives the width of a label in px, for one size and weight of the page's faces.
 * @param {Pick<Theme, "family" | "symbolFamily" | "unit">} theme
 * @param {number} size at a desk
 * @param {number} [symbolSize]
 * @param {number} [weight]
 * @returns {Measure}
 */
export function createMeasure(
  { family, symbolFamily, unit },
  size,
  symbolSize = size,
  weight = 400,
) {
  const text = advances(`${weight} ${size * unit}px ${family}`);
  const symbol = advances(`italic ${weight} ${symbolSize * unit}px ${symbolFamily}`);
  return (label) => {
    let width = 0;
    for (const run of runs(label)) {
      const advance = run.italic ? symbol : text;
      const scale = run.sub ? SUBSCRIPT_SCALE : 1;
      for (const character of run.text) width += advance(character) * scale;
    }
    return width;
  };
}

/**
 * @param {Box} box
 * @param {number} by grown by this on every side
 * @returns {Box}
 */
export function grown(box, by) {
  return {
    x: box.x - by,
    y: box.y - by,
    width: box.width + 2 * by,
    height: box.height + 2 * by,
  };
}

/**
 * @param {Box} a
 * @param {Box} b
 */
export function overlap(a, b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

/**
 * @param {Box} inner
 * @param {Box} outer
 */
export function within(inner, outer) {
  return (
    inner.x >= outer.x &&
    inner.y >= outer.y &&
    inner.x + inner.width <= outer.x + outer.width &&
    inner.y + inner.height <= outer.y + outer.height
  );
}

/**
 * Whether a segment meets a box (Liang and Barsky's clipping).
 * @param {Segment} segment
 * @param {Box} box
 */
export function crosses({ x1, y1, x2, y2 }, box) {
  const dx = x2 - x1;
  const dy = y2 - y1;
  let enter = 0;
  let leave = 1;
  for (const [p, q] of [
    [-dx, x1 - box.x],
    [dx, box.x + box.width - x1],
    [-dy, y1 - box.y],
    [dy, box.y + box.height - y1],
  ]) {
    if (p === 0) {
      if (q < 0) return false;
      continue;
    }
    const t = q / p;
    if (p < 0) enter = Math.max(enter, t);
    else leave = Math.min(leave, t);
    if (enter > leave) return false;
  }
  return true;
}

/**
 * How far a box reaches from its centre in a direction, so that a label can be set just outside a
 * circle or a line.
 * @param {{width: number, height: number}} size
 * @param {number} dx unit direction
 * @param {number} dy
 */
export function reach({ width, height }, dx, dy) {
  return (Math.abs(dx) * width + Math.abs(dy) * height) / 2;
}

/**
 * @param {{x: number, y: number}} centre
 * @param {{width: number, height: number}} size
 * @returns {Box}
 */
export function boxOf({ x, y }, { width, height }) {
  return { x: x - width / 2, y: y - height / 2, width, height };
}
