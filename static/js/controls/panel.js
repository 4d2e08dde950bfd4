/** What panels of controls are made of: choices, rows with a slider, and the sheet that holds them on a phone. */

import { put } from "../draw/svg.js";
import { sample } from "../models/look.js";
import { angle, clamp, inDegrees, inUnit, plain, snap, stepped } from "../numbers/format.js";
import { h, setText, symbol } from "../page/dom.js";

let groups = 0;

/** @param {ChoiceOptions} options */
export function createChoice({ legend, items, several = false, listed = false, onChange }) {
  groups += 1;
  const name = `choice-${groups}`;
  const inputs = items.map((item) =>
    h("input", {
      type: several ? "checkbox" : "radio",
      name,
      value: item.value,
      onchange: () => onChange(inputs.filter((i) => i.checked).map((i) => i.value)),
    }),
  );
  const labels = items.map((item, i) =>
    h("label", { title: item.note }, inputs[i], h("span", item.content ?? item.label)),
  );
  const element = h(
    "fieldset",
    { class: ["choice", several && "several", listed && "listed"].filter(Boolean).join(" ") },
    h("legend", legend),
    h("div.options", ...labels),
  );
  return {
    element,
    /** @param {readonly string[]} values @param {ReadonlyMap<string, string>} [reasons] why an item does not apply here */
    update(values, reasons) {
      inputs.forEach((input, i) => {
        input.checked = values.includes(input.value);
        const reason = reasons?.get(input.value);
        const label = labels[i];
        if ((label.dataset.reason ?? "") !== (reason ?? "")) {
          if (reason) label.dataset.reason = reason;
          else delete label.dataset.reason;
        }
      });
    },
  };
}

/** A fold of curves to choose among: how many of them are on stands in its line. @param {FoldOptions} options */
export function createFold({ legend, entries, open = false, chosen, onChange }) {
  const ids = entries.map(({ id }) => id);
  const group = createChoice({
    legend,
    several: true,
    listed: true,
    items: entries.map(({ id, title, note, style }) => ({
      value: id,
      label: title,
      note,
      content: h("span.overlay-name", sample(style), title),
    })),
    onChange(picked) {
      const kept = chosen().filter((id) => picked.includes(id) || !ids.includes(id));
      onChange([...kept, ...picked.filter((id) => !kept.includes(id))]);
    },
  });
  const count = h("span.count");
  const element = h("details.forms", { open }, h("summary", legend, count), group.element);
  const labels = group.element.querySelectorAll("label");
  let order = ids.join();
  return {
    element,
    ids,
    labels,
    /**
     * @param {readonly string[]} on
     * @param {ReadonlyMap<string, string>} [reasons] why one does not apply here
     * @param {readonly {id: string}[]} [wanted] all of them and others, in the order in which they stand
     */
    update(on, reasons, wanted) {
      group.update(on, reasons);
      const placed = wanted?.flatMap(({ id }) => (ids.includes(id) ? [id] : [])) ?? ids;
      if (placed.join() !== order) {
        order = placed.join();
        const all = placed.flatMap((id) => labels[ids.indexOf(id)] ?? []);
        all[0]?.parentElement?.append(...all);
      }
      const many = ids.filter((id) => on.includes(id)).length;
      setText(count, many ? ` ${many} of ${ids.length}` : ` ${ids.length}`);
      return many;
    },
  };
}

/**
 * Choices that stand for fields of the state: one of few words each.
 * @template {string} Name
 * @param {Pick<Actions, 'set'>} actions
 * @param {Record<Name, readonly [legend: string, words: Record<string, string | readonly [label: string, note: string]>]>} fields
 *   by the field's name the choice's own, and the word, or the word and what it means, for each value
 */
export function createChoices(actions, fields) {
  const names = /** @type {Name[]} */ (Object.keys(fields));
  const made = names.map((name) => {
    const [legend, words] = fields[name];
    const items = Object.entries(words).map(([value, word]) =>
      typeof word === "string" ? { value, label: word } : { value, label: word[0], note: word[1] },
    );
    const choice = createChoice({
      legend,
      items,
      onChange: ([value]) => actions.set({ [name]: value }),
    });
    return { name, choice };
  });
  return {
    elements: /** @type {Record<Name, HTMLElement>} */ (
      /** @type {unknown} */ (
        Object.fromEntries(made.map(({ name, choice }) => [name, choice.element]))
      )
    ),
    /** @param {State} state */
    update(state) {
      for (const { name, choice } of made) choice.update([state[name]]);
    },
  };
}

/**
 * @param {SheetOptions} options
 */
export function createSheet({ pages, body, first }) {
  const strip = h("div.strip", { role: "group", "aria-label": "Which value to move" });
  const entries = pages.map((page) => {
    const value = h("b");
    const button = h(
      "button",
      { type: "button", "aria-pressed": "false", onclick: () => choose(page.name) },
      symbol(page.symbol),
      value,
    );
    strip.append(button);
    return { page, button, value };
  });
  const opener = h("button.opener", { type: "button", "aria-expanded": "false" }, "all");
  strip.append(opener);
  const element = h(
    "section.panel",
    { "aria-label": "Controls", "data-sheet": "closed" },
    strip,
    body,
  );
  opener.addEventListener("click", () => {
    const open = element.dataset.sheet !== "open";
    element.dataset.sheet = open ? "open" : "closed";
    opener.setAttribute("aria-expanded", String(open));
    opener.textContent = open ? "close" : "all";
  });

  /** @param {string} name */
  function choose(name) {
    for (const { page, button } of entries) {
      const on = page.name === name;
      button.setAttribute("aria-pressed", String(on));
      page.row.element.toggleAttribute("data-chosen", on);
    }
  }
  choose(first);

  return {
    element,
    update() {
      for (const { page, value } of entries) setText(value, page.print());
    },
  };
}

