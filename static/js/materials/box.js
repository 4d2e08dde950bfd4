/** A box for wavelengths: read when it is left, and what cannot be read is said below it. */

import { ExpressionError } from "../numbers/expression.js";
import { h, setText } from "../page/dom.js";
import { LinkError } from "../state/state.js";

/**
 * @param {object} options
 * @param {string} options.id
 * @param {string} [options.name] what stands before the text that cannot be read
 * @param {(text: string) => any} options.parse
 * @param {(value: any) => void} options.onValue null where nothing was written
 */
export function createBox({ id, name = "", parse, onValue }) {
  const error = h("p", { class: "row-error", id: `${id}-error`, role: "alert" });
  const input = h("input", {
    class: `box ${id}`,
    type: "text",
    id,
    autocomplete: "off",
    spellcheck: "false",
    "aria-describedby": `${id}-error`,
  });
  input.addEventListener("change", () => {
    const text = input.value.trim();
    try {
      setText(error, "");
      onValue(text === "" ? null : parse(text));
    } catch (problem) {
      if (!(problem instanceof ExpressionError || problem instanceof LinkError)) throw problem;
      setText(error, `${name}“${text}”: ${problem.message}.`);
    }
  });
  return {
    input,
    error,
    /** @param {string} text what is being written is left alone */
    update(text) {
      if (document.activeElement !== input || !input.value) input.value = text;
    },
  };
}
