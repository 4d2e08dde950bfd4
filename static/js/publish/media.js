/** The media that a figure takes its indices from, for its caption to cite. */

/**
 * @typedef {object} Behind
 * @property {State | null} [state] whose media they are
 * @property {readonly string[]} [indices] of `n_i`, `n_t` and `k_t`, those that the figure holds fixed
 * @property {readonly string[]} [presets] that it shows over their wavelengths
 */

/**
 * @typedef {object} Medium
 * @property {string} id of the preset
 * @property {number | null} [at_nm] where it is taken; null is the preset's own wavelength
 * @property {string} [of] the only index that is taken
 */

/** @param {Behind} behind @returns {Medium[]} */
export function mediaBehind({ state, indices = [], presets = [] }) {
  const shown = presets.map((id) => ({ id }));
  if (!state) return shown;
  const { incident, material, wavelength_nm: at_nm, k_t } = state;
  const second = indices.filter((name) => name !== "n_i");
  const used = second.includes("n_t") || (second.includes("k_t") && k_t !== 0);
  return [
    ...shown,
    ...(incident && indices.includes("n_i") ? [{ id: incident, at_nm }] : []),
    ...(material && used
      ? [{ id: material, at_nm, ...(second.length === 1 && { of: second[0] }) }]
      : []),
  ];
}
