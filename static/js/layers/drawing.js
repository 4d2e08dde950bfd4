/**
 * The layers drawn to scale, with the light that comes and goes. The lower face of each layer is a
 * slider: dragged, or moved by the keys, it changes the layer's thickness.
 */

import { onResize } from "../draw/resized.js";
import { put, px, show, svg } from "../draw/svg.js";
import { angle, percent, plain } from "../numbers/format.js";
import { h, setText } from "../page/dom.js";
import { readLayers, roundAbove, shortMedium, THICKEST, thicknessText } from "./layers.js";

/** @typedef {import('./layers.js').Layer} Layer */

/** Shares of the height: the incident medium, and where the second one begins at the latest. */
const SKY = 0.34;
const GROUND = 0.78;
const THICK = 34; // px of a layer without interference, which is in no scale
const NAME = 15; // px that a line of text takes
const MOST_NAMES = 12;
const BEAM = 0.3; // where the light meets the films, of the width
const LENGTH = 0.3; // of its arrows, of the width
const WIDEST = 12; // px of all the light

/** @param {{nm: number, key: string, shift: boolean}} pressed @returns {number | null} */
export function moved({ nm, key, shift }) {
  const step = shift ? 0.1 : 1;
  /** @type {Record<string, number>} */
  const by = {
    ArrowRight: step,
    ArrowUp: -step,
    ArrowDown: step,
    ArrowLeft: -step,
    PageUp: -10,
    PageDown: 10,
  };
  const change = by[key];
  if (key === "Home") return 0;
  return change === undefined ? null : Math.max(0, Number((nm + change).toPrecision(12)));
}

/**
 * @param {(place: number, nm: number) => void} onMove
 * @param {() => void} onSettle
 */
