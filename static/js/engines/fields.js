/** The state that the Engines view adds to the one all views share, and what it asks for. */

import { choice } from "../state/state.js";
import { text } from "../state/text.js";

const ENGINE_ID = /^[a-z0-9]{1,30}$/;
const LONGEST_NAME = 40;

/** @returns {Record<string, Field>} */
export function engineFields() {
  return {
    engine: text((id) => ENGINE_ID.test(id), "it is no id of an engine", "three"),
    measured: text((name) => name.length <= LONGEST_NAME, "it is no medium's name", "glass"),
    engine_light: choice("environment", ["environment", "light"]),
    engine_channel: choice("red", ["red", "green", "blue"]),
    engine_error: choice("signed", ["signed", "relative"]),
  };
}

/** @param {State} state @returns {Record<string, string>} */
export const queries = (state) => ({
  engines: "/engines",
  measured: `/engines/${state.engine}`,
});

/** @param {State} state @returns {string[]} */
export const restCalls = (state) => Object.values(queries(state));
