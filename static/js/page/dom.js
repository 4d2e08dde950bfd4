/** Building elements without markup strings. */

/**
 * @typedef {Node | string | null | undefined | false} Child
 */

/**
 * @template {keyof HTMLElementTagNameMap} Tag
 * @param {Tag} tag
 * @param {Record<string, unknown>} [attributes] attributes; `on…` functions become listeners,
 *   true an empty attribute, false, null and undefined none
 * @param {...Child} children
 * @returns {HTMLElementTagNameMap[Tag]}
 */
export function h(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") {
      element.addEventListener(name.slice(2), /** @type {EventListener} */ (value));
    } else if (value !== false && value !== null && value !== undefined) {
      element.setAttribute(name, value === true ? "" : String(value));
    }
  }
  element.append(...children.filter((c) => c !== null && c !== undefined && c !== false));
  return element;
}

/** @param {HTMLElement} element @param {string} text set only if different, to spare the layout */
export function setText(element, text) {
  const only = element.firstChild;
  // the node stays, which spares the page a change of its tree
  if (only instanceof Text && only === element.lastChild) {
    if (only.data !== text) only.data = text;
  } else if (element.textContent !== text) element.textContent = text;
}

/** @param {string} id @returns {HTMLElement} the element that index.html promises */
export function byId(id) {
  const element = document.getElementById(id);
  if (!element) throw new Error(`index.html has no #${id}`);
  return element;
}

/** @type {Record<string, string>} */
const GREEK = {
  theta: "θ",
  eta: "η",
  kappa: "κ",
  alpha: "α",
  mu: "μ",
  lambda: "λ",
  phi: "φ",
  beta: "β",
};

/**
 * A symbol declared in LaTeX (`n_t`, `\theta_i`, `\alpha`, `F_{82}`) as italic serif with its index.
 * @param {string} latex
 * @returns {HTMLElement}
 */
export function symbol(latex) {
  const match = /^\\?([A-Za-z]+)(?:_\{?([A-Za-z0-9]+)\}?)?$/.exec(latex);
  const base = match?.[1] ?? latex;
  const index = match?.[2];
  return h("var", { class: "symbol" }, GREEK[base] ?? base, index ? h("sub", {}, index) : null);
}
