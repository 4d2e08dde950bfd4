/**
 * The words the plot modules share.
 *
 * @typedef {object} Trace
 * @property {string} id
 * @property {string} label may hold symbols such as `R_s`
 * @property {number[]} x
 * @property {(number | null)[]} y `null` is a gap
 * @property {string} color name of a CSS custom property, such as `--Rs`
 * @property {string} [dash] Plotly's: solid, dash, dot, dashdot, longdash, or lengths in px
 * @property {number} [width] px
 * @property {string} [unit] written behind a value
 * @property {"y" | "y2"} [axis]
 * @property {string} [column] heading in the CSV file, `id` when missing
 * @property {boolean} [bare] whether no name stands at it, because another curve's says it too
 *
 * @typedef {{x: number, label: string, kind: "landmark" | "current"}} Mark
 *
 * @typedef {object} Axis
 * @property {string} title
 * @property {readonly number[] | null} [range] `null` follows the data
 * @property {readonly number[] | {values: readonly number[], text: readonly string[]}} [ticks]
 * @property {string} [unit] `°` is written at each tick, others belong in the title
 * @property {string} [column] heading of x in the CSV file
 * @property {string} [short] its symbol, where it is named beside a value
 * @property {number} [labels] least room for the labels of its ticks in px, so that frames of several plots align
 * @property {{step: number, fine: number, page: number}} [steps] of the keyboard
 * @property {"log"} [scale] of x alone: equal ratios stand equally far apart
 *
 * @typedef {object} Band what several curves span, behind them all
 * @property {string} id
 * @property {readonly number[]} x
 * @property {readonly (number | null)[]} low
 * @property {readonly (number | null)[]} high
 * @property {string} color name of a CSS custom property
 *
 * @typedef {{width: number, height: number}} Size
 * @typedef {{left: number, right: number, top: number, bottom: number}} Margins
 * @typedef {{value: number, label: string}} Tick
 * @typedef {{id: string, y: number | null}} Point
 * @typedef {{id: string, x: number, y: number}} PlacedLabel centre of the label in px
 */

export {};
