/** Colours of a heat map: from values to a scale that light and dark pages and all eyes can read. */

/**
 * @typedef {'signed' | 'size'} ScaleKind
 * @typedef {{kind: ScaleKind, low: number, high: number, capped: boolean}} Scale
 */

/** Share of the cells that the scale's ends leave out, lest one corner darken all the rest. */
const LEFT_OUT = 0.02;

/** @param {number} value @returns {number} the next of 1, 1.5, 2, 3, 5, 7 times a power of ten */
export function roundUp(value) {
  if (!(value > 0)) return 1e-6;
  const power = 10 ** Math.floor(Math.log10(value));
  const factor = [1, 1.5, 2, 3, 5, 7, 10].find((f) => f * power >= value * (1 - 1e-9)) ?? 10;
  return Number((factor * power).toPrecision(3));
}

/**
 * @param {readonly (readonly (number | null)[])[]} z
 * @param {ScaleKind} kind
 * @returns {Scale}
 */
export function scaleOf(z, kind) {
  let count = 0;
  const all = new Float64Array(z.length * (z[0]?.length ?? 0));
  for (const row of z) {
    for (const value of row) {
      if (value === null || !Number.isFinite(value)) continue;
      all[count] = Math.abs(value);
      count += 1;
    }
  }
  const sizes = all.subarray(0, count).sort();
  const most = sizes.at(-1) ?? 1;
  const usual = sizes[Math.floor((sizes.length - 1) * (1 - LEFT_OUT))] ?? most;
  const high = roundUp(most > 2 * usual && usual > 0 ? usual : most);
  return { kind, low: kind === "signed" ? -high : 0, high, capped: most > high };
}

/**
 * Stops of the scale as Plotly and CSS gradients want them.
 * @param {ScaleKind} kind
 * @param {(property: string) => string} color of a CSS custom property
 * @returns {[number, string][]}
 */
export function stops(kind, color) {
  const positive = ["--map-0", "--map-1", "--map-2", "--map-3"];
  const names = kind === "size" ? positive : ["--map-n3", "--map-n2", "--map-n1", ...positive];
  return names.map((name, i) => [i / (names.length - 1), color(name)]);
}
