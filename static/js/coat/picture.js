/** Where the light goes in glossy paint, as bands whose widths are its shares: geometry only. */

/**
 * @typedef {{surface: number, body: number, absorbed: number}} Split
 * @typedef {'incoming' | 'surface' | 'entering' | 'body' | 'absorbed'} BandName
 * @typedef {{name: BandName, points: [number, number][]}} Band corners in px
 * @typedef {{x: number, y: number}} Place
 * @typedef {{bands: Band[], surface: number, body: number, floor: number,
 *   labels: Record<'incoming' | 'surface' | 'body' | 'absorbed' | 'internal', Place>, loop: string, head: string}} Picture
 *   `loop` is the way of what is thrown back, `head` its arrow
 */

/** Shares of the picture's width. */
const BEAM = 0.2;
const START = 0.2; // where the light meets the surface
const AIR = 0.17; // how far a band leans while it crosses the air
const COAT = 0.15; // and the coat
const FLARE = 4; // px that an arrow's head is wider on each side
/** Shares of its height, below the line of labels. */
const SURFACE = 0.4;
const BODY = 0.68;

/**
 * A band that keeps its width measured along the surface; an arrow where it has a head.
 * @param {BandName} name
 * @param {[number, number]} from the two ends at its start
 * @param {number} lean how far it moves sideways
 * @param {number} top
 * @param {number} bottom where it ends; the head is the last part of the way
 * @param {boolean} [arrow]
 * @returns {Band}
 */
function band(name, [left, right], lean, top, bottom, arrow = false) {
  /** @type {Band["points"]} */
  const start = [
    [left, top],
    [right, top],
  ];
  if (!arrow) return { name, points: [...start, [right + lean, bottom], [left + lean, bottom]] };
  const way = Math.hypot(lean, bottom - top) || 1;
  const [dx, dy] = [lean / way, (bottom - top) / way];
  const half = (Math.abs(dy) * (right - left)) / 2;
  const wing = half + FLARE;
  const long = Math.min(wing * 1.2, 0.45 * way);
  const [x, y] = [(left + right) / 2 + lean, bottom];
  // Across the way, toward the side where the band's right end is.
  const turn = dy < 0 ? 1 : -1;
  /** @param {number} size @returns {[number, number]} where the head begins */
  const beside = (size) => [x - dx * long - turn * dy * size, y - dy * long + turn * dx * size];
  const head = [half, wing, -wing, -half].map(beside);
  return { name, points: [...start, ...head.slice(0, 2), [x, y], ...head.slice(2)] };
}

/**
 * @param {Split} split
 * @param {{width: number, height: number, line: number}} size `line` is the height of a line of text
 * @returns {Picture}
 */
export function coatPicture({ surface, body, absorbed }, { width, height, line }) {
  const sky = 2.6 * line; // two lines of text above the bands
  const ys = sky + (height - sky) * SURFACE;
  const yb = sky + (height - sky) * BODY;
  const beam = BEAM * width;
  const left = START * width;
  const right = left + beam;
  const entering = beam * (body + absorbed);
  const down = left + COAT * width;
  const split = down + beam * absorbed;
  /** @type {[number, number]} */
  const up = [split, split + beam * body];
  /** @type {[number, number]} */
  const exit = [up[0] + COAT * width, up[1] + COAT * width];
  const bottom = height - line * 0.3;

  /** @type {Band[]} */
  const bands = [
    band("incoming", [left - AIR * width, right - AIR * width], AIR * width, sky, ys),
    band("entering", [left, left + entering], COAT * width, ys, yb),
    band("surface", [right - beam * surface, right], AIR * width, ys, sky, surface > 0),
    band("absorbed", [down, down + beam * absorbed], 0, yb, bottom, absorbed > 0),
    band("body", up, COAT * width, yb, ys),
    band("body", exit, AIR * width, ys, sky, body > 0),
  ];
  const x = Math.min(0.85 * width, exit[1] + 0.13 * width);
  const [start, end] = [round(x - 0.05 * width), round(x + 0.05 * width)];
  const turn = round(ys - 0.1 * (yb - ys));
  return {
    bands: bands.filter(
      (b) => b.name === "incoming" || (b.points[1]?.[0] ?? 0) - (b.points[0]?.[0] ?? 0) > 0.02,
    ),
    surface: ys,
    body: yb,
    floor: height,
    labels: {
      incoming: { x: left + beam / 2 - AIR * width, y: line },
      surface: { x: right - (beam * surface) / 2 + AIR * width, y: line },
      body: { x: (exit[0] + exit[1]) / 2 + AIR * width, y: line },
      absorbed: { x: down + beam * absorbed + 0.5 * line, y: (yb + bottom) / 2 },
      internal: { x, y: yb + 1.3 * line },
    },
    loop: `M${start},${round(yb - 2)}C${start},${turn} ${end},${turn} ${end},${round(yb - 4)}`,
    head: `M${end - 4},${round(yb - 10)}L${end},${round(yb - 2)}L${end + 4},${round(yb - 10)}`,
  };
}

/** @param {number} value */
const round = (value) => Math.round(value * 10) / 10;

/** @param {Band} shape @returns {string} of an SVG path */
export function outline({ points }) {
  return `M${points.map(([x, y]) => `${round(x)},${round(y)}`).join("L")}Z`;
}
