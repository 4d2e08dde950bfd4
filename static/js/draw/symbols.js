/**
 * Mathematical symbols in plain labels: `R_s`, `θ_i = 64°`, `F_{R} 11 %`.
 *
 * A letter with a subscript, a lone Greek letter, or a label that is one letter, is set in the italic of mathematics;
 * everything else stays in the text face.
 */

import { put, svg } from "./svg.js";

/** @typedef {{text: string, italic: boolean, sub: boolean}} Run */

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
    const span = /** @type {SVGTSpanElement} */ (node.children[index]);
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
