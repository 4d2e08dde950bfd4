/** Named examples: one click shows a source's figure, what it claims and what is measured. */

import { createExamples } from "../controls/examples.js";
import { EXAMPLES, shows, stateOf } from "../models/examples.js";
import { createChanged } from "../page/changed.js";
import { h } from "../page/dom.js";
import { pageLink } from "../page/links.js";
import { html, nothing, render } from "../page/lit.js";
import { words } from "../page/prose.js";

/**
 * @typedef {{id: string, claimed: string, found: string, verdict: string,
 *   source: {author: string, year: number, where: string}}} Claim
 */

/** A verdict as a sentence. @param {string} verdict */
const said = (verdict) => (verdict.startsWith("nothing") ? `There is ${verdict}` : `It ${verdict}`);

/** What was claimed, and what is so. @param {Claim} claim */
const told = ({ id, claimed, found, verdict, source }) => html`<p>
    <b title=${source.where}>${source.author} ${source.year}:</b> ${words(claimed)}
  </p>
  <p class="found">
    <span class="tag">measured</span> ${words(found)}
    ${pageLink(`${said(verdict)}: figures and requests`, "theory", { section: "claims", claim: id })}
  </p>`;

/** @param {ViewContext} context */
export function createNamedExamples({ presets, actions }) {
  const element = h("section.examples", { "aria-label": "Named examples" });
  const row = createExamples({
    examples: EXAMPLES,
    name: "example-list",
    label: "Named examples",
    onShow: (example) => actions.set(stateOf(example, presets)),
    isShown: ({ id }, state) => id === state.example,
  });
  const list = row.element;
  /** @type {ReturnType<typeof told>[] | string} what the claims of the example say */
  let claims = "Measuring …";
  const changed = createChanged();
  const revealed = createChanged();

  /** Beside the caption, which is what a reader who turns a knob compares with. @param {State} state */
  function away(state) {
    const example = EXAMPLES.find((e) => e.id === state.example);
    const wanted = example && stateOf(example, presets);
    if (!wanted || shows(wanted, state)) return nothing;
    return html`<p class="away">
      The page has moved away from this figure.
      <button type="button" class="quiet" @click=${() => actions.set(wanted)}>Back to it</button>
    </p>`;
  }

  /** @param {State} state */
  function caption(state) {
    if (!EXAMPLES.some((e) => e.id === state.example)) return nothing;
    return html`<div class="caption example-claims" role="group" aria-label="Claim and measurement">
      ${claims}
    </div>`;
  }

  return {
    element,
    /** @param {State} state @param {Record<string, any>} answers those of this state @param {boolean} moving */
    update(state, answers, moving) {
      /** @type {Claim[] | null} */
      const now = answers.claims?.claims ?? null;
      if (!moving && changed(now)) claims = now?.map(told) ?? "Measuring …";
      row.update(state);
      render(
        html`<div class="heading"><h2>Figures of the sources</h2>${away(state)}</div>
          ${list}${caption(state)}`,
        element,
      );
      /** @type {HTMLElement | null} */
      const on = list.querySelector('[aria-pressed="true"]');
      // On a phone the line of examples is longer than the screen.
      if (revealed(state.example) && on && list.scrollWidth > list.clientWidth)
        list.scrollTo({ left: on.offsetLeft - list.offsetLeft - 24 });
    },
  };
}
