/** The keys, at a glance. */

import { h } from "./dom.js";
import { loadStyle } from "./style.js";

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
  await loadStyle("css/dialog.css");
  const close = h("button.quiet", { type: "button", autofocus: true }, "Close");
  const dialog = h(
    "dialog.dialog.help",
    { "aria-labelledby": "help-title" },
    h("header", h("h2", { id: "help-title" }, "Keys"), close),
    ...KEYS.map(([title, keys]) =>
      h(
        "section",
        h("h3", title),
        h(
          "dl",
          ...keys.map(([names, does]) =>
            h("div", h("dt", ...names.map((name) => h("kbd", name))), h("dd", does)),
          ),
        ),
      ),
    ),
  );
  close.addEventListener("click", () => dialog.close());
  dialog.addEventListener("click", (event) => {
    if (event.target === dialog) dialog.close();
  });
  dialog.addEventListener("close", () => dialog.remove());
  document.body.append(dialog);
  dialog.showModal();
}
