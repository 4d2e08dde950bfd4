/** Controls of the models' own parameters, made from their declarations. */

import { modelStyle, sample, shortTitle } from "../models/look.js";
import { ExpressionError, evaluate } from "../numbers/expression.js";
import { plain } from "../numbers/format.js";
import { h, setText, symbol } from "../page/dom.js";
import { loadStyles } from "../page/style.js";
import { defaultOf, stateName } from "../state/state.js";
import { createChoice, createRow } from "./panel.js";

await loadStyles("parameters");

const CHANNELS = /** @type {const} */ (["R", "G", "B"]);

/** The first clause of a description is what a label has room for. @param {string} text */
function brief(text) {
  return text.split(/[;.,:] |\.$/, 1)[0] ?? text;
}

/** @param {Parameter} parameter */
function stepsOf({ minimum, maximum, integer }) {
  if (integer) return { step: 1, fine: 1, page: 16 };
  const size = 10 ** Math.round(Math.log10((maximum - minimum) / 100));
  return { step: size, fine: size / 10, page: size * 10 };
}

/** The part of a wide range that is of use on a slider. @param {Parameter} parameter @returns {[number, number]} */
function sliderRange({ minimum, maximum, default: preset }) {
  if (maximum - minimum <= 10) return [minimum, maximum];
  const middle = preset ?? 0;
  if (minimum < 0) return [-10, 10];
  return [minimum, Math.min(maximum, Math.max(10, 4 * middle))];
}

/**
 * @param {Parameter} parameter
 * @param {string} name
 * @param {string} prefix
 * @param {(value: any, moving: boolean) => void} onChange
 * @param {() => void} onSettle
 */
function numberRow(parameter, name, prefix, onChange, onSettle) {
  const { minimum, maximum, integer, description } = parameter;
  const range = sliderRange(parameter);
  const allowed = () =>
    `${integer ? "a whole number from " : ""}${plain(minimum)} to ${plain(maximum)}`;
  const row = createRow({
    parameter: { ...parameter, name },
    prefix,
    preset: parameter.default,
    label: brief(description),
    range,
    steps: stepsOf({ ...parameter, minimum: range[0], maximum: range[1] }),
    onChange,
    onSettle,
    writing: {
      print: (/** @type {number} */ v) => plain(v),
      end: (/** @type {number} */ v) => plain(v),
      parse(/** @type {string} */ text) {
        const value = evaluate(text);
        if (integer && !Number.isInteger(value)) throw new ExpressionError("it is not whole");
        return value;
      },
      allowed,
    },
  });
  return {
    element: row.element,
    stop: row.stop,
    /** @param {number | null} value @param {number} [solved] */
    update(value, solved) {
      row.update(value);
      row.box.placeholder = solved === undefined ? "auto" : `auto ${plain(solved, 4)}`;
    },
  };
}

/**
 * One number on a slider, or a box each for R, G and B.
 * @param {Parameter} parameter
 * @param {string} name
 * @param {string} prefix
 * @param {(value: any, moving: boolean) => void} onChange
 * @param {() => void} onSettle
 * @returns {Control}
 */
