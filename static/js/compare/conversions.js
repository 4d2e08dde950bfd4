/** What `/convert` is asked, and how its answers are written. */

import { plain, significant } from "../numbers/format.js";
import { path } from "../state/state.js";

/**
 * @typedef {{form: string, title: string, values: Record<string, any>, status: string, why: string}} Result
 * @typedef {{name: string, symbol: string, hint: string}} Input
 * @typedef {{name: string, label: string, value: any, default: number, minimum: number, maximum: number | null,
 *   clamps: string}} KnobInput
 * @typedef {{knob: string, title: string, inputs: KnobInput[], status: string, why: string, reference: string,
 *   measured: string[]}} Knob
 */

/** @param {string} label @param {string} start @param {[name: string, symbol: string, hint: string][]} inputs */
const source = (label, start, ...inputs) => ({
  label,
  start,
  inputs: inputs.map(([name, symbol, hint]) => ({ name, symbol, hint })),
});

/** What can be given; the second medium of the page stands first. @type {Record<string, {label: string, start: string, inputs: Input[]}>} */
export const SOURCES = {
  media: source("the second medium above", ""),
  ior: source("index of refraction", "1.5", ["n_t", "n_t", "1.5"]),
  nk: source("complex index n, k", "0.27;2.9", ["n_t", "n_t", "0.27"], ["k_t", "k_t", "2.9"]),
  f0: source("F0, linear", "0.04", ["F0", "F_0", "0.04, or 1, 0.77, 0.34"]),
  f0_srgb: source("F0, sRGB", "0.22", ["F0_srgb", "F_0", "0.22, or 1, 0.89, 0.62"]),
  hex: source("a picture's color", "#ffe29b", ["hex", "F_0", "#ffe29b"]),
  specular: source("specular level", "0.5", ["specular", "", "0.5"]),
  reflectance: source("Filament's reflectance", "0.5", ["reflectance", "", "0.5"]),
  blender: source(
    "Blender's IOR and level",
    "1.5;0.5",
    ["ior", "", "1.5"],
    ["specular_ior_level", "", "0.5"],
  ),
  gltf: source(
    "glTF's ior and specular",
    "1.5;1;1",
    ["ior", "", "1.5"],
    ["specularFactor", "", "1"],
    ["specularColorFactor", "", "1, or 1, 0.8, 0.6"],
  ),
  openpbr: source(
    "OpenPBR's specular",
    "1.5;1",
    ["specular_ior", "", "1.5"],
    ["specular_weight", "", "1"],
  ),
  three: source("three's reflectivity", "0.5", ["reflectivity", "", "0.5"]),
  unreal: source("Unreal's Specular", "0.5", ["specular", "", "0.5"]),
  godot: source("Godot's metallic_specular", "0.5", ["metallic_specular", "", "0.5"]),
  rg: source("Gulbrandsen's r, g", "0.9;0.5", ["r", "r", "0.9"], ["g", "g", "0.5"]),
  dg: source("d'Eon's r, G", "0.9;0.5", ["r", "r", "0.9"], ["G", "G", "0.5"]),
};
/** Values of several boxes stand in the link with this between. */
export const BETWEEN = ";";

/** The texts of a source's boxes. @param {State} state @returns {string[]} */
export function texts({ from, given }) {
  const { start = "", inputs = [] } = SOURCES[from] ?? {};
  const parts = (given ?? start).split(BETWEEN);
  return inputs.map((_, i) => (parts[i] ?? "").trim());
}

/** What may be a color; all else is one number. */
const COLORS = ["F0", "F0_srgb", "hex", "r", "g", "G", "specularColorFactor"];

/** What is given, as the server reads it: 1,5 is 1.5 where no list can be meant. @param {string} name @param {string} text */
function sent(name, text) {
  const bare = text.replace(/\s+/g, "").replace(/^#/, "");
  return COLORS.includes(name) ? bare : bare.replace(/^(\d*),(\d+)$/, "$1.$2");
}

/** @param {State} state @returns {string[]} what is given, as parts of a query */
function given(state) {
  const { from, n_t, k_t } = state;
  if (from === "media")
    return k_t > 0 ? ["from=nk", `n_t=${n_t}`, `k_t=${k_t}`] : ["from=ior", `n_t=${n_t}`];
  const values = texts(state);
  return [
    `from=${from === "hex" ? "f0_srgb" : from}`,
    ...(SOURCES[from]?.inputs ?? []).map(
      ({ name }, i) =>
        `${name}=${encodeURIComponent(sent(name, values[i] ?? "")).replace(/%2C/g, ",")}`,
    ),
  ];
}

/** @param {State} state @returns {string} */
export function convertPath(state) {
  const { n_i, seen_from, from, material } = state;
  return path("/convert", [
    ...given(state),
    n_i !== 1 && `n_i=${n_i}`,
    seen_from !== null && `seen_from=${seen_from}`,
    from === "media" && material && `dispersion_of=${encodeURIComponent(material)}`,
  ]);
}

/** Knobs as results, from which boxes are filled. @param {any} answer @returns {Result[]} */
export const asResults = ({ results, knobs }) => [
  ...results,
  ...knobs.map((/** @type {Knob} */ { knob, inputs, ...rest }) => ({
    ...rest,
    form: knob,
    values: Object.fromEntries(inputs.map(({ name, value }) => [name, value])),
  })),
];

/**
 * Every knob with what to type, those of dispersion where that is known.
 * @param {any} answer of `/convert`
 * @returns {Knob[]}
 */
export const knobsOf = (answer) => [...answer.knobs, ...(answer.dispersion?.knobs ?? [])];

/** What to type, three numbers of a color where there are three. @param {any} value */
export function typedValue(value) {
  if (Array.isArray(value)) return value.map((v) => plain(v, 4)).join(", ");
  return value === null ? "none" : plain(value);
}

/** Where an engine means a number to be, and what it is unless typed. @param {KnobInput} input */
export function rangeOf({ minimum, maximum, default: preset }) {
  const to =
    maximum === null ? `${plain(minimum)} or more` : `${plain(minimum)} to ${plain(maximum)}`;
  return `${to}, ${plain(preset)} unless typed`;
}

/** How a value is written: six digits, three of them where there are three. @param {any} value */
export function printValue(value) {
  if (typeof value === "string") return value;
  if (Array.isArray(value))
    return value.map((v) => (v === null ? "none" : significant(v, 4))).join(", ");
  return value === null ? "none" : significant(value, 6);
}

/** The boxes of a source, filled from a result of the same form. @param {string} from @param {Result[]} results */
export function filled(from, results) {
  const form = from === "hex" ? "f0_hex" : from;
  const values = results.find((r) => r.form === form)?.values ?? {};
  const parts = (SOURCES[from]?.inputs ?? []).map(({ name }) => {
    const value = values[name];
    if (typeof value === "string") return value;
    const all = Array.isArray(value) ? value : [value];
    return all.every((v) => typeof v === "number")
      ? all.map((v) => Number(v.toPrecision(6))).join(",")
      : "";
  });
  return parts.length > 0 && parts.every(Boolean) ? parts.join(BETWEEN) : null;
}
