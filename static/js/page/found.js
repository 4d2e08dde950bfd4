/** What the finder knows beside views, media, models and formulas: lessons, sheets, engines, targets of export. */

import { addressOf, follow } from "./links.js";

/** Skin has no measured spectrum here; its index is the one that renderers take. */
const SKIN = 1.4;

/** @param {FindablePlaces} places @param {(patch: State) => void} set @returns {Findable[]} */
export function moreEntries({ sections, steps, traps, sheets, engines, targets }, set) {
  /** @param {string} id @param {string} name @param {string} does @param {string} href @returns {Findable} */
  const place = (id, name, does, href) => ({
    id,
    name,
    category: id.replace(/:.*/u, ""),
    does,
    run: () => follow(href),
  });
  return [
    ...sections.map(({ id, title }) =>
      place(`section:${id}`, title, "section of Theory", addressOf("theory", { section: id })),
    ),
    ...steps.map(({ id, title }) =>
      place(
        `lesson:${id}`,
        title,
        "lesson of the first path",
        addressOf("theory", { section: "path", step: id }),
      ),
    ),
    ...traps.map(({ id, title }) =>
      place(`trap:${id}`, title, "trap", addressOf("theory", { section: "traps", trap: id })),
    ),
    ...sheets.map(({ title }) =>
      place(`sheet:${title}`, title, "worksheet", addressOf("theory", { section: "worksheets" })),
    ),
    ...engines.map(({ id, title }) =>
      place(`engine:${id}`, title, "engine, measured", addressOf("engines", { engine: id })),
    ),
    ...Object.entries(targets).map(([id, title]) =>
      place(
        `use:${id}`,
        `Use a material in ${title}`,
        "file or values, in Materials",
        addressOf("materials", { preset: "Au", use_in: id }),
      ),
    ),
    {
      id: "skin",
      name: `Skin (n = ${SKIN}, F0 = 0.028)`,
      category: "medium",
      source:
        "E. d'Eon, D. Luebke, Advanced Techniques for Realistic Real-Time Skin Rendering, GPU Gems 3, 2007",
      does: "second medium, as renderers take it",
      run: () => set({ view: "explore", n_t: SKIN, k_t: 0, material: null }),
    },
    place("documentation", "The REST API, described", "documentation", "docs"),
  ];
}
