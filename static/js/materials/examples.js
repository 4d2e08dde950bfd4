/** Figures of the sources, one click each. */

/** @typedef {{title: string, source: string, state: State, show: string}} Example */

/** @type {Example[]} `show` is the class of the figure that is meant */
export const EXAMPLES = [
  {
    title: "Copper at 400 to 800 nm",
    source: "Shirley",
    state: { preset: "Cu", nm: null, at_nm: null },
    show: "angles",
  },
  {
    title: "Glass: one float will do",
    source: "Shirley",
    state: { preset: "BK7", nm: null, at_nm: null },
    show: "two-schlicks",
  },
  {
    title: "Gold: it takes RGB",
    source: "Shirley",
    state: { preset: "Au", nm: null, at_nm: null },
    show: "two-schlicks",
  },
];

/** @param {Example} example @param {State} state */
export const isShown = (example, state) =>
  Object.entries(example.state).every(([key, value]) => state[key] === value);
