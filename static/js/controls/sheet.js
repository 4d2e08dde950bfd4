/** On a phone the controls are a sheet at the bottom: a strip of values, one row, the rest on demand. */

import { h, setText, symbol } from "../page/dom.js";

/**
 * @typedef {{name: string, symbol: string, row: {element: HTMLElement}, print: () => string}} Page
 * @param {object} options
 * @param {Page[]} options.pages
 * @param {HTMLElement} options.body
 * @param {string} options.first the page shown first
 */
export function createSheet({ pages, body, first }) {
  const strip = h("div", { class: "strip", role: "group", "aria-label": "Which value to move" });
  const entries = pages.map((page) => {
    const value = h("b", {});
    const button = h(
      "button",
      { type: "button", "aria-pressed": "false", onclick: () => choose(page.name) },
      symbol(page.symbol),
      value,
    );
    strip.append(button);
    return { page, button, value };
  });
  const opener = h("button", { type: "button", class: "opener", "aria-expanded": "false" }, "all");
  strip.append(opener);
  const element = h(
    "section",
    { class: "panel", "aria-label": "Controls", "data-sheet": "closed" },
    strip,
    body,
  );
  opener.addEventListener("click", () => {
    const open = element.dataset.sheet !== "open";
    element.dataset.sheet = open ? "open" : "closed";
    opener.setAttribute("aria-expanded", String(open));
    opener.textContent = open ? "close" : "all";
  });

  /** @param {string} name */
  function choose(name) {
    for (const { page, button } of entries) {
      const on = page.name === name;
      button.setAttribute("aria-pressed", String(on));
      page.row.element.toggleAttribute("data-chosen", on);
    }
  }
  choose(first);

  return {
    element,
    update() {
      for (const { page, value } of entries) setText(value, page.print());
    },
  };
}
