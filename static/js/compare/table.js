/** The table of errors: sortable; the row under the pointer or the focus lights its curve. */

import { COLUMNS, sayCost, sorted } from "../errors/metrics.js";
import { CHANNELS, modelStyle, sample, traceName } from "../models/look.js";
import { h, setText } from "../page/dom.js";
import { copyText, flash } from "../page/exports.js";

/**
 * @typedef {import('../errors/metrics.js').Row} Row
 * @typedef {import('../errors/metrics.js').Setting} Setting
 * @typedef {{by: string, order: 'up' | 'down', focus: string | null, unit: 'deg' | 'rad', here: (trace: string) => string, at: string,
 *   prices: ReadonlyMap<string, number>}} Shown `here` is the error at the marked angle, `at` that angle
 */

/**
 * @param {object} options
 * @param {Model[]} options.models
 * @param {(by: string, order: 'up' | 'down') => void} options.onSort
 * @param {(model: string | null) => void} options.onLight
 * @param {(model: string) => void} options.onFocus
 * @param {(text: string) => void} options.say
 */
export function createTable({ models, onSort, onLight, onFocus, say }) {
  const titles = new Map(models.map((m) => [m.id, m.title]));
  const costs = new Map(
    models.map((m) => [m.id, /** @type {Record<string, number>} */ (m.cost ?? {})]),
  );
  /** @type {Row[]} */
  let rows = [];
  /** @type {Shown} */
  let shown = {
    by: "rms",
    order: "up",
    focus: null,
    unit: "deg",
    here: () => "",
    at: "",
    prices: new Map(),
  };
  /** @returns {Setting} */
  const setting = () => ({ unit: shown.unit, titles, costs, prices: shown.prices });

  const here = h("span", {});
  const headings = COLUMNS.map((column) => {
    const button = h(
      "button",
      {
        type: "button",
        class: "sort",
        title: column.note || null,
        onclick: () => {
          const down = shown.by === column.name && shown.order === "up";
          onSort(column.name, down ? "down" : "up");
        },
      },
      column.heading,
    );
    return { column, button, th: h("th", { scope: "col" }, button) };
  });
  const hereHeading = h(
    "th",
    { scope: "col", title: "signed error at the marked angle" },
    "at ",
    here,
  );
  const body = h("tbody", {});
  const table = h(
    "table",
    { class: "errors" },
    h("caption", { class: "hidden" }, "Errors of the models against exact Fresnel"),
    h(
      "thead",
      {},
      h("tr", {}, headings[0]?.th, hereHeading, ...headings.slice(1).map((c) => c.th)),
    ),
    body,
  );
  const copy = h("button", { type: "button", class: "quiet" }, "copy");
  copy.setAttribute("aria-label", "Copy the table of errors, in full precision");
  copy.addEventListener("click", async () => {
    const lines = order().map((row) =>
      COLUMNS.map((c) =>
        c.name === "model" ? traceName(row.model, row.quantity) : (c.value(row, setting()) ?? ""),
      ).join("\t"),
    );
    const done = await copyText(
      `${[COLUMNS.map((c) => c.name).join("\t"), ...lines].join("\n")}\n`,
    );
    flash(copy, done);
    say(done ? `${lines.length} rows copied` : "Copying is not allowed here");
  });
  const empty = h("p", { class: "empty" }, "Choose a model to see its errors here.");
  const scroller = h(
    "div",
    { class: "errors-scroll", tabindex: "0", role: "region", "aria-label": "Table of errors" },
    table,
  );
  const element = h("div", { class: "errors-host" }, scroller, empty);

  const order = () => sorted(rows, shown.by, shown.order, setting());

  /** @type {Map<string, ReturnType<typeof line>>} */
  const lines = new Map();

  /** @param {string} id @param {string} quantity */
  function line(id, quantity) {
    const channel = CHANNELS[quantity];
    const pick = h(
      "button",
      { type: "button", class: "pick", "aria-pressed": "false", onclick: () => onFocus(id) },
      sample({ ...modelStyle(models, id), ...(channel && { color: channel.color }) }),
      h(
        "span",
        { class: "pick-name" },
        `${titles.get(id) ?? id}${channel ? ` ${channel.label}` : ""}`,
      ),
    );
    const reason = h("span", { class: "outside" });
    const cells = COLUMNS.slice(1).map((column) => ({
      column,
      td: h("td", column.name === "cost" ? { class: "cost" } : {}),
    }));
    const at = h("td", { class: "here" });
    const tr = h(
      "tr",
      {
        "data-model": id,
        onpointerenter: () => onLight(id),
        onpointerleave: () => onLight(null),
        onfocusin: () => onLight(id),
        onfocusout: () => onLight(null),
      },
      h("th", { scope: "row" }, pick, reason),
      at,
      ...cells.map((c) => c.td),
    );
    return { tr, pick, reason, cells, at };
  }

  /** @param {Row} row */
  function lineOf({ model, quantity }) {
    const key = traceName(model, quantity);
    const made = lines.get(key) ?? line(model, quantity);
    lines.set(key, made);
    return made;
  }

  function draw() {
    const now = order();
    const elements = now.map((row) => {
      const { tr, pick, reason, cells, at } = lineOf(row);
      setText(reason, row.in_domain ? "" : `outside its domain: ${row.reason ?? ""}`);
      tr.toggleAttribute("data-outside", !row.in_domain);
      pick.setAttribute("aria-pressed", String(row.model === shown.focus));
      setText(at, shown.here(traceName(row.model, row.quantity)));
      for (const { column, td } of cells) {
        setText(td, column.print(row, setting()));
        if (column.name === "cost") td.title = sayCost(costs.get(row.model));
      }
      return tr;
    });
    if (
      elements.length !== body.children.length ||
      elements.some((e, i) => body.children[i] !== e)
    ) {
      const active = document.activeElement;
      body.replaceChildren(...elements);
      if (active instanceof HTMLElement && body.contains(active)) active.focus();
    }
    for (const { column, th, button } of headings) {
      const on = column.name === shown.by;
      if (on) th.setAttribute("aria-sort", shown.order === "up" ? "ascending" : "descending");
      else th.removeAttribute("aria-sort");
      button.dataset.order = on ? shown.order : "";
    }
    setText(here, shown.at);
    empty.hidden = rows.length > 0;
    scroller.hidden = rows.length === 0;
  }

  return {
    element,
    copy,
    /** @param {Row[]} next @param {Shown} how @param {boolean} stale */
    update(next, how, stale) {
      rows = next;
      shown = how;
      table.toggleAttribute("data-stale", stale);
      draw();
    },
  };
}
