import assert from "node:assert/strict";
import { test } from "node:test";
import { matches } from "../../static/js/compare/chooser.js";
import { convertPath, filled, printValue, texts } from "../../static/js/compare/conversions.js";
import {
  against,
  compareFields,
  errorShown,
  focused,
  ranges,
  showingError,
} from "../../static/js/compare/fields.js";
import { later, queries, restCalls } from "../../static/js/compare/queries.js";
import { COLUMNS, printCost, short, sorted } from "../../static/js/errors/metrics.js";
import { curveTraces, distinct, errorRange, errorTraces } from "../../static/js/errors/traces.js";
import { EXAMPLES, shows, stateOf } from "../../static/js/models/examples.js";
import { createState, modelFields, parameterQuery } from "../../static/js/state/state.js";
import { lutPath, rgbLutPath } from "../../static/js/takeaway/fields.js";
import { pick } from "./catalog.js";

/** @param {string} name @param {Partial<Parameter>} rest @returns {Parameter} */
const parameter = (name, rest = {}) => ({
  name,
  symbol: name,
  default: null,
  minimum: 0,
  maximum: 1,
  unit: "",
  description: "",
  ...rest,
});

/** @param {string} id @param {Partial<Model>} rest @returns {Model} */
const model = (id, rest = {}) => ({
  id,
  title: id,
  kind: "approximation",
  applies_to: ["dielectric"],
  parameters: [],
  latex: "",
  reference: "",
  validity: "",
  cost: {},
  ...rest,
});

const MODELS = [
  model("exact", { kind: "exact" }),
  model("lut_1d", {
    parameters: [
      parameter("size", { default: 256, minimum: 2, maximum: 4096, integer: true }),
      parameter("filtering", {
        default: 1,
        choices: [
          ["nearest", 0],
          ["linear", 1],
        ],
      }),
    ],
  }),
  model("one_minus_cos"),
  model("schlick", { title: "Schlick", reference: "C. Schlick 1994" }),
  model("spherical_gaussian", { parameters: [parameter("F0", { triple: true })] }),
];
/** @type {Catalog} */
const CATALOG = {
  models: MODELS,
  materials: [],
  parameters: [
    parameter("n_i", { default: 1, minimum: 1e-3, maximum: 100 }),
    parameter("n_t", { default: 1.5, minimum: 1e-3, maximum: 100 }),
    parameter("k_t", { default: 0, maximum: 100 }),
  ],
};

/** @param {Record<string, any>} patch @returns {Record<string, any>} */
function stateWith(patch = {}) {
  const fields = compareFields(CATALOG);
  return {
    n_i: 1,
    n_t: 1.5,
    k_t: 0,
    angle: "deg",
    theta_i_deg: 64,
    ...Object.fromEntries(Object.entries(fields).map(([key, field]) => [key, field.default])),
    ...patch,
  };
}

/** @param {string} model @param {(number | null)[]} values @param {string} [quantity] */
const curve = (model, values, quantity = "R") => ({ model, quantity, values });
/** @param {number} n_t @param {ReturnType<typeof curve>[]} all @returns {any} */
const curves = (n_t, ...all) => ({
  interface: { n_i: 1, n_t, k_t: 0, F0: 0.04 },
  theta_i_deg: [0, 45, 90],
  curves: all,
});

test("an empty choice of models is said in the link, and the default is not", () => {
  const state = createState(compareFields(CATALOG));
  assert.equal(state.toQuery(), "");
  assert.deepEqual(against(state.get()), ["schlick", "spherical_gaussian", "generalized_schlick"]);
  state.set({ models: Object.freeze([]) }, { history: "none" });
  assert.equal(state.toQuery(), "models=none");
  assert.deepEqual(state.fromQuery("?models=none&family=1.3,2"), []);
  assert.deepEqual(against(state.get()), []);
  assert.deepEqual(state.get().family, [1.3, 2]);
  assert.equal(state.fromQuery("?models=schlick,nobody&family=0&over=space").length, 3);
});

