/**
 * The cells of a heat map as a picture of one pixel each, a tenth of what Plotly needs for its own.
 * Plotly's `<image>` covers exactly the cells, so that the picture only has to be put in its place.
 */

/** @typedef {import("./colors.js").Scale} Scale */

const SHADES = 256;
const XLINK = "http://www.w3.org/1999/xlink";

/**
 * The colours from one end of a scale to the other.
 * @param {CanvasRenderingContext2D} context
 * @param {readonly [number, string][]} stops
 * @returns {Uint32Array} a pixel for each shade
 */
function shades(context, stops) {
  const gradient = context.createLinearGradient(0, 0, SHADES, 0);
  for (const [at, color] of stops) gradient.addColorStop(at, color);
  context.canvas.width = SHADES;
  context.canvas.height = 1;
  context.fillStyle = gradient;
  context.fillRect(0, 0, SHADES, 1);
  return new Uint32Array(context.getImageData(0, 0, SHADES, 1).data.buffer);
}

/** @returns {(z: readonly (readonly (number | null)[])[], scale: Scale, stops: readonly [number, string][]) => string} */
export function createCells() {
  const canvas = document.createElement("canvas");
  const context = canvas.getContext("2d", { willReadFrequently: true });
  return (z, { low, high }, stops) => {
    if (!context) return "";
    const colors = shades(context, stops);
    const [rows, columns] = [z.length, z[0]?.length ?? 0];
    canvas.width = columns;
    canvas.height = rows;
    const picture = context.createImageData(columns, rows);
    const pixels = new Uint32Array(picture.data.buffer);
    const unit = (SHADES - 1) / (high - low || 1);
    z.forEach((row, index) => {
      // The first row is the lowest.
      const start = (rows - 1 - index) * columns;
      row.forEach((value, column) => {
        if (value === null) return;
        const shade = Math.round((value - low) * unit);
        pixels[start + column] = colors[Math.min(Math.max(shade, 0), SHADES - 1)] ?? 0;
      });
    });
    context.putImageData(picture, 0, 0);
    return canvas.toDataURL();
  };
}

/**
 * Put a picture in place of Plotly's.
 * @param {HTMLElement} plot where Plotly has drawn a heat map
 * @param {string} url
 * @returns {boolean} whether there was one to replace
 */
export function putCells(plot, url) {
  const image = plot.querySelector(".heatmaplayer image");
  if (!(image instanceof SVGImageElement) || url === "") return false;
  image.style.imageRendering = "pixelated";
  image.setAttributeNS(XLINK, "xlink:href", url);
  return true;
}
