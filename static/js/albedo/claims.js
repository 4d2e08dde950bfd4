/** What the fits claim beside what they do: rows, columns and their words. */

import { significant } from "../numbers/format.js";
import { byColumn } from "../numbers/sorted.js";

/**
 * @typedef {import('./answers.js').Fit} Fit
 * @typedef {import('./answers.js').Claim} Claim
 * @typedef {import('./answers.js').Domain} Domain
 * @typedef {{fit: Fit, claim: Claim}} Row
 * @typedef {object} Column
 * @property {string} name
 * @property {string} heading
 * @property {string} note
 * @property {(row: Row) => number | string | null} value to sort by and to copy
 * @property {(row: Row) => string} print
 */

/** @param {number} x as short as it was published */
function brief(x) {
  const text = Number(x.toPrecision(3)).toString();
  return text.includes("e") ? significant(x, 1) : text;
}

/** @param {number} size @param {boolean} relative */
export function printError(size, relative) {
  return relative ? `${brief(100 * size)}\u00a0%` : brief(size);
}

/** @param {readonly [number, number]} range @param {string} letter */
function span([low, high], letter) {
  return low === high ? `${letter} = ${brief(low)}` : `${letter} ${brief(low)} – ${brief(high)}`;
}

/** @param {Domain} domain @returns {string} over the medium in front */
export function printDomain({ kind, eta, kappa }) {
  if (kind === "conductor") return `${span(eta, "n")}, ${span(kappa, "k")}`;
  return eta[1] > 1 ? span(eta, "n") : span(eta, "η");
}

/** @param {Row} row */
export function printHolds({ claim }) {
  if (claim.holds === null || claim.claimed === null) return "nothing claimed";
  if (claim.holds) return "holds";
  return `does not hold: ${significant(claim.measured / claim.claimed, 2)} times as large`;
}

/** @param {Row} row */
function printMeasured({ claim }) {
  const { domain, measured_over: over, measured, relative, at } = claim;
  const elsewhere = printDomain(domain) === printDomain(over) ? "" : `, over ${printDomain(over)}`;
  const where =
    domain.kind === "conductor"
      ? `n = ${brief(at.eta)}, k = ${brief(at.kappa)}`
      : `${domain.eta[1] > 1 ? "n" : "η"} = ${brief(at.eta)}`;
  return `${printError(measured, relative)} at ${where}${elsewhere}`;
}

/** Broken claims first, then those that hold, then what claims nothing. @param {Row} row */
function rank({ claim }) {
  return claim.holds === null ? 2 : Number(claim.holds);
}

/**
 * @param {string} name
 * @param {string} heading
 * @param {string} note
 * @param {Column["print"]} print
 * @param {Column["value"]} [value]
 * @returns {Column}
 */
const column = (name, heading, note, print, value = print) => ({
  name,
  heading,
  note,
  print,
  value,
});

export const COLUMNS = [
  column("fit", "fit", "", ({ fit }) => fit.title),
  column("holds", "does it hold?", "", printHolds, rank),
  column(
    "claimed",
    "claimed",
    "largest error by the source: of the albedo, or relative to it where it is a percentage",
    ({ claim: { claimed, relative } }) =>
      claimed === null ? "none" : printError(claimed, relative),
    ({ claim }) => claim.claimed,
  ),
  column(
    "measured",
    "measured",
    "largest error found, as a test of ours measures it, and where",
    printMeasured,
    ({ claim }) => claim.measured,
  ),
  column(
    "domain",
    "claimed for",
    "the interfaces that the claim is about; n, k and η relative to the medium in front",
    ({ claim }) => printDomain(claim.domain),
  ),
  column("source", "source of the claim", "", ({ claim }) => claim.source),
];

/** @param {readonly Fit[]} fits @returns {Row[]} one for each claim */
export function rowsOf(fits) {
  return fits.flatMap((fit) => fit.claims.map((claim) => ({ fit, claim })));
}

/** @param {readonly Row[]} rows @param {string} by @param {'up' | 'down'} order @returns {Row[]} */
export function sortedClaims(rows, by, order) {
  const column = COLUMNS.find((c) => c.name === by) ?? /** @type {Column} */ (COLUMNS[0]);
  return byColumn(rows, column.value, order);
}
