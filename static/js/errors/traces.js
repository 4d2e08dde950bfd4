/** The curves of the Compare view and their errors, from the curves that the server sent. */

import { modelTraces } from "../models/look.js";
import { plain } from "../numbers/format.js";

/**
 * @typedef {{n: number, curves: Curves}} Member another index of the family
 */

/** @param {Curves} curves @returns {(number | null)[]} */
function exactOf(curves) {
  return curves.curves.find((c) => c.model === "exact" && c.quantity === "R")?.values ?? [];
}

/**
 * @param {Curves} curves
 * @param {readonly string[]} against
 * @param {Model[]} models
 * @param {(deg: number) => number} toUnit
 * @param {readonly Member[]} [family]
 * @returns {Trace[]}
 */
export function curveTraces(curves, against, models, toUnit, family = []) {
  const x = curves.theta_i_deg.map(toUnit);
  const { n_t } = curves.interface;
  const exact = {
    id: "exact",
    label: family.length ? `n = ${plain(n_t, 4)}` : "exact",
    color: "--R",
    dash: "solid",
    width: 2.6,
    x,
    y: exactOf(curves),
  };
  const others = family
    .filter((m) => m.n !== n_t)
    .flatMap((member) => {
      const own = member.curves.theta_i_deg.map(toUnit);
      const n = plain(member.n, 4);
      return [
        {
          ...exact,
          id: `exact@${member.n}`,
          label: `n = ${n}`,
          width: 1.5,
          x: own,
          y: exactOf(member.curves),
        },
        ...modelTraces(member.curves, against, models, own).map((t) => ({
          ...t,
          id: `${t.id}@${member.n}`,
          label: `${t.label}, n = ${n}`,
          width: 1.4,
        })),
      ];
    });
  return [exact, ...modelTraces(curves, against, models, x), ...others];
}

/**
 * Without the second of two equal curves: a model that knows no index has one for all of a family.
 * @param {readonly Trace[]} traces
 * @returns {Trace[]}
 */
export function distinct(traces) {
  return traces.filter((trace) => {
    const [first, other] = trace.id.split("@");
    const own = traces.find((t) => t.id === first);
    if (other === undefined || !own) return true;
    const known = new Map(own.x.map((x, i) => [x, own.y[i] ?? null]));
    return trace.x.some((x, i) => known.has(x) && known.get(x) !== trace.y[i]);
  });
}

/**
 * Model minus exact, or that over exact; null where either is missing or exact is 0.
 * @param {readonly (number | null)[]} values
 * @param {readonly (number | null)[]} exact
 * @param {boolean} relative
 * @returns {(number | null)[]}
 */
export function errorOf(values, exact, relative) {
  return values.map((value, i) => {
    const right = exact[i];
    if (value === null || right === null || right === undefined) return null;
    if (!relative) return value - right;
    return right === 0 ? null : (value - right) / right;
  });
}

/**
 * @param {readonly Trace[]} traces of `curveTraces`
 * @param {boolean} relative
 * @returns {Trace[]}
 */
export function errorTraces(traces, relative) {
  const zero = traces.find((t) => t.id === "exact");
  if (!zero) return [];
  return [
    { ...zero, label: "", width: 1.2, y: zero.x.map(() => 0) },
    ...traces
      .filter((t) => !t.id.startsWith("exact"))
      .map((trace) => {
        const at = trace.id.indexOf("@");
        const exact = traces.find(
          (t) => t.id === (at < 0 ? "exact" : `exact${trace.id.slice(at)}`),
        );
        return { ...trace, y: errorOf(trace.y, exact?.y ?? [], relative) };
      }),
  ];
}

/**
 * A range that holds all values in round steps, zero included, of one size up and down to the step.
 * @param {readonly Trace[]} traces
 * @returns {[number, number]}
 */
export function errorRange(traces) {
  let low = 0;
  let high = 0;
  for (const { y } of traces) {
    for (const value of y) {
      if (value === null || !Number.isFinite(value)) continue;
      low = Math.min(low, value);
      high = Math.max(high, value);
    }
  }
  if (low === high) return [-0.1, 0.1];
  // Rounding noise of an exact form is shown as the line that it is.
  const span = Math.max(high - low, 1e-9);
  const least = span / 4;
  const power = 10 ** Math.floor(Math.log10(least));
  const step = ([1, 2, 2.5, 5, 10].find((f) => f * power >= least * (1 - 1e-9)) ?? 10) * power;
  /** @param {number} value */
  const tidy = (value) => Number(value.toPrecision(12));
  const down = Math.floor(low / step + 1e-9);
  const up = Math.ceil(high / step - 1e-9);
  return [
    tidy((down === 0 && up === 0 ? -1 : down) * step),
    tidy((up === 0 && down === 0 ? 1 : up) * step),
  ];
}
