import assert from "node:assert/strict";
import { test } from "node:test";
import { boundsOf, cameraAt, rowsBelow } from "../../static/js/preview/camera.js";
import { tableOf, texelsOf } from "../../static/js/preview/curves.js";
import {
  amplification,
  ciede2000,
  differenceOf,
  lab,
  verdictOf,
} from "../../static/js/preview/difference.js";
import { putRight, sided } from "../../static/js/preview/fields.js";
import { coloredMaterial, later, queries, sidePaths } from "../../static/js/preview/queries.js";
import { INTERVALS, UNDEFINED } from "../../static/js/preview/shader.js";
import { PARAMETERS } from "./catalog.js";

/**
 * Table 1 of G. Sharma, W. Wu and E. Dalal, The CIEDE2000 color-difference formula, Color Res. Appl. 30
 * (2005) 21: two colors L*, a*, b* and their difference, rounded to four digits.
 * @type {[number, number, number, number, number, number, number][]}
 */
const SHARMA = [
  [50, 2.6772, -79.7751, 50, 0, -82.7485, 2.0425],
  [50, 3.1571, -77.2803, 50, 0, -82.7485, 2.8615],
  [50, 2.8361, -74.02, 50, 0, -82.7485, 3.4412],
  [50, -1.3802, -84.2814, 50, 0, -82.7485, 1],
  [50, -1.1848, -84.8006, 50, 0, -82.7485, 1],
  [50, -0.9009, -85.5211, 50, 0, -82.7485, 1],
  [50, 0, 0, 50, -1, 2, 2.3669],
  [50, -1, 2, 50, 0, 0, 2.3669],
  [50, 2.49, -0.001, 50, -2.49, 0.0009, 7.1792],
  [50, 2.49, -0.001, 50, -2.49, 0.001, 7.1792],
  [50, 2.49, -0.001, 50, -2.49, 0.0011, 7.2195],
  [50, 2.49, -0.001, 50, -2.49, 0.0012, 7.2195],
  [50, -0.001, 2.49, 50, 0.0009, -2.49, 4.8045],
  [50, -0.001, 2.49, 50, 0.001, -2.49, 4.8045],
  [50, -0.001, 2.49, 50, 0.0011, -2.49, 4.7461],
  [50, 2.5, 0, 50, 0, -2.5, 4.3065],
  [50, 2.5, 0, 73, 25, -18, 27.1492],
  [50, 2.5, 0, 61, -5, 29, 22.8977],
  [50, 2.5, 0, 56, -27, -3, 31.903],
  [50, 2.5, 0, 58, 24, 15, 19.4535],
  [50, 2.5, 0, 50, 3.1736, 0.5854, 1],
  [50, 2.5, 0, 50, 3.2972, 0, 1],
  [50, 2.5, 0, 50, 1.8634, 0.5757, 1],
  [50, 2.5, 0, 50, 3.2592, 0.335, 1],
  [60.2574, -34.0099, 36.2677, 60.4626, -34.1751, 39.4387, 1.2644],
  [63.0109, -31.0961, -5.8663, 62.8187, -29.7946, -4.0864, 1.263],
  [61.2901, 3.7196, -5.3901, 61.4292, 2.248, -4.962, 1.8731],
  [35.0831, -44.1164, 3.7933, 35.0232, -40.0716, 1.5901, 1.8645],
  [22.7233, 20.0904, -46.694, 23.0331, 14.973, -42.5619, 2.0373],
  [36.4612, 47.858, 18.3852, 36.2715, 50.5065, 21.2231, 1.4146],
  [90.8027, -2.0831, 1.441, 91.1528, -1.6435, 0.0447, 1.4441],
  [90.9257, -0.5406, -0.9208, 88.6381, -0.8985, -0.7239, 1.5381],
  [6.7747, -0.2908, -2.4247, 5.8714, -0.0985, -2.2286, 0.6377],
  [2.0776, 0.0795, -1.135, 0.9033, -0.0636, -0.5514, 0.9082],
];

test("CIEDE2000 gives the published test data, both ways round", () => {
  for (const [L1, a1, b1, L2, a2, b2, expected] of SHARMA) {
    const [one, two] = /** @type {const} */ ([
      [L1, a1, b1],
      [L2, a2, b2],
    ]);
    assert.ok(Math.abs(ciede2000(one, two) - expected) < 5.1e-5, `${one} ${two}`);
    assert.ok(Math.abs(ciede2000(two, one) - expected) < 5.1e-5, `${two} ${one}`);
  }
});

