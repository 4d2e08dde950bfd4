/** The table of errors: sortable; the row under the pointer or the focus lights its curve. */

import { COLUMNS, sayCost, short, sorted } from "../errors/metrics.js";
import { atWavelength } from "../media/media.js";
import { createDefinitions } from "../models/definitions.js";
import { CHANNELS, modelStyle, traceName } from "../models/look.js";
import { sampled } from "../models/sampled.js";
import { angle } from "../numbers/format.js";
import { h, setText } from "../page/dom.js";
import { html, nothing, render } from "../page/lit.js";
import { createCopy, heading } from "../page/tables.js";
import { against } from "./fields.js";

/**
 * @typedef {import('../errors/metrics.js').Row} Row
 * @typedef {import('../errors/metrics.js').Cost} Cost
 * @typedef {{state: State, rows: Row[], setting: import('../errors/metrics.js').Setting,
 *   here: ReadonlyMap<string, number | null>}} Shown the rows in order, `here` the errors at the marked angle by trace
 */

/** The server's weighted costs of all models. @param {any} answer of /recommend @returns {Map<string, number>} */
function pricesOf(answer) {
  const all = answer ? [...answer.models, ...answer.refused] : [];
  return new Map(all.map((c) => [c.model, c.weighted_cost]));
}

/** The errors of the models that are shown. @param {State} now @param {Record<string, any>} answers @returns {Row[]} */
export function errorsOf(now, answers) {
  /** @type {Row[]} */
  const rows = answers.errors?.errors ?? [];
  return rows.filter((r) => against(now).includes(r.model));
}

/** @param {ViewContext} context @param {(model: string | null) => void} onLight */
export function createTable({ catalog, state, actions, say, typeset }, onLight) {
  const { models } = catalog;
  const costs = new Map(models.map((m) => [m.id, /** @type {Cost} */ (m.cost)]));
  const definitions = createDefinitions(models, typeset);
  const element = h("div.errors-host");
  /** @type {Shown | null} */
  let shown = null;
  const copy = createCopy(
    "Copy the table of errors, in full precision",
    () => {
      const { rows, setting } = /** @type {Shown} */ (shown);
      return [
        COLUMNS.map((c) => c.name),
        ...rows.map((row) =>
          COLUMNS.map((c) =>
            c.name === "model" ? traceName(row.model, row.quantity) : (c.value(row, setting) ?? ""),
          ),
        ),
      ];
    },
    say,
  );
  const at = h("span.at-nm");
  const section = h(
    "section.column.metrics",
    { "aria-label": "Errors" },
    h("div.heading", h("h2", "Errors"), at, copy),
    element,
    definitions.element,
  );

  /** @param {EventTarget | null} target @returns {string | null} the model of its row */
  const rowOf = (target) =>
    (target instanceof Element && target.closest("tr")?.dataset.model) || null;
  const focusedRow = () =>
    element.contains(document.activeElement) ? rowOf(document.activeElement) : null;
  /** @param {Event} event */
  const light = (event) => onLight(rowOf(event.target));
  const dim = () => onLight(null);

  /** @param {string} id */
  const focus = (id) => actions.set({ focus: state().focus === id ? null : id });
  /** @param {string} by @param {string} order */
  const sort = (by, order) => actions.set({ sort: by, order });

  /** @param {Row} row @param {Shown} now */
  function line(row, { state: { focus: focused }, setting, here }) {
    const { model: id, quantity, in_domain, reason } = row;
    const channel = CHANNELS[quantity];
    const style = { ...modelStyle(models, id), ...(channel && { color: channel.color }) };
    const title = `${row.title}${channel ? ` ${channel.label}` : ""}`;
    return html`<tr data-model=${id} ?data-outside=${!in_domain}>
      <th scope="row"><button
        type="button"
        class="pick"
        aria-pressed=${id === focused}
        @click=${() => focus(id)}
      >${sampled(style)}<span class="pick-name">${title}</span></button><span class="outside">${
        in_domain ? nothing : `outside its domain: ${reason ?? ""}`
      }</span></th>
      <td class="here">${short(here.get(traceName(id, quantity)))}</td>
      ${COLUMNS.slice(1).map(({ name, print }) =>
        name === "cost"
          ? html`<td class="cost" title=${sayCost(costs.get(id))}>${print(row, setting)}</td>`
          : html`<td>${print(row, setting)}</td>`,
      )}
    </tr>`;
  }

  /** @param {Shown} now @param {boolean} stale */
  function table(now, stale) {
    const { sort: by, order, angle: unit, theta_i_deg } = now.state;
    const [first, ...others] = COLUMNS.map((column) => heading(column, { by, order }, sort));
    return html`<div class="errors-scroll" tabindex="0" role="region" aria-label="Table of errors">
      <table class="errors" ?data-stale=${stale}>
        <caption class="hidden">Errors of the models against exact Fresnel</caption>
        <thead><tr>
          ${first}
          <th scope="col" title="signed error at the marked angle">at ${angle(theta_i_deg, unit, unit === "deg" ? 1 : 3)}</th>
          ${others}
        </tr></thead>
        <tbody @pointerover=${light} @pointerleave=${dim} @focusin=${light} @focusout=${dim}>
          ${now.rows.map((row) => line(row, now))}
        </tbody>
      </table>
    </div>`;
  }

  return {
    element: section,
    /**
     * @param {State} now
     * @param {Record<string, any>} answers
     * @param {ReadonlyMap<string, number | null>} here
     * @param {boolean} stale
     */
    update(now, answers, here, stale) {
      const setting = { unit: now.angle, costs, prices: pricesOf(answers.recommend) };
      const rows = sorted(errorsOf(now, answers), now.sort, now.order, setting);
      shown = { state: now, rows, setting, here };
      definitions.update(against(now));
      setText(at, atWavelength(catalog.materials, now));
      const focused = focusedRow();
      const empty = html`<p class="empty">Choose a model to see its errors here.</p>`;
      render(rows.length === 0 ? empty : table(shown, stale), element);
      // Rows change places; the focus goes with its own.
      if (focused && focusedRow() !== focused) {
        /** @type {HTMLElement | null} */
        const pick = element.querySelector(`tr[data-model="${focused}"] .pick`);
        pick?.focus();
      }
    },
  };
}
