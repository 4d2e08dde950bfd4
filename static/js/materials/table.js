/** The table of presets: one stop for the Tab key, arrows walk through it, the row walked to is shown. */

import { pathOf } from "../media/brought.js";
import { stretch } from "../media/wavelength.js";
import { isOwn } from "../own/kept.js";
import { createChanged } from "../page/changed.js";
import { h } from "../page/dom.js";
import { html, noChange, nothing, render } from "../page/lit.js";
import { COLUMNS, sortedPresets } from "./columns.js";

/** @typedef {import('./columns.js').Preset} Preset */

const PAGE = 10;

/** A color, hatched where sRGB does not hold it. @param {string | null | undefined} hex @param {string} [size] */
export const swatch = (hex, size = "") =>
  html`<span class="swatch ${size}" aria-hidden="true" style="--swatch: ${hex ?? "transparent"}"
    ?data-outside=${!hex}></span>`;

/**
 * @param {object} options
 * @param {(id: string, moving: boolean) => void} options.onPick
 * @param {() => void} options.onSettle
 * @param {(by: string, order: 'up' | 'down') => void} options.onSort
 * @param {() => void} options.onLeave upwards, beyond the first row
 */
export function createPresetTable({ onPick, onSettle, onSort, onLeave }) {
  const element = h("div.presets-scroll");
  /** @type {readonly Preset[]} */
  let shown = [];
  let sort = { by: "match", order: "up" };
  let chosen = "";
  /** What each row was drawn of. @type {unknown[][]} */
  const rows = [];
  const [listed, changed] = [createChanged(), createChanged()];

  /** @param {string} id @returns {HTMLTableRowElement | null} */
  const rowOf = (id) => element.querySelector(`tr[data-id="${CSS.escape(id)}"]`);
  /** @param {Event} event */
  const idAt = ({ target }) =>
    target instanceof Element ? target.closest("tr")?.dataset.id : undefined;
  /** @param {string} id */
  const focus = (id) => rowOf(id)?.querySelector("button")?.focus({ preventScroll: true });

  /** A third click goes back to the catalog's own order. @param {string} name */
  function sortBy(name) {
    if (sort.by !== name) onSort(name, "up");
    else if (sort.order === "up") onSort(name, "down");
    else onSort("match", "up");
  }

  /** @param {import('./columns.js').Column} column */
  function heading({ name, note, heading: words }) {
    const on = name === sort.by;
    return html`<th scope="col" class="c-${name}"
      aria-sort=${on ? (sort.order === "up" ? "ascending" : "descending") : nothing}>
      <button type="button" class="sort" title=${note || nothing} data-order=${on ? sort.order : ""}
        @click=${() => sortBy(name)}>${words}</button>
    </th>`;
  }

  /** @param {Preset} preset @param {number} index @param {string} stop */
  function row(preset, index, stop) {
    const { id, name, category, kind, n_range_nm, page, source } = preset;
    const of = [preset, id === chosen, id === stop];
    // Two hundred rows are walked through at every press of a key: those that are the same stay.
    if (of.every((one, i) => one === rows[index]?.[i])) return noChange;
    rows[index] = of;
    const known = kind === "single" || !n_range_nm ? "one index" : stretch(n_range_nm);
    const about = page
      ? `${known} · ${pathOf(id)}`
      : `${isOwn(id) ? "your own" : category} · ${known}`;
    return html`<tr data-id=${id} ?data-chosen=${id === chosen}>
      <th scope="row">
        <button type="button" class="entry" title=${page ? source : nothing} tabindex=${id === stop ? 0 : -1} aria-pressed=${id === chosen}>
          ${swatch(preset.swatch?.hex)}
          <span class="entry-name">${name}</span>
          <span class="entry-about">${about}</span>
        </button>
      </th>
      ${COLUMNS.slice(1).map((c) => html`<td class="c-${c.name}">${c.print(preset)}</td>`)}
    </tr>`;
  }

  /** @param {string} stop the row that the Tab key goes to */
  function draw(stop) {
    rows.length = Math.min(rows.length, shown.length);
    render(
      html`<table class="presets">
        <caption class="hidden">Materials</caption>
        <thead><tr>${COLUMNS.map(heading)}</tr></thead>
        <tbody @click=${pick} @keydown=${walkBy} @keyup=${settle}>
          ${shown.map((one, index) => row(one, index, stop))}
        </tbody>
      </table>`,
      element,
    );
  }

  /** @param {number} index */
  function walk(index) {
    const preset = shown[Math.min(Math.max(index, 0), shown.length - 1)];
    if (!preset) return;
    focus(preset.id);
    reveal(preset.id);
    if (preset.id !== chosen) onPick(preset.id, true);
  }

  /** Scroll the table, not the page; to the middle where the row came from elsewhere. @param {string} id @param {boolean} [middle] */
  function reveal(id, middle = false) {
    const tr = rowOf(id);
    if (!tr) return;
    const head = element.querySelector("thead")?.offsetHeight ?? 0;
    const top = tr.offsetTop - head;
    const bottom = tr.offsetTop + tr.offsetHeight;
    const { scrollTop, clientHeight } = element;
    if (top >= scrollTop && bottom <= scrollTop + clientHeight) return;
    if (middle) element.scrollTop = top - (clientHeight - head) / 2;
    else element.scrollTop = top < scrollTop ? top : bottom - clientHeight;
  }

  /** @param {Event} event */
  function pick(event) {
    const id = idAt(event);
    if (id) onPick(id, false);
  }

  /** @param {KeyboardEvent} event */
  function walkBy(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const id = idAt(event) ?? chosen;
    const here = shown.findIndex((m) => m.id === id);
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
  }

  /** @param {KeyboardEvent} event */
  function settle({ key }) {
    if (/^(Arrow|Page|Home|End)/.test(key)) onSettle();
  }

  return {
    element,
    /** Into the table, to the chosen row or the first. */
    enter: () => walk(shown.findIndex((m) => m.id === chosen)),
    first: () => walk(0),
    /**
     * @param {readonly Preset[]} presets
     * @param {string} by
     * @param {'up' | 'down'} order
     * @param {string} preset the chosen one
     */
    update(presets, by, order, preset) {
      if (listed(presets, by, order)) shown = sortedPresets(presets, by, order);
      if (!changed(shown, preset)) return;
      sort = { by, order };
      const came = chosen !== preset;
      chosen = preset;
      const active = document.activeElement;
      const held = element.contains(active) ? active?.closest("tr")?.dataset.id : undefined;
      draw(shown.some((m) => m.id === preset) ? preset : (shown[0]?.id ?? ""));
      // Rows are those of their places: the focus goes with the preset.
      if (held) focus(held);
      if (came) requestAnimationFrame(() => reveal(preset, true));
    },
  };
}
