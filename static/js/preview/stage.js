/** The picture: a canvas to turn, the line between its halves, and when it is drawn how finely. */

import { signed } from "../numbers/format.js";
import { h, setText } from "../page/dom.js";
import { cameraAt } from "./camera.js";
import { differenceOf } from "./difference.js";
import { BOUNDS } from "./fields.js";
import { createRenderer } from "./renderer.js";

/**
 * @typedef {import('./renderer.js').Picture} Picture
 * @typedef {import('./renderer.js').Show} Show
 * @typedef {import('./difference.js').Difference} Difference
 */

/** Points of the scene to a pixel at rest, along each side: four to a pixel. */
const FINE = 2;
/** The fewest while it moves, where the machine is too slow for one. */
const COARSEST = 0.5;
const REFINE_AFTER = 160; // ms of rest
const MEASURE_AFTER = 120; // ms after the fine picture
/** The pixels of the measured picture's shorter side. */
const MEASURED = 320;
const FLICKER = 700; // ms a side: fewer than three changes a second
const SLOW = 24; // ms between frames
const TURN = { step: 3, fine: 0.5, page: 15 };
const DEGREES_PER_PIXEL = 0.35;

/** @param {number} value @param {{minimum: number, maximum: number}} bounds */
const within = (value, { minimum, maximum }) => Math.min(maximum, Math.max(minimum, value));
/** @param {number} yaw in degrees, any turns */
const turned = (yaw) => ((((yaw + 180) % 360) + 360) % 360) - 180;
/** @param {number} x */
const rounded = (x) => Number(x.toFixed(2));

/**
 * @param {Pick<ViewContext, 'state' | 'actions' | 'save'> & {onMeasured: (difference: Difference | null) => void}} context
 */
