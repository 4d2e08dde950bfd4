/** Figures of the sources, one click each. */

import { h } from "../page/dom.js";

/**
 * @typedef {{id: string, title: string, source: string, state: State, show: string}} Example
 */

/** @type {Example[]} `show` is the class of the figure that is meant */
export const EXAMPLES = [
  {
    id: "copper",
    title: "Copper at 400 to 800 nm",
    source: "Shirley",
    state: { preset: "Cu", nm: null, at_nm: null },
    show: "angles",
  },
  {
    id: "glass",
    title: "Glass: one float will do",
    source: "Shirley",
    state: { preset: "BK7", nm: null, at_nm: null },
    show: "two-schlicks",
  },
  {
    id: "gold",
    title: "Gold: it takes RGB",
    source: "Shirley",
    state: { preset: "Au", nm: null, at_nm: null },
    show: "two-schlicks",
  },
];

/**
 * @param {object} options
 * @param {(state: State) => void} options.onShow
 * @param {(name: string) => void} options.onReveal
 */
export function createExamples({ onShow, onReveal }) {
  const buttons = EXAMPLES.map((example) => ({
    example,
    button: h(
      "button",
      {
        type: "button",
        class: "example",
        "aria-pressed": "false",
        onclick: () => {
          onShow(example.state);
          onReveal(example.show);
        },
      },
      h("b", {}, example.title),
      " ",
      h("span", {}, example.source),
    ),
  }));
  return {
    element: h(
      "div",
      { class: "material-examples", role: "group", "aria-label": "Figures of the sources" },
      ...buttons.map((b) => b.button),
    ),
    /** @param {State} state */
    update(state) {
      for (const { example, button } of buttons)
        button.setAttribute(
          "aria-pressed",
          String(Object.entries(example.state).every(([key, value]) => state[key] === value)),
        );
    },
  };
}