const ROUNDING = 1e-12;

/** A printed number without its unit. @param {string} text */
const bare = (text) => text.replace(/[°\s]|rad/gu, "");
const SPEEDS = [0.25, 0.5, 1, 2, 4];
const SNAP = 0.015; // of the slider's span

/** How far the keys move an index, and an angle. */
export const INDEX_STEPS = { step: 0.01, fine: 0.001, page: 0.1 };
export const ANGLE_STEPS = { step: 0.5, fine: 0.05, page: 5 };

/**
 * How an angle is written that is kept in degrees.
 * @param {() => string} allowed
 * @param {() => "deg" | "rad"} [unit] that it is shown in
 * @returns {RowOptions["writing"]}
 */
export function angleWriting(allowed, unit = () => "deg") {
  return {
    print: (v) => (unit() === "rad" ? angle(v, "rad") : `${plain(v)}°`),
    end: (v) => (unit() === "rad" ? `${plain(inUnit(v, "rad"), 4)}\u00a0rad` : `${plain(v)}°`),
    parse(text, { evaluateAngle }) {
      const typed = evaluateAngle(text, unit());
      return inDegrees(typed.value, typed.unit);
    },
    allowed,
  };
}

/** @param {RowOptions} options */
export function createRow({
  parameter,
  prefix = "",
  preset,
  label,
  term,
  range,
  wide,
  steps,
  onChange,
  onSettle,
  writing,
}) {
  const id = prefix + parameter.name.replace(/\W/g, "-");
  /** @type {NonNullable<RowOptions["writing"]>} */
  const write = writing ?? {
    print: (v) => plain(v),
    end: (v) => plain(v),
    parse: (text, { evaluate }) => evaluate(text),
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
  const ticks = h("div.ticks", { "aria-hidden": "true" });
  const low = h("span.end");
  const high = h("span.end");
  const error = h("p.row-error", { id: `${id}-error`, role: "alert" });
  const play = h("button.play", {
    type: "button",
    "aria-label": `Play ${label}`,
    "aria-pressed": "false",
  });
  const back = h("button.mini", { type: "button", "aria-label": `${label}: a step down` }, "◂");
  const on = h("button.mini", { type: "button", "aria-label": `${label}: a step up` }, "▸");
  const pace = h(
    "select.mini",
    { "aria-label": `${label}: speed of play` },
    ...SPEEDS.map((s) => h("option", { value: s, selected: s === 1 }, `${s}×`)),
  );
  const widen = h("button.mini", { type: "button", "aria-pressed": "false" }, "more");
  const element = h(
    "div.row",
    { "data-parameter": parameter.name, role: "group", "aria-label": label },
    term
      ? h("div.row-name", term, h("label", { for: `${id}-box` }, label))
      : h("label.row-name", { for: `${id}-box` }, symbol(parameter.symbol), h("span", label)),
    h("div", h("div.box-frame", box)),
    play,
    h("div.track", h("div.track-frame", slider, ticks)),
    h("div.row-foot", low, h("span.steps", back, pace, on, wide ? widen : null), high),
    error,
  );

  function ends() {
    const [a, b] = more && wide ? wide : range;
    // The slider reaches what the box or a link says, also beyond "more".
    const outside = value < range[0] || value > range[1];
    const [c, d] = outside && wide ? wide : [a, b];
    return [Math.min(c, value), Math.max(d, value)];
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

  /** How what is typed is read, fetched when somebody comes to write. */
  const reading = () => import("../numbers/expression.js");
  const meaning = () => import("../numbers/meant.js");

  async function commit() {
    const given = box.value;
    const text = given.trim();
    if (preset === null && text === "") {
      typing = false;
      complain("");
      if (!left) onChange(null, false);
      return;
    }
    // What is shown is rounded: leaving it as it is must not round the value.
    if (!left && given === write.print(value)) {
      typing = false;
      complain("");
      return;
    }
    const expression = await reading();
    typing = false;
    try {
      const asked = write.parse(given, expression);
      const typed = clamp(asked, parameter.minimum, parameter.maximum);
      // A bound may be typed as it is shown, such as 1.5708 rad, or miss it by its rounding: pi/2.
      const bound = write.print(typed);
      const isBound = bare(text) === bare(bound) || Math.abs(asked - typed) < ROUNDING * typed;
      if (typed !== asked && !isBound) {
        const printed = write.print(asked);
        const said = printed === bound ? text : printed;
        const meant = (await meaning()).instead(parameter.name, asked);
        complain(
          `${parameter.name} = ${said}${meant ? `: ${meant}` : ` is outside ${write.allowed()}`}`,
        );
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
      if (!(problem instanceof expression.ExpressionError)) throw problem;
      const meant = (await meaning()).instead(parameter.name, text);
      const why = meant ?? `${problem.message}. Allowed: ${write.allowed()}`;
      complain(`${parameter.name} = “${given}”: ${why}`);
    }
  }

  /** At once: the next press of a key may come before the next frame. @param {number} next */
  function move(next) {
    value = next;
    left = false;
    onChange(next, true);
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
    if (next !== value) move(next);
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
        Home: () => move(ends()[0] ?? value),
        End: () => move(ends()[1] ?? value),
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
  box.addEventListener("focus", () => {
    box.select();
    void reading();
  });
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
