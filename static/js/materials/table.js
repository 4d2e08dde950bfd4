/** The table of presets: one stop for the Tab key, arrows walk through it, the row walked to is shown. */

import { stretch } from "../numbers/format.js";
import { h, setText } from "../page/dom.js";
import { COLUMNS, sortedPresets } from "./columns.js";

/** @typedef {import('./columns.js').Preset} Preset */

const PAGE = 10;

/**
 * @param {HTMLElement} element
 * @param {{hex: string | null} | undefined} swatch
 */
export function paint(element, swatch) {
  element.style.setProperty("--swatch", swatch?.hex ?? "transparent");
  element.toggleAttribute("data-outside", !swatch?.hex);
}

/**
 * @param {object} options
 * @param {(id: string, moving: boolean) => void} options.onPick
 * @param {() => void} options.onSettle
 * @param {(by: string, order: 'up' | 'down') => void} options.onSort
 * @param {() => void} options.onLeave upwards, beyond the first row
 */
export function createPresetTable({ onPick, onSettle, onSort, onLeave }) {
  /** @type {{by: string, order: 'up' | 'down'}} */
  let sort = { by: "match", order: "up" };
  const headings = COLUMNS.map((column) => {
    const button = h(
      "button",
      {
        type: "button",
        class: "sort",
        title: column.note || null,
        onclick: () => {
          // A third click goes back to the catalog's own order.
          if (sort.by !== column.name) onSort(column.name, "up");
          else if (sort.order === "up") onSort(column.name, "down");
          else onSort("match", "up");
        },
      },
      column.heading,
    );
    return { column, button, th: h("th", { scope: "col", class: `c-${column.name}` }, button) };
  });
  const body = h("tbody", {});
  const table = h(
    "table",
    { class: "presets" },
    h("caption", { class: "hidden" }, "Materials"),
    h("thead", {}, h("tr", {}, ...headings.map((c) => c.th))),
    body,
  );
  const element = h("div", { class: "presets-scroll" }, table);

  /** @type {Map<string, ReturnType<typeof line>>} */
  const lines = new Map();
  /** @type {Preset[]} */
  let shown = [];
  /** @type {unknown} */
  let drawn = null;
  let chosen = "";

  /** @param {Preset} preset */
  function line(preset) {
    const swatch = h("span", { class: "swatch", "aria-hidden": "true" });
    const about = [
      preset.category,
      preset.kind === "single" || !preset.n_range_nm ? "one index" : stretch(preset.n_range_nm),
    ];
    const pick = h(
      "button",
      {
        type: "button",
        class: "entry",
        tabindex: "-1",
        "aria-pressed": "false",
        onclick: () => onPick(preset.id, false),
      },
      swatch,
      h("span", { class: "entry-name" }, preset.name),
      h("span", { class: "entry-about" }, about.join(" · ")),
    );
    const cells = COLUMNS.slice(1).map((c) => h("td", { class: `c-${c.name}` }, c.print(preset)));
    const tr = h("tr", { "data-id": preset.id }, h("th", { scope: "row" }, pick), ...cells);
    tr.addEventListener("click", (event) => {
      if (!pick.contains(/** @type {Node} */ (event.target))) onPick(preset.id, false);
    });
    return { tr, pick, swatch };
  }

  /** @param {number} index */
  function walk(index) {
    const preset = shown[Math.min(Math.max(index, 0), shown.length - 1)];
    if (!preset) return;
    lines.get(preset.id)?.pick.focus({ preventScroll: true });
    reveal(preset.id);
    if (preset.id !== chosen) onPick(preset.id, true);
  }

  /** Scroll the table, not the page; to the middle where the row came from elsewhere. @param {string} id @param {boolean} [middle] */
  function reveal(id, middle = false) {
    const tr = lines.get(id)?.tr;
    if (!tr?.isConnected) return;
    const head = headings[0]?.th.offsetHeight ?? 0;
    const top = tr.offsetTop - head;
    const bottom = tr.offsetTop + tr.offsetHeight;
    const { scrollTop, clientHeight } = element;
    if (top >= scrollTop && bottom <= scrollTop + clientHeight) return;
    if (middle) element.scrollTop = top - (clientHeight - head) / 2;
    else element.scrollTop = top < scrollTop ? top : bottom - clientHeight;
  }

  body.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const at = shown.findIndex((m) => m.id === chosen);
    const id = /** @type {HTMLElement} */ (event.target).closest("tr")?.dataset.id;
    const here = id ? shown.findIndex((m) => m.id === id) : at;
    /** @type {Record<string, number>} */
    const goals = {
      ArrowDown: here + 1,
      ArrowUp: here - 1,
      PageDown: here + PAGE,
      PageUp: here - PAGE,
      Home: 0,
      End: shown.length - 1,
    };
    const goal = goals[event.key];
    if (goal === undefined) return;
    event.preventDefault();
    if (goal < 0 && event.key === "ArrowUp") onLeave();
    else walk(goal);
  });
  body.addEventListener("keyup", (event) => {
    if (/^(Arrow|Page|Home|End)/.test(event.key)) onSettle();
  });

  return {
    element,
    /** Into the table, to the chosen row or the first. */
    enter() {
      walk(
        Math.max(
          0,
          shown.findIndex((m) => m.id === chosen),
        ),
      );
    },
    first: () => walk(0),
    /**
     * @param {readonly Preset[]} presets
     * @param {string} by
     * @param {'up' | 'down'} order
     * @param {string} preset the chosen one
     */
    update(presets, by, order, preset) {
      const look = `${by} ${order}`;
      if (drawn !== presets || look !== `${sort.by} ${sort.order}`) {
        sort = { by, order };
        drawn = presets;
        shown = sortedPresets(presets, by, order);
        const rows = shown.map((one) => {
          const made = lines.get(one.id) ?? line(one);
          lines.set(one.id, made);
          paint(made.swatch, one.swatch);
          return made.tr;
        });
        const active = document.activeElement;
        body.replaceChildren(...rows);
        if (active instanceof HTMLElement && body.contains(active)) active.focus();
        for (const { column, th, button } of headings) {
          const on = column.name === by;
          if (on) th.setAttribute("aria-sort", order === "up" ? "ascending" : "descending");
          else th.removeAttribute("aria-sort");
          button.dataset.order = on ? order : "";
        }
      }
      const inside = shown.some((m) => m.id === preset);
      const before = chosen;
      chosen = preset;
      const stop = inside ? preset : shown[0]?.id;
      for (const { id } of shown) {
        const { pick, tr } = /** @type {ReturnType<typeof line>} */ (lines.get(id));
        const on = id === preset;
        if (tr.hasAttribute("data-chosen") !== on) {
          tr.toggleAttribute("data-chosen", on);
          pick.setAttribute("aria-pressed", String(on));
        }
        pick.tabIndex = id === stop ? 0 : -1;
      }
      if (before !== preset) requestAnimationFrame(() => reveal(preset, true));
    },
    /** @param {string} text */
    caption: (text) => setText(/** @type {HTMLElement} */ (table.caption), text),
  };
}
