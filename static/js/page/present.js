/** Present: a view alone, in large type. The address says so, and a link opens it. */

import { h } from "./dom.js";
import { loadStyles } from "./style.js";

/** @param {() => void} leave @returns {Promise<(on: boolean) => void>} what shows the way back, or hides it */
export async function createPresent(leave) {
  const back = h(
    "button.quiet.leave-present",
    { type: "button", "aria-keyshortcuts": "Escape", hidden: true, onclick: leave },
    "Leave",
  );
  await loadStyles("present");
  // What was drawn before has its letters yet to grow.
  document.documentElement.dispatchEvent(new Event("themechange"));
  document.body.append(back);
  document.addEventListener("keydown", (event) => {
    const busy = event.defaultPrevented || document.querySelector("dialog[open], :popover-open");
    if (event.key === "Escape" && !back.hidden && !busy) leave();
  });
  return (on) => {
    back.hidden = !on;
  };
}
