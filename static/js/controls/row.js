/** A Manipulate row: symbol, name, number box; below it play, slider, range. */

import { put } from "../draw/svg.js";
import { clamp, ExpressionError, evaluate, snap, stepped } from "../numbers/entry.js";
import { plain } from "../numbers/format.js";
import { h, setText, symbol } from "../page/dom.js";

const ROUNDING = 1e-12;

/** A printed number without its unit. @param {string} text */
const bare = (text) => text.replace(/[°\s]|rad/gu, "");
const SPEEDS = [0.25, 0.5, 1, 2, 4];
const SNAP = 0.015; // of the slider's span

/**
 * @typedef {object} RowOptions
 * @property {{name: string, symbol: string, minimum: number, maximum: number}} parameter
 * @property {string} [prefix] of the ids, where another view has a row of the same name
 * @property {number | null} preset the value that a double click goes back to; null leaves it to the server
 * @property {string} label
 * @property {[number, number]} range of the slider
 * @property {[number, number]} [wide] of the slider after "more"
 * @property {{step: number, fine: number, page: number}} steps
 * @property {(value: number | null, moving: boolean) => void} onChange
 * @property {() => void} onSettle
 * @property {{print: (value: number) => string, end: (value: number) => string,
 *   parse: (text: string) => number, allowed: () => string}} [writing]
 *   how the value is written where it differs from the plain number (angles)
 */