export function createStage({ state, actions, onMeasured, save }) {
  const canvas = h("canvas.scene", {
    tabindex: 0,
    role: "application",
    "aria-label":
      "Scene: arrow keys turn it, plus and minus change the distance, Home goes back to the start",
  });
  const names = {
    left: h("span.side-name"),
    right: h("span.side-name"),
  };
  const divider = h(
    "div.divider",
    {
      role: "slider",
      tabindex: 0,
      "aria-label": "Where the left side ends",
      "aria-valuemin": 0,
      "aria-valuemax": 100,
      "aria-orientation": "horizontal",
    },
    h("i"),
  );
  const frame = h("div.scene-frame", canvas, names.left, names.right, divider);
  const hint = h("p.hint");
  const lost = h("p.row-error", { role: "alert" });
  const element = h("div.shown", frame, hint, lost);

  let renderer = createRenderer(canvas);
  /** @type {Picture | null} */
  let picture = null;
  let side = /** @type {'left' | 'right'} */ ("left"); // that flicker shows
  let flickering = !matchMedia("(prefers-reduced-motion: reduce)").matches;
  let scale = 1; // while it moves
  /** @type {number[]} */
  let gaps = [];
  let last = 0;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let refining;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let measuring;
  /** @type {ReturnType<typeof setInterval> | undefined} */
  let flicker;
  /** Gives the renderer its textures; again all of them after it has lost them. @type {((force: boolean) => void) | null} */
  let upload = null;

  canvas.addEventListener("webglcontextlost", (event) => {
    event.preventDefault();
    stop();
    setText(lost, "The graphics system took the picture away; it comes back when it can.");
  });
  canvas.addEventListener("webglcontextrestored", () => {
    renderer = createRenderer(canvas);
    setText(lost, "");
    upload?.(true);
    actions.set({});
  });

  /** @returns {Show} */
  const shown = () => (state().see === "flicker" ? side : state().see);

  /** @param {number} points to a pixel of the screen, along each side */
  function paint(points) {
    if (!renderer || !picture) return;
    picture.show = shown();
    // Fewer points than pixels are spread by the browser.
    fit(Math.min(1, points));
    renderer.draw(picture, Math.max(1, points));
    canvas.dataset.points = String(points);
    const sides = picture.show;
    names.left.hidden = sides === "right";
    names.right.hidden = sides === "left";
    frame.dataset.show = sides;
  }

  /** A machine that cannot keep up draws fewer points while the scene moves. @param {number} now */
  function adapt(now) {
    const gap = now - last;
    last = now;
    if (gap > 250) {
      gaps = [];
      return;
    }
    gaps.push(gap);
    if (gaps.length < 12) return;
    const middle = /** @type {number} */ (gaps.sort((a, b) => a - b)[6]);
    gaps = [];
    if (middle > SLOW) scale = Math.max(COARSEST, scale * 0.8);
    else if (middle < 17.5 && scale < 1) scale = Math.min(1, scale * 1.1);
  }

  function refine() {
    paint(FINE);
    measuring = setTimeout(measure, MEASURE_AFTER);
  }

  /** Which picture is measured: what was asked of an older one is of no interest. */
  let turn = 0;

  async function measure() {
    if (!renderer || !picture) return;
    const { width, height } = canvas;
    const shrink = MEASURED / Math.min(width, height);
    const size = /** @type {const} */ ([Math.round(width * shrink), Math.round(height * shrink)]);
    const own = turn;
    const { left, right } = await renderer.read(picture, size);
    if (own === turn) onMeasured(differenceOf(left, right));
  }

  function stop() {
    clearTimeout(refining);
    clearTimeout(measuring);
    clearInterval(flicker);
    flicker = undefined;
  }

  /** @param {boolean} moving */
  function draw(moving) {
    clearTimeout(refining);
    clearTimeout(measuring);
    turn += 1;
    if (moving) adapt(performance.now());
    paint(moving ? scale : Math.min(1, scale));
    const percent = Math.round(100 * scale);
    setText(
      hint,
      scale < 1
        ? `drag to turn; while it moves, drawn at ${percent} % of the pixels along each side, to keep up`
        : "drag or use the arrow keys to turn, + and − for the distance",
    );
    if (!moving) refining = setTimeout(refine, REFINE_AFTER);
    const wanted = state().see === "flicker" && flickering;
    if (wanted && flicker === undefined) flicker = setInterval(swap, FLICKER);
    if (!wanted && flicker !== undefined) {
      clearInterval(flicker);
      flicker = undefined;
    }
  }

  function swap() {
    side = side === "left" ? "right" : "left";
    paint(Number(canvas.dataset.points ?? 1));
  }

  /** The canvas has as many pixels as the screen gives it, up to two for each of the page's. @param {number} share */
  function fit(share) {
    const dense = Math.min(2, devicePixelRatio) * share;
    const [width = 0, height = 0] = [frame.clientWidth * dense, frame.clientHeight * dense].map(
      Math.round,
    );
    if (!width || !height || (canvas.width === width && canvas.height === height)) return;
    canvas.width = width;
    canvas.height = height;
  }
  const watching = new ResizeObserver(() => {
    if (picture) draw(false);
  });
  watching.observe(frame);

  /** @param {{yaw?: number, pitch?: number, distance?: number}} by degrees, and a factor */
  function orbit({ yaw = 0, pitch = 0, distance = 1 }) {
    const now = state();
    actions.set(
      {
        yaw: rounded(turned(now.yaw + yaw)),
        pitch: rounded(within(now.pitch + pitch, BOUNDS.pitch)),
        distance: rounded(within(now.distance * distance, BOUNDS.distance)),
      },
      { history: "replace" },
    );
  }

  /** @type {{id: number, x: number, y: number, yaw: number, pitch: number} | null} */
  let held = null;
  canvas.addEventListener("pointerdown", (event) => {
    if (!event.isPrimary || event.button !== 0) return;
    canvas.setPointerCapture(event.pointerId);
    const { yaw, pitch } = state();
    held = { id: event.pointerId, x: event.clientX, y: event.clientY, yaw, pitch };
    frame.toggleAttribute("data-turning", true);
  });
  canvas.addEventListener("pointermove", (event) => {
    if (!held || event.pointerId !== held.id) return;
    const fine = DEGREES_PER_PIXEL * (event.shiftKey ? 0.2 : 1);
    actions.set(
      {
        yaw: rounded(turned(held.yaw - fine * (event.clientX - held.x))),
        pitch: rounded(within(held.pitch + fine * (event.clientY - held.y), BOUNDS.pitch)),
      },
      { history: "replace" },
    );
  });
  for (const kind of /** @type {const} */ (["pointerup", "pointercancel"]))
    canvas.addEventListener(kind, (event) => {
      if (!held || event.pointerId !== held.id) return;
      held = null;
      frame.removeAttribute("data-turning");
      actions.settle();
    });
  const KEYS = /^(Arrow|Page)|^[-+=]$/;
  canvas.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const by = event.shiftKey ? TURN.fine : TURN.step;
    /** @type {Record<string, () => void>} */
    const keys = {
      ArrowLeft: () => orbit({ yaw: -by }),
      ArrowRight: () => orbit({ yaw: by }),
      ArrowUp: () => orbit({ pitch: by }),
      ArrowDown: () => orbit({ pitch: -by }),
      PageUp: () => orbit({ pitch: TURN.page }),
      PageDown: () => orbit({ pitch: -TURN.page }),
      "+": () => orbit({ distance: 1 / 1.08 }),
      "=": () => orbit({ distance: 1 / 1.08 }),
      "-": () => orbit({ distance: 1.08 }),
      Home: () =>
        actions.set({
          yaw: BOUNDS.yaw.default,
          pitch: BOUNDS.pitch.default,
          distance: BOUNDS.distance.default,
        }),
      " ": () => {
        if (state().see === "flicker") swap();
      },
    };
    const action = keys[event.key];
    if (!action) return;
    event.preventDefault();
    action();
  });
  canvas.addEventListener("keyup", (event) => {
    if (KEYS.test(event.key)) actions.settle();
  });

  /** @param {number} split @param {'push' | 'replace'} history */
  const cut = (split, history) =>
    actions.set({ split: rounded(within(split, BOUNDS.split)) }, { history });
  divider.addEventListener("pointerdown", (event) => {
    if (!event.isPrimary || event.button !== 0) return;
    event.preventDefault();
    divider.focus({ preventScroll: true });
    divider.setPointerCapture(event.pointerId);
  });
  divider.addEventListener("pointermove", (event) => {
    if (!divider.hasPointerCapture(event.pointerId)) return;
    const { left, width } = frame.getBoundingClientRect();
    cut((event.clientX - left) / width, "replace");
  });
  divider.addEventListener("pointerup", actions.settle);
  divider.addEventListener("pointercancel", actions.settle);
  divider.addEventListener("dblclick", () => cut(BOUNDS.split.default, "push"));
  divider.addEventListener("keydown", (event) => {
    const now = state().split;
    const by = event.shiftKey ? 0.01 : 0.02;
    /** @type {Record<string, number>} */
    const to = {
      ArrowLeft: now - by,
      ArrowDown: now - by,
      ArrowRight: now + by,
      ArrowUp: now + by,
      PageDown: now - 0.1,
      PageUp: now + 0.1,
      Home: 0,
      End: 1,
    };
    const next = to[event.key];
    if (next === undefined || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    cut(next, "replace");
  });
  divider.addEventListener("keyup", actions.settle);

  /** The picture as it is at rest. @returns {Promise<Blob>} */
  function image() {
    paint(FINE);
    // In the same task, before the browser shows and forgets what was drawn.
    return new Promise((resolve, reject) => {
      canvas.toBlob((blob) => {
        if (blob) resolve(blob);
        else reject(new Error("the picture could not be made"));
      }, "image/png");
    });
  }

  return {
    element,
    works: renderer !== null,
    /** @param {(renderer: import('./renderer.js').Renderer, force: boolean) => void} fill what gives the renderer its textures */
    feed(fill) {
      upload = (force) => {
        if (renderer) fill(renderer, force);
      };
      upload(false);
    },
    /**
     * @param {Omit<Picture, 'camera' | 'show' | 'split' | 'gain'>} scene
     * @param {{left: string, right: string}} titles
     * @param {boolean} moving
     */
    update(scene, titles, moving) {
      const { yaw, pitch, distance, split, gain, see } = state();
      picture = {
        ...scene,
        camera: cameraAt({ yaw, pitch, distance }),
        show: shown(),
        split,
        gain,
      };
      setText(names.left, titles.left);
      setText(names.right, titles.right);
      divider.hidden = see !== "split";
      divider.style.setProperty("--at", String(split));
      divider.setAttribute("aria-valuenow", String(Math.round(100 * split)));
      divider.setAttribute("aria-valuetext", `${signed(String(Math.round(100 * split)))} %`);
      draw(moving);
    },
    flicker: {
      on: () => flickering,
      toggle() {
        flickering = !flickering;
        draw(false);
        return flickering;
      },
      swap,
    },
    /** @param {string} name */
    async export(name) {
      save(name, await image());
    },
    stop,
    destroy() {
      stop();
      watching.disconnect();
      renderer?.destroy();
    },
  };
}
