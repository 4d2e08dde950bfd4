/** Glossy paint: a diffuse body under a clear coat, and where the light goes that falls on it. */

import { createChoice } from "../controls/panel.js";
import { createRow } from "../controls/row.js";
import { put, svg } from "../draw/svg.js";
import { evaluateAngle } from "../numbers/entry.js";
import { angle, inDegrees, percent, plain, six } from "../numbers/format.js";
import { h, setText } from "../page/dom.js";
import { copyText, createExports, flash } from "../page/exports.js";
import { createTrouble } from "../page/trouble.js";
import { fontFaces, rasterized, withStyle } from "../plot/image.js";
import { coatPicture, outline } from "./picture.js";

/**
 * @typedef {{interface: Interface, body_albedo: number, theta_i_deg: number | null,
 *   external: number, internal: number, surface: number, body: number, absorbed: number}} Coat
 * @typedef {import('../page/trouble.js').Problem} Problem
 */

const PARTS = /** @type {const} */ ([
  ["surface", "off the surface", "reflected by the coat without reaching the body"],
  ["body", "out of the body", "scattered by the body and let out again"],
  ["absorbed", "absorbed", "lost in the body"],
]);
const SMALLEST = 60;
const FILE = "fresnel-coat";

/** Properties that an exported picture carries with it. */
const PAINT = [
  "fill",
  "fill-opacity",
  "stroke",
  "stroke-width",
  "stroke-dasharray",
  "font-family",
  "font-size",
  "font-style",
  "font-weight",
  "text-anchor",
];

/**
 * @param {object} options
 * @param {State} options.presets
 * @param {() => State} options.state
 * @param {Actions} options.actions
 * @param {(name: string, blob: Blob) => void} options.save
 * @param {(text: string) => void} options.say
 * @param {string} [options.prefix] of ids
 */
