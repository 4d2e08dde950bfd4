/** What a plot shows in numbers: as a table for those who read it by ear, and as CSV (RFC 4180) in full precision. */

import { plainText } from "../draw/svg.js";
import { plain, six, unitSuffix } from "../numbers/format.js";
import { h } from "../page/dom.js";

const ROWS = 40;

/** @param {HTMLTableRowElement} row @param {string} text @param {"col" | "row"} scope */
function heading(row, text, scope) {
  row.append(h("th", { scope }, text));
}

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

/** @param {string} text */
function cell(text) {
  return /[",\r\n]/u.test(text) ? `"${text.replace(/"/gu, '""')}"` : text;
}

/**
 * One table of several curves: a row for each abscissa that any of them has.
 * @param {readonly Pick<Trace, "x" | "y">[]} traces
 * @returns {{x: number[], columns: (number | null)[][]}}
 */
export function joined(traces) {
  const first = traces[0];
  const same = traces.every(
    (trace) =>
      trace.x === first?.x ||
      (trace.x.length === first?.x.length && trace.x.every((value, i) => value === first.x[i])),
  );
  if (first && same) return { x: first.x, columns: traces.map((trace) => trace.y) };
  const x = [...new Set(traces.flatMap((trace) => trace.x))].sort((a, b) => a - b);
  return {
    x,
    columns: traces.map((trace) => {
      const known = new Map(trace.x.map((value, index) => [value, trace.y[index] ?? null]));
      return x.map((value) => known.get(value) ?? null);
    }),
  };
}

/**
 * @param {string} xColumn heading of the abscissa
 * @param {readonly Trace[]} traces
 */
export function toCsv(xColumn, traces) {
  const { x, columns } = joined(traces);
  const lines = [[xColumn, ...traces.map((trace) => trace.column ?? trace.id)].map(cell).join(",")];
  x.forEach((value, row) => {
    lines.push([value, ...columns.map((column) => column[row] ?? "")].join(","));
  });
  return `${lines.join("\r\n")}\r\n`;
}

/** Of a grid that is read out. */
const GRID = { rows: 13, columns: 10 };

/**
 * One line for each cell.
 * @param {Grid} grid
 * @param {Axis} x
 * @param {Axis} y
 * @param {string} title
 */
export function gridCsv(grid, x, y, title) {
  const names = [x.column ?? plainText(x.title), y.column ?? plainText(y.title), title];
  const lines = [names.map(cell).join(",")];
  grid.y.forEach((v, row) => {
    grid.x.forEach((u, column) => {
      lines.push(`${u},${v},${grid.z[row]?.[column] ?? ""}`);
    });
  });
  return `${lines.join("\r\n")}\r\n`;
}

/**
 * @param {string} name
 * @param {Grid | null} grid
 * @param {Axis} x
 * @param {Axis} y
 * @param {(value: number | null) => string} print
 * @returns {HTMLTableElement}
 */
export function gridTable(name, grid, x, y, print) {
  const table = document.createElement("table");
  table.className = "curve-table";
  if (!grid) return table;
  const columns = pickedRows(grid.x.length, GRID.columns);
  const rows = pickedRows(grid.y.length, GRID.rows);
  table.createCaption().textContent = `${name}: ${columns.length} × ${rows.length} of ${grid.x.length} × ${grid.y.length} cells; the CSV file has all`;
  const head = table.createTHead().insertRow();
  heading(head, `${plainText(y.short ?? y.title)} \\ ${plainText(x.short ?? x.title)}`, "col");
  for (const column of columns)
    heading(head, plain(grid.x[column] ?? 0, 4) + (x.unit === "°" ? "°" : ""), "col");
  const body = table.createTBody();
  for (const index of rows) {
    const row = body.insertRow();
    heading(row, plain(grid.y[index] ?? 0, 4), "row");
    for (const column of columns)
      row.insertCell().textContent = print(grid.z[index]?.[column] ?? null);
  }
  return table;
}
