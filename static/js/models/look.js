/** One colour and one dash for each model, the same in every view. */

const COLORS = 8;
const DASHES = [
  "dash",
  "dot",
  "dashdot",
  "longdash",
  "longdashdot",
  "8px 3px 2px 3px",
  "3px 6px",
  "12px 4px",
];

/**
 * The models that are often seen together keep a look that tells them apart, whatever else is
 * registered: d'Eon's figure has Schlick dashed, Pharr's form dot-dashed, the misunderstanding red.
 * @type {Record<string, [number, string]>}
 */
const OWN = {
  schlick: [1, "dash"],
  pharr_humphreys: [4, "dashdot"],
  complex_dielectric: [5, "12px 4px"],
  lazanyi2005: [2, "longdash"],
  schlick_tir: [3, "dashdot"],
  spherical_gaussian: [6, "dashdot"],
  generalized_schlick: [3, "longdash"],
  hoffman_f82: [4, "8px 3px 2px 3px"],
  f82_tint: [2, "dot"],
  one_minus_cos: [7, "dot"],
  cook_torrance: [7, "longdashdot"],
};

/** @param {readonly [number, string]} look */
const styled = ([color, dash]) => ({ color: `--model-${color}`, dash });

/**
 * @param {{id: string}[]} models in the order of the registry
 * @param {string} id
 * @returns {{color: string, dash: string}} a css custom property's name and a dash
 */
export function modelStyle(models, id) {
  if (id === "exact") return { color: "--R", dash: "solid" };
  const own = OWN[id];
  if (own) return styled(own);
  const taken = new Set(models.flatMap((m) => (OWN[m.id] ? [String(OWN[m.id])] : [])));
  let place = models.filter((m) => m.id !== "exact" && !OWN[m.id]).findIndex((m) => m.id === id);
  for (let i = 0; ; i += 1) {
    // After eight models the colours come again with another dash.
    const dash = DASHES[(i + Math.floor(i / COLORS)) % DASHES.length] ?? "dash";
    const look = /** @type {const} */ ([(i % COLORS) + 1, dash]);
    if (i < COLORS * DASHES.length && taken.has(String(look))) continue;
    if (place <= 0) return styled(look);
    place -= 1;
  }
}