function tripleControl(parameter, name, prefix, onChange, onSettle) {
  const single = numberRow(parameter, name, prefix, onChange, onSettle);
  const label = brief(parameter.description);
  /** @type {any} */
  let value = parameter.default;
  const error = h("p.row-error", { role: "alert" });
  const boxes = CHANNELS.map((channel) =>
    h("input.box", {
      type: "text",
      autocomplete: "off",
      "aria-label": `${label}, ${channel}`,
      onchange: commit,
    }),
  );
  const split = h(
    "button.mini.rgb",
    { type: "button", "aria-pressed": "false", onclick: toggle },
    "R, G, B",
  );
  split.setAttribute("aria-label", `${label}: a value for each of R, G and B`);
  const three = h(
    "div.triple",
    { role: "group", "aria-label": label },
    h("span.row-name", symbol(parameter.symbol), h("span", label)),
    h("div.triple-boxes", ...boxes),
    error,
  );
  const element = h("div.triple-control", single.element, three, split);

  function commit() {
    try {
      const values = boxes.map((box) => evaluate(box.value));
      const outside = values.some((v) => v < parameter.minimum || v > parameter.maximum);
      if (outside) throw new ExpressionError("it is out of range");
      setText(error, "");
      onChange(Object.freeze(values), false);
    } catch (problem) {
      if (!(problem instanceof ExpressionError)) throw problem;
      setText(
        error,
        `${problem.message}. Allowed: three numbers from ${plain(parameter.minimum)} to ${plain(parameter.maximum)}`,
      );
    }
  }

  function toggle() {
    if (Array.isArray(value)) onChange(parameter.default, false);
    else onChange(Object.freeze(CHANNELS.map(() => value ?? parameter.maximum / 2)), false);
  }

  return {
    element,
    stop: () => single.stop(),
    update(next, solved) {
      value = next;
      const several = Array.isArray(next);
      element.toggleAttribute("data-split", several);
      split.setAttribute("aria-pressed", String(several));
      if (!several) {
        single.update(next, solved);
        return;
      }
      boxes.forEach((box, i) => {
        if (document.activeElement !== box) box.value = plain(next[i]);
      });
    },
  };
}

/**
 * @param {Parameter} parameter
 * @param {(value: any, moving: boolean) => void} onChange
 * @returns {Control}
 */
function choiceControl(parameter, onChange) {
  const group = createChoice({
    legend: brief(parameter.description),
    items: (parameter.choices ?? []).map(([value]) => ({ value, label: value })),
    onChange: ([value]) => onChange(value, false),
  });
  return { element: group.element, stop: () => {}, update: (value) => group.update([value]) };
}

/** @param {ParametersOptions} options */
export function createParameters({ models, state, actions, prefix = "" }) {
  const element = h("div.own-rows");
  /** @type {Map<string, {box: HTMLElement, controls: Map<string, Control>}>} */
  const made = new Map();

  /** @param {Model} model */
  function controlsOf(model) {
    const found = made.get(model.id);
    if (found) return found;
    const controls = new Map(
      model.parameters.map((p) => {
        const name = stateName(model, p);
        /** @param {any} value @param {boolean} moving */
        const change = (value, moving) =>
          actions.set({ [name]: value }, { history: moving ? "replace" : "push" });
        const control = p.choices?.length
          ? choiceControl(p, change)
          : p.triple
            ? tripleControl(p, name, prefix, change, actions.settle)
            : numberRow(p, name, prefix, change, actions.settle);
        return [name, control];
      }),
    );
    const box = h(
      "details.own",
      h(
        "summary.own-name",
        sample(modelStyle(models, model.id)),
        `${shortTitle(model.title)}: parameters`,
      ),
      ...[...controls.values()].map((c) => c.element),
    );
    // What a link or an example has set is to be seen.
    box.open = model.parameters.some((p) => {
      const value = state()[stateName(model, p)] ?? null;
      return value !== defaultOf(p);
    });
    const entry = { box, controls };
    made.set(model.id, entry);
    return entry;
  }

  return {
    element,
    /**
     * @param {State} now
     * @param {readonly string[]} ids of the models shown
     * @param {ReadonlyMap<string, number>} [solved] what parameters left to the server came out as
     */
    update(now, ids, solved = new Map()) {
      const wanted = models.filter((m) => ids.includes(m.id) && m.parameters.length > 0);
      const entries = wanted.map(controlsOf);
      const boxes = entries.map((e) => e.box);
      if (
        boxes.length !== element.children.length ||
        boxes.some((b, i) => element.children[i] !== b)
      )
        element.replaceChildren(...boxes);
      for (const { controls } of entries)
        for (const [name, control] of controls) control.update(now[name], solved.get(name));
    },
    stop() {
      for (const { controls } of made.values()) for (const c of controls.values()) c.stop();
    },
  };
}
