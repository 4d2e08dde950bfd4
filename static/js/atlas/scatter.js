/**
 * Materials as points over what they are, at the height of their error, on the plots' core. Some carry
 * their names; the pointer, or arrow keys on the handle, names any other, and Enter, like a click, takes it.
 */

import { createMeasure, overlap, plainText } from "../draw/svg.js";
import { h } from "../page/dom.js";
import { arrange } from "../plot/arrange.js";
import { captioned, imageOf, PRINT_PADDING, published } from "../plot/export.js";
import { createHost, library } from "../plot/figure.js";
import { CONFIG, plotlyLayout } from "../plot/plotly.js";

/**
 * @typedef {{id: string, name: string, kind: string, x: number, y: number, words: string,
 *   rank: number}} Spot `y` is a decimal logarithm; those of the lowest rank are named first
 * @typedef {{name: string, x: Axis, y: Axis, color: string, line: number, at: string | null, ids: readonly string[]}} Look
 *   `color` is a custom property, `line` the height of what counts as small, `ids` are of the models
 */

/** By kind: what is drawn, and its sign in the key. */
export const SYMBOLS = {
  clear: { symbol: "circle-open", sign: "○" },
  absorbing: { symbol: "diamond-open", sign: "◇" },
  metal: { symbol: "circle", sign: "●" },
};

const NEAR = 18; // px from a point within which it is meant
const ROOM = 46; // px of a figure's width and height for each name
const LINE = 15;
const APART = 3;

