/** What the panel of shader code adds to the state, and what it asks the server for. */

import { choice } from "../state/state.js";

/**
 * @typedef {{id: string, label: string, file: string}} Language
 */

/** @type {Language[]} */
export const LANGUAGES = [
  { id: "glsl", label: "GLSL", file: "glsl" },
  { id: "hlsl", label: "HLSL", file: "hlsl" },
  { id: "wgsl", label: "WGSL", file: "wgsl" },
  { id: "osl", label: "OSL", file: "osl" },
  { id: "python", label: "Python", file: "py" },
];

/** @param {Model[]} models @returns {Record<string, Field>} */
export function snippetFields(models) {
  const ids = models.map((m) => m.id);
  return {
    code: { ...choice("", ids), default: null, print: (value) => value ?? "" },
    language: choice(
      "glsl",
      LANGUAGES.map((l) => l.id),
    ),
    channels: choice("1", ["1", "3"]),
  };
}

/**
 * The model whose code is shown: the one asked for while it is offered, else the first.
 * @param {State} state
 * @param {readonly string[]} offered
 */
export function codeOf({ code }, offered) {
  return code !== null && offered.includes(code) ? code : (offered[0] ?? "exact");
}

/** @param {State} state @param {readonly string[]} offered @returns {string} */
export function snippetPath(state, offered) {
  const { language, channels } = state;
  const colors = channels === "3" ? "&channels=3" : "";
  return `/shaders/${codeOf(state, offered)}?language=${language}${colors}`;
}
