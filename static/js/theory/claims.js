/** Claims of the literature and of popular code beside what is measured, each with its request. */

import { EXAMPLES } from "../models/examples.js";
import { percent, signed, significant } from "../numbers/format.js";
import { h } from "../page/dom.js";
import { aside, pageLink } from "../page/links.js";
import { html, nothing, render } from "../page/lit.js";
import { words } from "../page/prose.js";

/**
 * @typedef {{name: string, says: string, value: number, unit: string, request: string, reading: string}} Figure
 * @typedef {{says: string, figure: string, holds: boolean}} Part
 * @typedef {{author: string, year: number, title: string, url: string, where: string}} Source
 * @typedef {{id: string, title: string, claimed: string, source: Source, domain: string, verdict: string,
 *   found: string, figures: Figure[], parts: Part[], example: string | null}} Claim
 */

/** What color a verdict has. @type {Record<string, string>} */
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

/** @param {Figure} figure */
const figureRow = (figure) => html`<tr>
  <td>${amount(figure)}</td>
  <td>${words(figure.says)}</td>
  <td><a href=${figure.request.replace(/^\//, "")} target=${aside()} title="read ${figure.reading}"><code>${figure.request}</code></a></td>
</tr>`;

/** @param {Part} part */
const partItem = ({ holds, says }) =>
  html`<li data-holds=${holds}><b>${holds ? "yes" : "no"}</b> ${words(says)}</li>`;

/** @param {string} id of an example of the Compare view */
function exampleLink(id) {
  const { state = {} } = EXAMPLES.find((e) => e.id === id) ?? {};
  const texts = Object.entries(state).map(([key, value]) => [key, String(value)]);
  const to = { ...Object.fromEntries(texts), example: id };
  return html`<p class="lesson-more">${pageLink("See it in Compare", "compare", to)}</p>`;
}

/** @param {Claim} claim */
function card({ id, title, claimed, source, domain, verdict, found, figures, parts, example }) {
  const known = example !== null && EXAMPLES.some((e) => e.id === example);
  const summary =
    figures.length === 1
      ? "The figure and the request that gives it"
      : `${figures.length} figures and the requests that give them`;
  const element = h("article.claim", { id: `claim-${id}`, tabindex: "-1" });
  render(
    html`<p class="claim-head">
        <span class="claim-verdict" data-mood=${MOODS[verdict] ?? "none"}>${verdict}</span>
        <a href=${source.url} rel="noreferrer" target="_blank" title=${source.title}>${sourceName(source)}</a>
        <span>${source.where}</span>
      </p>
      <h3>${words(title)}</h3>
      <p class="claimed">${words(claimed)}</p>
      <p class="found"><b>Measured: </b>${words(found)}</p>
      <p class="hint">${words(domain)}</p>
      ${parts.length ? html`<ul class="parts">${parts.map(partItem)}</ul>` : nothing}
      <details class="definitions">
        <summary>${summary}</summary>
        <table class="measured figures">
          <thead><tr><th scope="col">value</th><th scope="col">what</th><th scope="col">request</th></tr></thead>
          <tbody>${figures.map(figureRow)}</tbody>
        </table>
      </details>
      ${known ? exampleLink(example) : nothing}`,
    element,
  );
  return element;
}

/** @param {Pick<ViewContext, 'actions'>} context */
export function createClaimsPage({ actions }) {
  const element = h("div.claims-page");
  /** @type {Claim[]} */
  let claims = [];
  /** @type {Map<string, HTMLElement>} */
  let cards = new Map();
  let shown = "";
  let count = "";

  /** @param {State} now */
  function tools(now) {
    const verdicts = claims.map((c) => c.verdict);
    const order = [...new Set([...Object.keys(MOODS), ...verdicts])];
    const offered = [null, ...order.filter((one) => verdicts.includes(one))];
    const names = [...new Set(claims.map((c) => sourceName(c.source)))].sort();
    const filter = (/** @type {string | null} */ verdict) => {
      const many = verdicts.filter((one) => verdict === null || one === verdict).length;
      return html`<button type="button" class="medium" aria-pressed=${verdict === now.verdict}
        @click=${() => actions.set({ verdict, claim: null })}>${verdict ?? "all"} (${many})</button>`;
    };
    return html`<div class="filters" role="group" aria-label="Verdict">${claims.length ? offered.map(filter) : nothing}</div>
      <label ?hidden=${claims.length === 0}>Source
        <select class="by-source" aria-label="Source"
          @change=${(/** @type {any} */ { target }) => actions.set({ by: target.value || null, claim: null })}>
          <option value="">all</option>
          ${names.map((name) => html`<option value=${name}>${name}</option>`)}
        </select>
      </label>
      <p class="hint" role="status">${count}</p>`;
  }

  return {
    element,
    /** @param {State} now @param {Record<string, any>} answers */
    update(now, answers) {
      if (answers.claims && claims.length === 0) {
        claims = answers.claims.claims;
        cards = new Map(claims.map((claim) => [claim.id, card(claim)]));
      }
      const { verdict, by } = now;
      const visible = new Set(chosen(claims, { verdict, by }).map((c) => c.id));
      for (const [id, element] of cards) element.hidden = !visible.has(id);
      const all = claims.length;
      const some = `${visible.size} of ${all} claims, ${percent(visible.size / all)}`;
      count = all === 0 ? "Measuring …" : visible.size === all ? `${all} claims` : some;
      render(
        html`<h2>Claims, measured</h2>
          <p class="intro">What papers, notes and code say of these formulas, and what this server measures. Every figure is the answer to the request beside it: follow it, or run it elsewhere.</p>
          <div class="claim-tools">${tools(now)}</div>
          <div class="claim-cards">${[...cards.values()]}</div>`,
        element,
      );
      const select = element.querySelector("select");
      if (select) select.value = by ?? "";
      const target = cards.get(now.claim);
      if (target && now.claim !== shown) {
        target.scrollIntoView({ block: "start" });
        target.focus({ preventScroll: true });
        shown = now.claim;
      }
    },
    sentence: () => count,
  };
}
