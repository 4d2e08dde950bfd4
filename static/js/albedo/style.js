/** One color and one dash for each fit: what has the same authors has the same color. */

/** @type {Record<string, [number, string]>} */
const OWN = {
  deon_2019_log: [3, "dashdot"],
  deon_irving_2011: [4, "dash"],
  egan_hilgeman_1973_external: [5, "dot"],
  kulla_conty_2017: [6, "longdash"],
  egan_hilgeman_1973: [5, "dot"],
  deon_irving_2011_internal: [4, "dash"],
  kulla_conty_2017_internal: [6, "longdash"],
  dunkle_1963_s: [7, "dot"],
  dunkle_1963_p: [7, "longdash"],
  deon_2019_rational: [5, "dash"],
  deon_2019_rg: [3, "dashdot"],
  kulla_conty_2017_tint: [6, "longdash"],
  schlick_nk: [1, "dot"],
  large_k: [8, "longdashdot"],
  // The average of a model's curve looks like that model.
  schlick: [1, "dash"],
  f82_tint: [2, "dot"],
  dunkle_1963: [4, "dashdot"],
};
/** Where a formula is used beyond what it was made for. */
export const OUTSIDE = { color: "--muted", dash: "2px,4px", width: 1.3 };
/** At the largest error that a source promises. */
export const CLAIMED = { dash: "1px,3px", width: 1.4 };

/** @param {string} id of a fit @returns {{color: string, dash: string}} */
export function fitStyle(id) {
  const [color, dash] = OWN[id] ?? [8, "dash"];
  return { color: `--model-${color}`, dash };
}
