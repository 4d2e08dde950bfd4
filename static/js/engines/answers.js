/** What the server tells of an engine, and the part of it that is chosen. */

/**
 * @typedef {{max_abs: number, at_deg: number, channel: string}} Largest
 * @typedef {{medium: string, light: string, way: string, typed: Record<string, any>,
 *   reflectance: number[][], error: Largest, model: string | null, model_error: Largest | null}} Curve
 * @typedef {{name: string, kind: string, n: number[], k: number[], exact: number[][]}} Medium
 * @typedef {{id: string, title: string, package: string, version: string, date: string, how: string,
 *   repeat: string, noise: number, departures: string[]}} Engine
 * @typedef {Engine & {channels_nm: number[], theta_i_deg: number[], media: Medium[], curves: Curve[]}} Measured
 */

const CHANNELS = ["red", "green", "blue"];

/** The medium that the state names, glass where the engine knows none of that name. @param {State} state @param {Measured} engine @returns {Medium} */
export function mediumOf(state, { media }) {
  const named = media.find((m) => m.name === state.measured);
  return named ?? media.find((m) => m.name === "glass") ?? /** @type {Medium} */ (media[0]);
}

/** The curves of the medium under the light chosen, or under the one light that the engine was measured by. @param {State} state @param {Measured} engine */
export function curvesOf(state, engine) {
  const own = engine.curves.filter((c) => c.medium === mediumOf(state, engine).name);
  const lit = own.filter((c) => c.light === state.engine_light);
  return lit.length ? lit : own;
}

/** A column of rows of red, green and blue; clear media have the same in all. @param {number[][]} rows @param {State} state @returns {number[]} */
export function channelOf(rows, { engine_channel: channel }) {
  const at = CHANNELS.indexOf(channel);
  return rows.map((row) => /** @type {number} */ (row[at]));
}

/** What was typed, in a line. @param {Record<string, any>} typed @returns {string} */
export function typedWords(typed) {
  /** @param {any} value @returns {string} */
  const words = (value) => {
    if (Array.isArray(value)) return value.map(words).join(" ");
    if (typeof value === "number") return String(Number(value.toPrecision(4)));
    if (typeof value === "object") return `(${typedWords(value)})`;
    return String(value);
  };
  return Object.entries(typed)
    .map(([name, value]) => `${name} ${words(value)}`)
    .join(", ");
}