export function createDrawing(onMove, onSettle) {
  const root = svg("svg", { class: "film-svg", "aria-hidden": "true", focusable: "false" });
  const front = svg("rect", { class: "film-medium" }, root);
  const back = svg("rect", { class: "film-medium" }, root);
  const slabs = svg("g", {}, root);
  const faces = svg("g", {}, root);
  const beams = {
    incident: svg("path", { class: "film-beam incident" }, root),
    reflected: svg("path", { class: "film-beam reflected" }, root),
    transmitted: svg("path", { class: "film-beam transmitted" }, root),
  };
  const bar = svg("path", { class: "film-scale" }, root);
  const frame = h("div.film-drawing", { role: "group", "aria-label": "Layers to scale" });
  const texts = {
    front: h("span.film-word"),
    back: h("span.film-word"),
    scale: h("span.film-word"),
    R: h("span.film-word"),
    T: h("span.film-word"),
  };
  frame.append(root, ...Object.values(texts));
  /** @type {{slab: SVGElement, face: SVGElement, name: HTMLElement, handle: HTMLElement}[]} */
  const made = [];
  /** @type {{now: State, facts: any, here: any, reading: {R: number, T: number} | null} | null} */
  let known = null;
  /** @type {{place: number, y: number, nm: number, scale: number} | null} */
  let held = null;
  /** What a key has set and no frame has drawn yet. @type {{place: number, nm: number} | null} */
  let pressed = null;
  let scaled = 0; // nm that the room for layers stands for
  let perPixel = 1;

  /** @param {number} place */
  function nmOf(place) {
    if (pressed?.place === place) return pressed.nm;
    return readLayers(known?.now.layers ?? "")?.[place]?.nm ?? 0;
  }

  /** @param {number} place */
  function makeLayer(place) {
    const handle = h("div.film-handle", {
      tabindex: "0",
      role: "slider",
      "aria-orientation": "vertical",
      "aria-valuemin": "0",
      "aria-valuemax": String(THICKEST),
      onpointerdown(/** @type {PointerEvent} */ event) {
        handle.setPointerCapture(event.pointerId);
        held = { place, y: event.clientY, nm: nmOf(place), scale: perPixel };
        handle.focus({ preventScroll: true });
        event.preventDefault();
      },
      onpointermove(/** @type {PointerEvent} */ event) {
        if (held?.place !== place) return;
        const nm = held.nm + (event.clientY - held.y) * held.scale;
        const digits = event.shiftKey || held.scale < 0.4 ? 10 : 1;
        onMove(place, Math.min(Math.max(Math.round(nm * digits) / digits, 0), THICKEST));
      },
      onpointerup: letGo,
      onpointercancel: letGo,
      onkeydown(/** @type {KeyboardEvent} */ event) {
        if (event.ctrlKey || event.metaKey || event.altKey) return;
        const next = moved({ nm: nmOf(place), key: event.key, shift: event.shiftKey });
        if (next === null) return;
        event.preventDefault();
        pressed = { place, nm: next };
        onMove(place, next);
      },
      onkeyup: onSettle,
    });
    const name = h("span.film-name");
    frame.append(name, handle);
    return {
      slab: svg("rect", { class: "film-layer" }, slabs),
      face: svg("line", { class: "film-face" }, faces),
      name,
      handle,
    };
  }

  function letGo() {
    if (!held) return;
    held = null;
    draw();
    onSettle();
  }

  /** @param {readonly Layer[]} layers */
  function fit(layers) {
    while (made.length < layers.length) made.push(makeLayer(made.length));
    while (made.length > layers.length)
      for (const part of Object.values(made.pop() ?? {})) part.remove();
  }

  /** How a medium is tinted: by its index, an absorbing one gray. @param {number} n @param {number} k */
  const tint = (n, k) =>
    k > 0.05
      ? { fill: "var(--edge)", opacity: Math.min(0.75, 0.35 + 0.08 * k) }
      : { fill: "var(--accent)", opacity: Math.min(0.45, 0.04 + 0.16 * Math.abs(n - 1)) };

  /** @param {SVGElement} node @param {number} y @param {number} height @param {number} width @param {{fill: string, opacity: number}} look */
  function place(node, y, height, width, { fill, opacity }) {
    put(node, "y", px(y));
    put(node, "height", px(Math.max(height, 0)));
    put(node, "width", width);
    put(node, "style", `fill: ${fill}; fill-opacity: ${opacity.toFixed(3)}`);
  }

  /** An arrow from or to a point. @param {SVGElement} node @param {[number, number]} from @param {[number, number]} to @param {number} power */
  function arrow(node, from, to, power) {
    const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
    const long = Math.hypot(dx, dy) || 1;
    const [ux, uy] = [dx / long, dy / long];
    const half = Math.max(0.6, (WIDEST / 2) * power);
    const wing = half + 4;
    const neck = Math.max(long - 1.6 * wing, 0);
    /** @param {number} along @param {number} aside */
    const at = (along, aside) =>
      `${px(from[0] + ux * along - uy * aside)},${px(from[1] + uy * along + ux * aside)}`;
    put(
      node,
      "d",
      `M${at(0, half)}L${at(neck, half)}L${at(neck, wing)}L${at(long, 0)}L${at(neck, -wing)}L${at(neck, -half)}L${at(0, -half)}Z`,
    );
    show(node, power > 5e-4);
  }

  function draw() {
    const { width, height } = size;
    if (!known || width < 60 || height < 60) return;
    const { now, facts, here, reading } = known;
    const layers = readLayers(now.layers) ?? [];
    fit(layers);
    for (const [name, value] of Object.entries({ width, height })) put(root, name, value);
    const top = Math.round(SKY * height);
    const room = Math.round(GROUND * height) - top;
    const thin = layers.filter((layer) => !layer.incoherent);
    const total = thin.reduce((sum, layer) => sum + layer.nm, 0);
    const free = Math.max(room - THICK * (layers.length - thin.length), 40);
    const wanted = Math.max(roundAbove(1.15 * total), 10);
    scaled = held ? Math.max(scaled, wanted) : wanted;
    perPixel = scaled / free;

    place(front, 0, top, width, tint(now.n_i, 0));
    let y = top;
    let free_y = top + 2;
    layers.forEach((layer, i) => {
      const part = made[i];
      if (!part) return;
      const tall = layer.incoherent ? THICK : layer.nm / perPixel;
      // The answer may still be that of the layers before.
      const found = facts?.[i]?.medium === layer.medium ? facts[i] : { n: 1.4, k: 0 };
      place(part.slab, y, tall, width, tint(found.n, found.k));
      const end = y + tall;
      for (const [name, value] of Object.entries({ x1: 0, x2: width, y1: px(end), y2: px(end) }))
        put(part.face, name, value);
      part.handle.style.transform = `translateY(${px(end)}px)`;
      part.handle.hidden = layer.incoherent;
      part.handle.toggleAttribute("data-chosen", now.film_layer === i + 1 && layers.length > 1);
      const label = `${shortMedium(layer.medium)}, ${thicknessText(layer.nm)}`;
      put(part.handle, "aria-label", `Thickness of layer ${i + 1}`);
      put(part.handle, "aria-valuenow", layer.nm);
      put(part.handle, "aria-valuetext", label);
      const named = layers.length <= MOST_NAMES;
      part.name.hidden = !named;
      if (named) {
        setText(part.name, label);
        const line = Math.max(free_y, (y + end - NAME) / 2);
        part.name.style.transform = `translate(${width - 8}px, ${px(line)}px) translateX(-100%)`;
        free_y = line + NAME;
      }
      y = end;
    });
    place(back, y, height - y, width, tint(now.n_t, now.k_t));
    put(back, "data-k", now.k_t > 0 ? "1" : null);

    setText(texts.front, `n = ${plain(now.n_i, 4)}`);
    texts.front.style.transform = "translate(8px, 4px)";
    const behind = now.k_t > 0 ? ` + ${plain(now.k_t, 4)}i` : "";
    setText(texts.back, `n = ${plain(now.n_t, 4)}${behind}`);
    texts.back.style.transform = `translate(8px, ${height - NAME - 6}px)`;
    const [, step = 1, power = 0] = /^(\d)e([+-]\d+)$/u.exec((scaled / 4).toExponential(0)) ?? [];
    const length = Number(`${step}e${power}`);
    texts.scale.hidden = thin.length === 0;
    show(bar, thin.length > 0);
    setText(texts.scale, thicknessText(length));
    texts.scale.style.transform = `translate(18px, ${px(top + length / perPixel / 2 - NAME / 2)}px)`;
    put(bar, "d", `M8,${top}h6m-3,0v${px(length / perPixel)}m-3,0h6`);

    const theta = (now.theta_i_deg * Math.PI) / 180;
    const meets = /** @type {[number, number]} */ ([BEAM * width, top]);
    const far = Math.min(LENGTH * width, 0.86 * top);
    const [sin, cos] = [Math.sin(theta) * far, Math.cos(theta) * far];
    const aside = 9 * Math.cos(theta); // at normal incidence the beams stand side by side
    arrow(beams.incident, [meets[0] - sin - aside, top - cos], [meets[0] - aside, top], 1);
    const R = reading?.R ?? 0;
    arrow(beams.reflected, [meets[0] + aside, top], [meets[0] + sin + aside, top - cos], R);
    const theta_t = here?.theta_t_deg ?? null;
    const T = theta_t === null && now.k_t === 0 ? 0 : (reading?.T ?? 0);
    const inside = ((theta_t ?? 0) * Math.PI) / 180;
    const deep = Math.min(far, 0.9 * (height - y));
    arrow(
      beams.transmitted,
      [meets[0], y],
      [meets[0] + Math.sin(inside) * deep, y + Math.cos(inside) * deep],
      T,
    );
    /** @param {HTMLElement} node @param {number} x @param {number} below @param {string} words */
    const write = (node, x, below, words) => {
      setText(node, reading ? words : "");
      node.style.transform = `translate(${px(Math.min(x, width - 80))}px, ${px(below)}px)`;
    };
    write(texts.R, meets[0] + sin + aside + 14, Math.max(top - cos - 4, 4), `R ${percent(R)}`);
    write(
      texts.T,
      meets[0] + Math.sin(inside) * deep + 14,
      Math.min(y + Math.cos(inside) * deep - NAME, height - NAME - 4),
      `T ${percent(reading?.T ?? 0)}`,
    );
    frame.ariaDescription = `${angle(now.theta_i_deg, now.angle)}; reflected ${percent(R)}`;
  }

  const { size, stop } = onResize(frame, draw);

  return {
    element: frame,
    /**
     * @param {State} now
     * @param {any} facts of the layers, as the server knows them
     * @param {any} here at one angle
     * @param {{R: number, T: number} | null} reading
     */
    update(now, facts, here, reading) {
      known = { now, facts, here, reading };
      pressed = null;
      draw();
    },
    destroy: stop,
  };
}
