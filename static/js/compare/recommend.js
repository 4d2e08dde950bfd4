/** Which model will do: those that stay within an error budget, the cheapest first. */

import { candidatesOf } from "../errors/answers.js";
import { printCost, sayCost, short } from "../errors/metrics.js";
import { modelStyle, sample } from "../models/look.js";
import { evaluate } from "../numbers/entry.js";
import { percent, plain } from "../numbers/format.js";
import { h, setText } from "../page/dom.js";
import { METRICS } from "./figure.js";

const BUDGETS = [0.05, 0.02, 0.005, 0.001];
const WITHIN = ["max_abs", "rms", "cosine_weighted_mean", "max_relative"];
const FEW = 6;
/** Below this an error is the rounding of doubles. */
const ROUNDING = 1e-12;

/**
 * @param {object} options
 * @param {Model[]} options.models
 * @param {() => State} options.state
 * @param {Pick<Actions, 'set'>} options.actions
 */
export function createRecommend({ models, state, actions }) {
  const box = h("input", {
    class: "box bound",
    type: "text",
    autocomplete: "off",
    spellcheck: "false",
    "aria-label": "Error budget",
    "aria-describedby": "budget-error",
  });
  const wrong = h("p", { class: "row-error", id: "budget-error", role: "alert" });
  box.addEventListener("change", () => {
    try {
      const value = evaluate(box.value);
      if (value < 1e-9 || value > 1) throw new Error("allowed is more than 0, up to 1");
      setText(wrong, "");
      actions.set({ budget: value });
    } catch (problem) {
      setText(wrong, `“${box.value}”: ${problem instanceof Error ? problem.message : problem}`);
    }
  });
  const quick = BUDGETS.map((value) =>
    h(
      "button",
      {
        type: "button",
        class: "mini",
        "data-budget": value,
        onclick: () => actions.set({ budget: value }),
      },
      plain(value),
    ),
  );
  const within = h(
    "select",
    {
      class: "preset",
      "aria-label": "Measure of the error",
      onchange: () => actions.set({ within: within.value }),
    },
    ...WITHIN.map((value) => h("option", { value }, METRICS[value] ?? value)),
  );
  const answer = h("ol", { class: "picks" });
  const others = h("ol", { class: "picks" });
  const moreSummary = h("summary", {});
  const more = h("details", { class: "definitions", hidden: true }, moreSummary, others);
  const refused = h("ul", { class: "refused" });
  const summary = h("summary", {});
  // Beside the answer where there is room for it, folded below it elsewhere.
  const wide = matchMedia("(min-width: 1180px)").matches;
  const rest = h("details", { class: "definitions", hidden: true, open: wide }, summary, refused);
  const note = h("p", { class: "reason" });
  const element = h(
    "section",
    { class: "column recommend", "aria-label": "Which will do?" },
    h("div", { class: "heading" }, h("h2", {}, "Which will do?")),
    h(
      "div",
      { class: "budget" },
      h("span", { class: "picker" }, within),
      h("span", {}, "≤"),
      box,
      h("span", { class: "quick" }, ...quick),
    ),
    wrong,
    note,
    h("div", { class: "verdict" }, h("div", {}, answer, more), rest),
  );

  /** @param {number | null} value @param {string} metric */
  const figureOf = (value, metric) => {
    if (value !== null && Math.abs(value) < ROUNDING) return "rounding";
    if (metric === "max_relative" && value !== null) return percent(value);
    return short(value === null ? null : Math.abs(value));
  };

  /** @param {string} id */
  const toggle = (id) => {
    const { against } = state();
    actions.set({
      against: Object.freeze(
        against.includes(id)
          ? against.filter((/** @type {string} */ other) => other !== id)
          : [...against, id],
      ),
    });
  };

  /** @param {import('../errors/answers.js').Candidate} entry @param {State} now */
  function pick({ model: id, figures }, now) {
    const model = models.find((m) => m.id === id);
    const cost = /** @type {Record<string, number>} */ (model?.cost ?? {});
    const name = [
      sample(modelStyle(models, id)),
      h("span", { class: "pick-name" }, model?.title ?? id),
    ];
    const value = figures?.[now.within] ?? null;
    return h(
      "li",
      {},
      id === "exact"
        ? h("span", { class: "pick" }, ...name)
        : h(
            "button",
            {
              type: "button",
              class: "pick",
              "aria-pressed": String(now.against.includes(id)),
              onclick: () => toggle(id),
            },
            ...name,
          ),
      h("span", { class: "pick-error" }, figureOf(value, now.within)),
      h("span", { class: "pick-cost", title: sayCost(cost) }, printCost(cost)),
    );
  }

  /** @type {unknown} */
  let last = null;
  let look = "";
  return {
    element,
    /** @param {State} now @param {any} given of /recommend @param {{title: string, lines: string[]} | undefined} problem */
    update(now, given, problem) {
      if (document.activeElement !== box) box.value = plain(now.budget);
      within.value = now.within;
      for (const button of quick)
        button.setAttribute("aria-pressed", String(Number(button.dataset.budget) === now.budget));
      setText(note, problem ? [problem.title, ...problem.lines].join(" · ") : "");
      const shown = JSON.stringify([now.against, now.within]);
      if (!given || (given === last && shown === look)) return;
      last = given;
      look = shown;
      const { good, bad } = candidatesOf(given);
      answer.replaceChildren(...good.slice(0, FEW).map((entry) => pick(entry, now)));
      if (good.length === 0)
        answer.append(h("li", { class: "none" }, "No model stays within that."));
      more.hidden = good.length <= FEW;
      setText(moreSummary, `${good.length - FEW} more, dearer ones`);
      others.replaceChildren(...good.slice(FEW).map((entry) => pick(entry, now)));
      setText(summary, `${bad.length} refused, and why`);
      rest.hidden = bad.length === 0;
      refused.replaceChildren(
        ...bad.map(({ title, reason }) =>
          h("li", {}, h("b", { class: "refused-name" }, title), ` ${reason}`),
        ),
      );
    },
  };
}
