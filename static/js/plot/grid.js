/** A heat map's cells as a file and as a table to read. */

import { plainText } from "../draw/symbols.js";
import { plain } from "../numbers/format.js";
import { pickedRows } from "./table.js";

/**
 * @typedef {import("./model.js").Axis} Axis
 * @typedef {import("./heatmap.js").Grid} Grid
 */

const ROWS = 13;
const COLUMNS = 10;

/** @param {string} text */
const quoted = (text) => (/[",\r\n]/u.test(text) ? `"${text.replace(/"/gu, '""')}"` : text);

/**
 * One line for each cell.
 * @param {Grid} grid
 * @param {Axis} x
 * @param {Axis} y
 * @param {string} title
 */
export function gridCsv(grid, x, y, title) {
  const heading = [x.column ?? plainText(x.title), y.column ?? plainText(y.title), title];
  const lines = [heading.map(quoted).join(",")];
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
  const columns = pickedRows(grid.x.length, COLUMNS);
  const rows = pickedRows(grid.y.length, ROWS);
  table.createCaption().textContent = `${name}: ${columns.length} × ${rows.length} of ${grid.x.length} × ${grid.y.length} cells; the CSV file has all`;
  /** @param {HTMLTableRowElement} row @param {string} text @param {"col" | "row"} scope */
  const heading = (row, text, scope) => {
    const th = document.createElement("th");
    th.scope = scope;
    th.textContent = text;
    row.append(th);
  };
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
