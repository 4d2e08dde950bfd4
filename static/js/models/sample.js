/** A short piece of a curve, as keys beside names. */

const SVG = "http://www.w3.org/2000/svg";
const WIDTH = 26;

/** @type {Record<string, string>} */
const DASHES = {
  solid: "",
  dash: "7 4",
  dot: "2 3",
  dashdot: "7 3 2 3",
  longdash: "11 4",
  longdashdot: "11 3 2 3",
};

/** @param {{color: string, dash: string}} style @returns {SVGSVGElement} */
export function sample({ color, dash }) {
  const svg = document.createElementNS(SVG, "svg");
  svg.setAttribute("class", "sample");
  svg.setAttribute("viewBox", `0 0 ${WIDTH} 8`);
  svg.setAttribute("aria-hidden", "true");
  const line = document.createElementNS(SVG, "path");
  line.setAttribute("d", `M0 4H${WIDTH}`);
  line.style.stroke = `var(${color})`;
  line.style.strokeDasharray = DASHES[dash] ?? dash;
  svg.append(line);
  return svg;
}