test("L*a*b* of sRGB's corners", () => {
  // B. Lindbloom's calculator, sRGB, D65, no adaptation.
  /** @type {[number, number, number, number, number, number][]} */
  const known = [
    [255, 0, 0, 53.2408, 80.0925, 67.2032],
    [0, 255, 0, 87.7347, -86.1827, 83.1793],
    [0, 0, 255, 32.297, 79.1875, -107.8602],
    [255, 255, 255, 100, 0, 0],
    [0, 0, 0, 0, 0, 0],
  ];
  for (const [r, g, b, ...expected] of known)
    lab(r, g, b).forEach((x, i) => {
      assert.ok(Math.abs(x - Number(expected[i])) < 0.02, `${r} ${g} ${b}: ${x}`);
    });
});

test("only pixels that are all surface count", () => {
  const left = Uint8Array.of(10, 10, 10, 255, 0, 0, 0, 128, 50, 50, 50, 255, 9, 9, 9, 0);
  const right = Uint8Array.of(10, 10, 10, 255, 99, 0, 0, 128, 50, 56, 47, 255, 200, 9, 9, 0);
  const { pixels, steps, colors } = differenceOf(left, right);
  assert.equal(pixels, 2);
  assert.deepEqual(steps, { mean: 3, largest: 6 });
  const one = ciede2000(lab(50, 50, 50), lab(50, 56, 47));
  assert.deepEqual(colors, { mean: one / 2, largest: one });
  assert.deepEqual(differenceOf(left, left).colors, { mean: 0, largest: 0 });
});

const theta = Array.from({ length: 721 }, (_, i) => i / 8);
/** @param {(mu: number) => number | null} f */
const answerOf = (f) => ({
  interface: /** @type {any} */ ({}),
  theta_i_deg: theta,
  curves: [
    { model: "m", quantity: "R", values: theta.map((t) => f(Math.cos((t * Math.PI) / 180))) },
  ],
});

test("a curve over the angle becomes a texture over its cosine", () => {
  const f = (/** @type {number} */ mu) => 0.04 + 0.96 * (1 - mu) ** 5;
  const texels = texelsOf([answerOf(f)], "m");
  assert.equal(texels.length, 4 * (INTERVALS + 1));
  for (let j = 0; j <= INTERVALS; j += 1)
    for (const c of [0, 1, 2])
      assert.ok(Math.abs(Number(texels[4 * j + c]) - f(j / INTERVALS)) < 2e-5, `texel ${j}`);
  const table = tableOf(texels, 5);
  assert.deepEqual(
    [0, 1, 2, 3, 4].map((j) => table[4 * j]),
    [0, 0.25, 0.5, 0.75, 1].map((mu) => Math.round(255 * f(mu))),
  );
});

test("R, G and B have a curve each, and where a model is undefined no color", () => {
  const [red, green, blue] = [0.9, 0.6, 0.3].map((x) => answerOf(() => x));
  const texels = texelsOf(/** @type {any[]} */ ([red, green, blue]), "m");
  assert.deepEqual([...texels.slice(40, 44)], [...Float32Array.of(0.9, 0.6, 0.3, 1)]);
  const broken = texelsOf([answerOf((mu) => (mu > 0.5 ? 0.2 : null))], "m");
  assert.equal(broken[0], UNDEFINED);
  assert.equal(broken[4 * INTERVALS], Math.fround(0.2));
});

test("the camera sees its target in the middle, balls in their rectangles and the horizon as a line", () => {
  const camera = cameraAt({ yaw: 0, pitch: 0, distance: 6 });
  assert.deepEqual(camera.eye, [0, 0.72, 6]);
  // A ball around the target fills a disc: tangents at asin(1 / 6) from the axis.
  const unit = 256 / camera.lens;
  const rim = Math.tan(Math.asin(1 / 6)) * unit;
  const box = boundsOf(camera, { center: [0, 0.72, 0], radius: 1 }, [512, 512]);
  assert.ok(box);
  assert.ok(Math.abs(box[0] - (256 - rim)) < 4 && box[0] <= 256 - rim);
  assert.ok(box[0] + box[2] >= 256 + rim);
  assert.equal(rowsBelow(camera, [512, 512]), 256);
  const down = cameraAt({ yaw: 30, pitch: 10, distance: 6 });
  const row = 256 + (Math.tan((10 * Math.PI) / 180) / down.lens) * 256;
  assert.ok(Math.abs(rowsBelow(down, [512, 512]) - row) < 1);
  assert.equal(boundsOf(camera, { center: [0, 0.72, 20], radius: 1 }, [512, 512]), null);
});

