/** Named examples: one click shows a source's figure, what it claims and what is measured. */

import { EXAMPLES, shows, stateOf } from "../models/examples.js";
import { h } from "../page/dom.js";
import { pageLink } from "../page/links.js";
import { words } from "../page/prose.js";

/**
 * @typedef {{id: string, claimed: string, found: string, verdict: string,
 *   source: {author: string, year: number, where: string}}} Claim
 */

/** What was claimed, and what is so. @param {Claim} claim */
function told({ id, claimed, found, verdict, source }) {
  return [
    h(
      "p",
      {},
      h("b", { title: source.where }, `${source.author} ${source.year}:`),
      " ",
      ...words(claimed),
    ),
    h(
      "p",
      { class: "found" },
      h("span", { class: "tag" }, "measured"),
      " ",
      ...words(found),
      " ",
      pageLink(`It ${verdict}: figures and requests`, "theory", { section: "claims", claim: id }),
    ),
  ];
}

/**
 * @param {object} options
 * @param {State} options.presets
 * @param {Pick<Actions, 'set'>} options.actions
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
  const claims = h("div", { class: "example-claims" });
  const away = h("p", { class: "away" });
  const caption = h(
    "div",
    { class: "caption", hidden: true, role: "group", "aria-label": "Claim and measurement" },
    claims,
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
  /** @type {Claim[] | null} */
  let shown = null;

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
      claims.hidden = !here;
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
      caption.dataset.example = example.id;
      const now = answers.claims?.claims ?? null;
      if (moving || (now !== null && now === shown)) return;
      shown = now;
      claims.replaceChildren(...(now?.flatMap(told) ?? ["Measuring …"]));
    },
  };
}
