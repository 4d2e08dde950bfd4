/** Worksheets: tasks whose links open the page as the task wants it. */

import { createChanged } from "../page/changed.js";
import { h } from "../page/dom.js";
import { addressOf, followed } from "../page/links.js";
import { html, nothing, render } from "../page/lit.js";
import { pieces } from "../page/prose.js";
import { freshOf } from "../state/state.js";
import { KEYS } from "./answer-key.js";

/**
 * @typedef {object} Sheet
 * @property {string} id
 * @property {string} title
 * @property {string} level
 * @property {string} about
 * @property {string[]} tasks each ends with a link, `[words](address)`
 */

/** @type {Sheet[]} */
export const SHEETS = [
  {
    id: "pond",
    title: "Reflection at a pond",
    level: "school, 30 minutes",
    about: "The law of refraction and the split of light, read off a picture that is to scale.",
    tasks: [
      "Read $R$ at 0°, 30°, 60°, 75° and 85°, and sketch the curve before you look at it. [water](?n_t=1.333&theta_i_deg=0)",
      "Measure $\\theta_t$ for five angles and check $n=\\sin\\theta_i/\\sin\\theta_t$. [the ray at 45°](?n_t=1.333&theta_i_deg=45)",
      "A fisherman looks at 50° from the normal. What share of the light from the fish reaches his eye, and what share of what he sees is sky? [water at 50°](?n_t=1.333&theta_i_deg=50)",
    ],
  },
  {
    id: "brewster",
    title: "Brewster's angle measured",
    level: "school and first year, 45 minutes",
    about: "Find an index from an angle, as it is done with a laser and a polarizer.",
    tasks: [
      "Set the polarization to p and find where nothing is reflected, for water, crown glass and diamond. [p light on glass](?polarization=p&theta_i_deg=50)",
      "Show from Snell's law that $\\theta_B+\\theta_t=90^\\circ$ means $\\tan\\theta_B=n_t/n_i$; check it by the numbers of the page. [the formula](?view=theory&section=formulas&formula=angle.brewster)",
      "Add some absorption, $k=0.5$. What is left of Brewster's angle? [with k = 0.5](?k_t=0.5&polarization=p&theta_i_deg=57)",
    ],
  },
  {
    id: "caught",
    title: "Caught light",
    level: "school and first year, 45 minutes",
    about: "Total internal reflection, its phases and the wave beyond the surface.",
    tasks: [
      "Stand exactly at the critical angle of glass: the slider holds there. What do both arrows do? [inside glass](?n_i=1.5&n_t=1&theta_i_deg=41.810314895778596)",
      "Do not swap anything: start from $n_i=1$ and raise it beyond $n_t$. At which $n_i$ is a ray at 60° caught? [start here](?n_i=1&n_t=1.2&theta_i_deg=60)",
      "Plot the phases. By how much do they differ at most between s and p? Where would you build Fresnel's rhomb, which needs 45° twice? [with phases](?n_i=1.51&n_t=1&theta_i_deg=54&show=phase)",
      "At which depth have the power and the field of the evanescent wave fallen to 1/e, at 45° and at 42°, in wavelengths? [both depths](?n_i=1.5&n_t=1&theta_i_deg=45)",
    ],
  },
  {
    id: "renderer",
    title: "What may a renderer leave out?",
    level: "computer graphics, 60 minutes",
    about: "Approximations judged by numbers, not by looks.",
    tasks: [
      "For which $n$ from 1 to 3 is Schlick's largest error below 0.04? [error over n](?view=compare&models=schlick&over=n)",
      "Find the cheapest model that stays within 0.01 for iron. [iron, n = 2.9, k = 3](?view=compare&n_t=2.9&k_t=3&budget=0.01)",
      "Where on the n, k plane does Pharr and Humphreys' form stay within 0.01? [the map](?view=compare&n_t=1.5&k_t=3&models=pharr_humphreys&over=n-k&focus=pharr_humphreys)",
      "Name the trap in each of the five cards before you read its cure. [traps](?view=theory&section=traps)",
    ],
  },
  {
    id: "metals",
    title: "The color of metals",
    level: "computer graphics and optics, 45 minutes",
    about: "From measured spectra to three numbers and what they lose.",
    tasks: [
      "Over which wavelengths does gold's reflectance rise? Which color does it take away? [gold](?view=materials&preset=Au)",
      "Compare copper's spectrum with Schlick and F82-tint. Which of R, G and B is worst, and at which angle? [copper](?view=materials&preset=Cu)",
      "Rank silver, aluminium and iron by their F0 and explain which makes the best mirror in the blue. [silver](?view=materials&preset=Ag)",
    ],
  },
  {
    id: "paint",
    title: "Paint under a coat",
    level: "computer graphics, 45 minutes",
    about: "Energy between a surface and what is below it.",
    tasks: [
      "A white wall of albedo 0.8 is varnished, $n=1.5$. What is its albedo now? [body 0.8](?view=albedo&coat_n=1.5&coat_body=0.8)",
      "Why does a shirt get darker when it is wet? Change the index around the coat in your mind, then on the page. [albedos from inside](?view=albedo&surface=inside)",
      "Which fit of the internal albedo would you put into a shader, and why? [claimed and measured](?view=albedo&surface=inside&claims_by=measured)",
    ],
  },
  {
    id: "guess",
    title: "Guess the material",
    level: "for a lesson's last ten minutes",
    about: "Three curves, from easy to hard. Make your own and send the link.",
    tasks: [
      "A gem. [first](?view=theory&section=mystery&mystery=z1amiz)",
      "Clear, but which? [second](?view=theory&section=mystery&mystery=qy2f0x)",
      "A metal. [third](?view=theory&section=mystery&mystery=g21piv)",
    ],
  },
];

