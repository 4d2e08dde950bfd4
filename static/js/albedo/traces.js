/** The albedos over an abscissa and the errors of the fits, from the sweep that the server sent. */

import { shortTitle } from "../models/look.js";
import { CLAIMED, fitStyle, OUTSIDE } from "./style.js";

/**
 * @typedef {import('./answers.js').Fit} Fit
 * @typedef {import('./answers.js').Sweep} Sweep
 * @typedef {import('./answers.js').SweepCurve} SweepCurve
 * @typedef {{lights: readonly string[], relative: boolean}} Shown
 */

/** Exact curves, by their quantity. @type {Record<string, {label: string, color: string, dash: string, width: number, column: string}>} */
const EXACT = {
  unpolarized: { label: "A", color: "--R", dash: "solid", width: 2.6, column: "exact" },
  s: { label: "A_s", color: "--Rs", dash: "solid", width: 1.7, column: "exact_s" },
  p: { label: "A_p", color: "--Rp", dash: "dash", width: 1.7, column: "exact_p" },
  flatland: { label: "flatland", color: "--T", dash: "longdash", width: 1.7, column: "flatland" },
};

/** @param {Sweep} sweep */
const fitsOf = (sweep) => sweep.curves.filter((c) => c.kind === "fit");

/** Which exact albedos are drawn: those asked for, and those that a fit approximates. @param {Sweep} sweep @param {readonly string[]} lights */
function exactCurves(sweep, lights) {
  const needed = fitsOf(sweep).map((c) => c.quantity);
  return sweep.curves.filter((c) => {
    if (c.kind !== "exact") return false;
    if (c.id === "flatland") return lights.includes("flatland");
    return (
      c.quantity === "unpolarized" || lights.includes(c.quantity) || needed.includes(c.quantity)
    );
  });
}

/**
 * A curve in two: within the fit's domain and beyond it, where the two meet in one sample.
 * @param {readonly number[]} x
 * @param {readonly (number | null)[]} y
 * @param {readonly [number, number] | null} domain
 * @returns {{inside: (number | null)[], beyond: (number | null)[] | null}}
 */
export function divided(x, y, domain) {
  const last = x.length - 1;
  const within = x.map((v) => domain !== null && v >= domain[0] && v <= domain[1]);
  if (within.every(Boolean)) return { inside: [...y], beyond: null };
  return {
    inside: y.map((v, i) => (within[i] ? v : null)),
    beyond: y.map((v, i) =>
      !within[i] || (i > 0 && !within[i - 1]) || (i < last && !within[i + 1]) ? v : null,
    ),
  };
}

/**
 * @param {SweepCurve} curve
 * @param {readonly number[]} x
 * @param {readonly (number | null)[]} y
 * @param {readonly Fit[]} fits
 * @returns {Trace[]}
 */
function fitTraces(curve, x, y, fits) {
  const title = fits.find((f) => f.id === curve.id)?.title ?? curve.id;
  const { inside, beyond } = divided(x, y, curve.in_domain);
  const own = { id: curve.id, label: shortTitle(title), x: [...x], width: 1.9 };
  const style = fitStyle(curve.id);
  const within = { ...own, ...style, y: inside };
  if (!beyond) return [within];
  return [
    {
      ...own,
      ...OUTSIDE,
      id: `${curve.id}.outside`,
      label: `${own.label}, outside its domain`,
      bare: true,
      y: beyond,
    },
    ...(curve.in_domain ? [within] : []),
  ];
}

/** @param {Sweep} sweep @param {Shown} shown @param {readonly Fit[]} fits @returns {Trace[]} */
export function albedoTraces(sweep, { lights }, fits) {
  const x = sweep.values;
  const exact = exactCurves(sweep, lights).map(({ id, quantity, values: y }) => {
    const flat = id === "flatland";
    const look = /** @type {typeof EXACT.s & {}} */ (EXACT[flat ? id : quantity]);
    return { id: flat ? id : `exact.${quantity}`, x, y, ...look };
  });
  // The exact albedo lies under the fits, or one would not see that they are there.
  return [...exact, ...fitsOf(sweep).flatMap((fit) => fitTraces(fit, x, fit.values, fits))];
}