export function createCoat({ presets, state, actions, save, say, prefix = "albedo-" }) {
  /** @param {string} name @param {string} symbol @param {string} label @param {[number, number]} bounds @param {[number, number]} range @param {Partial<import('../controls/row.js').RowOptions>} [more] */
  const row = (name, symbol, label, bounds, range, more = {}) =>
    createRow({
      parameter: { name, symbol, minimum: bounds[0], maximum: bounds[1] },
      prefix,
      preset: presets[name],
      label,
      range,
      steps: { step: 0.01, fine: 0.001, page: 0.1 },
      onChange: (value, moving) =>
        actions.set({ [name]: value }, { history: moving ? "replace" : "push" }),
      onSettle: actions.settle,
      ...more,
    });
  const rows = {
    coat_n: row("coat_n", "n", "index of the coat", [1e-3, 100], [1, 3]),
    coat_body: row("coat_body", "ρ", "albedo of the body", [0, 1], [0, 1]),
    coat_theta: row("coat_theta", "\\theta_i", "angle of the ray", [0, 90], [0, 90], {
      steps: { step: 0.5, fine: 0.05, page: 5 },
      writing: {
        print: (v) => `${plain(v)}°`,
        end: (v) => `${plain(v)}°`,
        parse(text) {
          const { value, unit } = evaluateAngle(text, "deg");
          return inDegrees(value, unit);
        },
        allowed: () => "0° to 90°",
      },
    }),
  };
  const light = createChoice({
    legend: "Light",
    items: [
      { value: "diffuse", label: "from everywhere" },
      { value: "ray", label: "a ray" },
    ],
    onChange: ([value]) => actions.set({ coat_light: value }),
  });
  const same = h(
    "button",
    {
      type: "button",
      class: "quiet same-media",
      onclick: () => {
        const { n_i, n_t } = state();
        actions.set({ coat_n: Number((n_t / n_i).toPrecision(12)) });
      },
    },
    "take n from the media",
  );

  const root = svg("svg", { class: "coat-svg", "aria-hidden": "true", focusable: "false" });
  const layers = {
    coat: svg("rect", { class: "coat-layer" }, root),
    ground: svg("rect", { class: "body-layer" }, root),
    line: svg("line", { class: "coat-line" }, root),
    under: svg("line", { class: "coat-line" }, root),
  };
  const bands = svg("g", {}, root);
  const loop = svg("path", { class: "coat-loop" }, root);
  const loopHead = svg("path", { class: "coat-loop-head" }, root);
  /** @param {string} className */
  const text = (className) => svg("text", { class: className }, root);
  const labels = {
    incoming: [text("coat-name"), text("coat-value")],
    surface: [text("coat-name"), text("coat-value")],
    body: [text("coat-name"), text("coat-value")],
    absorbed: [text("coat-name start"), text("coat-value start")],
    internal: [text("coat-note"), text("coat-note")],
  };
  const names = { coat: text("coat-word"), body: text("coat-word") };
  const frame = h("div", { class: "coat-frame", role: "figure" }, root);
  const bar = h("div", { class: "energy-bar", "aria-hidden": "true" });
  const pieces = PARTS.map(([name]) => {
    const piece = h("div", { class: `energy ${name}` });
    bar.append(piece);
    return piece;
  });
  const list = h("dl", { class: "energies" });
  const values = PARTS.map(([name, words, note]) => {
    const value = h("button", { type: "button", class: "number" });
    value.addEventListener("click", async () => {
      if (!shown) return;
      const done = await copyText(String(shown[name]));
      flash(value, done);
      say(done ? `${name} copied` : "Copying is not allowed here");
    });
    const share = h("span", { class: "share" });
    list.append(
      h(
        "div",
        {},
        h("dt", { title: note }, h("i", { class: `swatch ${name}` }), words),
        h("dd", {}, share, value),
      ),
    );
    return { name, value, share };
  });
  const says = h("p", { class: "coat-says" });
  const trouble = createTrouble("Back to the usual paint", () =>
    actions.set({
      coat_n: presets.coat_n,
      coat_body: presets.coat_body,
      coat_theta: presets.coat_theta,
    }),
  );
  const element = h(
    "section",
    { class: "column coat", "aria-label": "Glossy paint" },
    h(
      "div",
      { class: "heading" },
      h("h2", {}, "Glossy paint: a body under a coat"),
      createExports({ what: "the picture of the paint", name: () => FILE, make, save }),
    ),
    h(
      "div",
      { class: "coat-parts" },
      h("div", { class: "coat-picture" }, frame, bar, list, says, trouble.element),
      h(
        "div",
        { class: "coat-rows" },
        light.element,
        rows.coat_theta.element,
        rows.coat_n.element,
        same,
        rows.coat_body.element,
      ),
    ),
  );

  /** @type {Coat | null} */
  let shown = null;

  function draw() {
    const width = frame.clientWidth;
    const height = frame.clientHeight;
    if (!shown || width < SMALLEST || height < SMALLEST) return;
    const line = Number.parseFloat(getComputedStyle(frame).fontSize) * 1.35;
    const picture = coatPicture(shown, { width, height, line });
    for (const [name, value] of Object.entries({
      width,
      height,
      viewBox: `0 0 ${width} ${height}`,
    }))
      put(root, name, value);
    /** @param {SVGElement} rect @param {number} y @param {number} to */
    const place = (rect, y, to) => {
      for (const [name, value] of Object.entries({ x: 0, y, width, height: Math.max(0, to - y) }))
        put(rect, name, value);
    };
    place(layers.coat, picture.surface, picture.body);
    place(layers.ground, picture.body, picture.floor);
    for (const [node, y] of /** @type {const} */ ([
      [layers.line, picture.surface],
      [layers.under, picture.body],
    ])) {
      for (const [name, value] of Object.entries({ x1: 0, x2: width, y1: y, y2: y }))
        put(node, name, value);
    }
    while (bands.children.length > picture.bands.length) bands.lastElementChild?.remove();
    picture.bands.forEach((shape, i) => {
      const node = bands.children[i] ?? bands.appendChild(svg("path"));
      put(node, "class", `coat-band ${shape.name}`);
      put(node, "d", outline(shape));
    });
    put(loop, "d", picture.loop);
    const { x } = picture.labels.internal;
    const tip = { x: x + 0.05 * width, y: picture.body - 2 };
    put(loopHead, "d", `M${tip.x - 4},${tip.y - 8}L${tip.x},${tip.y}L${tip.x + 4},${tip.y - 8}`);
    /** @param {keyof typeof labels} name @param {[string, string]} words @param {{x: number, y: number}} at */
    const write = (name, words, at) => {
      labels[name].forEach((node, i) => {
        put(node, "x", at.x);
        put(node, "y", at.y + i * line);
        if (node.textContent !== words[i]) node.textContent = /** @type {string} */ (words[i]);
      });
    };
    const { labels: at } = picture;
    write("incoming", ["light", "100 %"], at.incoming);
    write("surface", ["surface", percent(shown.surface)], at.surface);
    write("body", ["body", percent(shown.body)], at.body);
    write("absorbed", ["absorbed", percent(shown.absorbed)], at.absorbed);
    write("internal", [width < 330 ? "back" : "thrown back", percent(shown.internal)], at.internal);
    for (const [node, words, top] of /** @type {const} */ ([
      [names.coat, "coat", picture.surface],
      [names.body, "body", picture.body],
    ])) {
      put(node, "x", 0.6 * line);
      put(node, "y", top + 1.2 * line);
      if (node.textContent !== words) node.textContent = words;
    }
  }

  let waiting = 0;
  const observer = new ResizeObserver(() => {
    cancelAnimationFrame(waiting);
    waiting = requestAnimationFrame(draw);
  });
  observer.observe(frame);

  /** The picture alone: with the paint that the page's style gives it. @param {'png' | 'svg' | 'csv'} format */
  async function make(format) {
    if (!shown) throw new Error("there is no picture yet");
    if (format === "csv") {
      const { interface: media, body_albedo, theta_i_deg, external, internal } = shown;
      const row = {
        n_t: media.n_t,
        body_albedo,
        theta_i_deg,
        external,
        internal,
        surface: shown.surface,
        body: shown.body,
        absorbed: shown.absorbed,
      };
      const text = `${Object.keys(row).join(",")}\r\n${Object.values(row)
        .map((v) => v ?? "")
        .join(",")}\r\n`;
      return new Blob([text], { type: "text/csv;charset=utf-8" });
    }
    const width = frame.clientWidth;
    const height = frame.clientHeight;
    const copy = /** @type {SVGElement} */ (root.cloneNode(true));
    const originals = [...root.querySelectorAll("*")];
    [...copy.querySelectorAll("*")].forEach((node, i) => {
      const style = getComputedStyle(/** @type {Element} */ (originals[i]));
      for (const name of PAINT) {
        const value = style.getPropertyValue(name);
        if (value) node.setAttribute(name, value);
      }
      node.removeAttribute("class");
    });
    copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
    const ground = svg("rect", {
      width,
      height,
      fill: getComputedStyle(document.documentElement).backgroundColor,
    });
    copy.prepend(ground);
    const source = withStyle(
      new XMLSerializer().serializeToString(copy),
      await fontFaces(getComputedStyle(frame).fontFamily),
    );
    const blob = new Blob([source], { type: "image/svg+xml;charset=utf-8" });
    return format === "svg" ? blob : rasterized(blob, 2 * width, 2 * height);
  }

  return {
    element,
    stop() {
      for (const r of Object.values(rows)) r.stop();
    },
    /** @param {State} now @param {Coat | undefined} answer @param {Problem | undefined} problem */
    update(now, answer, problem) {
      light.update([now.coat_light]);
      rows.coat_n.update(
        now.coat_n,
        now.k_t === 0 ? [{ value: now.n_t / now.n_i, label: "the media at hand" }] : [],
      );
      rows.coat_body.update(now.coat_body);
      rows.coat_theta.update(now.coat_theta);
      rows.coat_theta.element.hidden = now.coat_light !== "ray";
      same.hidden = now.k_t > 0 || now.coat_n === Number((now.n_t / now.n_i).toPrecision(12));
      trouble.update(problem, true);
      if (!answer || answer === shown) return;
      shown = answer;
      const lit =
        answer.theta_i_deg === null
          ? "diffuse light"
          : `a ray at ${angle(answer.theta_i_deg, "deg", 1)}`;
      const shares = PARTS.map(([name, words]) => `${percent(answer[name])} ${words}`);
      frame.setAttribute(
        "aria-label",
        `Of ${lit} on paint with a coat of n = ${plain(answer.interface.n_t, 4)}: ${shares.join(", ")}`,
      );
      PARTS.forEach(([name], i) => {
        pieces[i]?.style.setProperty("--share", String(answer[name]));
      });
      for (const { name, value, share } of values) {
        setText(share, percent(answer[name]));
        setText(value, six(answer[name]));
        value.ariaLabel = `${name}: ${value.textContent}, copy`;
      }
      setText(
        says,
        `The coat throws ${percent(answer.internal)} of what the body sends up back to it, so that a body of albedo ${plain(answer.body_albedo, 4)} lets out ${percent(answer.body)} of the light in place of ${percent(answer.body_albedo)}.`,
      );
      draw();
    },
    destroy() {
      observer.disconnect();
      cancelAnimationFrame(waiting);
    },
  };
}
