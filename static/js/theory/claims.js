/** Claims of the literature and of popular code beside what is measured, each with its request. */

import { EXAMPLES } from "../models/examples.js";
import { percent, signed, significant } from "../numbers/format.js";
import { h, setText } from "../page/dom.js";
import { pageLink } from "../page/links.js";
import { words } from "../page/prose.js";

/**
 * @typedef {{name: string, says: string, value: number, unit: string, request: string, reading: string}} Figure
 * @typedef {{says: string, figure: string, holds: boolean}} Part
 * @typedef {{author: string, year: number, title: string, url: string, where: string}} Source
 * @typedef {{id: string, title: string, claimed: string, source: Source, domain: string, verdict: string,
 *   found: string, figures: Figure[], parts: Part[], example: string | null}} Claim
 */

/** What colour a verdict has. @type {Record<string, string>} */
const MOODS = {
  holds: "good",
  "holds in part": "part",
  "does not hold": "bad",
};

/** @param {Source} source */
export const sourceName = ({ author, year }) => `${author} ${year}`;

/** @param {Figure} figure */
function amount({ value, unit }) {
  if (unit === "deg") return `${signed(value.toFixed(2))}°`;
  return `${significant(value, 4)}${unit ? ` ${unit}` : ""}`;
}

/**
 * The claims that a reader wants to see.
 * @param {Claim[]} claims
 * @param {{verdict: string | null, by: string | null}} wanted
 */
export function chosen(claims, { verdict, by }) {
  return claims.filter(
    (c) =>
      (verdict === null || c.verdict === verdict) && (by === null || sourceName(c.source) === by),
  );
}

/** @param {Claim} claim */
function card(claim) {
  const { source } = claim;
  const example = EXAMPLES.find((e) => e.id === claim.example);
  const state = example
    ? Object.fromEntries(Object.entries(example.state).map(([key, value]) => [key, String(value)]))
    : null;
  return h(
    "article",
    { class: "claim", id: `claim-${claim.id}`, tabindex: "-1" },
    h(
      "p",
      { class: "claim-head" },
      h(
        "span",
        { class: "claim-verdict", "data-mood": MOODS[claim.verdict] ?? "none" },
        claim.verdict,
      ),
      h(
        "a",
        { href: source.url, rel: "noreferrer", target: "_blank", title: source.title },
        sourceName(source),
      ),
      h("span", {}, source.where),
    ),
    h("h3", {}, ...words(claim.title)),
    h("p", { class: "claimed" }, ...words(claim.claimed)),
    h("p", { class: "found" }, h("b", {}, "Measured: "), ...words(claim.found)),
    h("p", { class: "hint" }, ...words(claim.domain)),
    claim.parts.length
      ? h(
          "ul",
          { class: "parts" },
          ...claim.parts.map((part) =>
            h(
              "li",
              { "data-holds": String(part.holds) },
              h("b", {}, part.holds ? "yes" : "no"),
              " ",
              ...words(part.says),
            ),
          ),
        )
      : null,
    h(
      "details",
      { class: "definitions" },
      h(
        "summary",
        {},
        claim.figures.length === 1
          ? "The figure and the request that gives it"
          : `${claim.figures.length} figures and the requests that give them`,
      ),
      h(
        "table",
        { class: "measured figures" },
        h(
          "thead",
          {},
          h("tr", {}, ...["value", "what", "request"].map((t) => h("th", { scope: "col" }, t))),
        ),
        h(
          "tbody",
          {},
          ...claim.figures.map((figure) =>
            h(
              "tr",
              {},
              h("td", {}, amount(figure)),
              h("td", {}, ...words(figure.says)),
              h(
                "td",
                {},
                h(
                  "a",
                  { href: figure.request.replace(/^\//, ""), title: `read ${figure.reading}` },
                  h("code", {}, figure.request),
                ),
              ),
            ),
          ),
        ),
      ),
    ),
    state
      ? h(
          "p",
          { class: "lesson-more" },
          pageLink("See it in Compare", "compare", { ...state, example: claim.example }),
        )
      : null,
  );
}

/**
 * @param {object} options
 * @param {Pick<Actions, 'set'>} options.actions
 */
export function createClaimsPage({ actions }) {
  const verdicts = h("div", { class: "filters", role: "group", "aria-label": "Verdict" });
  const sources = h("select", { class: "by-source", "aria-label": "Source" });
  sources.addEventListener("change", () => actions.set({ by: sources.value || null, claim: null }));
  const bySource = h("label", { hidden: true }, "Source ", sources);
  const count = h("p", { class: "hint", role: "status" });
  const cards = h("div", { class: "claim-cards" });
  const element = h(
    "div",
    { class: "claims-page" },
    h("h2", {}, "Claims, measured"),
    h(
      "p",
      { class: "intro" },
      "What papers, notes and code say of these formulas, and what this server measures. Every figure is the answer to the request beside it: follow it, or run it elsewhere.",
    ),
    h("div", { class: "claim-tools" }, verdicts, bySource, count),
    cards,
  );

  /** @type {Claim[]} */
  let claims = [];
  /** @type {Map<string, HTMLElement>} */
  let made = new Map();
  /** @type {{verdict: string | null, button: HTMLElement}[]} */
  let buttons = [];
  let shown = "";

  /** @param {Claim[]} all */
  function fill(all) {
    claims = all;
    made = new Map(all.map((claim) => [claim.id, card(claim)]));
    cards.replaceChildren(...made.values());
    const counts = new Map();
    for (const { verdict } of all) counts.set(verdict, (counts.get(verdict) ?? 0) + 1);
    const order = [...Object.keys(MOODS), ...counts.keys()].filter((v) => counts.has(v));
    const offered = [...new Set(order)].map((verdict) => [verdict, counts.get(verdict)]);
    buttons = [[null, all.length], ...offered].map(([verdict, many]) => ({
      verdict,
      button: h(
        "button",
        {
          type: "button",
          class: "medium",
          onclick: () => actions.set({ verdict, claim: null }),
        },
        `${verdict ?? "all"} (${many})`,
      ),
    }));
    verdicts.replaceChildren(...buttons.map((b) => b.button));
    bySource.hidden = false;
    const names = [...new Set(all.map((c) => sourceName(c.source)))].sort();
    sources.replaceChildren(
      h("option", { value: "" }, "all"),
      ...names.map((name) => h("option", { value: name }, name)),
    );
  }

  return {
    element,
    /** @param {State} now @param {Record<string, any>} answers */
    update(now, answers) {
      if (answers.claims && claims.length === 0) fill(answers.claims.claims);
      const wanted = { verdict: now.verdict, by: now.by };
      const visible = new Set(chosen(claims, /** @type {any} */ (wanted)).map((c) => c.id));
      for (const [id, element] of made) element.hidden = !visible.has(id);
      for (const { verdict, button } of buttons)
        button.setAttribute("aria-pressed", String(verdict === now.verdict));
      sources.value = now.by ?? "";
      const share = claims.length ? percent(visible.size / claims.length) : "";
      setText(
        count,
        claims.length === 0
          ? "Measuring …"
          : visible.size === claims.length
            ? `${claims.length} claims`
            : `${visible.size} of ${claims.length} claims, ${share}`,
      );
      if (now.claim && now.claim !== shown) {
        const target = made.get(now.claim);
        target?.scrollIntoView({ block: "start" });
        target?.focus({ preventScroll: true });
        if (target) shown = now.claim;
      }
    },
    sentence: () => count.textContent ?? "",
  };
}
