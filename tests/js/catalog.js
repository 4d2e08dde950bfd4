/** What tests of several views need of the catalog: the parameters of an interface. */
export const PARAMETERS = [
  { name: "n_i", default: 1, minimum: 1e-3, maximum: 100 },
  { name: "n_t", default: 1.5, minimum: 1e-3, maximum: 100 },
  { name: "k_t", default: 0, minimum: 0, maximum: 100 },
  { name: "theta_i_deg", default: 0, minimum: 0, maximum: 90 },
];

/**
 * One property of each.
 * @template T
 * @template {keyof T} K
 * @param {readonly T[]} all
 * @param {K} key
 */
export const pick = (all, key) => all.map((one) => one[key]);
