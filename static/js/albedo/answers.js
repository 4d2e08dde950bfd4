/**
 * The shapes that `/albedo` sends, and what of them the view reads.
 *
 * @typedef {'unpolarized' | 's' | 'p'} Quantity
 * @typedef {{kind: 'dielectric' | 'conductor', eta: [number, number], kappa: [number, number]}} Domain
 * @typedef {{domain: Domain, claimed: number | null, relative: boolean, source: string, measured: number,
 *   at: {eta: number, kappa: number}, measured_over: Domain, holds: boolean | null}} Claim
 * @typedef {{id: string, title: string, quantity: Quantity, domains: Domain[], latex: string,
 *   reference: string, note: string, claims: Claim[]}} Fit
 * @typedef {{kind: 'exact' | 'fit' | 'model', id: string, quantity: Quantity, values: (number | null)[],
 *   error: (number | null)[] | null, in_domain: [number, number] | null}} SweepCurve
 * @typedef {{over: 'n_t' | 'k_t' | 'eta', n_i: number, n_t: number | null, k_t: number | null,
 *   values: number[], curves: SweepCurve[]}} Sweep
 * @typedef {{unpolarized: number, s: number, p: number, method: string}} Exact
 * @typedef {{id: string, title: string, quantity: Quantity, value: number | null, error: number | null,
 *   in_domain: boolean, reason: string | null}} Approximation
 * @typedef {{exact: Exact, approximations: Approximation[]}} Side
 * @typedef {Side & {interface: Interface, flatland: number | null, reverse: Side | null}} Here
 * @typedef {{value: number, n_t: number, k_t: number}} Largest
 * @typedef {{n_i: number, n_t: number[], k_t: number[], fit: string | null, quantity: Quantity,
 *   show: 'exact' | 'value' | 'error', values: (number | null)[][], largest: Largest | null,
 *   largest_in_domain: Largest | null, domains: {n_t: [number, number], k_t: [number, number]}[]}} AlbedoMap
 */

/** The figure where a fit is at home, and where a claim is to be seen. @param {Domain} domain */
export function homeOf({ kind, eta }) {
  if (kind === "conductor") return "metal-n";
  return eta[1] > 1 ? "outside" : "inside";
}

/** The side of the surface that a figure shows. @param {Here} here @param {boolean} forward @returns {Side} */
export function sideOf(here, forward) {
  return forward || !here.reverse ? here : here.reverse;
}
