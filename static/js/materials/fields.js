/** The state that the Materials view adds to the one all views share. */

import { choice, LinkError, number, optional } from "../state/state.js";
import { text } from "../state/text.js";
import { useFields } from "../takeaway/use.js";
import { COLUMNS } from "./columns.js";
import { COVER_N, COVERS } from "./covered.js";

/** The wavelengths of Shirley's figure of copper, in nm. */
export const SHIRLEY_NM = Object.freeze([400, 500, 600, 700, 800]);
/** Where wavelengths are looked at: from the far ultraviolet to radio, whatever a source covers. */
const NM = { minimum: 1, maximum: 1e9 };
const MOST_WAVELENGTHS = 12;

/** Several wavelengths; null stands for those of Shirley's figure that the material covers. @returns {Field} */
export function wavelengths() {
  const one = number({ default: null, ...NM });
  return {
    default: null,
    parse(text) {
      const values = text
        .split(/[\s,;]+/)
        .filter(Boolean)
        .map((part) => one.parse(part));
      const distinct = [...new Set(values)].sort((a, b) => a - b);
      if (distinct.length === 0) throw new LinkError("allowed are wavelengths in nm");
      if (distinct.length > MOST_WAVELENGTHS)
        throw new LinkError(`at most ${MOST_WAVELENGTHS} wavelengths`);
      return Object.freeze(distinct);
    },
    print: (value) => value?.join(",") ?? "",
  };
}

/** @param {Catalog} catalog @returns {Record<string, Field>} */
export function materialFields({ materials }) {
  const categories = [...new Set(materials.map((m) => m.category))];
  return {
    preset: optional(() => materials.map((m) => m.id)),
    find: text((given) => given.length <= 100, "it is too long", ""),
    category: choice("all", ["all", ...categories]),
    of_kind: choice("all", ["all", "spectrum", "single"]),
    list_by: choice("match", ["match", ...COLUMNS.map((c) => c.name)]),
    list_order: choice("up", ["up", "down"]),
    at_nm: number({ default: null, ...NM }),
    nm: wavelengths(),
    plot_of: choice("nk", ["nk", "F0"]),
    reach: choice("visible", ["visible", "all"]),
    lambda_axis: choice("linear", ["linear", "log"]),
    rivals: choice("shown", ["shown", "hidden"]),
    beside: optional(() => materials.filter((m) => m.kind === "spectrum").map((m) => m.id)),
    map_of: choice("R", ["R", "Rs", "Rp"]),
    gamut: choice("scaled", ["scaled", "clamped", "unclamped"]),
    illuminant: choice("D65", ["D65", "E"]),
    cover: choice("coat", Object.keys(COVERS)),
    cover_n: number({ default: 1.5, ...COVER_N }),
    ...useFields(),
  };
}