/** @param {HTMLElement} element @param {{filename: string, onPick: (id: string) => void, csv: () => Promise<Blob>}} options */
export function createScatter(element, { filename, onPick, csv }) {
  const host = createHost(element, () => void settle());
  const { area, canvas } = host;
  element.classList.add("scatter");
  const handle = h("div.map-handle", { tabindex: "0", role: "slider" });
  const tip = h("div.map-tip", { hidden: true, "aria-hidden": "true" });
  area.append(handle, tip);
  /** @type {readonly Spot[]} by what they are, so that keys go from left to right */
  let spots = [];
  /** @type {Look} */
  let look = {
    name: "",
    x: { title: "" },
    y: { title: "" },
    color: "--R",
    line: 0,
    at: null,
    ids: [],
  };
  /** @type {Arrangement | null} */
  let arrangement = null;

  const axes = () => ({ x: look.x, y: look.y, y2: null });

  /** @param {Size} size @param {Theme} theme @param {{header?: number, padding?: number}} [around] */
  function arranged(size, theme, around = {}) {
    const measure = createMeasure(theme, 12);
    const { unit } = theme;
    return arrange({ size, axes: axes(), traces: [], measure, marksRow: false, unit, ...around });
  }

  /** @param {Arrangement} layout @param {Spot} spot */
  const placed = (layout, { x, y }) => ({ left: layout.xPixel(x), top: layout.yPixel(y) });

  /** Names that have room, the chosen material's first. @param {Arrangement} layout @param {Theme} theme */
  function names(layout, theme) {
    const measure = createMeasure(theme, 11);
    const { frame } = layout;
    const most = Math.round((frame.width * frame.height) / (ROOM * ROOM * 4));
    /** @param {Spot} spot */
    const rank = (spot) => (spot.id === look.at ? -1 : spot.rank);
    const wanted = spots.filter((s) => Number.isFinite(rank(s))).sort((a, b) => rank(a) - rank(b));
    /** @type {(Box & {spot: Spot})[]} */
    const boxes = [];
    const said = new Set();
    for (const spot of wanted) {
      if (boxes.length >= most) break;
      if (said.has(spot.name)) continue;
      const { left, top } = placed(layout, spot);
      const width = measure(spot.name) + 2 * APART;
      const right = left + 6 + width > frame.x + frame.width;
      const x = right ? left - 6 - width : left + 6;
      const box = { x, y: top - LINE / 2, width, height: LINE, spot };
      const inside = box.y >= frame.y && box.y + LINE <= frame.y + frame.height && x >= frame.x;
      if (!inside || boxes.some((other) => overlap(other, box))) continue;
      boxes.push(box);
      said.add(spot.name);
    }
    return boxes.map(({ spot, x, y, width }) => ({
      text: plainText(spot.name),
      xref: "paper",
      yref: "paper",
      x: (x + width / 2 - frame.x) / frame.width,
      y: 1 - (y + LINE / 2 - frame.y) / frame.height,
      xanchor: "center",
      yanchor: "middle",
      showarrow: false,
      borderpad: 0,
      bgcolor: `${theme.paper}b8`, // points shine through, letters stand before them
      font: {
        size: 11 * theme.unit,
        color: spot.id === look.at ? theme.accent : theme.ink,
        family: theme.family,
      },
    }));
  }

  /** @param {Theme} theme @returns {Plotly.Trace[]} */
  function traces(theme) {
    const color = theme.color(look.color);
    const kinds = Object.entries(SYMBOLS).map(([kind, { symbol }]) => {
      const own = spots.filter((spot) => spot.kind === kind);
      return {
        type: /** @type {const} */ ("scatter"),
        mode: "markers",
        name: kind,
        x: own.map((spot) => spot.x),
        y: own.map((spot) => spot.y),
        hoverinfo: "skip",
        cliponaxis: false,
        marker: { symbol, size: 6 * theme.unit, color, opacity: 0.72, line: { width: 1.2, color } },
      };
    });
    const chosen = spots.filter((spot) => spot.id === look.at);
    return [
      ...kinds,
      {
        type: "scatter",
        mode: "markers",
        name: "chosen",
        x: chosen.map((spot) => spot.x),
        y: chosen.map((spot) => spot.y),
        hoverinfo: "skip",
        cliponaxis: false,
        marker: {
          symbol: "circle-open",
          size: 13 * theme.unit,
          color: theme.accent,
          line: { width: 2, color: theme.accent },
        },
      },
    ];
  }

  /** @param {Arrangement} layout @param {Theme} theme @returns {Plotly.Layout} */
  function bare(layout, theme) {
    const full = plotlyLayout(axes(), layout, theme);
    return {
      ...full,
      hovermode: false,
      shapes: [
        {
          type: "line",
          xref: "paper",
          x0: 0,
          x1: 1,
          y0: look.line,
          y1: look.line,
          line: { color: theme.accent, width: 1, dash: "dash" },
        },
      ],
      annotations: [...(full.annotations ?? []), ...names(layout, theme)],
    };
  }

  /** The figure to stand alone. @param {Size} size @param {Theme} theme @param {string} title @param {readonly string[]} [caption] @returns {Plotly.Figure} */
  function framed(size, theme, title, caption = []) {
    const layout = arranged(size, theme, title ? { header: 40 } : { padding: PRINT_PADDING });
    const drawn = bare(layout, theme);
    const below = captioned(caption, { ...layout, size }, 0, theme);
    return {
      data: traces(theme),
      layout: {
        ...drawn,
        height: size.height + below.height,
        annotations: [...(drawn.annotations ?? []), ...below.annotations],
        margin: { ...drawn.margin, b: layout.margins.bottom + below.height },
        title: title && {
          text: `<b>${title}</b>`,
          x: 0.01,
          xanchor: "left",
          font: { size: 16, color: theme.ink },
        },
        paper_bgcolor: theme.paper,
        plot_bgcolor: theme.paper,
      },
      config: { ...CONFIG, staticPlot: true },
    };
  }

  async function settle() {
    if (!window.Plotly) await library();
    const size = host.size();
    if (!size) return;
    const theme = host.theme();
    arrangement = arranged(size, theme);
    placeHandle();
    await Plotly.react(canvas, traces(theme), bare(arrangement, theme), CONFIG);
  }

  /** Where the keyboard stands: at the chosen material, else at the first. */
  let probe = 0;
  function placeHandle() {
    const spot = spots[probe];
    handle.toggleAttribute("data-away", !spot);
    handle.setAttribute("aria-label", `${look.name}, material`);
    handle.setAttribute("aria-valuemin", "0");
    handle.setAttribute("aria-valuemax", String(Math.max(spots.length - 1, 0)));
    handle.setAttribute("aria-valuenow", String(probe));
    handle.setAttribute("aria-valuetext", spot ? spot.words : "none");
    if (!spot || !arrangement) return;
    const { left, top } = placed(arrangement, spot);
    handle.style.transform = `translate(${left}px, ${top}px) translate(-50%, -50%)`;
  }

  /** @param {Spot | null} spot */
  function tell(spot) {
    tip.hidden = spot === null;
    area.classList.toggle("on-spot", spot !== null);
    if (!spot || !arrangement) return;
    tip.textContent = spot.words;
    const { left, top } = placed(arrangement, spot);
    const { frame } = arrangement;
    const before = left > frame.x + frame.width / 2;
    const under = top < frame.y + 40;
    tip.style.maxWidth = `${Math.max(before ? left - 14 : frame.x + frame.width - left - 6, 120)}px`;
    tip.style.transform = `translate(${left + (before ? -10 : 10)}px, ${top + (under ? 12 : -8)}px) translate(${before ? -100 : 0}%, ${under ? 0 : -100}%)`;
  }

  /** @param {MouseEvent} event @returns {number} place of the nearest point, -1 if none is near */
  function nearest(event) {
    if (!arrangement) return -1;
    const bounds = area.getBoundingClientRect();
    const [x, y] = [event.clientX - bounds.left, event.clientY - bounds.top];
    let [best, least] = [-1, NEAR * NEAR];
    for (const [index, spot] of spots.entries()) {
      const { left, top } = placed(arrangement, spot);
      const far = (left - x) ** 2 + (top - y) ** 2;
      if (far <= least) [best, least] = [index, far];
    }
    return best;
  }

  area.addEventListener("pointermove", (event) => tell(spots[nearest(event)] ?? null));
  area.addEventListener("pointerleave", () => tell(null));
  area.addEventListener("click", (event) => {
    const index = nearest(event);
    const spot = spots[index];
    if (!spot) return;
    probe = index;
    tell(spot);
    onPick(spot.id);
  });
  handle.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || spots.length === 0) return;
    const spot = spots[probe];
    if (spot && (event.key === "Enter" || event.key === " ")) {
      event.preventDefault();
      onPick(spot.id);
      return;
    }
    const far = event.shiftKey ? 10 : 1;
    const step = {
      ArrowRight: far,
      ArrowUp: far,
      ArrowLeft: -far,
      ArrowDown: -far,
      PageUp: 25,
      PageDown: -25,
      Home: -spots.length,
      End: spots.length,
    }[event.key];
    if (step === undefined) return;
    event.preventDefault();
    probe = Math.min(Math.max(probe + step, 0), spots.length - 1);
    placeHandle();
    tell(spots[probe] ?? null);
  });
  handle.addEventListener("blur", () => tell(null));

  return {
    /** @param {readonly Spot[]} next @param {Look} how */
    draw(next, how) {
      spots = [...next].sort((a, b) => a.x - b.x || a.y - b.y);
      look = how;
      probe = Math.max(
        spots.findIndex((spot) => spot.id === how.at),
        0,
      );
      element.setAttribute("aria-label", how.name);
      tell(null);
      return settle();
    },
    about: () => ({ name: look.name, ids: look.ids }),
    filename: (/** @type {string} */ format) => `${filename}.${format}`,
    /** @param {'png' | 'svg' | 'csv'} format @param {Publication} [publication] */
    exportAs(format, publication) {
      if (format === "csv") return csv();
      if (publication)
        return published(element, publication, format, ({ size, theme, caption }) =>
          framed(size, theme, "", caption),
        );
      return imageOf(framed({ width: 1200, height: 760 }, host.theme(), look.name), format);
    },
    theme: host.refresh,
    destroy: host.destroy,
  };
}
