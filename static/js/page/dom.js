/** Building elements without markup strings, and taking away what they show: texts, figures as files, curves as tables. */

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

/**
 * Save one file, or several that are told apart by their numbers.
 * @param {(name: string, blob: Blob) => void} save
 * @param {readonly Blob[]} blobs
 * @param {(part: string) => string} name
 */
export function saveEach(save, blobs, name) {
  blobs.forEach((blob, i) => {
    save(name(blobs.length > 1 ? `-${i + 1}` : ""), blob);
  });
}

/** @param {ExportsOptions} options */
export function createExports({ what, kinds = ["png", "svg", "csv"], name, make, save, print }) {
  /** @param {'png' | 'svg' | 'csv'} kind */
  async function take(kind) {
    saveEach(save, [await make(kind)].flat(), (part) => `${name()}${part}.${kind}`);
  }
  return h(
    "p.exports",
    ...kinds.map((kind) =>
      h(
        "button.quiet",
        {
          type: "button",
          "aria-label": `Save ${what} as ${kind.toUpperCase()}`,
          onclick: () => take(kind),
        },
        kind.toUpperCase(),
      ),
    ),
    print &&
      h(
        "button.quiet",
        {
          type: "button",
          "aria-label": `For print… (${what.replace(/^the /u, "")})`,
          onclick: async () => {
            const { publish } = await import("../publish/dialog.js");
            const { figures, call, behind, wide } = print;
            publish({
              ...{ figures: figures(), call, behind: behind(), name: name(), save },
              wide: wide?.() ?? false,
            });
          },
        },
        "For print…",
      ),
  );
}

/** @param {string} text @returns {Promise<boolean>} whether it was copied */
export async function copyText(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const area = document.createElement("textarea");
    area.value = text;
    area.className = "hidden";
    document.body.append(area);
    area.select();
    const done = document.execCommand("copy");
    area.remove();
    return done;
  }
}

/**
 * Show on a button for a moment that it did its work.
 * @param {HTMLElement} button
 * @param {boolean} done
 */
export function flash(button, done) {
  button.dataset.flash = done ? "copied" : "not copied";
  setTimeout(() => delete button.dataset.flash, 1200);
}

/**
 * What a button does that copies: it shows whether it was allowed to, and says it aloud.
 * @param {() => string} text
 * @param {(words: string) => void} say
 * @param {string} done what is said then
 * @param {string} [refused]
 * @returns {(event: Event) => Promise<void>}
 */
export function copying(text, say, done, refused = "Copying is not allowed here") {
  return async (event) => {
    const button = /** @type {HTMLElement} */ (event.currentTarget);
    const copied = await copyText(text());
    flash(button, copied);
    say(copied ? done : refused);
  };
}

/**
 * @param {string} summary
 * @param {Record<string, () => HTMLElement[]>} named what makes the tables, by the name of each place; none keeps what is there
 */
export function createDataTables(summary, named) {
  const places = Object.entries(named).map(([name, make]) => ({
    make,
    host: h("div.plot-table", { tabindex: "0", role: "region", "aria-label": name }),
  }));
  const element = h(
    "details.definitions",
    h("summary", summary),
    ...places.map((place) => place.host),
  );
  function fill() {
    if (!element.open) return;
    for (const { make, host } of places) {
      const tables = make();
      if (tables.length) host.replaceChildren(...tables);
    }
  }
  element.addEventListener("toggle", fill);
  return { element, fill };
}
