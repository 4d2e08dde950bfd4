/** Boxes to type in, alone or as the two ends of an axis, and the words that say why something cannot be taken. */

import { evaluate } from "../numbers/expression.js";
import { plain } from "../numbers/format.js";
import { createChanged } from "../page/changed.js";
import { h, setText, symbol } from "../page/dom.js";

/**
 * @template T
 * @param {object} options
 * @param {Record<string, unknown>} options.attributes of the box
 * @param {(text: string) => T} options.parse throws what is wrong
 * @param {(value: T) => void} options.onChange
 * @param {string} [options.id] of the place where it is said what is wrong
 * @param {string} [options.name] of the box, where several share a place for what is wrong
 * @param {HTMLElement} [options.wrong] that place
 * @param {(text: string, why: string) => string} [options.words] what is said there
 */
export function createTyped({
  attributes,
  parse,
  onChange,
  id,
  name,
  wrong,
  words = (text, why) => `${name ? `${name}, ` : ""}“${text}”: ${why}`,
}) {
  const box = h("input", {
    type: "text",
    autocomplete: "off",
    spellcheck: "false",
    "aria-describedby": id,
    ...attributes,
  });
  const said = wrong ?? h("p.row-error", { role: "alert", id });
  box.addEventListener("change", () => {
    const text = box.value.trim();
    try {
      const value = parse(text);
      setText(said, "");
      box.removeAttribute("aria-invalid");
      onChange(value);
    } catch (problem) {
      box.setAttribute("aria-invalid", "true");
      setText(said, words(text, problem instanceof Error ? problem.message : String(problem)));
    }
  });
  return {
    box,
    wrong: said,
    /** @param {string} text that stands in the box unless somebody is typing there */
    update(text) {
      if (document.activeElement !== box) box.value = text;
    },
  };
}

/**
 * From and to: the ends of an axis; an empty box leaves its end to the page.
 * @param {object} options
 * @param {string} options.letter symbol of the axis
 * @param {[string, string]} options.names of the two ends in the state
 * @param {(patch: Record<string, number | null>) => void} options.onChange
 * @param {Pick<Parameter, "minimum" | "maximum">} [options.bounds] of what is refused here and not by the server
 * @param {HTMLElement} [options.wrong] where several axes share the place for what is wrong
 */
export function createEnds({ letter, names, onChange, bounds, wrong }) {
  /** @param {string} text */
  function parse(text) {
    const value = text === "" ? null : evaluate(text);
    if (value !== null && bounds && (value < bounds.minimum || value > bounds.maximum))
      throw new Error(`allowed is ${plain(bounds.minimum)} to ${plain(bounds.maximum)}`);
    return value;
  }
  const said = wrong ?? h("p.row-error", { role: "alert" });
  const ends = names.map((key, end) =>
    createTyped({
      attributes: { class: "box end-box" },
      parse,
      onChange: (value) => onChange({ [key]: value }),
      wrong: said,
      name: wrong && `${letter} ${end === 0 ? "from" : "to"}`,
    }),
  );
  const name = h("span");
  const [from, to] = ends;
  const element = h("div.ends", name, from?.box, "to", to?.box, !wrong && said);
  const changed = createChanged();
  return {
    element,
    /** @param {readonly number[]} range @param {string} [shown] the symbol of another axis */
    update(range, shown = letter) {
      if (changed(shown)) name.replaceChildren(symbol(shown));
      ends.forEach(({ box, update }, end) => {
        box.ariaLabel = `${shown} ${end === 0 ? "from" : "to"}`;
        update(plain(range[end] ?? 0));
      });
    },
  };
}
