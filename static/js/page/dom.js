/** Building elements without markup strings. */

/** Attributes, which may be left out, are a plain object. @param {unknown} given @returns {given is Record<string, unknown>} */
const isAttributes = (given) =>
  typeof given === "object" && given !== null && !(given instanceof Node);

/**
 * An element: `h("p.hint", "text")`, `h("button", { type: "button", onclick }, "go")`. Functions become
 * listeners, true an empty attribute; false, null and undefined are left out, as children too.
 * @type {MakeElement}
 */
export const h = (/** @type {string} */ tag, /** @type {unknown[]} */ ...given) => {
  const [name = "", ...classes] = tag.split(".");
  const element = document.createElement(name);
  if (classes.length) element.className = classes.join(" ");
  const attributes = isAttributes(given[0]) ? given.shift() : {};
  for (const [key, value] of Object.entries(/** @type {object} */ (attributes))) {
    if (typeof value === "function") element.addEventListener(key.slice(2), value);
    else if (value !== false && value !== null && value !== undefined)
      element.setAttribute(key, value === true ? "" : String(value));
  }
  element.append(
    .../** @type {Child[]} */ (given).filter((c) => c !== null && c !== undefined && c !== false),
  );
  return /** @type {any} */ (element);
};

/** @param {HTMLElement} element @param {string} text set only if different, to spare the layout */
export function setText(element, text) {
  const only = element.firstChild;
  // the node stays, which spares the page a change of its tree
  if (only instanceof Text && only === element.lastChild) {
    if (only.data !== text) only.data = text;
  } else if (element.textContent !== text) element.textContent = text;
}

/** @param {HTMLElement} target @param {AbortSignal} signal that ends it @param {Listeners} listeners */
export function listen(target, signal, listeners) {
  for (const [kind, listener] of Object.entries(listeners))
    target.addEventListener(kind, /** @type {EventListener} */ (listener), { signal });
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

/** A symbol in LaTeX (`n_t`, `\theta_i`, `F_{82}`) as italic serif with its index. @param {string} latex */
export function symbol(latex) {
  const match = /^\\?([A-Za-z]+)(?:_\{?([A-Za-z0-9]+)\}?)?$/.exec(latex);
  const base = match?.[1] ?? latex;
  const index = match?.[2];
  return h("var.symbol", GREEK[base] ?? base, index ? h("sub", index) : null);
}
