/** What is known of both sides: their curves as textures, kept by the questions they answer. */

import { constantTexels, tableOf, texelsOf } from "./curves.js";
import { isEven, isFilmed, isOpaque, isPaint, isShortcut, NONE } from "./fields.js";
import { coatPaths, queries, SIDES, shortcutReason, sidePaths, throughPath } from "./queries.js";
import { BODY, HOW, UNDEFINED } from "./shader.js";

/**
 * @typedef {import('./renderer.js').Renderer} Renderer
 * @typedef {import('./queries.js').Side} Side
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
  /** Whether the model held by a side is undefined somewhere. */
  const holes = { left: false, right: false };
  /** The last that was known of the paint, by channel. @type {any[]} */
  let coats = [];

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
    const nothing = model === NONE ? 0 : UNDEFINED;
    const fresh = paths.length ? texelsOf(answers, model) : constantTexels(nothing);
    keep(made, key, fresh);
    return fresh;
  }

  return {
    /** @param {Record<string, any>} answers */
    take(answers) {
      for (const [name, path] of Object.entries(answers.asked ?? {}))
        if (answers[name] && kept.get(path) !== answers[name]) keep(kept, path, answers[name]);
    },

    /** Why a side's model does not apply here. @param {State} state @param {Side} side @returns {string} */
    reason(state, side) {
      const model = state[side];
      if (isShortcut(model)) return shortcutReason(state, model);
      if (isFilmed(state) && model !== "exact" && model !== NONE)
        return "It knows no films: the surface without them.";
      const [path = ""] = Object.values(sidePaths(state, catalog, side));
      /** @type {Curve[]} */
      const curves = kept.get(path)?.curves ?? [];
      const reason = curves.find((c) => c.model === model)?.reason;
      return reason ? `Outside its domain: ${reason}` : "";
    },

    /**
     * Put into the renderer what is known for this state; what is on its way stays as it was.
     * @param {Renderer} renderer
     * @param {State} state
     * @param {boolean} force after the renderer lost all it had
     * @returns {boolean} whether all is this state's
     */
    fill(renderer, state, force) {
      if (force) held = {};
      let all = true;
      for (const side of SIDES) {
        const paths = Object.values(sidePaths(state, catalog, side));
        const found = texels(paths, state[side]);
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
        const through = throughPath(state, catalog, side);
        if (through) {
          const passing = texels([through], "exact");
          if (passing && held[`${side}_T`] !== through) {
            renderer.setCurve(`${side}_T`, passing);
            held[`${side}_T`] = through;
          }
          all &&= passing !== null;
        }
        const table = `${key} ${state.texels}`;
        if (state[`${side}_by`] === "texture" && held[`table.${side}`] !== table) {
          renderer.setTable(side, tableOf(found, state.texels));
          held[`table.${side}`] = table;
        }
      }
      const { water } = queries(state, catalog);
      if (water !== undefined) {
        const found = texels([water], "exact");
        if (found && held.water !== water) {
          renderer.setCurve("water", found);
          held.water = water;
        }
        all &&= found !== null;
      }
      const fresh = Object.values(coatPaths(state, catalog)).map((path) => kept.get(path));
      if (fresh.includes(undefined)) return false;
      coats = fresh;
      return all;
    },

    /** What the picture is made of. @param {State} now */
    scene(now) {
      /** @param {Side} side @returns {import('./shader.js').Variant} */
      const variant = (side) => ({
        how: HOW[/** @type {keyof typeof HOW} */ (now[`${side}_by`])],
        body: isOpaque(now) ? BODY.opaque : isPaint(now) ? BODY.paint : BODY.clear,
        water: now.scene === "water",
        even: isEven(now),
        holes: holes[side],
        own_t: throughPath(now, catalog, side) !== null,
      });
      const external = coats[0]?.external ?? 0;
      return {
        sides: { left: variant("left"), right: variant("right") },
        eta: now.n_i / now.n_t,
        external,
        escape: coats.length ? coats.map((coat) => coat.body / (1 - external) ** 2) : [0, 0, 0],
      };
    },
  };
}
