/**
 * Plotly's name of a dash as SVG's `stroke-dasharray`, for lines drawn beside a plot.
 * @param {string | undefined} dash
 * @param {number} width of the line in px
 */
export function dashArray(dash, width) {
  const unit = Math.max(width, 3);
  /** @type {Record<string, number[]>} */
  const named = {
    dot: [1, 1],
    dash: [3, 3],
    longdash: [5, 5],
    dashdot: [3, 1, 1, 1],
    longdashdot: [5, 2, 1, 2],
  };
  if (!dash || dash === "solid") return null;
  const pattern = named[dash];
  return pattern ? pattern.map((length) => length * unit).join(" ") : dash.replace(/px/gu, "");
}
