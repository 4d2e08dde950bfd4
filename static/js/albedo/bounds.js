/** From and to: the ends of an axis, in boxes; an empty box leaves its end to the page. */

import { evaluate } from "../numbers/entry.js";
import { plain } from "../numbers/format.js";
import { h, setText, symbol } from "../page/dom.js";

/**
 * @param {object} options
 * @param {string} options.letter symbol of the axis
 * @param {[string, string]} options.names of the two ends in the state
 * @param {(patch: Record<string, number | null>) => void} options.onChange
 */
export function createBounds({ letter, names, onChange }) {
  const wrong = h("p", { class: "row-error", role: "alert" });
  const name = h("span", {}, symbol(letter));
  const boxes = names.map((key, end) => {
    const box = h("input", {
      class: "box end-box",
      type: "text",
      autocomplete: "off",
      spellcheck: "false",
      "aria-label": `${letter} ${end === 0 ? "from" : "to"}`,
    });
    box.addEventListener("change", () => {
      const text = box.value.trim();
      try {
        const value = text === "" ? null : evaluate(text);
        setText(wrong, "");
        box.removeAttribute("aria-invalid");
        onChange({ [key]: value });
      } catch (problem) {
        box.setAttribute("aria-invalid", "true");
        setText(wrong, `“${text}”: ${problem instanceof Error ? problem.message : problem}`);
      }
    });
    return box;
  });
  const element = h("div", { class: "ends" }, name, boxes[0], "to", boxes[1], wrong);
  let shown = letter;
  return {
    element,
    /** @param {readonly number[]} range @param {string} [nextLetter] */
    update(range, nextLetter = letter) {
      if (nextLetter !== shown) {
        shown = nextLetter;
        name.replaceChildren(symbol(nextLetter));
        boxes.forEach((box, end) => {
          box.setAttribute("aria-label", `${nextLetter} ${end === 0 ? "from" : "to"}`);
        });
      }
      boxes.forEach((box, end) => {
        if (document.activeElement !== box) box.value = plain(range[end] ?? 0);
      });
    },
  };
}
