/** What `/convert` is asked, and how its answers are written. */

import { significant } from "../numbers/format.js";

/**
 * @typedef {{form: string, title: string, values: Record<string, any>, status: string, why: string}} Result
 * @typedef {{name: string, symbol: string, hint: string}} Input
 */

/** What can be given; the second medium of the page stands first. @type {Record<string, {label: string, inputs: Input[], start: string}>} */
export const SOURCES = {
  media: { label: "the second medium above", inputs: [], start: "" },
  ior: {
    label: "index of refraction",
    inputs: [{ name: "n_t", symbol: "n_t", hint: "1.5" }],
    start: "1.5",
  },
  nk: {
    label: "complex index n, k",
    inputs: [
      { name: "n_t", symbol: "n_t", hint: "0.27" },
      { name: "k_t", symbol: "k_t", hint: "2.9" },
    ],
    start: "0.27;2.9",
  },
  f0: {
    label: "F0, linear",
    inputs: [{ name: "F0", symbol: "F_0", hint: "0.04, or 1, 0.77, 0.34" }],
    start: "0.04",
  },
  f0_srgb: {
    label: "F0, sRGB",
    inputs: [{ name: "F0_srgb", symbol: "F_0", hint: "0.22, or 1, 0.89, 0.62" }],
    start: "0.22",
  },
  hex: {
    label: "a picture's color",
    inputs: [{ name: "hex", symbol: "F_0", hint: "#ffe29b" }],
    start: "#ffe29b",
  },
  specular: {
    label: "specular level",
    inputs: [{ name: "specular", symbol: "", hint: "0.5" }],
    start: "0.5",
  },
  reflectance: {
    label: "Filament's reflectance",
    inputs: [{ name: "reflectance", symbol: "", hint: "0.5" }],
    start: "0.5",
  },
  rg: {
    label: "Gulbrandsen's r, g",
    inputs: [
      { name: "r", symbol: "r", hint: "0.9" },
      { name: "g", symbol: "g", hint: "0.5" },
    ],
    start: "0.9;0.5",
  },
  dg: {
    label: "d'Eon's r, G",
    inputs: [
      { name: "r", symbol: "r", hint: "0.9" },
      { name: "G", symbol: "G", hint: "0.5" },
    ],
    start: "0.9;0.5",
  },
};
/** Values of several boxes stand in the link with this between. */
export const BETWEEN = ";";

/** The texts of a source's boxes. @param {{from: string, given: string | null}} state @returns {string[]} */
export function texts({ from, given }) {
  const source = SOURCES[from];
  const parts = (given ?? source?.start ?? "").split(BETWEEN);
  return (source?.inputs ?? []).map((_, i) => (parts[i] ?? "").trim());
}

/** @param {State} state @returns {string} */
export function convertPath(state) {
  const { from, n_i, n_t, k_t, seen_from } = state;
  const parts =
    from === "media"
      ? k_t > 0
        ? ["from=nk", `n_t=${n_t}`, `k_t=${k_t}`]
        : ["from=ior", `n_t=${n_t}`]
      : [
          `from=${from === "hex" ? "f0_srgb" : from}`,
          ...(SOURCES[from]?.inputs ?? []).map(({ name }, i) => {
            const text = (texts(/** @type {any} */ (state))[i] ?? "").replace(/\s+/g, "");
            return `${name}=${encodeURIComponent(text.replace(/^#/, "")).replace(/%2C/g, ",")}`;
          }),
        ];
  if (n_i !== 1) parts.push(`n_i=${n_i}`);
  if (seen_from !== null) parts.push(`seen_from=${seen_from}`);
  return `/convert?${parts.join("&")}`;
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
