/** The bar that shows how the energy splits at the surface. */

import { percent } from "../numbers/format.js";
import { h, setText } from "../page/dom.js";

export function createSplit() {
  const reflected = h("div");
  const bar = h("div", { class: "split-bar", "aria-hidden": "true" }, reflected);
  const left = h("b", {});
  const right = h("b", {});
  const rest = h("span", {}, "transmitted");
  const element = h(
    "div",
    { class: "split" },
    bar,
    h(
      "p",
      { class: "split-text" },
      h("span", {}, "reflected ", left),
      h("span", {}, right, " ", rest),
    ),
  );
  return {
    element,
    /** @param {number} share reflected @param {number} passed @param {boolean} absorbing */
    update(share, passed, absorbing) {
      bar.style.setProperty("--share", String(share));
      setText(left, percent(share));
      setText(right, percent(passed));
      setText(rest, absorbing ? "into the absorber" : "transmitted");
    },
  };
}
