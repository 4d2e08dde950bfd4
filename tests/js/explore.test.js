import assert from "node:assert/strict";
import { test } from "node:test";
import {
  allLandmarksOf,
  axesOf,
  landmarksOf,
  locate,
  marksOf,
  read,
  readingAt,
  tracesOf,
} from "../../static/js/curves/reading.js";
import { pick } from "./catalog.js";

/** @type {Interface} */
const MEDIA = {
  n_i: 1,
  n_t: 1.5,
  k_t: 0,
  eta: 1.5,
  kappa: 0,
  kind: "dielectric",
  F0: 0.04,
  F82: 0.45,
  brewster_deg: 56.3,
  critical_deg: null,
  pseudo_brewster_deg: 56.3,
  principal_deg: 56.3,
};

/** @param {Partial<typeof MEDIA>} [media] */
function curves(media = {}) {
  /** @param {string} quantity @param {(number | null)[]} values @param {string} [model] */
  const curve = (quantity, values, model = "exact") => ({ model, quantity, values });
  return {
    interface: { ...MEDIA, ...media },
    theta_i_deg: [0, 45, 90],
    curves: [
      curve("R", [0.04, 0.05, 1]),
      curve("Rs", [0.04, 0.09, 1]),
      curve("Rp", [0.04, 0.01, 1]),
      curve("T", [0.96, 0.95, 0]),
      curve("theta_t_deg", [0, 28, 42]),
      curve("penetration_depth_wavelengths", [null, 0.2, 0.1]),
      curve("field_penetration_depth_wavelengths", [null, 0.4, 0.2]),
      curve("phase_s_deg", [180, 180, 180]),
      curve("phase_p_deg", [-90, -179, 180]),
      curve("R", [0.04, 0.06, 1], "schlick"),
    ],
  };
}

/** @type {Shown} */
const SHOWN = { polarization: "unpolarized", angle: "deg", show: [], models: [], marks: true };
const MODELS = /** @type {any} */ ([
  { id: "exact", title: "Exact" },
  { id: "schlick", title: "Schlick" },
]);

test("between samples the curves answer, and what is not reflected passes", () => {
  const reading = readingAt(curves(), undefined, 22.5);
  assert.equal(reading.Rs, 0.065);
  assert.equal(reading.R + reading.T, 1);
  assert.equal(reading.theta_t_deg, 14);
  assert.equal(reading.penetration_depth_wavelengths, null);
  assert.equal(reading.field_penetration_depth_wavelengths, null);
  assert.equal(reading.tir, false);
  assert.equal(reading.snell, null);
});

test("the server's answer for this angle and these media replaces the interpolation", () => {
  const snell = /** @type {any} */ ({
    interface: MEDIA,
    theta_i_deg: 22.5,
    theta_t_deg: 14.8,
    total_internal_reflection: false,
    R: 0.0401,
    Rs: 0.05,
    Rp: 0.03,
    T: 0.9599,
    Ts: 0.95,
    Tp: 0.97,
    penetration_depth_wavelengths: null,
    field_penetration_depth_wavelengths: null,
  });
  assert.equal(readingAt(curves(), snell, 22.5).R, 0.0401);
  assert.equal(readingAt(curves(), snell, 22.6).snell, null);
  assert.equal(readingAt(curves({ n_t: 1.6 }), snell, 22.5).snell, null);
});

test("beyond the critical angle there is no refracted ray", () => {
  const reading = readingAt(curves({ critical_deg: 41.8 }), undefined, 60);
  assert.equal(reading.tir, true);
  assert.equal(reading.theta_t_deg, null);
});

test("landmarks are those that exist, each named once", () => {
  assert.deepEqual(pick(landmarksOf(MEDIA), "label"), ["Brewster"]);
  assert.deepEqual(pick(landmarksOf({ ...MEDIA, critical_deg: 41.8 }), "label"), [
    "Brewster",
    "critical",
  ]);
  const metal = { ...MEDIA, brewster_deg: null, pseudo_brewster_deg: 70, principal_deg: 71 };
  assert.deepEqual(landmarksOf(metal), [{ deg: 70, label: "pseudo-Brewster" }]);
  assert.deepEqual(allLandmarksOf(metal), [
    { deg: 70, label: "pseudo-Brewster" },
    { deg: 71, label: "principal" },
  ]);
  assert.deepEqual(allLandmarksOf(MEDIA), landmarksOf(MEDIA));
});

test("the plot shows R, Rs and Rp, and what is laid over them", () => {
  assert.deepEqual(pick(tracesOf(curves(), SHOWN, MODELS), "id"), ["Rs", "Rp", "R"]);
  const shown = { ...SHOWN, show: ["T", "phase"], models: ["schlick", "coming"] };
  assert.deepEqual(pick(tracesOf(curves(), shown, MODELS), "id"), [
    "Rs",
    "Rp",
    "R",
    "T",
    "schlick",
    "phase_s_deg",
    "phase_p_deg",
  ]);
});

test("a phase that ends at 180 degrees is drawn where its curve arrives", () => {
  const traces = tracesOf(curves(), { ...SHOWN, show: ["phase"] }, MODELS);
  assert.deepEqual(traces.at(-1)?.y, [-90, -179, -180]);
  assert.deepEqual(traces.at(-2)?.y, [180, 180, 180]);
});

test("radians reach the abscissa, its marks and the phases", () => {
  const shown = { ...SHOWN, angle: /** @type {const} */ ("rad"), show: ["phase"] };
  assert.deepEqual(tracesOf(curves(), shown, MODELS)[0]?.x, [0, Math.PI / 4, Math.PI / 2]);
  assert.equal(marksOf(curves({ brewster_deg: 45 }), shown)[0]?.x, Math.PI / 4);
  assert.deepEqual(axesOf(shown).x.range, [0, Math.PI / 2]);
  assert.equal(axesOf(SHOWN).y2, null);
});

const xs = [0, 1, 2, 2.5, 3];
const ys = [0, 10, 20, null, 30];

/** @param {number} x */
const at = (x) => read(ys, locate(xs, x));

test("linear between samples, exact at them", () => {
  assert.equal(at(0), 0);
  assert.equal(at(0.25), 2.5);
  assert.equal(at(1), 10);
  assert.equal(at(2), 20);
  assert.equal(at(3), 30);
});

test("a gap stays a gap", () => {
  assert.equal(at(2.2), null);
  assert.equal(at(2.5), null);
  assert.equal(at(2.7), null);
});

test("outside the samples the end value is read", () => {
  assert.equal(at(-1), 0);
  assert.equal(at(4), 30);
  assert.equal(read([], locate([], 1)), null);
});
