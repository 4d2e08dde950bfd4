/** The curves as a table, for those who read a plot by ear. */

import { plainText } from "../draw/symbols.js";
import { plain, six } from "../numbers/format.js";
import { joined } from "./csv.js";
import { unitSuffix } from "./figure.js";

/** @typedef {import("./model.js").Trace} Trace */
/** @typedef {import("./model.js").Axis} Axis */

const ROWS = 40;

/**
 * Which rows to read out: equal steps, both ends.
 * @param {number} count
 * @param {number} [limit]
 */
export function pickedRows(count, limit = ROWS) {
  const every = Math.max(1, Math.ceil((count - 1) / (limit - 1)));
  const rows = [];
  for (let row = 0; row < count; row += every) rows.push(row);
  const last = count - 1;
  if (last >= 0 && rows[rows.length - 1] !== last) rows.push(last);
  return rows;
}

/**
 * @param {HTMLTableElement} table
 * @param {string} name
 * @param {Axis} axis of the abscissa
 * @param {readonly Trace[]} traces
 */
export function fillTable(table, name, axis, traces) {
  const { x, columns } = joined(traces);
  const rows = pickedRows(x.length);
  table.className = "curve-table";
  table.createCaption().textContent =
    rows.length < x.length
      ? `${name}: ${rows.length} of ${x.length} samples; the CSV file has all`
      : name;
  /** @param {HTMLTableRowElement} row @param {string} text @param {"col" | "row"} scope */
  const heading = (row, text, scope) => {
    const th = document.createElement("th");
    th.scope = scope;
    th.textContent = text;
    row.append(th);
  };
  const head = table.createTHead().insertRow();
  heading(head, plainText(axis.title || axis.short || "x"), "col");
  for (const trace of traces) heading(head, plainText(trace.label || trace.id), "col");
  const body = table.createTBody();
  for (const index of rows) {
    const row = body.insertRow();
    heading(row, plain(x[index] ?? 0) + unitSuffix(axis.unit), "row");
    columns.forEach((column, n) => {
      const value = column[index];
      row.insertCell().textContent =
        value === null || value === undefined ? "none" : six(value) + unitSuffix(traces[n]?.unit);
    });
  }
}
