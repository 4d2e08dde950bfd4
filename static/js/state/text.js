/** A field of the state that holds words. */

import { LinkError } from "./state.js";

/**
 * What a reader wrote, or an id that the server judges.
 * @param {(given: string) => boolean} allowed
 * @param {string} message
 * @param {string | null} [preset]
 * @returns {Field}
 */
export function text(allowed, message, preset = null) {
  return {
    default: preset,
    parse(given) {
      if (!allowed(given)) throw new LinkError(message);
      return given;
    },
    print: (value) => value ?? "",
  };
}
