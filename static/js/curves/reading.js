/** The numbers at one angle: from the answer for that angle, or read from the fetched curves. */

/**
 * @typedef {{interface: Interface, theta_i_deg: number, theta_t_deg: number | null, tir: boolean,
 *   R: number, Rs: number, Rp: number, T: number, Ts: number, Tp: number,
 *   penetration_depth_wavelengths: number | null, snell: Snell | null}} Reading
 */

/**
 * @param {Curves} curves
 * @param {string} quantity
 * @param {string} [model]
 * @returns {(number | null)[]}
 */
export function values(curves, quantity, model = "exact") {
  return curves.curves.find((c) => c.model === model && c.quantity === quantity)?.values ?? [];
}

/**
 * @param {Interface} a
 * @param {{n_i: number, n_t: number, k_t: number}} b
 */
export function sameMedia(a, b) {
  return a.n_i === b.n_i && a.n_t === b.n_t && a.k_t === b.k_t;
}

/**
 * While something moves the curves answer at once; the exact numbers replace them as soon as the
 * server has sent those of this very angle.
 * @param {Curves} curves
 * @param {Snell | undefined} snell
 * @param {number} theta_i_deg
 * @returns {Reading}
 */
export function readingAt(curves, snell, theta_i_deg) {
  if (snell && snell.theta_i_deg === theta_i_deg && sameMedia(snell.interface, curves.interface)) {
    const {
      theta_t_deg,
      total_internal_reflection: tir,
      R,
      Rs,
      Rp,
      T,
      Ts,
      Tp,
      penetration_depth_wavelengths,
    } = snell;
    return {
      interface: snell.interface,
      theta_i_deg,
      theta_t_deg,
      tir,
      R,
      Rs,
      Rp,
      T,
      Ts,
      Tp,
      penetration_depth_wavelengths,
      snell,
    };
  }
  const place = locate(curves.theta_i_deg, theta_i_deg);
  /** @param {string} quantity */
  const at = (quantity) => read(values(curves, quantity), place);
  const [R, Rs, Rp] = [at("R") ?? 0, at("Rs") ?? 0, at("Rp") ?? 0];
  const critical = curves.interface.critical_deg;
  const tir = critical !== null && theta_i_deg > critical;
  return {
    interface: curves.interface,
    theta_i_deg,
    theta_t_deg: tir ? null : at("theta_t_deg"),
    tir,
    R,
    Rs,
    Rp,
    // What is not reflected passes the surface.
    T: 1 - R,
    Ts: 1 - Rs,
    Tp: 1 - Rp,
    penetration_depth_wavelengths: at("penetration_depth_wavelengths"),
    snell: null,
  };
}

/**
 * Where R, Rs and Rp turn: Brewster's, the critical and the pseudo-Brewster angle, as far as they exist
 * and differ.
 * @param {Interface} media
 * @returns {{deg: number, label: string}[]}
 */
export function landmarksOf(media) {
  const marks = [];
  if (media.brewster_deg !== null) marks.push({ deg: media.brewster_deg, label: "Brewster" });
  if (media.critical_deg !== null) marks.push({ deg: media.critical_deg, label: "critical" });
  if (media.brewster_deg === null)
    marks.push({ deg: media.pseudo_brewster_deg, label: "pseudo-Brewster" });
  return marks;
}

/** These, and the principal angle of the phases. @param {Interface} media */
export function allLandmarksOf(media) {
  const principal = { deg: media.principal_deg, label: "principal" };
  return [...landmarksOf(media), ...(media.brewster_deg === null ? [principal] : [])];
}

/**
 * The sample interval that holds x: the largest i with xs[i] <= x, and the fraction of the way on.
 * @param {number[]} xs ascending
 * @param {number} x
 * @returns {{index: number, fraction: number}}
 */
export function locate(xs, x) {
  let low = 0;
  let high = xs.length - 1;
  if (high < 1 || x <= /** @type {number} */ (xs[0])) return { index: 0, fraction: 0 };
  if (x >= /** @type {number} */ (xs[high])) return { index: high, fraction: 0 };
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (/** @type {number} */ (xs[middle]) <= x) low = middle;
    else high = middle;
  }
  const x0 = /** @type {number} */ (xs[low]);
  const x1 = /** @type {number} */ (xs[high]);
  return { index: low, fraction: x1 > x0 ? (x - x0) / (x1 - x0) : 0 };
}

/**
 * Linear interpolation; null where either neighbour is missing, unless x is a sample itself.
 * @param {(number | null)[]} values
 * @param {{index: number, fraction: number}} place
 * @returns {number | null}
 */
export function read(values, { index, fraction }) {
  const here = values[index] ?? null;
  if (fraction === 0 || here === null) return here;
  const next = values[index + 1] ?? null;
  return next === null ? null : here + fraction * (next - here);
}

/** @param {readonly number[]} values @returns {[number, number]} the ends of an axis that holds them */
export function ends(values) {
  return [values[0] ?? 0, values.at(-1) ?? 1];
}
