/** What several curves span, behind them all. */

/** How much of the page shows through a band. */
const BAND_OPACITY = 0.16;

/**
 * Bands as closed paths below the curves, a piece for each stretch without gaps.
 * @param {readonly Band[]} bands
 * @param {Theme} theme
 */
export function bandShapes(bands, theme) {
  return bands.flatMap(({ x, low, high, color }) => {
    /** @type {number[][]} */
    const pieces = [[]];
    x.forEach((_, i) => {
      if (low[i] === null || high[i] === null) pieces.push([]);
      else pieces.at(-1)?.push(i);
    });
    return pieces
      .filter((piece) => piece.length > 1)
      .map((piece) => {
        const there = piece.map((i) => `${x[i]},${high[i]}`);
        const back = [...piece].reverse().map((i) => `${x[i]},${low[i]}`);
        return {
          type: "path",
          path: `M${[...there, ...back].join("L")}Z`,
          xref: "x",
          yref: "y",
          layer: "below",
          fillcolor: theme.color(color),
          opacity: BAND_OPACITY,
          line: { width: 0 },
        };
      });
  });
}
