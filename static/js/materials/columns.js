/** The columns of the table of presets, and how it is sorted. */

import { plain, significant } from "../numbers/format.js";
import { byColumn } from "../numbers/sorted.js";

/**
 * @typedef {object} Preset as `/materials` lists it
 * @property {string} id
 * @property {string} name
 * @property {string} category
 * @property {string} kind
 * @property {string | null} rival_of
 * @property {number} n
 * @property {number | null} n_min
 * @property {number | null} n_max
 * @property {number | null} k
 * @property {number | null} wavelength_nm
 * @property {[number, number] | null} n_range_nm
 * @property {string} confidence
 * @property {string} sample
 * @property {string} source
 * @property {number} F0
 * @property {{luminance: number}} [color] kept long ago, one's own has none
 * @property {{gamut: string, hex: string | null}} swatch
 * @property {{shelf: string, book: string, page: string, title: string} | null} [page] of refractiveindex.info
 *
 * @typedef {object} Column
 * @property {string} name
 * @property {string} heading
 * @property {string} note
 * @property {(preset: Preset) => number | string | null} value to sort by
 * @property {(preset: Preset) => string} print
 */

const CONFIDENCE = ["low", "medium", "high"];

/** A coefficient in the width of a column: what is too weak to see keeps its power of ten. @param {number | null} x */
export function narrow(x) {
  if (x === null) return "–";
  if (x === 0) return "0";
  return Math.abs(x) < 1e-3 ? significant(x, 2) : plain(x, 4);
}

/** @type {Column[]} */
export const COLUMNS = [
  {
    name: "name",
    heading: "material",
    note: "",
    value: (m) => m.name,
    print: (m) => m.name,
  },
  {
    name: "n",
    heading: "n",
    note: "as the source has it, at the reference wavelength: glasses relative to air, of which the sheet tells; of a range the middle",
    value: (m) => m.n,
    print: (m) =>
      m.n_min && m.n_max
        ? `${plain(m.n_min, 4)}–${plain(m.n_max, 4)}`
        : m.n < 1.01 && m.n > 1
          ? plain(m.n, 7)
          : plain(m.n, 5),
  },
  {
    name: "k",
    heading: "k",
    note: "extinction at the reference wavelength; – where the source gives none",
    value: (m) => m.k,
    print: (m) => narrow(m.k),
  },
  {
    name: "F0",
    heading: "Y",
    note: "luminous reflectance at normal incidence from vacuum, under D65",
    value: (m) => m.color?.luminance ?? null,
    print: ({ color }) => {
      if (!color) return "–";
      const { luminance } = color;
      return luminance >= 5e-4 ? luminance.toFixed(3) : luminance === 0 ? "0" : "< 0.001";
    },
  },
  {
    name: "confidence",
    heading: "confidence",
    note: "how far to trust the data: sample, agreement with others, range",
    value: (m) => CONFIDENCE.indexOf(m.confidence),
    print: (m) => m.confidence ?? "–",
  },
];

/**
 * Presets by a column; `match` keeps the server's order, best matches first.
 * @param {readonly Preset[]} presets
 * @param {string} by
 * @param {'up' | 'down'} order
 * @returns {Preset[]}
 */
export function sortedPresets(presets, by, order) {
  const column = COLUMNS.find((c) => c.name === by);
  return column ? byColumn(presets, column.value, order) : [...presets];
}
