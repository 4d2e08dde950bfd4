/** The interface at hand: its exact albedos from both sides, and what the fits make of it. */

import { short } from "../errors/metrics.js";
import { sampled } from "../models/sampled.js";
import { plain, six } from "../numbers/format.js";
import { h, symbol } from "../page/dom.js";
import { html, nothing, render } from "../page/lit.js";
import { copied } from "../page/tables.js";
import { sideOf } from "./answers.js";
import { chosenFits, facing, isMetal } from "./fields.js";
import { fitStyle } from "./style.js";

/**
 * @typedef {import('./answers.js').Fit} Fit
 * @typedef {import('./answers.js').Here} Here
 * @typedef {import('./answers.js').Exact} Exact
 * @typedef {import('./answers.js').Approximation} Approximation
 */

const QUANTITIES = /** @type {const} */ (["unpolarized", "s", "p"]);

/** @param {Here["interface"]} media @param {boolean} back @returns {string} which way the light goes, in words */
export function direction({ n_i, n_t, k_t }, back) {
  const [from, into] = back ? [n_t, n_i] : [n_i, n_t];
  const second = k_t > 0 ? `${plain(n_t, 4)} + ${plain(k_t, 4)}i` : plain(into, 4);
  return `from ${plain(from, 4)} into ${second}`;
}

/** @param {Here} here @param {boolean} back @returns {string} */
export function meaning(here, back) {
  const { n_i, n_t, k_t } = here.interface;
  if (k_t > 0) return "";
  const inside = back ? n_t > n_i : n_i > n_t;
  return inside ? "internal diffuse reflectance" : "external diffuse reflectance";
}

/** A condition as people write it. @param {string} reason */
export function written(reason) {
  return reason
    .replaceAll("<=", "≤")
    .replaceAll(">=", "≥")
    .replace(/\beta\b/g, "η")
    .replace(/\bkappa\b/g, "κ");
}

/** @param {(text: string) => void} say */
export function createReading(say) {
  const element = h("div.reading");
  const symbols = ["A", "A_s", "A_p"].map((name) => html`<th scope="col">${symbol(name)}</th>`);

  /** @param {string} name @param {string} way @param {string} what @param {Exact | undefined} exact */
  const line = (name, way, what, exact) => html`<tr>
    <th scope="row"><span class="way">${way}</span><span class="meaning">${what}</span></th>
    ${QUANTITIES.map(
      (q) => html`<td>${copied(`${name} albedo, ${q}`, exact?.[q] ?? null, say)}</td>`,
    )}
  </tr>`;

  /** @param {Approximation} fit */
  const fitLine = ({ id, title, value, error, in_domain, reason }) => html`<tr
    data-fit=${id}
    ?data-outside=${!in_domain}
  >
    <th scope="row"><span class="overlay-name">${sampled(fitStyle(id))}${title}</span>${
      reason && html`<span class="beyond">outside its domain: ${written(reason)}</span>`
    }</th>
    <td>${six(value)}</td>
    <td>${short(error)}</td>
  </tr>`;

  return {
    element,
    /** @param {State} state @param {Here | undefined} here */
    update(state, here) {
      if (!here) return;
      const { interface: media, reverse } = here;
      const forwards = isMetal(state.surface) || facing(state);
      const { approximations } = sideOf(here, forwards);
      const rows = chosenFits(state).flatMap((id) => approximations.find((a) => a.id === id) ?? []);
      const back = reverse
        ? { way: direction(media, true), what: meaning(here, true) }
        : { way: "from inside", what: "an absorber is met from outside alone" };
      render(
        html`<table class="exact-albedos">
            <caption class="hidden">Exact albedos of the interface</caption>
            <thead><tr><td></td>${symbols}</tr></thead>
            <tbody>
              ${line("forward", direction(media, false), meaning(here, false), here.exact)}
              ${line("reverse", back.way, back.what, reverse?.exact)}
              <tr>
                <th scope="row">in flatland<span class="meaning">two dimensions, unpolarized</span></th>
                <td>${copied("flatland albedo", here.flatland, say)}</td>
                <td></td>
                <td></td>
              </tr>
            </tbody>
          </table>
          <p class="reason">exact by ${here.exact.method}</p>
          <p class="reason">${
            rows.length ? `Fits ${direction(media, !forwards && reverse !== null)}:` : nothing
          }</p>
          <table class="fit-values" ?hidden=${rows.length === 0}>
            <caption class="hidden">The fits for this interface</caption>
            <thead><tr>
              <th scope="col">fit</th>
              <th scope="col">albedo</th>
              <th scope="col">error</th>
            </tr></thead>
            <tbody>${rows.map(fitLine)}</tbody>
          </table>`,
        element,
      );
    },
  };
}