/** The place of a sheet, or of all of them. @param {string | null} id @param {boolean} [key] whether its answers are shown */
const place = (id, key = false) =>
  addressOf("theory", { section: "worksheets", sheet: id, answers: key ? "open" : null });

/** A link, which on paper is followed by its address. @param {string} words @param {string} address */
function printed(words, address) {
  const link = followed(words, address);
  link.dataset.address = new URL(address, document.baseURI).href;
  return link;
}

/** @param {string} text */
function task(text) {
  const [, words = "", link = "", address = ""] = /^(.*) \[(.*)\]\((.*)\)$/.exec(text) ?? [];
  return html`<li>${pieces(words)} ${printed(`${link} ↗`, address)}</li>`;
}

/** @param {Sheet} sheet @param {boolean} alone */
const article = (
  { id, title, level, about, tasks },
  alone,
) => html`<article class="worksheet" id="sheet-${id}">
  <h3>${alone ? title : followed(title, place(id))}</h3>
  <p class="hint">${level}. ${about}</p>
  <ol>${tasks.map(task)}</ol>
</article>`;

/** @param {import('./answer-key.js').Key} key @param {Record<string, any>} asked */
function answers({ asks, answers: all }, asked) {
  const waiting = Object.keys(asks).some((name) => !asked[name]);
  return html`<section class="answer-key" aria-label="Answer key">
    <h4>Answer key</h4>
    ${
      waiting
        ? html`<p class="hint">The numbers are being worked out …</p>`
        : html`<ol>${all.map((answer) => html`<li>${pieces(answer(asked))}</li>`)}</ol>`
    }
  </section>`;
}

export function createWorksheets() {
  const element = h("div.worksheets");
  const changed = createChanged();
  return {
    element,
    /** @param {State} now @param {Record<string, any>} given */
    update(now, given) {
      const sheet = SHEETS.find(({ id }) => id === now.sheet);
      const open = now.answers === "open";
      const key = sheet && KEYS[sheet.id];
      const asked = freshOf(given, key && open ? key.asks : {});
      if (!changed(sheet, open, ...Object.values(asked))) return;
      render(
        sheet && key
          ? html`<h2>Worksheet</h2>
            <p class="intro sheet-links">${followed("All worksheets", place(null))}
              ${followed(open ? "Without the answer key" : "With the answer key", place(sheet.id, !open))}</p>
            ${article(sheet, true)} ${open ? answers(key, asked) : nothing}`
          : html`<h2>Worksheets</h2>
            <p class="intro">Each link opens the page as the task wants it; every value on it can be read, copied and saved. A sheet's title is its own link, to be sent or printed, with its answer key for teachers.</p>
            ${SHEETS.map((one) => article(one, false))}`,
        element,
      );
    },
  };
}
