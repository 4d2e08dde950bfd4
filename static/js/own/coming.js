/** What brings a material of one's own: files that are dropped, the last line of a list of media. */

import { prepare } from "./sheet.js";

let listens = false;

/**
 * @param {Event} event something is held over the page, or the line was taken
 * @param {(given: OwnGiven) => unknown} open
 */
export function on(event, open) {
  if (event instanceof CustomEvent) open({ side: event.detail });
  else if (!listens) takeDrops(open);
}

/** @param {(given: OwnGiven) => unknown} open */
function takeDrops(open) {
  listens = true;
  /** @param {boolean} is */
  const show = (is) => document.body.classList.toggle("dropping", is);
  window.addEventListener("dragover", (event) => {
    if (!event.dataTransfer?.types.includes("Files")) return;
    event.preventDefault();
    show(true);
  });
  window.addEventListener("dragleave", ({ relatedTarget }) => {
    if (!relatedTarget) show(false);
  });
  window.addEventListener("drop", (event) => {
    show(false);
    const files = [...(event.dataTransfer?.files ?? [])];
    if (!files.length) return;
    event.preventDefault();
    open({ files });
  });
  void prepare();
}
