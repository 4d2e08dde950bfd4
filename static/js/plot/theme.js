/** The page's colours and faces as plain values, for what cannot read CSS variables itself. */

/**
 * @typedef {object} Theme
 * @property {string} paper
 * @property {string} ink
 * @property {string} muted
 * @property {string} rule
 * @property {string} accent
 * @property {string} panel
 * @property {string} family
 * @property {string} symbolFamily
 * @property {number} unit how much larger than 14 px the page writes
 * @property {(property: string) => string} color a custom property's value
 */

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
