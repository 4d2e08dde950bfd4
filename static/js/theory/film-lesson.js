/** The films of the lesson about them, and what it asks the server for. */

import { choice, number, path } from "../state/state.js";

export const FILMS = {
  soap: { medium: "water", name: "water", most: 1000, quantity: "R", side: "in front" },
  gold: { medium: "Au", name: "gold", most: 200, quantity: "T", side: "from behind" },
};
const YELLOW = 587.6; // nm

/** @returns {Record<string, Field>} */
export function thinFields() {
  return {
    thin_film: choice("soap", Object.keys(FILMS)),
    thin_nm: number({ default: 120, minimum: 0, maximum: 1000 }),
  };
}

/** @param {State} state @param {number} deg @returns {Record<string, string>} */
export function thinQueries({ thin_film, thin_nm }, deg) {
  const { medium, most, quantity } = FILMS[/** @type {keyof typeof FILMS} */ (thin_film)];
  const behind = quantity === "T";
  const film = ["n_t=1", `layers=${medium}`];
  const light = behind && "quantity=T";
  return {
    snell: path("/snell", [
      "n_t=1",
      `layers=${medium}:${thin_nm}`,
      `wavelength_nm=${YELLOW}`,
      `theta_i_deg=${deg}`,
    ]),
    here: path("/films/color", [...film, `thickness_nm=${thin_nm}`, `theta_i_deg=${deg}`, light]),
    map: path("/films/color", [
      ...film,
      `thickness_nm=0..${most}:${behind ? 64 : 256}`,
      `samples=${behind ? 61 : 91}`,
      light,
      "digits=4",
    ]),
  };
}
