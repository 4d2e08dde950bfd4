/** Curves that the server computed: read at an angle, and as the traces of a plot over the angle. */

import { modelTraces } from "../models/look.js";
import { inUnit } from "../numbers/format.js";

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

/** @param {readonly number[]} values @returns {[number, number]} the ends of an axis that holds them */
export function ends(values) {
  return [values[0] ?? 0, values.at(-1) ?? 1];
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
      field_penetration_depth_wavelengths,
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
      field_penetration_depth_wavelengths,
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
    field_penetration_depth_wavelengths: at("field_penetration_depth_wavelengths"),
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
  if (high < 1 || x <= xs[0]) return { index: 0, fraction: 0 };
  if (x >= xs[high]) return { index: high, fraction: 0 };
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (xs[middle] <= x) low = middle;
    else high = middle;
  }
  const x0 = xs[low];
  const x1 = xs[high];
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

/**
 * @param {Curves} curves
 * @param {Shown} shown
 * @param {Model[]} models
 */
export function tracesOf(curves, shown, models) {
  const x =
    shown.angle === "deg" ? curves.theta_i_deg : curves.theta_i_deg.map((d) => inUnit(d, "rad"));
  const chosen = { s: "Rs", p: "Rp", unpolarized: "R" }[shown.polarization];
  /** @param {string} id @param {number} width */
  const weight = (id, width) => (id === chosen ? Math.max(width, 2.6) : width);
  const exact = [
    { id: "Rs", label: "Rₛ", color: "--Rs", dash: "solid", width: weight("Rs", 1.9) },
    { id: "Rp", label: "Rₚ", color: "--Rp", dash: "dash", width: weight("Rp", 1.9) },
    { id: "R", label: "R", color: "--R", dash: "solid", width: 2.6 },
  ];
  if (shown.show.includes("T"))
    exact.push({ id: "T", label: "T", color: "--T", dash: "longdash", width: 1.9 });
  /** @type {Trace[]} */
  const traces = exact.map((line) => ({ ...line, x, y: values(curves, line.id) }));
  for (const id of shown.models) {
    // The overlay may have been chosen a moment ago, and its curve still be under way.
    traces.push(...modelTraces(curves, [id], models, x));
  }
  if (shown.show.includes("phase")) {
    for (const [id, label, color, dash] of /** @type {const} */ ([
      ["phase_s_deg", "phase s", "--phase-s", "dot"],
      ["phase_p_deg", "phase p", "--phase-p", "dashdot"],
    ])) {
      const y = branch(beforeJumps(values(curves, id), curves)).map((d) =>
        d === null ? null : inUnit(d, shown.angle),
      );
      if (y.length)
        traces.push({
          id,
          label,
          x,
          y,
          color,
          dash,
          width: 1.4,
          axis: "y2",
          unit: shown.angle === "deg" ? "°" : " rad",
        });
    }
  }
  return traces;
}

/**
 * Where an amplitude vanishes or total reflection begins, a phase jumps, and rounding decides on which
 * side of the jump it is told: it is drawn on the side that it comes from.
 * @param {(number | null)[]} degrees
 * @param {Curves} curves
 */
function beforeJumps(degrees, { interface: { brewster_deg, critical_deg }, theta_i_deg }) {
  const jumps = [brewster_deg, critical_deg].flatMap((d) => (d === null ? [] : [d]));
  const at = new Set(jumps.map((d) => theta_i_deg.indexOf(d)));
  return degrees.map((d, i) => (at.has(i) && i > 0 ? (degrees[i - 1] ?? null) : d));
}

/**
 * 180 and -180 degrees are one phase: where a curve ends on the other side, its end is drawn where
 * the curve arrives.
 * @param {(number | null)[]} degrees
 */
function branch(degrees) {
  const last = degrees.at(-1) ?? null;
  const before = degrees.at(-2) ?? null;
  if (last === null || before === null || Math.abs(last) < 180 || last * before >= 0)
    return degrees;
  return Math.abs(last - before) > 180 ? [...degrees.slice(0, -1), -last] : degrees;
}

/** @param {Curves} curves @param {Shown} shown */
export function marksOf(curves, shown) {
  if (!shown.marks) return [];
  return allLandmarksOf(curves.interface).map(({ deg, label }) => ({
    x: inUnit(deg, shown.angle),
    label,
    kind: /** @type {const} */ ("landmark"),
  }));
}

const DEGREES = [0, 15, 30, 45, 60, 75, 90];
const TWELFTHS = ["0", "π/12", "π/6", "π/4", "π/3", "5π/12", "π/2"];
const PHASES = [-180, -90, 0, 90, 180];
const HALVES = ["−π", "−π/2", "0", "π/2", "π"];

/** The axis of the angles of incidence. @param {{angle: 'deg' | 'rad'} | State} shown */
export function angleAxis({ angle }) {
  const rad = angle === "rad";
  return {
    title: `angle of incidence θᵢ (${rad ? "rad" : "degrees"})`,
    range: [0, inUnit(90, angle)],
    ticks: {
      values: DEGREES.map((d) => inUnit(d, angle)),
      text: rad ? TWELFTHS : DEGREES.map((d) => `${d}°`),
    },
    unit: rad ? " rad" : "°",
    column: rad ? "theta_i_rad" : "theta_i_deg",
  };
}

/** @param {Shown} shown */
export function axesOf(shown) {
  const rad = shown.angle === "rad";
  return {
    name: "Reflectance against the angle of incidence",
    x: angleAxis(shown),
    y: {
      title: shown.show.includes("T") ? "reflectance, transmittance" : "reflectance",
      range: [0, 1],
    },
    y2: shown.show.includes("phase")
      ? {
          title: "phase",
          range: [inUnit(-190, shown.angle), inUnit(190, shown.angle)],
          ticks: {
            values: PHASES.map((d) => inUnit(d, shown.angle)),
            text: rad ? HALVES : PHASES.map((d) => `${d}°`.replace("-", "−")),
          },
        }
      : null,
  };
}

/** What curves are at a place. @param {readonly {id: string, x: number[], y: (number | null)[]}[]} traces @param {number} x */
export const pointsAt = (traces, x) =>
  traces.map((t) => ({ id: t.id, y: read(t.y, locate(t.x, x)) }));
