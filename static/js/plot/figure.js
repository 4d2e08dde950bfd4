/** What plots and maps stand on: an element as a figure, the page's theme as plain values, Plotly, and news of size. */

import { h } from "../page/dom.js";

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

/** @type {Promise<void> | null} */
let coming = null;
/** Once it could not be had. @type {(() => void) | null} */
let again = null;
/** @type {(again: (() => void) | null) => void} */
let tellMissing = () => {};

/**
 * @param {(again: (() => void) | null) => void} listener is told how to ask again when Plotly could not be
 *   had, and null when it has come
 */
export function onMissing(listener) {
  tellMissing = listener;
}

/**
 * Plotly, asked for once. Where it could not be had, whoever needs it next asks again, and so does the
 * network that is back.
 * @returns {Promise<void>} once its script has run
 */
export function library() {
  again?.();
  coming ??= new Promise((run) => {
    const { href } = /** @type {HTMLLinkElement} */ (document.getElementById("plotly"));
    function ask() {
      again = null;
      window.removeEventListener("online", ask);
      const script = h("script", { src: href });
      script.addEventListener("load", () => {
        tellMissing(null);
        run();
      });
      script.addEventListener("error", () => {
        script.remove();
        again = ask;
        window.addEventListener("online", ask);
        tellMissing(ask);
      });
      document.head.append(script);
    }
    ask();
  });
  return coming;
}

/**
 * Whether some of an element is seen: on the screen, and not behind the sheet that holds a phone's controls.
 * @param {HTMLElement} element
 * @returns {Promise<void>} once it is
 */
export function seen(element) {
  const sheet = element.closest(".view")?.querySelector(".panel");
  return new Promise((done) => {
    /** @type {IntersectionObserver | undefined} */
    let watching;
    // At once, and when the sheet is opened or closed or the phone is turned.
    const sizes = new ResizeObserver(() => {
      watching?.disconnect();
      const fixed = sheet && getComputedStyle(sheet).position === "fixed";
      const rootMargin = `0px 0px ${fixed ? -sheet.clientHeight : 0}px`;
      watching = new IntersectionObserver(
        (entries) => {
          if (!entries.some((entry) => entry.isIntersecting)) return;
          watching?.disconnect();
          sizes.disconnect();
          done();
        },
        { rootMargin },
      );
      watching.observe(element);
    });
    sizes.observe(sheet ?? element);
  });
}

/** The smallest area that is worth drawing into; a hidden one has no size. */
const SMALLEST = 40;

/**
 * Draw anew when the size, the letters or the colors of what is drawn into change.
 * @param {HTMLElement} element whose colors they are
 * @param {HTMLElement} area
 * @param {() => void} draw
 */
export function watchSize(element, area, draw) {
  let theme = readTheme(element);
  /** @type {Size} */
  let drawn = { width: 0, height: 0 };
  let waiting = 0;

  function refresh() {
    theme = readTheme(element); // letters grow with the window, too
    draw();
  }
  function resize() {
    cancelAnimationFrame(waiting);
    waiting = requestAnimationFrame(() => {
      if (area.clientWidth !== drawn.width || area.clientHeight !== drawn.height) refresh();
    });
  }
  const observer = new ResizeObserver(resize);
  observer.observe(area);
  void document.fonts.ready.then(refresh);

  return {
    theme: () => theme,
    /** What can be drawn into now. @returns {Size | null} */
    size() {
      const { clientWidth: width, clientHeight: height, isConnected } = area;
      if (!isConnected || width < SMALLEST || height < SMALLEST) return null;
      drawn = { width, height };
      return drawn;
    },
    refresh,
    resize,
    stop() {
      cancelAnimationFrame(waiting);
      observer.disconnect();
    },
  };
}

/** Make a figure of an element: an area in it for Plotly to draw into. @param {HTMLElement} element @param {() => void} draw */
export function createHost(element, draw) {
  element.classList.add("plot");
  element.setAttribute("role", "figure");
  /** @type {HTMLElement} */
  const canvas = h("div.plot-canvas", { "aria-hidden": "true" });
  const area = h("div.plot-area", canvas);
  element.append(area);
  const { stop, ...watched } = watchSize(element, area, draw);
  return {
    ...watched,
    area,
    canvas,
    destroy() {
      stop();
      window.Plotly?.purge(canvas);
      element.replaceChildren();
    },
  };
}
