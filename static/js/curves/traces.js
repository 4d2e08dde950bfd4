/** What the plot of the Explore view shows, in the unit of its axis. */

import { modelTraces } from "../models/look.js";
import { inUnit } from "../numbers/format.js";
import { allLandmarksOf, values } from "./reading.js";

/**
 * @typedef {{polarization: string, angle: 'deg' | 'rad', show: string[], models: string[], marks: boolean}} Shown
 */

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
      const y = branch(values(curves, id)).map((d) => (d === null ? null : inUnit(d, shown.angle)));
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
    range: /** @type {[number, number]} */ ([0, inUnit(90, angle)]),
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
      range: /** @type {[number, number]} */ ([0, 1]),
    },
    y2: shown.show.includes("phase")
      ? {
          title: "phase",
          range: /** @type {[number, number]} */ ([
            inUnit(-190, shown.angle),
            inUnit(190, shown.angle),
          ]),
          ticks: {
            values: PHASES.map((d) => inUnit(d, shown.angle)),
            text: rad ? HALVES : PHASES.map((d) => `${d}°`.replace("-", "−")),
          },
        }
      : null,
  };
}
