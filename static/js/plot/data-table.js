/** What plots draw as tables, below a line that opens them; filled only while they are open. */

import { h } from "../page/dom.js";

/**
 * @param {string} summary
 * @param {Record<string, () => HTMLElement[]>} named what makes the tables, by the name of each place; none keeps what is there
 */
export function createDataTables(summary, named) {
  const places = Object.entries(named).map(([name, make]) => ({
    make,
    host: h("div", { class: "plot-table", tabindex: "0", role: "region", "aria-label": name }),
  }));
  const element = h(
    "details",
    { class: "definitions" },
    h("summary", {}, summary),
    ...places.map((place) => place.host),
  );
  function fill() {
    if (!element.open) return;
    for (const { make, host } of places) {
      const tables = make();
      if (tables.length) host.replaceChildren(...tables);
    }
  }
  element.addEventListener("toggle", fill);
  return { element, fill };
}
