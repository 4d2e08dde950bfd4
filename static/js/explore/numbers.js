/** The numbers of the Explore view: shown with six digits, copied in full. */

import { angle, inUnit, six } from "../numbers/format.js";
import { copying, h, setText, symbol } from "../page/dom.js";
import { createTerm } from "./term.js";

/** While something moves, the numbers are written as often as an eye can catch, ms apart. */
const READABLE = 100;

/** Four columns where there is room. @returns {NumberEntry[]} */
function summaryEntries() {
  /** @type {[string, Node | string, (r: Reading) => number | null, degrees?: boolean][]} */
  const entries = [
    ["R", symbol("R"), (r) => r.R],
    ["Rs", symbol("R_s"), (r) => r.Rs],
    ["Rp", symbol("R_p"), (r) => r.Rp],
    ["F0", symbol("F_0"), (r) => r.interface.F0],
    ["T", symbol("T"), (r) => r.T],
    ["Ts", symbol("T_s"), (r) => r.Ts],
    ["Tp", symbol("T_p"), (r) => r.Tp],
    ["F82", symbol("F_{82}"), (r) => r.interface.F82],
    ["eta", symbol("\\eta"), (r) => r.interface.eta],
    ["kappa", symbol("\\kappa"), (r) => r.interface.kappa],
    ["penetration_depth_wavelengths", "power’s depth / λ", (r) => r.penetration_depth_wavelengths],
    [
      "field_penetration_depth_wavelengths",
      "field’s depth / λ",
      (r) => r.field_penetration_depth_wavelengths,
    ],
    ["theta_t", symbol("\\theta_t"), (r) => r.theta_t_deg, true],
    ["brewster", "Brewster", (r) => r.interface.brewster_deg, true],
    ["critical", "critical", (r) => r.interface.critical_deg, true],
    ["pseudo_brewster", "pseudo-Brewster", (r) => r.interface.pseudo_brewster_deg, true],
    ["principal", "principal", (r) => r.interface.principal_deg, true],
  ];
  return entries.map(([name, heading, get, degrees]) => ({ name, heading, get, degrees }));
}

const AMPLITUDES = /** @type {const} */ (["r_s", "r_p", "t_s", "t_p"]);
const PARTS = /** @type {const} */ (["re", "im", "abs", "phase_deg"]);

/** @returns {NumberEntry[][]} a row for each amplitude */
function amplitudeEntries() {
  return AMPLITUDES.map((a) =>
    PARTS.map((part) => ({
      name: `${a}.${part === "phase_deg" ? "phase" : part}`,
      heading: symbol(a),
      get: (/** @type {Reading} */ r) => r.snell?.[a][part],
      degrees: part === "phase_deg",
    })),
  );
}

/** More than an angle can be off for being a double, degrees. */
const SAME_ANGLE = 1e-13;

/** @param {Reading} reading */
const atBrewster = ({ theta_i_deg, interface: { brewster_deg } }) =>
  brewster_deg !== null && Math.abs(theta_i_deg - brewster_deg) < SAME_ANGLE;

/**
 * What is written of a number. At Brewster's angle no p-polarized light comes back; the double beside that
 * angle leaves some 1e-17 of its field, which would be read as an amplitude that has a phase.
 * @param {NumberEntry} entry
 * @param {Reading} reading
 */
function shown(entry, reading) {
  const number = entry.get(reading);
  if (typeof number !== "number" || !/^(Rp$|r_p)/u.test(entry.name) || !atBrewster(reading))
    return number;
  return entry.degrees ? null : 0;
}

