/** One box that finds whatever the page shows, and does what has a key. */

import { matching, origin } from "../controls/picker.js";
import { copyText, h } from "./dom.js";
import { addressOf, follow } from "./links.js";
import { loadStyles } from "./style.js";
import { led } from "./trade.js";

const MOST_SHOWN = 60;
/** Views whose second medium is the one that is found; elsewhere it is opened among the materials. */
const WITH_MEDIUM = ["explore", "compare"];

/** @param {string} text */
const quoted = (text) =>
  text.replaceAll("&", "&amp;").replaceAll('"', "&quot;").replaceAll("<", "&lt;");

/** Copy the HTML that shows a view, as it is now, in another page. @param {FinderOptions["notice"]} notice */
async function copyEmbed(notice) {
  const address = new URL(location.href);
  address.hash = "";
  address.searchParams.set("embed", "1");
  const code = `<iframe src="${quoted(address.href)}" title="${quoted(document.title)}" width="100%" height="640" style="border: 0"></iframe>`;
  const done = await copyText(code);
  const title = done ? "Copied: the HTML that embeds this view" : "Copying is not allowed here";
  notice("embed", { title, lines: [code] });
}

/** @param {FinderOptions} options @returns {Findable[]} */
export function entries({ catalog, views, view, set, actions, notice }) {
  const here = views.find((one) => one.id === view() && WITH_MEDIUM.includes(one.id));
  return [
    ...views.map(({ id, title }) => ({
      id,
      name: title,
      category: "view",
      does: "view",
      run: () => set({ view: id }),
    })),
    ...[
      ...actions,
      {
        name: "Copy the HTML that embeds this view",
        note: "iframe",
        run: () => copyEmbed(notice),
      },
    ].map(({ name, note, run }) => ({
      id: name,
      name,
      category: "action",
      does: note,
      run,
    })),
    ...catalog.materials.map((material) => ({
      ...material,
      does: `${origin(material)} · ${here ? `second medium in ${here.title}` : "open in Materials"}`,
      run: () =>
        here
          ? set({ material: material.id })
          : follow(addressOf("materials", { preset: material.id })),
    })),
    ...catalog.models
      .filter(({ id }) => id !== "exact")
      .map(({ id, title }) => ({
        id,
        name: title,
        category: "model",
        does: "model, in Compare",
        run: () => follow(addressOf("compare", { models: id })),
      })),
  ];
}

/** @param {{id: string, title: string}[]} formulas @returns {Findable[]} */
export function formulaEntries(formulas) {
  return formulas.map(({ id, title }) => ({
    id,
    name: title,
    category: "formula",
    does: "formula, in Theory",
    run: () => follow(addressOf("theory", { section: "formulas", formula: id })),
  }));
}

/** @param {FinderOptions} options */
export async function openFinder(options) {
  await loadStyles("dialog");
  const input = h("input.finder-box", {
    type: "text",
    role: "combobox",
    autocomplete: "off",
    spellcheck: "false",
    placeholder: "gold, plastic, schlick, Brewster, blender, worksheet …",
    "aria-label": "Find a view, a medium, a model, a formula, a lesson or an engine",
    "aria-expanded": "true",
    "aria-autocomplete": "list",
    "aria-controls": "finder-list",
  });
  const list = h("ul", { id: "finder-list", role: "listbox", "aria-label": "Found" });
  const none = h("p.finder-none", { role: "status" });
  const dialog = h("dialog.dialog.finder", { "aria-label": "Find anything" }, input, list, none);
  /** What is found once it has come. @type {Findable[]} */
  let come = [];
  /** @type {Findable[]} */
  let found = [];
  let active = 0;

  function show() {
    const all = [...entries(options), ...come];
    const leading = led(all, input.value);
    const fitting = [...leading, ...matching(all, input.value).filter((e) => !leading.includes(e))];
    found = fitting.slice(0, MOST_SHOWN);
    list.replaceChildren(
      ...found.map((entry, index) =>
        h(
          "li",
          { id: `found-${index}`, role: "option", "aria-selected": "false", "data-index": index },
          h("span", entry.name),
          h("span.note", entry.does),
        ),
      ),
    );
    list.hidden = found.length === 0;
    none.textContent = found.length
      ? fitting.length > found.length
        ? `${found.length} of ${fitting.length}; write on to narrow them down`
        : ""
      : "No match";
    activate(0);
  }

  /** @param {number} index */
  function activate(index) {
    list.children[active]?.setAttribute("aria-selected", "false");
    active = Math.min(Math.max(index, 0), found.length - 1);
    const row = list.children[active];
    if (!row) {
      input.removeAttribute("aria-activedescendant");
      return;
    }
    row.setAttribute("aria-selected", "true");
    row.scrollIntoView({ block: "nearest" });
    input.setAttribute("aria-activedescendant", row.id);
  }

  /** @param {number} index */
  function take(index) {
    const entry = found[index];
    if (!entry) return;
    dialog.close();
    entry.run();
  }

  input.addEventListener("input", show);
  input.addEventListener("keydown", (event) => {
    const step = { ArrowDown: 1, ArrowUp: -1, PageDown: 8, PageUp: -8 }[event.key];
    if (step !== undefined) activate(active + step);
    else if (event.key === "Enter") take(active);
    else return;
    event.preventDefault();
  });
  list.addEventListener("click", (event) => {
    const row = /** @type {HTMLElement} */ (event.target).closest("li");
    if (row) take(Number(row.dataset.index));
  });
  dialog.addEventListener("click", (event) => {
    if (event.target === dialog) dialog.close(); // beside the box
  });
  dialog.addEventListener("close", () => dialog.remove());
  document.body.append(dialog);
  dialog.showModal();
  show();

  // Authors, other names and all else are found as soon as they are here; names will do until then.
  await Promise.all([
    options.describeMedia(),
    Promise.all([
      import("./found.js"),
      options.formulas().catch(() => ({ formulas: [] })),
      options.places(),
    ]).then(
      ([{ moreEntries }, { formulas }, places]) => {
        come = [...formulaEntries(formulas), ...moreEntries(places, options.set)];
      },
      () => {},
    ),
  ]);
  if (dialog.open) show();
}
