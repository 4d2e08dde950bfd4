/** Curves as comma-separated values (RFC 4180), every number in full precision. */

/** @typedef {import("./model.js").Trace} Trace */

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
