/** What white light asks the server for. */

import { knownRange, mediaAt } from "../media/constants.js";

/** From violet to red, in nm. */
const COLORS = [400, 450, 500, 550, 600, 650, 700];
const SAMPLES = 361;

/**
 * The curves of each wavelength at which the media are known, if white light is to be seen.
 * @param {State} state
 * @param {Material[]} materials
 * @returns {Record<string, string>}
 */
export function spreadPaths(state, materials) {
  const range = knownRange(materials, state);
  if (state.light !== "white" || !range) return {};
  const known = COLORS.filter((nm) => nm >= range[0] && nm <= range[1]);
  return Object.fromEntries(
    known.map((nm) => [
      `white:${nm}`,
      `/curves?${[...(mediaAt(materials, state, nm) ?? []), "refraction=true", `samples=${SAMPLES}`].join("&")}`,
    ]),
  );
}
