/** Which model will do: those that stay within an error budget, the cheapest first. */

import { createSelect } from "../controls/select.js";
import { createTyped } from "../controls/typed.js";
import { METRICS, printCost, sayCost, short } from "../errors/metrics.js";
import { atWavelength } from "../media/media.js";
import { modelStyle } from "../models/look.js";
import { sampled } from "../models/sampled.js";
import { evaluate } from "../numbers/expression.js";
import { percent, plain } from "../numbers/format.js";
import { h } from "../page/dom.js";
import { html, nothing, render } from "../page/lit.js";
import { against, BUDGET } from "./fields.js";

/**
 * @typedef {{model: string, title: string, cost: Record<string, number>, figures: Record<string, number | null> | null,
 *   reason: string | null}} Candidate
 * @typedef {{models: Candidate[], refused: Candidate[]}} Answer of /recommend
 */

const BUDGETS = [0.05, 0.02, 0.005, 0.001];
const FEW = 6;
/** Below this an error is the rounding of doubles. */
const ROUNDING = 1e-12;

/** @param {number | null} value @param {string} metric */
function written(value, metric) {
  if (value === null) return short(null);
  if (Math.abs(value) < ROUNDING) return "rounding";
  return metric === "max_relative" ? percent(value) : short(Math.abs(value));
}

/** @param {ViewContext} context */
export function createRecommend({ catalog, state, actions }) {
  const { models } = catalog;
  const budget = createTyped({
    attributes: { class: "box bound", "aria-label": "Error budget" },
    id: "budget-error",
    parse(text) {
      const value = evaluate(text);
      if (value < BUDGET.minimum || value > BUDGET.maximum)
        throw new Error("allowed is more than 0, up to 1");
      return value;
    },
    onChange: (value) => actions.set({ budget: value }),
  });
  const within = createSelect(
    "Measure of the error",
    (name) => actions.set({ within: name }),
    METRICS,
  );
  // Beside the answer where there is room for it, folded below it elsewhere.
  const wide = matchMedia("(min-width: 1180px)").matches;
  const element = h("section.column.recommend", { "aria-label": "Which will do?" });

  /** @param {string} id */
  function toggle(id) {
    const now = against(state());
    const others = now.filter((other) => other !== id);
    actions.set({ models: Object.freeze(now.includes(id) ? others : [...now, id]) });
  }

  /** @param {Candidate} candidate @param {State} now */
  function pick({ model: id, title, cost, figures }, now) {
    const name = html`${sampled(modelStyle(models, id))}<span class="pick-name">${title}</span>`;
    return html`<li>
      ${
        id === "exact"
          ? html`<span class="pick">${name}</span>`
          : html`<button
              type="button"
              class="pick"
              aria-pressed=${against(now).includes(id)}
              @click=${() => toggle(id)}
            >${name}</button>`
      }
      <span class="pick-error">${written(figures?.[now.within] ?? null, now.within)}</span>
      <span class="pick-cost" title=${sayCost(cost)}>${printCost(cost)}</span>
    </li>`;
  }

  /** @param {Answer} answer @param {State} now */
  const verdict = ({ models: good, refused }, now) => html`<div class="verdict">
    <div>
      <ol class="picks">${
        good.length === 0
          ? html`<li class="none">No model stays within that.</li>`
          : good.slice(0, FEW).map((one) => pick(one, now))
      }</ol>
      <details class="definitions" ?hidden=${good.length <= FEW}>
        <summary>${good.length - FEW} costlier ${good.length - FEW === 1 ? "model" : "models"}</summary>
        <ol class="picks">${good.slice(FEW).map((one) => pick(one, now))}</ol>
      </details>
    </div>
    <details class="definitions" ?hidden=${refused.length === 0} ?open=${wide}>
      <summary>Ruled out: ${refused.length} ${refused.length === 1 ? "model" : "models"}</summary>
      <ul class="refused">${refused.map(
        ({ title, reason }) => html`<li><b class="refused-name">${title}</b> ${reason}</li>`,
      )}</ul>
    </details>
  </div>`;

  /** @type {Answer | undefined} */
  let last;
  return {
    element,
    /** @param {State} now @param {Answer | undefined} answer @param {import('../page/trouble.js').Problem | undefined} problem */
    update(now, answer, problem) {
      last = answer ?? last;
      budget.update(plain(now.budget));
      within.update(now.within);
      render(
        html`<div class="heading"><h2>Which will do?</h2><span class="at-nm">${atWavelength(catalog.materials, now)}</span></div>
          <div class="budget">
            ${within.element}<span>≤</span>${budget.box}
            <span class="quick">${BUDGETS.map(
              (value) => html`<button
                type="button"
                class="mini"
                aria-pressed=${value === now.budget}
                @click=${() => actions.set({ budget: value })}
              >${plain(value)}</button>`,
            )}</span>
          </div>
          ${budget.wrong}
          <p class="reason">${problem ? [problem.title, ...problem.lines].join(" · ") : nothing}</p>
          ${last && verdict(last, now)}`,
        element,
      );
    },
  };
}
