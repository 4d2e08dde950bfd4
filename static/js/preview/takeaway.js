/** Code and tables of the models on the sides, below the picture; made when the reader comes near. */

import { h } from "../page/dom.js";
import { freshOf } from "../server/questions.js";
import { withCode } from "./fields.js";
import { later } from "./queries.js";

/**
 * @typedef {{title: string, lines: string[]}} Told
 */

/** @param {Pick<ViewContext, 'catalog' | 'state' | 'actions' | 'say' | 'save'>} context */
export function createTakeaway({ catalog, state, actions, say, save }) {
  const element = h("div", { class: "takeaway" });
  /** @type {Awaited<ReturnType<typeof make>> | null} */
  let panels = null;
  /** @type {Record<string, any>} */
  let answers = {};
  /** @type {Record<string, Told>} what went wrong, by the query's name */
  let problems = {};

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
    const fresh = freshOf(answers, later(now, catalog));
    panels?.snippets.update(now, withCode(now), fresh.shader, problems.shader);
    panels?.tables.update(now, withCode(now), fresh.lut, problems.lut);
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
      problems = Object.fromEntries(
        Object.entries(problems).filter(([name]) => found[name] === answers[name]),
      );
      answers = found;
      show();
    },
    /** @param {string} name @param {Told} problem @returns {boolean} whether it is said here */
    problem(name, problem) {
      if (name !== "shader" && name !== "lut") return false;
      problems[name] = problem;
      show();
      return true;
    },
    theme: () => panels?.tables.theme(),
    destroy() {
      watching.disconnect();
      panels?.tables.destroy();
    },
  };
}
