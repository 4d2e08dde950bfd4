/** What is known of both sides: their curves as textures, kept by the questions they answer. */

import { constantTexels, tableOf, texelsOf } from "./curves.js";
import { NONE } from "./fields.js";
import { queries, SIDES, sidePaths } from "./queries.js";
import { UNDEFINED } from "./shader.js";

/**
 * @typedef {import('./renderer.js').Renderer} Renderer
 */

/** Curves kept in memory, so that a model seen before is drawn at once. */
const KEPT = 64;

/** @param {Catalog} catalog */
export function createSides(catalog) {
  /** @type {Map<string, any>} answers by path, the last asked for last */
  const kept = new Map();
  /** @type {Map<string, Float32Array>} */
  const made = new Map();
  /** @type {Record<string, string>} what each texture holds */
  let held = {};
  const holes = { left: false, right: false };

  /** @template T @param {Map<string, T>} map @param {string} key @param {T} value */
  function keep(map, key, value) {
    map.delete(key);
    map.set(key, value);
    const [oldest] = map.keys();
    if (map.size > KEPT && oldest !== undefined) map.delete(oldest);
  }

  /** @param {string[]} paths @param {string} model @returns {Float32Array | null} */
  function texels(paths, model) {
    const key = `${model} ${paths.join(" ")}`;
    const found = made.get(key);
    if (found) return found;
    const answers = paths.map((path) => kept.get(path));
    if (answers.includes(undefined)) return null;
    const fresh = paths.length ? texelsOf(answers, model) : constantTexels(0);
    keep(made, key, fresh);
    return fresh;
  }

  return {
    /** @param {Record<string, any>} answers */
    take(answers) {
      for (const [name, path] of Object.entries(answers.asked ?? {}))
        if (answers[name] && kept.get(path) !== answers[name]) keep(kept, path, answers[name]);
    },

    /** Whether the model held by a side is undefined somewhere. @param {'left' | 'right'} side */
    hasHoles: (side) => holes[side],

    /** What was answered to a question, if it is known. @param {string | undefined} path */
    answer: (path) => (path === undefined ? null : (kept.get(path) ?? null)),

    /**
     * Put into the renderer what is known for this state; what is on its way stays as it was.
     * @param {Renderer} renderer
     * @param {State} state
     * @param {boolean} force after the renderer lost all it had
     * @returns {boolean} whether both sides are this state's
     */
    fill(renderer, state, force) {
      if (force) held = {};
      let all = true;
      for (const side of SIDES) {
        const paths = Object.values(sidePaths(state, catalog, side));
        const found = texels(paths, state[side] === NONE ? NONE : state[side]);
        if (!found) {
          all = false;
          continue;
        }
        const key = `${state[side]} ${paths.join(" ")}`;
        if (held[side] !== key) {
          renderer.setCurve(side, found);
          holes[side] = found.includes(UNDEFINED);
          held[side] = key;
        }
        const table = `${key} ${state.texels}`;
        if (state[`${side}_by`] === "texture" && held[`table.${side}`] !== table) {
          renderer.setTable(side, tableOf(found, state.texels));
          held[`table.${side}`] = table;
        }
      }
      const { water } = queries(state, catalog);
      const found = water === undefined ? null : texels([water], "exact");
      if (found && held.water !== water) {
        renderer.setCurve("water", found);
        held.water = /** @type {string} */ (water);
      }
      return all && (water === undefined || found !== null);
    },
  };
}
