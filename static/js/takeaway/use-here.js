/** Where a view has no room for it from the start: the panel "Use it in" in a fold, which asks by itself. */

import { h } from "../page/dom.js";
import { loadStyles } from "../page/style.js";
import { load, Problem } from "../server/api.js";
import { mediaQuery } from "../state/state.js";
import { createUse, usePath } from "./use.js";

const SETTLED = 250; // ms

/** The second medium as `/export` takes it: its spectrum where it is a preset. @param {State} state @param {Catalog} catalog */
export function boundary(state, catalog) {
  const { material } = state;
  return material === null
    ? mediaQuery(state, catalog)
    : [...mediaQuery(state, catalog, ["n_i"]), `material=${encodeURIComponent(material)}`];
}

/** @param {HTMLDetailsElement} fold @param {Pick<ViewContext, 'catalog' | 'say' | 'save'>} context */
export async function createUseHere(fold, { catalog, say, save }) {
  await loadStyles("sheet", "take");
  /** @type {State} */
  let now = {};
  let chosen = { use_in: "blender", use_mode: null };
  let asked = "";
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let settling;
  const place = h("div");
  fold.append(place);
  const use = createUse({
    parent: place,
    say,
    save,
    actions: {
      /** @param {any} patch */
      set(patch) {
        chosen = { ...chosen, ...patch };
        void ask();
      },
      settle() {},
    },
  });

  async function ask() {
    const wanted = usePath("/export", { ...now, ...chosen }, boundary(now, catalog));
    if (!fold.open || wanted === asked) return;
    asked = wanted;
    try {
      const answer = await load(wanted);
      if (asked !== wanted) return;
      use.problem(undefined);
      use.update(chosen, answer);
    } catch (problem) {
      if (asked !== wanted || !(problem instanceof Problem)) return;
      const { title, detail, errors, status } = problem;
      if (status === 0 || status > 499) asked = ""; // it was no answer: the next occasion asks again
      use.problem({ title, lines: errors.length ? errors.map((e) => e.message) : [detail] });
    }
  }

  fold.addEventListener("toggle", ask);
  window.addEventListener("online", ask);
  return {
    /** @param {State} state */
    update(state) {
      now = state;
      clearTimeout(settling);
      settling = setTimeout(ask, SETTLED);
    },
  };
}
