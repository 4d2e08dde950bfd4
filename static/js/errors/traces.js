/** The curves of the Compare view and their errors, from the curves that the server sent. */

import { values } from "../curves/reading.js";
import { modelStyle, modelTraces, shortTitle, traceName } from "../models/look.js";
import { plain } from "../numbers/format.js";

/**
 * @typedef {{n: number, curves: Curves}} Member another index of the family
 */

/**
 * The exact curve and the models', then those of the other members of the family.
 * @param {Curves} curves
 * @param {readonly string[]} against
 * @param {Model[]} models
 * @param {(deg: number) => number} toUnit
 * @param {readonly Member[]} [family]
 * @param {boolean} [polarized] whether Rs and Rp stand behind R
 * @returns {Trace[]}
 */
export function curveTraces(curves, against, models, toUnit, family = [], polarized = false) {
  const { n_t } = curves.interface;
  const members = [{ n: n_t, curves }, ...family.filter((m) => m.n !== n_t)];
  return members.flatMap(({ n, curves: own }, index) => {
    const x = own.theta_i_deg.map(toUnit);
    const words = `n = ${plain(n, 4)}`;
    const exact = {
      id: "exact",
      label: family.length ? words : "exact",
      color: "--R",
      dash: "solid",
      width: index ? 1.5 : 2.6,
      x,
      y: values(own, "R"),
    };
    const others = modelTraces(own, against, models, x);
    if (index === 0)
      return [exact, ...others, ...(polarized ? polarizedTraces(own, against, models, x) : [])];
    return [
      { ...exact, id: `exact@${n}` },
      ...others.map((t) => ({
        ...t,
        id: `${t.id}@${n}`,
        label: `${t.label}, ${words}`,
        width: 1.4,
      })),
    ];
  });
}

/** @type {Record<string, {label: string, color: string, dash: string}>} */
const POLARIZED = {
  Rs: { label: "R_s", color: "--Rs", dash: "solid" },
  Rp: { label: "R_p", color: "--Rp", dash: "dash" },
};

/**
 * Rs and Rp of the exact curve, and in their colors with their own dashes those of the models that tell
 * them apart. @param {Curves} curves @param {readonly string[]} against @param {Model[]} models @param {number[]} x
 * @returns {Trace[]}
 */
function polarizedTraces(curves, against, models, x) {
  return curves.curves
    .filter((c) => c.quantity in POLARIZED && (c.model === "exact" || against.includes(c.model)))
    .map(({ model, quantity, values: y }) => {
      const look = /** @type {typeof POLARIZED[string]} */ (POLARIZED[quantity]);
      const own = model === "exact" ? look : { ...look, dash: modelStyle(models, model).dash };
      const title = shortTitle(models.find((m) => m.id === model)?.title ?? model);
      const label = model === "exact" ? look.label : `${title} ${look.label}`;
      return { ...own, id: traceName(model, quantity), label, x, y, width: 1.7 };
    });
}

/** @param {Trace} trace */
export const isPolarized = ({ id }) => /\.R[sp]$/.test(id);

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
 * Model minus exact, or that over exact in percent; null where either is missing or exact is 0.
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
    return right === 0 ? null : 100 * ((value - right) / right);
  });
}

/**
 * @param {readonly Trace[]} traces of `curveTraces`
 * @param {boolean} relative
 * @returns {Trace[]} the exact curve's is the line at 0
 */
export function errorTraces(traces, relative) {
  const unit = relative ? " %" : undefined;
  return traces
    .filter((t) => !t.id.startsWith("exact@") && !isPolarized(t))
    .map((trace) => {
      if (trace.id === "exact")
        return { ...trace, unit, label: "", width: 1.2, y: trace.x.map(() => 0) };
      const at = trace.id.indexOf("@");
      const exact = traces.find((t) => t.id === (at < 0 ? "exact" : `exact${trace.id.slice(at)}`));
      return { ...trace, unit, y: errorOf(trace.y, exact?.y ?? [], relative) };
    });
}

/**
 * What models take away from Schlick's curve, beside what would have to be taken: Schlick minus exact.
 * @param {readonly Trace[]} traces of `curveTraces`
 * @returns {Trace[] | null} null where Schlick's is none of them
 */
export function takenTraces(traces) {
  const schlick = traces.find((t) => t.id === "schlick");
  if (!schlick) return null;
  return traces
    .filter((t) => t !== schlick && !t.id.includes("@") && !isPolarized(t))
    .map((t) => ({
      ...t,
      label: t.id === "exact" ? "needed" : t.label,
      y: errorOf(schlick.y, t.y, false),
    }));
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