/** @type {any} */
const catalog = {
  parameters: PARAMETERS,
  models: [
    { id: "exact", parameters: [] },
    { id: "schlick", parameters: [{ name: "F0", default: null }], takes_color: true },
    { id: "pharr_humphreys", parameters: [] },
  ],
  materials: [
    { id: "Au", kind: "spectrum", n_range_nm: [300, 20000] },
    { id: "UV", kind: "spectrum", n_range_nm: [100, 400] },
    { id: "Au-shirley", kind: "single", n_range_nm: null },
  ],
};
const state = {
  ...{ n_i: 1, n_t: 1.5, k_t: 0, incident: null, material: null, wavelength_nm: null },
  ...{ left: "exact", right: "schlick", scene: "ball", sky: "day" },
  ...{ body: "paint", paint: "#ff0000", colors: "rgb" },
};

test("one question for both sides of an interface, the paint by channel, the water", () => {
  assert.deepEqual(queries(state, catalog), {
    curves: "/curves?models=exact,schlick&samples=721&digits=7",
    "coat.red": "/albedo/coat?body_albedo=1",
    "coat.green": "/albedo/coat?body_albedo=0",
    "coat.blue": "/albedo/coat?body_albedo=0",
    water: "/curves?n_t=1.333&samples=721&digits=7",
  });
  const dark = { ...state, k_t: 3, left: "none", right: "none", scene: "water" };
  assert.deepEqual(queries(dark, catalog), {});
});

test("a material is asked for in color, by its color or at three wavelengths", () => {
  const gold = { ...state, material: "Au", right: "pharr_humphreys" };
  assert.deepEqual(sidePaths(gold, catalog, "left"), {
    left: "/materials/Au/curves?models=schlick&wavelengths_nm=550&samples=721&digits=7",
  });
  assert.deepEqual(
    Object.values(sidePaths(gold, catalog, "right")),
    [630, 532, 465].map(
      (nm) => `/curves?material=Au&wavelength_nm=${nm}&models=pharr_humphreys&samples=721&digits=7`,
    ),
  );
  for (const other of [{ material: "UV" }, { material: "Au-shirley" }, { wavelength_nm: 500 }])
    assert.equal(coloredMaterial({ ...gold, ...other }, catalog), null);
});

test("code and tables are those of a model on the sides, or of what is exact", () => {
  const catalog = /** @type {any} */ ({ models: [], materials: [], parameters: PARAMETERS });
  const state = { left: "none", right: "none", language: "osl", n_i: 1, n_t: 2, code: null };
  assert.deepEqual(later({ ...state, k_t: 0 }, catalog), {
    shader: "/shaders/exact?language=osl",
    lut: "/lut/errors?n_t=2",
  });
  const one = { ...state, left: "schlick", right: "schlick", k_t: 0 };
  assert.equal(later(one, catalog).lut, "/lut/errors?model=schlick&n_t=2");
  assert.equal(later({ ...one, code: "exact" }, catalog).shader, "/shaders/exact?language=osl");
});

test("on the right stands the first model of all views, and what is put there is their first", () => {
  assert.equal(sided({ right: null, models: null }).right, "schlick");
  assert.equal(sided({ right: null, models: ["cos_form", "schlick"] }).right, "cos_form");
  assert.equal(sided({ right: "none", models: ["cos_form"] }).right, "none"); // as a link says
  const state = { right: "none", models: ["schlick", "cos_form"] };
  assert.deepEqual(putRight(state, "cos_form"), { right: null, models: ["cos_form", "schlick"] });
  assert.deepEqual(putRight(state, "exact"), { right: "exact" });
  assert.deepEqual(putRight({ right: null, models: null }, "cos_form"), {
    right: null,
    models: ["cos_form"],
  });
});

test("a difference is amplified until something shows, and not beyond the scale", () => {
  assert.equal(amplification(0), 1);
  assert.equal(amplification(255), 1);
  assert.equal(amplification(1), 200);
  for (let largest = 1; largest <= 100; largest += 1) {
    const shown = largest * amplification(largest);
    assert.ok(shown >= 80 && shown <= 200, `${largest}: ${shown}`);
  }
});

test("a color difference is told in words", () => {
  assert.equal(verdictOf(0), "not visible side by side");
  assert.equal(verdictOf(0.99), "not visible side by side");
  assert.equal(verdictOf(1), "hardly visible side by side");
  assert.equal(verdictOf(3), "visible side by side");
  assert.equal(verdictOf(40), "plain to see");
});