test("a model's own parameters: whole numbers, words and triples, and only those that differ", () => {
  const fields = modelFields(MODELS);
  assert.equal(fields["lut_1d.filtering"]?.default, "linear");
  assert.throws(() => fields["lut_1d.size"]?.parse("2.5"), /whole/);
  assert.throws(() => fields["spherical_gaussian.F0"]?.parse("1,2,3"), /0 to 1/);
  assert.throws(() => fields["spherical_gaussian.F0"]?.parse("0.1,0.2"), /three/);
  assert.deepEqual(fields["spherical_gaussian.F0"]?.parse("1,0.5,0"), [1, 0.5, 0]);
  const state = stateWith({ "lut_1d.size": 16, "spherical_gaussian.F0": [1, 0.5, 0] });
  assert.deepEqual(parameterQuery(state, MODELS, ["lut_1d", "schlick"]), ["lut_1d.size=16"]);
  assert.deepEqual(parameterQuery(state, MODELS, ["spherical_gaussian"]), [
    "spherical_gaussian.F0=1,0.5,0",
  ]);
});

test("while something moves only curves are asked for, and slow questions come last", () => {
  const state = stateWith({ n_t: 2, family: [3], over: "theta-n" });
  assert.deepEqual(Object.keys(queries(state, CATALOG, true)), ["curves", "curves@3"]);
  const { map, curves: path } = queries(state, CATALOG, false);
  assert.match(
    path ?? "",
    /^\/curves\?n_t=2&models=exact,schlick,spherical_gaussian,generalized_schlick&landmarks=true$/,
  );
  assert.match(map ?? "", /x=theta_i_deg&.*x_steps=181&y=n_t&.*y_steps=121&metric=error&digits=4/);
  assert.doesNotMatch(map ?? "", /[?&]n_t=/);
  assert.deepEqual(Object.keys(later(state, CATALOG)), [
    "errors",
    "convert",
    "recommend",
    "shader",
    "lut",
  ]);
  const swept = later(stateWith({ over: "k" }), CATALOG);
  assert.match(swept["sweep:schlick"] ?? "", /over=k_t&minimum=0&maximum=5&steps=201$/);
  assert.ok(restCalls(state, CATALOG).every((p) => p.startsWith("/")));
});

test("a model with three values of a parameter has curves but no sweep and no map", () => {
  const state = stateWith({ "spherical_gaussian.F0": [1, 0.5, 0], focus: "spherical_gaussian" });
  assert.ok(!("sweep:spherical_gaussian" in later(state, CATALOG)));
  assert.ok(!("map" in queries({ ...state, over: "n-k" }, CATALOG)));
});

test("the figure's ranges follow the media unless they are set", () => {
  assert.deepEqual(ranges(stateWith()).n_t, [1.05, 3.05]);
  assert.deepEqual(ranges(stateWith({ n_t: 4 })).n_t, [1.05, 5]);
  assert.deepEqual(ranges(stateWith({ k_t: 2 })).n_t, [0.1, 5]);
  assert.deepEqual(ranges(stateWith({ n_i: 1.5, n_t: 1 })).n_t, [0.45, 1.5]);
  assert.deepEqual(ranges(stateWith({ n_low: 2, n_high: 1.2 })).n_t, [1.2, 2]);
  assert.equal(focused(stateWith({ focus: "lut_1d" })), "schlick");
});

test("errors are model minus exact, or that over exact in percent, null where exact is 0", () => {
  const traces = curveTraces(
    curves(1.5, curve("exact", [0, 0.1, 1]), curve("schlick", [0.01, 0.2, 1])),
    ["schlick"],
    MODELS,
    (d) => d,
  );
  assert.deepEqual(
    errorTraces(traces, false).map((t) => [t.id, t.y]),
    [
      ["exact", [0, 0, 0]],
      ["schlick", [0.01, 0.1, 0]],
    ],
  );
  assert.deepEqual(errorTraces(traces, true)[1]?.y, [null, 100, 0]);
  const [low, high] = errorRange(errorTraces(traces, false));
  assert.ok(low <= 0 && high >= 0.1 && high <= 0.15);
  assert.deepEqual(errorRange([]), [-0.1, 0.1]);
});