/** @param {(message: string) => void} say */
export function createNumbers(say) {
  /** @type {Reading | null} */
  let reading = null;
  /** @type {'deg' | 'rad'} */
  let unit = "deg";
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let dimming;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let overdue;
  let written = Number.NEGATIVE_INFINITY;

  /** @param {NumberEntry} entry @returns {number | null | undefined} */
  function full(entry) {
    const value = reading ? entry.get(reading) : undefined;
    return entry.degrees && typeof value === "number" ? inUnit(value, unit) : value;
  }

  /** @param {NumberEntry} entry */
  function cell(entry) {
    const value = h("button.number", { type: "button", tabindex: "-1" });
    const copy = copying(() => String(full(entry) ?? "none"), say, `${entry.name} copied`);
    value.addEventListener("click", (event) => full(entry) !== undefined && copy(event));
    return { entry, value };
  }

  /** @param {NumberEntry} entry one stop for the Tab key leads to all of them */
  const term = ({ name, heading }) => createTerm(name, heading, say, { tabindex: "-1" });
  const summary = summaryEntries().map(cell);
  const amplitudes = amplitudeEntries().map((row) => row.map(cell));
  const all = [...summary, ...amplitudes.flat()];

  const grid = h(
    "dl.numbers",
    ...summary.map(({ entry, value }) => h("div", h("dt", term(entry)), h("dd", value))),
  );
  const table = h(
    "table.amplitudes",
    h(
      "thead",
      h(
        "tr",
        h("td"),
        ...["real", "imaginary", "modulus", "phase"].map((t) => h("th", { scope: "col" }, t)),
      ),
    ),
    h(
      "tbody",
      ...amplitudes.map((row) =>
        h(
          "tr",
          h("th", { scope: "row" }, row[0] && term(row[0].entry)),
          ...row.map(({ value }) => h("td", value)),
        ),
      ),
    ),
  );

  roving(
    grid,
    summary.map((c) => c.value),
    () => getComputedStyle(grid).gridTemplateColumns.split(" ").length,
  );
  roving(
    table,
    amplitudes.flat().map((c) => c.value),
    () => PARTS.length,
  );
  for (const [host, columns] of /** @type {const} */ ([
    [grid, () => getComputedStyle(grid).gridTemplateColumns.split(" ").length],
    [table, () => 1],
  ]))
    roving(
      host,
      [.../** @type {NodeListOf<HTMLElement>} */ (host.querySelectorAll(".term"))],
      columns,
    );

  function everything() {
    const { n_i, n_t, k_t } = /** @type {Reading} */ (reading).interface;
    const rows = [
      ["n_i", n_i],
      ["n_t", n_t],
      ["k_t", k_t],
      [`theta_i_${unit}`, inUnit(reading?.theta_i_deg ?? 0, unit)],
      ...all.map(({ entry }) => [
        entry.degrees ? `${entry.name}_${unit}` : entry.name,
        full(entry) ?? "none",
      ]),
    ];
    return `${rows.map((r) => r.join("\t")).join("\n")}\n`;
  }
  const copyAll = h("button.quiet", { type: "button" }, "copy all");
  const copy = copying(everything, say, `${all.length + 4} numbers copied`);
  copyAll.addEventListener("click", (event) => reading && copy(event));

  return {
    grid,
    table,
    copyAll,
    /** @param {Reading} next @param {'deg' | 'rad'} nextUnit @param {boolean} moving */
    update(next, nextUnit, moving) {
      reading = next;
      unit = nextUnit;
      // Digits that change with every frame cannot be read, and cost more than the picture.
      clearTimeout(overdue);
      const since = performance.now() - written;
      if (moving && since < READABLE) {
        overdue = setTimeout(() => this.update(next, nextUnit, moving), READABLE - since);
        return;
      }
      written = performance.now();
      // The amplitudes come with the server's answer for this very angle; until then the last ones stay,
      // and are dimmed if that takes long enough to be seen.
      const stale = next.snell === null;
      table.toggleAttribute("data-stale", stale);
      if (!stale) {
        clearTimeout(dimming);
        dimming = undefined;
        if (table.hasAttribute("data-dim")) table.removeAttribute("data-dim");
      } else dimming ??= setTimeout(() => table.setAttribute("data-dim", ""), 300);
      for (const { entry, value } of all) {
        const number = shown(entry, next);
        if (number === undefined) continue;
        setText(value, entry.degrees ? angle(number, unit) : six(number));
        if (value.hasAttribute("data-none") !== (number === null)) {
          value.toggleAttribute("data-none", number === null);
        }
        if (moving) continue; // nobody reads it out meanwhile
        const label = `${entry.name}: ${value.textContent}, copy`;
        if (value.ariaLabel !== label) value.ariaLabel = label;
      }
    },
  };
}

/**
 * One stop for the Tab key; arrows move between the numbers.
 * @param {HTMLElement} element
 * @param {HTMLElement[]} cells
 * @param {() => number} columns
 */
function roving(element, cells, columns) {
  let at = 0;
  if (cells[0]) cells[0].tabIndex = 0;
  element.addEventListener("focusin", (event) => {
    const next = cells.indexOf(/** @type {HTMLElement} */ (event.target));
    if (next < 0) return;
    const last = cells[at];
    if (last) last.tabIndex = -1;
    at = next;
    const now = cells[at];
    if (now) now.tabIndex = 0;
  });
  element.addEventListener("keydown", (event) => {
    const move = { ArrowRight: 1, ArrowLeft: -1, ArrowDown: columns(), ArrowUp: -columns() }[
      event.key
    ];
    if (move === undefined || cells[at] !== event.target) return;
    event.preventDefault();
    cells[at + move]?.focus();
  });
}
