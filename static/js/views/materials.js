/** Materials: the catalog, and all that is known of the chosen preset. */

import { createExamples } from "../controls/examples.js";
import { createAngles } from "../materials/angles.js";
import { createBrowser } from "../materials/browser.js";
import { createColors } from "../materials/colors.js";
import { createCovered } from "../materials/covered.js";
import { EXAMPLES, isShown } from "../materials/examples.js";
import { materialFields } from "../materials/fields.js";
import { createHead } from "../materials/head.js";
import { createMap } from "../materials/map.js";
import { createNumbers } from "../materials/numbers.js";
import { presetOf, shown } from "../materials/queries.js";
import { createRivals, createSource } from "../materials/source.js";
import { createSpectrum } from "../materials/spectrum.js";
import { become, isPage, pathOf } from "../media/brought.js";
import { percent, plain } from "../numbers/format.js";
import { h } from "../page/dom.js";
import { loadStyles } from "../page/style.js";
import { createProblems } from "../page/trouble.js";
import { createUse } from "../takeaway/use.js";

export { queries, restCalls } from "../materials/queries.js";
export const fields = materialFields;

await loadStyles("heatmap", "sheet", "take", "materials");

/** A view narrower than this shows the catalog above the preset. */
const NARROW = "(max-width: 900px)";

/** @param {ViewContext} view */
export function createView(view) {
  const { element, views, catalog, actions, state, say, save, describeMedia } = view;
  const now = () => shown(state(), catalog);
  /** What was chosen last, while what it is comes. */
  let picked = "";

  /** @param {string} id @param {boolean} moving */
  async function pick(id, moving) {
    picked = id;
    if (isPage(id) && !presetOf(catalog, id)) {
      try {
        await become(catalog.materials, id);
      } catch {
        say(`${pathOf(id)} did not come: is the server running?`);
        return;
      }
      if (picked !== id) return;
    }
    actions.set({ preset: id, ...kept(state(), id) }, { history: moving ? "replace" : "push" });
    if (!moving && matchMedia(NARROW).matches) {
      detail.scrollIntoView({ block: "start" });
      head.focus();
    }
  }

  /** Wavelengths that the next material is not known at are let go. @param {State} now @param {string} id */
  function kept({ at_nm, nm }, id) {
    const [low, high] = presetOf(catalog, id)?.n_range_nm ?? [Infinity, -Infinity];
    /** @param {number} value */
    const outside = (value) => value < low || value > high;
    return {
      use_mode: null,
      ...(at_nm !== null && outside(at_nm) && { at_nm: null }),
      ...(nm?.some(outside) && { nm: null }),
    };
  }

  const browser = createBrowser({ catalog, actions, onPick: pick });
  const head = createHead({ views, actions });
  const numbers = createNumbers({ actions, say });
  const examples = createExamples({
    examples: EXAMPLES,
    name: "material-examples",
    label: "Figures of the sources",
    onShow(example) {
      actions.set(example.state);
      detail.querySelector(`.${example.show}`)?.scrollIntoView({ block: "nearest" });
    },
    isShown,
  });
  const source = createSource(say);
  const rivals = createRivals((id) => pick(id, false));
  const sheets = h("div.sheets");
  const detail = h(
    "div.material",
    { role: "region", "aria-label": "Material" },
    examples.element,
    head.element,
    numbers.element,
    sheets,
  );
  element.append(browser.element, detail);
  const context = { parent: sheets, catalog, actions, save, now, describeMedia };
  const spectrum = createSpectrum(context);
  const angles = createAngles(context);
  const colors = createColors(context);
  const map = createMap(context);
  sheets.append(h("div.beside", rivals.element, source.element));
  const covered = createCovered({ parent: sheets, actions });
  const use = createUse({ parent: sheets, actions, say, save });
  /** By the name of the query. */
  const figures = { spectrum, angles, colors, map };

  const problems = createProblems(["detail", "index", "covered", "use", ...Object.keys(figures)]);
  /** @type {Record<string, any>} */
  let latest = {};
  /** The answer of which what does not move was drawn. @type {unknown} */
  let drawn = null;

  function showProblems() {
    /** @param {string} name */
    const of = (name) => problems.of(name, latest);
    numbers.problem(of("detail"));
    covered.problem(of("covered"));
    use.problem(of("use"));
    for (const [name, figure] of Object.entries(figures)) figure.problem(of(name));
    if (!of("colors")) colors.problem(of("index"));
  }

  return {
    /** @param {State} state @param {Record<string, any>} answers */
    update(state, answers) {
      const now = shown(state, catalog);
      latest = answers;
      browser.update(now, answers.list);
      examples.update(now);
      numbers.choices(now);
      const preset = presetOf(catalog, now.preset);
      const spectral = preset?.kind === "spectrum";
      for (const { element } of [spectrum, angles, map]) element.hidden = !spectral;
      const { detail } = answers;
      if (detail?.id === now.preset) {
        head.update(detail, now);
        numbers.update(detail, now);
        if (detail !== drawn) {
          drawn = detail;
          source.update(detail);
          rivals.update(detail);
        }
      }
      const at = now.at_nm ?? preset?.wavelength_nm ?? null;
      if (spectral) {
        spectrum.update(now, answers, at);
        angles.update(now, answers.angles);
        map.update(now, answers.map, at);
      }
      colors.update(now, answers);
      covered.update(now, answers.covered);
      use.update(now, answers.use);
      showProblems();
    },

    /** @param {State} now @param {Record<string, any>} answers */
    sentence(now, { detail: known }) {
      if (known?.id !== shown(now, catalog).preset) return "";
      const { n, k, F0, wavelength_nm } = known.constants;
      const at = wavelength_nm === null ? "" : ` at ${plain(wavelength_nm)} nanometers`;
      return `${known.name}${at}: n ${plain(n, 5)}, k ${k === null ? "not given" : plain(k, 4)}, ${percent(F0)} reflected at normal incidence.`;
    },

    /** @param {string} name @param {{title: string, lines: string[]}} problem */
    problem(name, problem) {
      if (name.startsWith("rival:")) return true;
      const told = problems.add(name, problem, latest);
      showProblems();
      return told;
    },

    theme() {
      for (const figure of Object.values(figures)) figure.theme();
    },
    deactivate() {},
    destroy() {
      for (const figure of Object.values(figures)) figure.destroy();
    },
  };
}
