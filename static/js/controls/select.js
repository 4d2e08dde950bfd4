/** One of some, from a list that opens. */

import { createChanged } from "../page/changed.js";
import { h } from "../page/dom.js";

/** @typedef {{[value: string]: string | Options}} Options words by value; a group of options has a name and options */

/** @param {Readonly<Options>} options @returns {HTMLElement[]} */
const made = (options) =>
  Object.entries(options).map(([value, words]) =>
    typeof words === "string"
      ? h("option", { value }, words)
      : h("optgroup", { label: value }, ...made(words)),
  );

/**
 * @param {string} label
 * @param {(value: string) => void} onChange
 * @param {Readonly<Options>} [options] where they are always the same
 */
export function createSelect(label, onChange, options = {}) {
  const select = h(
    "select.preset",
    { "aria-label": label, onchange: () => onChange(select.value) },
    ...made(options),
  );
  const changed = createChanged();
  return {
    element: h("span.picker", select),
    /** @param {string} value @param {Readonly<Options>} [offered] */
    update(value, offered) {
      if (offered && changed(JSON.stringify(offered))) select.replaceChildren(...made(offered));
      select.value = value;
    },
  };
}
