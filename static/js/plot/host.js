/** The page's colours and faces as plain values, for what cannot read CSS variables itself. */

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

/** @returns {Promise<Plotly.Library>} the library, once its script has run */
export async function library() {
  if (window.Plotly) return window.Plotly;
  const script = document.querySelector('script[src*="plotly"]');
  if (!script) throw new Error("Plotly's script is not on the page");
  await new Promise((resolve, reject) => {
    script.addEventListener("load", resolve, { once: true });
    script.addEventListener("error", () => reject(new Error("Plotly could not be loaded")), {
      once: true,
    });
  });
  return library();
}
