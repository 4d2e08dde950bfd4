/** States worth a look, such as the figures of the sources, one click each. */

import { h } from "../page/dom.js";
import { html, render } from "../page/lit.js";
import { loadStyles } from "../page/style.js";

await loadStyles("examples");

/**
 * @template {{title: string, source: string}} Example
 * @param {object} options
 * @param {readonly Example[]} options.examples
 * @param {string} options.name of their class
 * @param {string} options.label
 * @param {(example: Example) => void} options.onShow
 * @param {(example: Example, state: State) => boolean} options.isShown
 */
export function createExamples({ examples, name, label, onShow, isShown }) {
  const element = h("div", { class: `example-row ${name}`, role: "group", "aria-label": label });
  return {
    element,
    /** @param {State} state */
    update(state) {
      const button = (/** @type {Example} */ example) =>
        html`<button type="button" class="example" aria-pressed=${isShown(example, state)}
          @click=${() => onShow(example)}><b>${example.title}</b> <span>${example.source}</span></button>`;
      render(examples.map(button), element);
    },
  };
}