/**
 * Fit minus exact of the same polarization, or that over exact in percent; null where exact is 0.
 * @param {SweepCurve} curve
 * @param {Sweep} sweep
 * @param {boolean} relative
 * @returns {(number | null)[]}
 */
export function errorOf({ error, quantity }, sweep, relative) {
  if (!relative || !error) return error ?? [];
  const exact = sweep.curves.find((c) => c.id === "exact" && c.quantity === quantity)?.values;
  return error.map((e, i) => {
    const right = exact?.[i];
    return e === null || !right ? null : (100 * e) / right;
  });
}

/** @param {Sweep} sweep @param {Shown} shown @param {readonly Fit[]} fits @returns {Trace[]} */
export function errorTraces(sweep, { relative }, fits) {
  const x = sweep.values;
  const unit = relative ? " %" : undefined;
  const look = { color: "--R", dash: "solid", width: 1.2 };
  const zero = { id: "zero", label: "exact", ...look, x, y: x.map(() => 0) };
  const fitted = fitsOf(sweep).flatMap((curve) => {
    const quantity = curve.quantity === "unpolarized" ? "" : ` (${curve.quantity})`;
    return fitTraces(curve, x, errorOf(curve, sweep, relative), fits).map((t) => ({
      ...t,
      label: t.label + quantity,
      unit,
      column: `${t.id}.error`,
    }));
  });
  return [zero, ...fitted];
}

/**
 * What a fit claims where its figure's abscissa lies in the claim's domain: lines at plus and minus
 * the largest error that its source promises.
 * @param {Sweep} sweep
 * @param {readonly Fit[]} fits
 * @param {boolean} relative
 * @returns {Trace[]}
 */
export function claimTraces(sweep, fits, relative) {
  const { over, n_i, values: x } = sweep;
  const along = over === "k_t" ? "kappa" : "eta";
  const across = over === "k_t" ? "eta" : "kappa";
  const other = (over === "k_t" ? sweep.n_t : sweep.k_t) ?? 0;
  /** @param {number} v @param {readonly [number, number]} range over the medium in front */
  const within = (v, [low, high]) => {
    const unit = over === "eta" ? 1 : n_i;
    return v >= low * unit && v <= high * unit;
  };
  return fitsOf(sweep).flatMap(({ id }) => {
    const fit = fits.find((f) => f.id === id);
    return (fit?.claims ?? []).flatMap(({ claimed, relative: own, domain }, index) => {
      if (claimed === null || own !== relative || !within(other, domain[across])) return [];
      const size = relative ? 100 * claimed : claimed;
      return [size, -size].map((end) => ({
        id: `claim.${id}.${index}.${Math.sign(end)}`,
        label: `${fit?.title}, claimed`,
        bare: true,
        column: `${id}.claimed`,
        ...fitStyle(id),
        ...CLAIMED,
        unit: relative ? " %" : undefined,
        x,
        y: x.map((v) => (within(v, domain[along]) ? end : null)),
      }));
    });
  });
}

/** Only what lies in a fit's domain says how far an axis reaches. @param {readonly Trace[]} traces @returns {Trace[]} */
export function decisive(traces) {
  const own = traces.filter((t) => !t.id.endsWith(".outside"));
  return own.some((t) => t.id !== "zero") ? own : [...traces];
}

/** Share of the samples that a range may leave out where they run away, as relative errors do where the albedo goes to 0. */
const LEFT_OUT = 0.05;

/** Traces without what runs away, to find the range of an axis by. @param {readonly Trace[]} traces @returns {Trace[]} */
export function tamed(traces) {
  const sizes = traces
    .filter((t) => t.id !== "zero" && !t.id.startsWith("claim."))
    .flatMap((t) => t.y.flatMap((v) => (v === null ? [] : [Math.abs(v)])))
    .sort((a, b) => a - b);
  const most = sizes.at(-1) ?? 0;
  const usual = sizes[Math.floor((sizes.length - 1) * (1 - LEFT_OUT))] ?? 0;
  if (usual === 0 || most <= 3 * usual) return [...traces];
  return traces.map((t) => ({
    ...t,
    y: t.y.map((v) => (v === null || Math.abs(v) > usual ? null : v)),
  }));
}