test("a family adds curves, and a model that knows no index adds none, yet has its error", () => {
  const water = curves(1.33, curve("exact", [0.02, 0.03, 1]), curve("one_minus_cos", [0, 0.3, 1]));
  const diamond = curves(
    2.417,
    curve("exact", [0.17, 0.2, 1]),
    curve("one_minus_cos", [0, 0.3, 1]),
  );
  const traces = curveTraces(water, ["one_minus_cos"], MODELS, (d) => d, [
    { n: 2.417, curves: diamond },
  ]);
  assert.deepEqual(pick(distinct(traces), "id"), ["exact", "one_minus_cos", "exact@2.417"]);
  const errors = errorTraces(traces, false);
  assert.equal(errors.find((t) => t.id === "one_minus_cos@2.417")?.y[0], -0.17);
});

test("a triple gives a curve for each channel", () => {
  const traces = curveTraces(
    curves(
      1.5,
      curve("exact", [0, 0, 1]),
      curve("schlick", [1, 1, 1], "R_red"),
      curve("schlick", [0, 0, 1], "R_blue"),
    ),
    ["schlick"],
    MODELS,
    (d) => d,
  );
  assert.deepEqual(
    traces.map((t) => [t.id, t.label, t.color]),
    [
      ["exact", "exact", "--R"],
      ["schlick.R_red", "Schlick R", "--red"],
      ["schlick.R_blue", "Schlick B", "--blue"],
    ],
  );
});

test("the table sorts by size, what is unknown last, costs by the server's weights", () => {
  /** @param {string} id @param {Partial<import("../../static/js/errors/metrics.js").Row>} rest @returns {any} */
  const row = (id, rest) => ({
    model: id,
    title: id,
    quantity: "R",
    in_domain: true,
    reason: null,
    ...rest,
  });
  const rows = [
    row("a", { title: "Zed", rms: 0.2, cosine_weighted_mean: -0.3 }),
    row("b", { rms: null, cosine_weighted_mean: null }),
    row("c", { rms: 0.1, cosine_weighted_mean: 0.2 }),
  ];
  const setting = {
    unit: /** @type {const} */ ("deg"),
    costs: new Map(),
    prices: new Map([
      ["a", 9],
      ["b", 1],
      ["c", 4],
    ]),
  };
  /** @param {string} by @param {'up' | 'down'} order */
  const ids = (by, order) => sorted(rows, by, order, setting).map((r) => r.model);
  assert.deepEqual(ids("rms", "up"), ["c", "a", "b"]);
  assert.deepEqual(ids("rms", "down"), ["a", "c", "b"]);
  assert.deepEqual(ids("cosine_weighted_mean", "down"), ["a", "c", "b"]);
  assert.deepEqual(ids("cost", "up"), ["b", "c", "a"]);
  assert.deepEqual(ids("model", "up"), ["b", "c", "a"]);
  assert.ok(COLUMNS.some((c) => c.name === "max_relative"));
});

test("errors are written short, costs as counts", () => {
  assert.equal(short(0.0356926), "0.0357");
  assert.equal(short(-0.975), "−0.975");
  assert.equal(short(null), "none");
  assert.equal(short(0), "0");
  assert.equal(printCost({ mul: 4, add: 2, div: 0, lookup: 1 }), "4× 2+ 1\u00a0texel");
  assert.equal(printCost({}), "0");
});

test("a search finds words in any order, in the title and in the reference", () => {
  const schlick = /** @type {Model} */ (MODELS[3]);
  assert.ok(matches(schlick, "1994 schlick"));
  assert.ok(!matches(schlick, "schlick 2005"));
});

test("each example is a state of its own that the page recognizes", () => {
  const presets = stateWith();
  assert.equal(new Set(EXAMPLES.map((e) => e.id)).size, EXAMPLES.length);
  for (const example of EXAMPLES) {
    const state = { ...presets, ...stateOf(example, presets) };
    assert.equal(state.example, example.id);
    assert.ok(shows(stateOf(example, presets), state));
    assert.ok(shows(stateOf(example, presets), { ...state, over: "n-k" }));
    assert.ok(!shows(stateOf(example, presets), { ...state, n_t: 7 }));
    assert.equal(later(state, CATALOG).claims, `/claims?example=${example.id}`);
  }
});

