/** The map of colors as a file: a picture with its axes and what it is of, or every cell in numbers. */

import { svg } from "../draw/svg.js";
import { fontFaces, rasterized, withStyle } from "../plot/image.js";

/**
 * @typedef {import('./map.js').ColorMap} ColorMap
 * @typedef {readonly {share: number, text: string}[]} Ticks
 */

const LEFT = 56;
const TOP = 36;
const [WIDTH, HEIGHT] = [640, 400]; // of the map, px
const SIZE = { width: LEFT + WIDTH + 24, height: TOP + HEIGHT + 76 };

/** @param {ColorMap} map @returns {string} */
function csv({ thickness_nm, theta_i_deg, colors }) {
  const names = colors.flatMap(({ model, delta_e }) => [
    ...["red", "green", "blue", "L", "a", "b"].map((name) => `${model}.${name}`),
    ...(delta_e ? [`${model}.delta_e`] : []),
    `${model}.hex`,
  ]);
  const rows = thickness_nm.flatMap((nm, i) =>
    theta_i_deg.map((deg, j) => {
      const cells = colors.flatMap(({ linear_srgb, lab, delta_e, hex }) => [
        ...(linear_srgb[i]?.[j] ?? []),
        ...(lab[i]?.[j] ?? []),
        ...(delta_e ? [delta_e[i]?.[j] ?? ""] : []),
        hex[i]?.[j] ?? "",
      ]);
      return [nm, deg, ...cells].join(",");
    }),
  );
  return `${[["thickness_nm", "theta_i_deg", ...names].join(","), ...rows].join("\r\n")}\r\n`;
}

/**
 * @param {'png' | 'svg' | 'csv'} format
 * @param {HTMLCanvasElement} canvas
 * @param {ColorMap} map
 * @param {{x: Ticks, y: Ticks, title: string, caption: string}} words
 * @returns {Promise<Blob>}
 */
export async function mapFile(format, canvas, map, { x, y, title, caption }) {
  if (format === "csv") return new Blob([csv(map)], { type: "text/csv;charset=utf-8" });
  const style = getComputedStyle(canvas);
  const [paper, ink] = ["--paper", "--ink"].map((name) => style.getPropertyValue(name));
  const root = svg("svg", {
    ...SIZE,
    viewBox: `0 0 ${SIZE.width} ${SIZE.height}`,
    "font-family": style.fontFamily,
    "font-size": 13,
    fill: ink ?? "",
  });
  const box = { x: LEFT, y: TOP, width: WIDTH, height: HEIGHT };
  svg("rect", { width: SIZE.width, height: SIZE.height, fill: paper ?? "" }, root);
  const href = canvas.toDataURL("image/png");
  svg("image", { ...box, href, preserveAspectRatio: "none" }, root);
  svg("rect", { ...box, fill: "none", stroke: ink ?? "" }, root);
  /** @param {string} text @param {Record<string, string | number>} place */
  const write = (text, place) => {
    svg("text", place, root).textContent = text;
  };
  const below = TOP + HEIGHT;
  for (const { share, text } of x)
    write(text, { x: LEFT + share * WIDTH, y: below + 18, "text-anchor": "middle" });
  for (const { share, text } of y)
    write(text, { x: LEFT - 8, y: below - share * HEIGHT + 4, "text-anchor": "end" });
  write("angle of incidence", { x: 8, y: 18 });
  write(title, { x: LEFT + WIDTH / 2, y: below + 38, "text-anchor": "middle" });
  write(caption, { x: LEFT, y: below + 62, "font-size": 11 });
  const source = new XMLSerializer().serializeToString(root);
  const whole = withStyle(source, await fontFaces(style.fontFamily));
  const blob = new Blob([whole], { type: "image/svg+xml;charset=utf-8" });
  return format === "svg" ? blob : rasterized(blob, 2 * SIZE.width, 2 * SIZE.height);
}
