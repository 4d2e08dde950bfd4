/** The keys, at a glance. */

import { h } from "./dom.js";
import { html, render } from "./lit.js";
import { loadStyles } from "./style.js";

const CONTROL = /Mac|iPhone|iPad/.test(navigator.platform) ? "⌘" : "Ctrl";

/** @type {[string, [string[], string][]][]} */
const KEYS = [
  [
    "Everywhere",
    [
      [[CONTROL, "K"], "find a view, a medium, a model or a formula"],
      [[CONTROL, "Z"], "undo the last change"],
      [[CONTROL, "Shift", "Z"], "redo it"],
      [["?"], "these keys"],
      [["Esc"], "close what is open"],
    ],
  ],
  [
    "Sliders, the ray, a plot’s marker",
    [
      [["←", "→"], "a step"],
      [["Shift", "←", "→"], "a finer step"],
      [["PageUp", "PageDown"], "a coarser step"],
      [["Home", "End"], "to either end"],
    ],
  ],
  [
    "Number boxes",
    [
      [["↑", "↓"], "a step"],
      [["Enter"], "take what is written; 1/1.5 works too"],
      [["Esc"], "leave the value as it was"],
    ],
  ],
  [
    "Pointer",
    [
      [["Alt", "drag"], "without snapping to Brewster’s and the critical angle"],
      [["double click"], "a slider back to its default"],
    ],
  ],
];

export async function openHelp() {
  await loadStyles("dialog");
  const close = () => dialog.close();
  const dialog = h("dialog.dialog.help", { "aria-labelledby": "help-title" });
  render(
    html`<header>
        <h2 id="help-title">Keys</h2>
        <button type="button" class="quiet" autofocus @click=${close}>Close</button>
      </header>
      ${KEYS.map(
        ([title, keys]) => html`<section>
          <h3>${title}</h3>
          <dl>${keys.map(
            ([names, does]) => html`<div>
              <dt>${names.map((name) => html`<kbd>${name}</kbd>`)}</dt>
              <dd>${does}</dd>
            </div>`,
          )}</dl>
        </section>`,
      )}`,
    dialog,
  );
  dialog.addEventListener("click", (event) => {
    if (event.target === dialog) close();
  });
  dialog.addEventListener("close", () => dialog.remove());
  document.body.append(dialog);
  dialog.showModal();
}
