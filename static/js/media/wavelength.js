/** How wavelengths are written, and told apart: a color that suggests the light, a dash, and the number itself. */

import { plain } from "../numbers/format.js";

import { encoded } from "../numbers/srgb.js";

/**
 * Hue and lightness by wavelength in OKLCH, for light and dark pages. Lightness falls towards the red,
 * so that those who see no hues still see an order.
 * @type {readonly {nm: number, hue: number, chroma: number, light: number, dark: number}[]}
 */
const ANCHORS = [
  { nm: 340, hue: 330, chroma: 0.06, light: 0.5, dark: 0.8 },
  { nm: 400, hue: 302, chroma: 0.17, light: 0.5, dark: 0.74 },
  { nm: 450, hue: 266, chroma: 0.17, light: 0.5, dark: 0.72 },
  { nm: 500, hue: 205, chroma: 0.1, light: 0.58, dark: 0.82 },
  { nm: 550, hue: 146, chroma: 0.14, light: 0.56, dark: 0.84 },
  { nm: 580, hue: 95, chroma: 0.13, light: 0.6, dark: 0.88 },
  { nm: 600, hue: 62, chroma: 0.14, light: 0.61, dark: 0.82 },
  { nm: 650, hue: 32, chroma: 0.17, light: 0.53, dark: 0.72 },
  { nm: 700, hue: 22, chroma: 0.18, light: 0.45, dark: 0.68 },
  { nm: 800, hue: 15, chroma: 0.07, light: 0.32, dark: 0.62 },
  { nm: 1000, hue: 15, chroma: 0.02, light: 0.4, dark: 0.75 },
];

/** @param {number} channel linear @returns {string} two hexadecimal digits */
function hex(channel) {
  const step = Math.round(255 * encoded(Math.min(Math.max(channel, 0), 1)));
  return step.toString(16).padStart(2, "0");
}

/** @param {number} lightness @param {number} chroma @param {number} hue degrees @returns {string} #rrggbb */
export function oklch(lightness, chroma, hue) {
  const a = chroma * Math.cos((hue * Math.PI) / 180);
  const b = chroma * Math.sin((hue * Math.PI) / 180);
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  const rgb = [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s,
  ];
  return `#${rgb.map(hex).join("")}`;
}

/**
 * @param {number} nm
 * @param {boolean} dark
 * @returns {string} #rrggbb
 */
export function wavelengthColor(nm, dark) {
  const first = /** @type {typeof ANCHORS[number]} */ (ANCHORS[0]);
  const last = /** @type {typeof ANCHORS[number]} */ (ANCHORS.at(-1));
  const at = ANCHORS.findIndex((a) => a.nm > nm);
  const [low, high] =
    at === 0 ? [first, first] : at < 0 ? [last, last] : [ANCHORS[at - 1], ANCHORS[at]];
  const from = low ?? first;
  const to = high ?? last;
  const part = to.nm > from.nm ? (nm - from.nm) / (to.nm - from.nm) : 0;
  /** @param {'hue' | 'chroma' | 'light' | 'dark'} key */
  const mix = (key) => from[key] + part * (to[key] - from[key]);
  return oklch(mix(dark ? "dark" : "light"), mix("chroma"), mix("hue"));
}

const DASHES = ["dot", "dash", "solid", "dashdot", "longdash", "longdashdot"];

/** A dash for each of several wavelengths, in their order. @param {number} index */
export function wavelengthDash(index) {
  return DASHES[index % DASHES.length] ?? "solid";
}

/** A name for the color's CSS custom property. @param {number} nm */
export function wavelengthProperty(nm) {
  return `--nm-${String(nm).replace(/\W/g, "_")}`;
}

/** A wavelength as it is written in a table. @param {number} nm */
export function wavelength(nm) {
  if (nm >= 1e6) return `${plain(nm / 1e6, 3)}\u00a0mm`;
  if (nm >= 10_000) return `${plain(nm / 1e3, 3)}\u00a0µm`;
  return `${plain(nm, nm < 1000 ? 3 : 4)}\u00a0nm`;
}

/** From where to where, with the unit once where it is the same. @param {readonly [number, number]} range */
export function stretch([low, high]) {
  if (low === high) return wavelength(low);
  const [a, b] = [wavelength(low), wavelength(high)];
  const [number = "", unit] = a.split("\u00a0");
  return unit === b.split("\u00a0")[1] ? `${number}–${b}` : `${a} – ${b}`;
}

/** A wavelength below this, in nm, is most likely one in µm, as the server holds too. */
const SHORTEST_NM = 10;

/** And below this one in m. */
const LONGEST_M = 1e-4;

/** @param {number | null} nm @returns {string} the question whether it was meant in µm or m, else nothing */
export function inMicrometers(nm) {
  return nm !== null && nm > 0 && nm < SHORTEST_NM
    ? `in nm: did you mean ${plain((nm < LONGEST_M ? 1e9 : 1e3) * nm, 10)}?`
    : "";
}
