/** What the picture of glossy paint adds to the state, and what it asks the server for. */

import { choice, declared, number, path } from "../state/state.js";

/**
 * What `/albedo/coat` sends.
 * @typedef {{interface: Interface, body_albedo: number, theta_i_deg: number | null,
 *   external: number, internal: number, surface: number, body: number, absorbed: number}} Coat
 */

/** @param {Parameter[]} parameters @returns {Record<string, Field>} */
export function coatFields(parameters) {
  return {
    coat_n: number({ ...declared(parameters, "n_t"), default: 1.5 }),
    coat_body: number({ default: 0.5, minimum: 0, maximum: 1 }),
    coat_light: choice("diffuse", ["diffuse", "ray"]),
    coat_theta: number({ default: 45, minimum: 0, maximum: 90 }),
  };
}

/** @param {State} state */
export function coatPath({ coat_n, coat_body, coat_light, coat_theta }) {
  return path("/albedo/coat", [
    `n_t=${coat_n}`,
    `body_albedo=${coat_body}`,
    coat_light === "ray" && `theta_i_deg=${coat_theta}`,
  ]);
}
