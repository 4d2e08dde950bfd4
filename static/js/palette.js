/** One colour and one dash for each model, the same in every view. */

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
 * @param {{id: string}[]} models in the order of the registry
 * @param {string} id
 * @returns {{color: string, dash: string}} a css custom property's name and a dash
 */
export function modelStyle(models, id) {
  if (id === "exact") return { color: "--R", dash: "solid" };
  const index = models.filter((m) => m.id !== "exact").findIndex((m) => m.id === id);
  const color = `--model-${(Math.max(0, index) % 8) + 1}`;
  // After eight models the colours come again with another dash.
  return { color, dash: DASHES[(index + Math.floor(index / 8)) % DASHES.length] ?? "dash" };
}