test("what is converted follows the media, the boxes and the picture's color", () => {
  assert.equal(convertPath(stateWith()), "/convert?from=ior&n_t=1.5");
  assert.equal(convertPath(stateWith({ k_t: 2 })), "/convert?from=nk&n_t=1.5&k_t=2");
  assert.equal(
    convertPath(stateWith({ from: "hex", given: "#FFE29b", n_i: 1.33 })),
    "/convert?from=f0_srgb&hex=FFE29b&n_i=1.33",
  );
  assert.equal(
    convertPath(stateWith({ from: "nk", given: "0,27;2,9" })),
    "/convert?from=nk&n_t=0.27&k_t=2.9",
  );
  assert.equal(
    convertPath(stateWith({ from: "gltf", given: "1,5;0,5;1,5" })),
    "/convert?from=gltf&ior=1.5&specularFactor=0.5&specularColorFactor=1,5",
  );
  assert.equal(
    convertPath(stateWith({ from: "f0", given: "1,5" })), // a list that is not whole, for the server to refuse
    "/convert?from=f0&F0=1,5",
  );
  assert.equal(
    convertPath(stateWith({ from: "rg", given: "0.9, 0.8,0.7;0.5", seen_from: 1.5 })),
    "/convert?from=rg&r=0.9,0.8,0.7&g=0.5&seen_from=1.5",
  );
  assert.equal(
    convertPath(stateWith({ material: "N-BK7" })),
    "/convert?from=ior&n_t=1.5&dispersion_of=N-BK7",
  );
  assert.equal(
    convertPath(stateWith({ from: "gltf", given: "1.5;0.5;1,0.8,0.6" })),
    "/convert?from=gltf&ior=1.5&specularFactor=0.5&specularColorFactor=1,0.8,0.6",
  );
  assert.deepEqual(texts({ from: "nk", given: null }), ["0.27", "2.9"]);
  assert.equal(printValue([1, null, 0.5]), "1, none, 0.5000");
  const results = [
    { form: "nk", title: "", status: "exact", why: "", values: { n_t: 0.123456789, k_t: 3 } },
    { form: "rg", title: "", status: "infeasible", why: "", values: { r: 0.9, g: null } },
  ];
  assert.equal(filled("nk", results), "0.123457;3");
  assert.equal(filled("rg", results), null);
});

test("the code shown is that of a model on the screen, of numbers or of colors", () => {
  const state = stateWith({ models: ["schlick"], language: "wgsl" });
  assert.equal(later(state, CATALOG).shader, "/shaders/schlick?language=wgsl");
  const colors = { ...state, channels: "3", code: "exact" };
  assert.equal(later(colors, CATALOG).shader, "/shaders/exact?language=wgsl&channels=3");
  const gone = { ...state, code: "spherical_gaussian" };
  assert.equal(later(gone, CATALOG).shader, "/shaders/schlick?language=wgsl");
});

test("a table is that of the model whose code is shown, with its parameters", () => {
  const state = stateWith({ models: ["lut_1d", "schlick"], "lut_1d.size": 16, n_t: 2 });
  assert.equal(later(state, CATALOG).lut, "/lut/errors?model=lut_1d&n_t=2&lut_1d.size=16");
  const exact = { ...state, code: "exact" };
  assert.equal(lutPath(exact, CATALOG, "exact", "/lut", ["size=8"]), "/lut?n_t=2&size=8");
  assert.equal(rgbLutPath(exact, CATALOG, "exact"), null);
  const gold = { ...exact, material: "Au" };
  const materials = /** @type {any} */ ([{ id: "Au", n_range_nm: [300, 800] }]);
  const found = rgbLutPath(gold, { ...CATALOG, materials }, "exact");
  assert.equal(found, "/lut?material=Au&n_i=1&channels=3");
  assert.equal(rgbLutPath(gold, { ...CATALOG, materials }, "schlick"), null);
});

test("what is taken from Schlick's curve is shown beside that curve", () => {
  const bare = { models: ["one_minus_cos"], k_t: 0, error: "taken" };
  assert.equal(errorShown(bare), "signed");
  assert.equal(errorShown({ ...bare, models: ["schlick"] }), "taken");
  assert.deepEqual(showingError(bare, "taken"), {
    error: "taken",
    models: ["schlick", "one_minus_cos"],
  });
  assert.deepEqual(showingError(bare, "relative"), { error: "relative" });
  assert.deepEqual(showingError({ ...bare, models: ["schlick"] }, "taken"), { error: "taken" });
});
