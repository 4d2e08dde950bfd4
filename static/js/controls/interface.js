/** The interface in a panel: its three indices as rows, and its media as presets. */

import { plain } from "../numbers/format.js";
import { createMedia } from "./media.js";
import { createRow } from "./row.js";

/**
 * @typedef {{set: (patch: State, options?: {history?: 'push' | 'replace'}) => void, settle: () => void}} Actions
 * @typedef {Pick<import('./row.js').RowOptions, 'label' | 'range' | 'wide'>} Manner
 */

const STEPS = { step: 0.01, fine: 0.001, page: 0.1 };
/** A value of one's own is no preset any more. @type {Record<string, string>} */
const PRESETS = { n_i: "incident", n_t: "material", k_t: "material" };

/**
 * @param {object} options
 * @param {Catalog} options.catalog
 * @param {State} options.presets
 * @param {() => State} options.state
 * @param {Actions} options.actions
 * @param {string} options.prefix of the ids
 * @param {Record<string, Manner>} options.manners how each index is shown, in this order
 * @param {() => Promise<void>} options.describeMedia
 */
export function createInterface({
  catalog,
  presets,
  state,
  actions,
  prefix,
  manners,
  describeMedia,
}) {
  const rows = Object.entries(manners).flatMap(([name, manner]) => {
    const parameter = catalog.parameters.find((p) => p.name === name);
    if (!parameter) return [];
    const row = createRow({
      parameter,
      prefix,
      preset: presets[name],
      ...manner,
      steps: STEPS,
      onChange: (value, moving) =>
        actions.set(
          { [name]: value, [/** @type {string} */ (PRESETS[name])]: null },
          { history: moving ? "replace" : "push" },
        ),
      onSettle: actions.settle,
    });
    return [{ name, symbol: parameter.symbol, row, print: () => plain(state()[name], 4) }];
  });

  const media = createMedia({
    materials: catalog.materials,
    describe: describeMedia,
    actions,
    prefix,
    onPick(side, id) {
      if (catalog.materials.some((m) => m.id === id)) actions.set({ [side]: id });
    },
    onSwap() {
      const { n_i, n_t, incident, material } = state();
      actions.set({ n_i: n_t, n_t: n_i, incident: material, material: incident });
    },
  });

  return { rows, media };
}
