/** Theory: a first path, every formula, claims measured, traps, a material to guess, worksheets. */

import { h } from "../page/dom.js";
import { addressOf, clicked } from "../page/links.js";
import { html, nothing, render } from "../page/lit.js";
import { loadKatex } from "../page/prose.js";
import { loadStyles } from "../page/style.js";
import { SECTIONS, theoryFields, UNTOUCHED } from "../theory/fields.js";
import { createLessons } from "../theory/lessons.js";
import { STEPS } from "../theory/steps.js";
import { TRAPS } from "../theory/trap-cards.js";

export { queries, restCalls } from "../theory/queries.js";
export const fields = theoryFields;

/**
 * @typedef {object} Section
 * @property {HTMLElement} element
 * @property {(now: State, answers: Record<string, any>, moving: boolean) => void} [update]
 * @property {(now: State) => string} [sentence]
 * @property {() => void} [theme]
 * @property {() => void} [stop]
 * @property {() => void} [destroy]
 */

await Promise.all([
  loadStyles("parameters", "heatmap", "albedo", "albedo-coat", "films", "materials", "theory"),
  loadKatex().catch(() => {}), // formulas then stand as LaTeX
]);

/** What makes a section, loaded when it is opened. @type {Record<string, (context: ViewContext) => Promise<Section>>} */
const MAKERS = {
  path: async (context) =>
    createLessons({
      context,
      lessons: STEPS,
      key: "step",
      title: "First path",
      intro:
        "Twelve steps from a pond to gold leaf, each with a picture to touch. No mathematics is needed to begin.",
    }),
  traps: async (context) =>
    createLessons({
      context,
      lessons: TRAPS,
      key: "trap",
      title: "Traps",
      intro: "Mistakes that look right. Find out where each fails before you read the cure.",
    }),
  formulas: async (context) => (await import("../theory/formulas.js")).createFormulas(context),
  claims: async (context) => (await import("../theory/claims.js")).createClaimsPage(context),
  mystery: async (context) => (await import("../theory/mystery.js")).createMystery(context),
  worksheets: async () => (await import("../theory/worksheets.js")).createWorksheets(),
};

/** @param {ViewContext} context */
export function createView(context) {
  const { element, state, actions } = context;
  const place = h("div.theory-section");
  /** @type {Map<string, Section>} */
  const made = new Map();
  /** @type {Set<string>} */
  const making = new Set();
  /** @type {Record<string, any>} */
  let latest = {};
  let complaint = "";
  /** Whether what had the focus, a link into another section, is hidden now. */
  let homeless = false;
  draw();

  function draw() {
    const { section } = state();
    /** @param {string} id */
    const go = (id) => {
      actions.set({ ...UNTOUCHED, section: id });
      window.scrollTo(0, 0);
    };
    const tab = (/** @type {{id: string, title: string}} */ { id, title }) =>
      html`<a href=${addressOf("theory", { section: id === "path" ? null : id })}
        aria-current=${id === section ? "true" : nothing} @click=${clicked(() => go(id))}>${title}</a>`;
    render(
      html`<nav class="theory-tabs" aria-label="Sections of Theory">${SECTIONS.map(tab)}</nav>
        <p class="trouble" role="alert" ?hidden=${complaint === ""}>${complaint}</p>
        ${place}`,
      element,
    );
  }

  /** @param {string} id */
  async function make(id) {
    if (making.has(id)) return;
    making.add(id);
    try {
      const section = await /** @type {(context: ViewContext) => Promise<Section>} */ (MAKERS[id])(
        context,
      );
      made.set(id, section);
      section.element.tabIndex = -1;
      place.append(section.element);
      section.theme?.(); // colors and faces are those of the place in the document
      actions.set({}, { history: "none" });
    } catch {
      making.delete(id); // the network: the next change tries again
    }
  }

  return {
    /** @param {State} now @param {Record<string, any>} answers @param {boolean} moving */
    update(now, answers, moving) {
      if (answers !== latest) complaint = "";
      latest = answers;
      draw();
      for (const [id, { element }] of made) {
        const gone = id !== now.section;
        homeless ||= gone && element.contains(document.activeElement);
        element.hidden = gone;
      }
      const section = made.get(now.section);
      if (!section) {
        void make(now.section);
        return;
      }
      section.update?.(now, answers, moving);
      if (homeless && !section.element.contains(document.activeElement))
        section.element.focus({ preventScroll: true });
      homeless = false;
    },
    /** @param {State} now */
    sentence: (now) => made.get(now.section)?.sentence?.(now) ?? "",
    /** @param {string} _ @param {{title: string, lines: string[]}} problem */
    problem(_, { title, lines }) {
      complaint = [title, ...lines].join(": ");
      draw();
      return true;
    },
    theme() {
      for (const section of made.values()) section.theme?.();
    },
    deactivate() {
      made.get(state().section)?.stop?.();
    },
    destroy() {
      for (const section of made.values()) section.destroy?.();
    },
  };
}