/** @param {RowOptions} options */
export function createRow({
  parameter,
  prefix = "",
  preset,
  label,
  range,
  wide,
  steps,
  onChange,
  onSettle,
  writing,
}) {
  const id = prefix + parameter.name.replace(/\W/g, "-");
  const write = writing ?? {
    print: (/** @type {number} */ v) => plain(v),
    end: (/** @type {number} */ v) => plain(v),
    parse: evaluate,
    allowed: () => `${plain(parameter.minimum)} to ${plain(parameter.maximum)}`,
  };
  let value = preset ?? range[0];
  let left = preset === null; // left to the server
  let more = false;
  /** @type {{value: number, label: string}[]} */
  let landmarks = [];
  let free = false;
  let shown = "";

  const box = h("input", {
    id: `${id}-box`,
    class: "box",
    type: "text",
    inputmode: "text",
    autocomplete: "off",
    spellcheck: "false",
    placeholder: preset === null ? "auto" : null,
    "aria-label": `${label}, value`,
    "aria-describedby": `${id}-error`,
  });
  const slider = h("input", {
    id: `${id}-slider`,
    class: "slider",
    type: "range",
    step: "any",
    "aria-label": label,
  });
  const ticks = h("div", { class: "ticks", "aria-hidden": "true" });
  const low = h("span", { class: "end" });
  const high = h("span", { class: "end" });
  const error = h("p", { class: "row-error", id: `${id}-error`, role: "alert" });
  const play = h("button", {
    type: "button",
    class: "play",
    "aria-label": `Play ${label}`,
    "aria-pressed": "false",
  });
  const back = h(
    "button",
    { type: "button", class: "mini", "aria-label": `${label}: a step down` },
    "◂",
  );
  const on = h(
    "button",
    { type: "button", class: "mini", "aria-label": `${label}: a step up` },
    "▸",
  );
  const pace = h(
    "select",
    { class: "mini", "aria-label": `${label}: speed of play` },
    ...SPEEDS.map((s) => h("option", { value: s, selected: s === 1 }, `${s}×`)),
  );
  const widen = h("button", { type: "button", class: "mini", "aria-pressed": "false" }, "more");
  const element = h(
    "div",
    { class: "row", "data-parameter": parameter.name, role: "group", "aria-label": label },
    h(
      "label",
      { class: "row-name", for: `${id}-box` },
      symbol(parameter.symbol),
      h("span", {}, label),
    ),
    h("div", {}, h("div", { class: "box-frame" }, box)),
    play,
    h("div", { class: "track" }, h("div", { class: "track-frame" }, slider, ticks)),
    h(
      "div",
      { class: "row-foot" },
      low,
      h("span", { class: "steps" }, back, pace, on, wide ? widen : null),
      high,
    ),
    error,
  );

  function ends() {
    const [a, b] = more && wide ? wide : range;
    // The slider reaches what the box or a link says, also beyond "more".
    const outside = value < range[0] || value > range[1];
    const [c, d] = outside && wide ? wide : [a, b];
    return /** @type {[number, number]} */ ([Math.min(c, value), Math.max(d, value)]);
  }

  /** @type {ReturnType<typeof import("./player.js").createPlayer> | null} */
  let player = null;

  async function startOrStop() {
    const { createPlayer } = await import("./player.js");
    player ??= createPlayer({
      now() {
        const [a, b] = ends();
        return { value, low: a, high: b, fine: steps.fine };
      },
      onValue: (v) => onChange(v, true),
      onPlaying(playing) {
        play.setAttribute("aria-pressed", String(playing));
        if (!playing) onSettle();
      },
    });
    player.setSpeed(Number(pace.value));
    player.toggle();
  }

  /** @param {string} message */
  function complain(message) {
    setText(error, message);
    box.toggleAttribute("aria-invalid", message !== "");
  }

  /** What is being typed stays, whatever answers arrive meanwhile. */
  let typing = false;

  function commit() {
    typing = false;
    if (preset === null && box.value.trim() === "") {
      complain("");
      if (!left) onChange(null, false);
      return;
    }
    // What is shown is rounded: leaving it as it is must not round the value.
    if (!left && box.value === write.print(value)) {
      complain("");
      return;
    }
    try {
      const asked = write.parse(box.value);
      const typed = clamp(asked, parameter.minimum, parameter.maximum);
      // A bound may be typed as it is shown, such as 1.5708 rad, or miss it by its rounding: pi/2.
      const text = box.value.trim();
      const bound = write.print(typed);
      const isBound = bare(text) === bare(bound) || Math.abs(asked - typed) < ROUNDING * typed;
      if (typed !== asked && !isBound) {
        const printed = write.print(asked);
        const said = printed === bound ? text : printed;
        complain(`${parameter.name} = ${said} is outside ${write.allowed()}`);
        return;
      }
      complain("");
      if (typed !== value || left) {
        // At once: with the old value shown here, a change event could follow and bring it back.
        value = typed;
        left = false;
        onChange(typed, false);
      }
      show();
    } catch (problem) {
      if (!(problem instanceof ExpressionError)) throw problem;
      complain(
        `${parameter.name} = “${box.value}”: ${problem.message}. Allowed: ${write.allowed()}`,
      );
    }
  }

  /** @param {number} step */
  function go(step) {
    const next = clamp(
      stepped(
        value,
        step,
        landmarks.map((l) => l.value),
      ),
      parameter.minimum,
      parameter.maximum,
    );
    if (next !== value) onChange(next, true);
  }

  /** @param {KeyboardEvent} event @param {boolean} inBox */
  function key(event, inBox) {
    const fine = event.shiftKey ? steps.fine : steps.step;
    /** @type {Record<string, () => void>} */
    const keys = {
      ArrowUp: () => go(fine),
      ArrowDown: () => go(-fine),
      PageUp: () => go(steps.page),
      PageDown: () => go(-steps.page),
    };
    if (!inBox) {
      Object.assign(keys, {
        ArrowRight: () => go(fine),
        ArrowLeft: () => go(-fine),
        Home: () => onChange(ends()[0], true),
        End: () => onChange(ends()[1], true),
      });
    }
    const action = keys[event.key];
    if (!action || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    complain("");
    action();
    if (!inBox) return;
    typing = false;
    box.value = write.print(value);
  }

  box.addEventListener("keydown", (event) => {
    if (event.key === "Enter") commit();
    else if (event.key === "Escape") {
      typing = false;
      complain("");
      box.value = left ? "" : write.print(value);
    } else key(event, true);
  });
  box.addEventListener("keyup", (event) => {
    if (/^(Arrow|Page)/.test(event.key)) onSettle();
  });
  box.addEventListener("input", () => {
    typing = true;
  });
  box.addEventListener("change", commit);
  box.addEventListener("focus", () => box.select());
  slider.addEventListener("keydown", (event) => key(event, false));
  slider.addEventListener("keyup", onSettle);
  for (const kind of /** @type {const} */ (["pointerdown", "pointermove"])) {
    slider.addEventListener(kind, (event) => {
      free = event.altKey;
    });
  }
  slider.addEventListener("input", () => {
    const [a, b] = ends();
    const raw = Number((Math.round(Number(slider.value) / steps.fine) * steps.fine).toFixed(9));
    const next = free
      ? raw
      : snap(
          raw,
          landmarks.map((l) => l.value),
          SNAP * (b - a),
        );
    complain("");
    onChange(clamp(next, a, b), true);
  });
  slider.addEventListener("change", onSettle);
  slider.addEventListener("dblclick", () => onChange(preset, false));
  play.addEventListener("click", startOrStop);
  for (const [button, sign] of /** @type {const} */ ([
    [back, -1],
    [on, 1],
  ])) {
    button.addEventListener("click", (event) => {
      go(sign * (event.shiftKey ? steps.fine : steps.step));
      onSettle();
    });
  }
  pace.addEventListener("change", () => player?.setSpeed(Number(pace.value)));
  widen.addEventListener("click", () => {
    more = !more;
    show();
  });

  function show() {
    const [a, b] = ends();
    const text = left ? "" : write.print(value);
    // Rows are shown at every frame of a drag, and most have not changed: what is set is laid out again.
    const state = JSON.stringify([a, b, value, left, text, landmarks]);
    const busy = typing || box.hasAttribute("aria-invalid");
    if (document.activeElement !== box || !busy) {
      if (box.value !== text) box.value = text;
    }
    if (state === shown) return;
    shown = state;
    put(slider, "min", a);
    put(slider, "max", b);
    slider.value = String(value);
    put(slider, "aria-valuetext", left ? "from the media" : text);
    element.toggleAttribute("data-left", left);
    slider.style.setProperty("--fill", String((value - a) / (b - a || 1)));
    setText(low, write.end(a));
    setText(high, write.end(b));
    const open = wide !== undefined && (a !== range[0] || b !== range[1]);
    put(widen, "aria-pressed", String(open));
    setText(widen, open ? "less" : "more");
    const wanted = landmarks.filter((l) => l.value >= a && l.value <= b);
    while (ticks.children.length > wanted.length) ticks.lastElementChild?.remove();
    wanted.forEach((l, index) => {
      const tick = /** @type {HTMLElement} */ (ticks.children[index] ?? ticks.appendChild(h("i")));
      put(tick, "title", l.label);
      tick.style.setProperty("--at", String((l.value - a) / (b - a || 1)));
      tick.toggleAttribute("data-on", l.value === value);
    });
  }

  return {
    element,
    box,
    /** @param {number | null} next @param {{value: number, label: string}[]} marks */
    update(next, marks = []) {
      left = next === null;
      value = next ?? (preset === null ? (range[0] + range[1]) / 2 : preset);
      landmarks = marks;
      show();
    },
    print: () => write.print(value),
    stop: () => player?.stop(),
  };
}

/** @typedef {ReturnType<typeof createRow>} Row */
