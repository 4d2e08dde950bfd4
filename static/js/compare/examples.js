/** Named examples: one click shows a source's figure, and what of its claim is measured. */

import { h, setText } from "../dom.js";
import { EXAMPLES, shows, stateOf } from "../examples.js";
import { angle, percent, plain } from "../format.js";
import { candidatesOf, rowsOf, sweepOf } from "./answers.js";
import { short } from "./metrics.js";

/**
 * @typedef {import('../types.js').State} State
 * @typedef {import('../examples.js').Figure} Figure
 * @typedef {import('../examples.js').Example} Example
 */

/** @param {string} metric @param {number} value */
function print(metric, value) {
  if (metric.endsWith("_deg")) return angle(value, "deg", 1);
  if (metric === "F0" || metric === "max_relative") return percent(value);
  return short(value);
}

/**
 * A measured figure, null as long as the answer that holds it is under way.
 * @param {Figure} figure
 * @param {Record<string, any>} answers
 * @returns {string | null}
 */
export function measured({ of, model, metric = "", n, within }, answers) {
  const at = n === undefined ? "" : `@${n}`;
  if (of === "errors" && metric === "F0") {
    const F0 = answers[`curves${at}`]?.interface.F0;
    return F0 === undefined ? null : print(metric, F0);
  }
  if (of === "errors") {
    const row = rowsOf(answers[`errors${at}`]).find((r) => r.model === model);
    const value = row?.[/** @type {'max_abs'} */ (metric)];
    return value === undefined || value === null ? null : print(metric, value);
  }
  if (of === "sweep" && within) {
    const answer = answers[`sweep:${model}`];
    if (!answer) return null;
    const { x, metrics } = sweepOf(answer);
    const [low, high] = within;
    const step = Math.abs((x[1] ?? 1) - (x[0] ?? 0));
    const values = (metrics[metric] ?? []).filter(
      (v, i) => v !== null && (x[i] ?? 0) > low - step / 2 && (x[i] ?? 0) < high + step / 2,
    );
    return values.length === 0
      ? null
      : print(metric, Math.max(.../** @type {number[]} */ (values)));
  }
  if (of === "solved") {
    const { good, bad } = candidatesOf(answers.recommend);
    const value = [...good, ...bad].find((c) => c.model === model)?.parameters[metric];
    return value === undefined || value === null ? null : plain(value, 5);
  }
  if (of === "split") {
    /** @param {string} quantity @returns {(number | null)[]} */
    const values = (quantity) =>
      answers.curves?.curves.find(
        (/** @type {import('../types.js').Curve} */ c) =>
          c.model === "exact" && c.quantity === quantity,
      )?.values ?? [];
    const R = values("R");
    const apart = values("Rs").map((s, i) => Math.abs((s ?? 0) - (R[i] ?? 0)));
    return apart.length === 0 ? null : short(Math.max(...apart));
  }
  return null;
}

/**
 * @param {object} options
 * @param {State} options.presets
 * @param {{set: (patch: State) => void}} options.actions
 */
export function createExamples({ presets, actions }) {
  const buttons = EXAMPLES.map((example) => {
    const button = h(
      "button",
      {
        type: "button",
        class: "example",
        "aria-pressed": "false",
        onclick: () => actions.set(stateOf(example, presets)),
      },
      h("b", { class: "example-title" }, example.title),
      h("span", { class: "example-source" }, example.source),
    );
    return { example, button };
  });
  const source = h("b", {});
  const claim = h("span", {});
  const found = h("p", { class: "found" });
  const away = h("p", { class: "away" });
  const caption = h(
    "div",
    { class: "caption", hidden: true, role: "group", "aria-label": "Claim and measurement" },
    h("p", {}, source, " ", claim),
    found,
    away,
  );
  const list = h(
    "div",
    { class: "example-list", role: "group", "aria-label": "Named examples" },
    ...buttons.map((b) => b.button),
  );
  const element = h(
    "section",
    { class: "examples", "aria-label": "Named examples" },
    h("h2", {}, "Figures of the sources"),
    list,
    caption,
  );
  /** @type {string | null} */
  let revealed = null;

  return {
    element,
    /** @param {State} state @param {Record<string, any>} answers those of this state @param {boolean} moving */
    update(state, answers, moving) {
      for (const { example, button } of buttons) {
        const on = example.id === state.example;
        button.setAttribute("aria-pressed", String(on));
        if (on && revealed !== example.id && list.scrollWidth > list.clientWidth)
          list.scrollTo({ left: button.offsetLeft - list.offsetLeft - 24 });
      }
      revealed = state.example;
      const example = EXAMPLES.find((e) => e.id === state.example);
      caption.hidden = !example;
      if (!example) return;
      const here = shows(stateOf(example, presets), state);
      setText(source, `${example.source}:`);
      setText(claim, example.claim);
      found.hidden = !here;
      away.hidden = here;
      if (!here) {
        if (away.childElementCount === 0)
          away.append(
            "The page has moved away from this figure. ",
            h(
              "button",
              {
                type: "button",
                class: "quiet",
                onclick: () => {
                  const back = EXAMPLES.find((e) => e.id === caption.dataset.example);
                  if (back) actions.set(stateOf(back, presets));
                },
              },
              "Back to it",
            ),
          );
        caption.dataset.example = example.id;
        return;
      }
      if (moving && caption.dataset.example === example.id) return;
      caption.dataset.example = example.id;
      const pieces = example.measured.map((piece) =>
        typeof piece === "string"
          ? piece
          : h("b", { class: "figure-value" }, measured(piece, answers) ?? "…"),
      );
      found.replaceChildren(h("span", { class: "tag" }, "measured"), " ", ...pieces);
    },
  };
}
