/** Code and tables of the models on the sides, below the picture; made when the reader comes near. */

import { h } from "../page/dom.js";
import { createProblems } from "../page/trouble.js";
import { freshOf } from "../state/state.js";
import { withCode } from "./fields.js";
import { later } from "./queries.js";

/** @param {Pick<ViewContext, 'catalog' | 'state' | 'actions' | 'say' | 'save'>} context */
export function createTakeaway({ catalog, state, actions, say, save }) {
  const element = h("div.takeaway");
  /** @type {Awaited<ReturnType<typeof make>> | null} */
  let panels = null;
  /** @type {Record<string, any>} */
  let answers = {};
  const problems = createProblems(["shader", "lut"]);

  async function make() {
    const [{ createSnippets }, { createTables }] = await Promise.all([
      import("../takeaway/code.js"),
      import("../takeaway/table.js"),
    ]);
    const snippets = createSnippets({ models: catalog.models, actions, say, save });
    element.append(snippets.element);
    return { snippets, tables: createTables({ parent: element, catalog, actions }) };
  }

  function show() {
    const now = state();
    const { shader, lut } = freshOf(answers, later(now, catalog));
    panels?.snippets.update(now, withCode(now), shader, problems.of("shader", answers));
    panels?.tables.update(now, withCode(now), lut, problems.of("lut", answers));
  }

  const watching = new IntersectionObserver(
    async (entries) => {
      if (!entries.some((entry) => entry.isIntersecting)) return;
      watching.disconnect();
      panels = await make();
      show();
    },
    // Of the first screen, which is the picture's, a strip at the bottom may be left.
    { rootMargin: "0px 0px -25% 0px" },
  );
  watching.observe(element);

  return {
    element,
    /** @param {Record<string, any>} found */
    update(found) {
      answers = found;
      show();
    },
    /** @param {string} name @param {import('../page/trouble.js').Problem} problem @returns {boolean} whether it is said here */
    problem(name, problem) {
      const told = problems.add(name, problem, answers);
      if (told) show();
      return told;
    },
    theme: () => panels?.tables.theme(),
    destroy() {
      watching.disconnect();
      panels?.tables.destroy();
    },
  };
}
