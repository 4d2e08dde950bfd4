/** The table of errors: sortable; the row under the pointer or the focus lights its curve. */

import { COLUMNS, sayCost, sorted } from "../errors/metrics.js";
import { CHANNELS, modelStyle, traceName } from "../models/look.js";
import { sampled } from "../models/sampled.js";
import { h } from "../page/dom.js";
import { html, nothing, render } from "../page/lit.js";
import { createCopy, heading } from "../page/tables.js";

/**
 * @typedef {import('../errors/metrics.js').Row} Row
 * @typedef {import('../page/tables.js').Sorting & import('../errors/metrics.js').Setting & {rows: readonly Row[],
 *   focus: string | null, here: (trace: string) => string, at: string, stale: boolean}} Shown
 *   `here` is the error at the marked angle, `at` that angle
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
  /** @type {Shown | null} */
  let shown = null;
  const element = h("div", { class: "errors-host" });

  /** @param {Shown} now */
  const ordered = (now) => sorted(now.rows, now.by, now.order, now);
  const copy = createCopy(
    "Copy the table of errors, in full precision",
    () => {
      const now = /** @type {Shown} */ (shown);
      return [
        COLUMNS.map((c) => c.name),
        ...ordered(now).map((row) =>
          COLUMNS.map((c) =>
            c.name === "model" ? traceName(row.model, row.quantity) : (c.value(row, now) ?? ""),
          ),
        ),
      ];
    },
    say,
  );

  /** @param {EventTarget | null} target @returns {string | null} the model of its row */
  const rowOf = (target) =>
    (target instanceof Element && target.closest("tr")?.dataset.model) || null;
  const focusedRow = () =>
    element.contains(document.activeElement) ? rowOf(document.activeElement) : null;
  /** @param {Event} event */
  const light = (event) => onLight(rowOf(event.target));
  const dim = () => onLight(null);

  /** @param {Row} row @param {Shown} now */
  function line(row, now) {
    const { model: id, quantity, in_domain, reason } = row;
    const channel = CHANNELS[quantity];
    const style = { ...modelStyle(models, id), ...(channel && { color: channel.color }) };
    return html`<tr data-model=${id} ?data-outside=${!in_domain}>
      <th scope="row"><button
        type="button"
        class="pick"
        aria-pressed=${id === now.focus}
        @click=${() => onFocus(id)}
      >${sampled(style)}<span class="pick-name">${row.title}${channel ? ` ${channel.label}` : ""}</span></button><span
        class="outside"
      >${in_domain ? nothing : `outside its domain: ${reason ?? ""}`}</span></th>
      <td class="here">${now.here(traceName(id, quantity))}</td>
      ${COLUMNS.slice(1).map((c) =>
        c.name === "cost"
          ? html`<td class="cost" title=${sayCost(now.costs.get(id))}>${c.print(row, now)}</td>`
          : html`<td>${c.print(row, now)}</td>`,
      )}
    </tr>`;
  }

  return {
    element,
    copy,
    /** @param {Shown} now */
    update(now) {
      shown = now;
      const focused = focusedRow();
      const [first, ...others] = COLUMNS.map((column) => heading(column, now, onSort));
      render(
        now.rows.length === 0
          ? html`<p class="empty">Choose a model to see its errors here.</p>`
          : html`<div class="errors-scroll" tabindex="0" role="region" aria-label="Table of errors">
              <table class="errors" ?data-stale=${now.stale}>
                <caption class="hidden">Errors of the models against exact Fresnel</caption>
                <thead><tr>
                  ${first}
                  <th scope="col" title="signed error at the marked angle">at ${now.at}</th>
                  ${others}
                </tr></thead>
                <tbody
                  @pointerover=${light}
                  @pointerleave=${dim}
                  @focusin=${light}
                  @focusout=${dim}
                >${ordered(now).map((row) => line(row, now))}</tbody>
              </table>
            </div>`,
        element,
      );
      // Rows change places; the focus goes with its own.
      if (focused && focusedRow() !== focused) {
        /** @type {HTMLElement | null} */
        const pick = element.querySelector(`tr[data-model="${focused}"] .pick`);
        pick?.focus();
      }
    },
  };
}
