import assert from "node:assert/strict";
import { test } from "node:test";
import { largestOf, pointsOf } from "../../static/js/atlas/answers.js";
import { atlasFields, csvPath, hasColor, queries, within } from "../../static/js/atlas/fields.js";
import { told } from "../../static/js/atlas/formulas.js";
import { createState, LinkError } from "../../static/js/state/state.js";

const MODELS = /** @type {Model[]} */ ([
  { id: "exact", kind: "exact" },
  { id: "cos_form", kind: "exact" },
  { id: "schlick", kind: "approximation", takes_color: true },
  { id: "one_minus_cos", kind: "approximation" },
  { id: "schlick_four_percent", kind: "approximation", trap: true },
]);
const CATALOG = /** @type {Catalog} */ ({ models: MODELS, materials: [], parameters: [] });

/** @param {string} [search] */
function stateOf(search = "") {
  const state = createState(atlasFields(CATALOG));
  assert.deepEqual(state.fromQuery(search), []);
  return state.get();
}

test("the address asks for what is chosen, and for nothing else", () => {
  assert.deepEqual(queries(stateOf()), { atlas: "/atlas?model=schlick&digits=5" });
  const chosen = stateOf(
    "?atlas_model=one_minus_cos&atlas_metric=rms&atlas_within=0.02&atlas_kind=metal" +
      "&atlas_band=elsewhere&atlas_shelf=main&atlas_find=%20Johnson%20&atlas_at=rii%3Amain%2FAg%2FChoi",
  );
  const asked =
    "/atlas?model=one_minus_cos&metric=rms&within=0.02&kind=metal&band=elsewhere&shelf=main&q=Johnson";
  assert.deepEqual(queries(chosen), {
    atlas: `${asked}&digits=5`,
    material: "/atlas/material?material=rii%3Amain%2FAg%2FChoi&digits=5",
  });
  assert.equal(csvPath(chosen), `${asked}&format=csv`);
});

test("what counts as small follows the measure, unless it is typed", () => {
  assert.equal(within(stateOf()), 0.01);
  assert.equal(within(stateOf("?atlas_metric=delta_e")), 1);
  assert.equal(within(stateOf("?atlas_metric=delta_e&atlas_within=3")), 3);
});

test("a link names what an atlas cannot have", () => {
  const { atlas_metric, atlas_within } = atlasFields(CATALOG);
  assert.throws(() => atlas_metric?.parse("largest"), LinkError);
  assert.throws(() => atlas_within?.parse("0"), LinkError);
});

test("only models that are given a color have a color difference", () => {
  const able = MODELS.filter(({ id }) => hasColor(CATALOG, id)).map(({ id }) => id);
  assert.deepEqual(able, ["exact", "schlick"]);
});

test("columns become materials, with all that is told of each", () => {
  const answer = /** @type {any} */ ({
    points: {
      material: ["Au", "H2O"],
      name: ["Gold", "Water"],
      error: [0.1, null],
      k: [2.9, null],
    },
  });
  assert.deepEqual(pointsOf(answer), [
    { id: "Au", name: "Gold", error: 0.1, k: 2.9 },
    { id: "H2O", name: "Water", error: null, k: null },
  ]);
});

test("of signed errors the largest in size counts, and an undefined one above all", () => {
  const rows = /** @type {any} */ ({
    albedo_error: [0.01, -0.03],
    max_abs: [0.1, null],
    delta_e: 2,
  });
  assert.equal(largestOf(rows, "albedo_error"), 0.03);
  assert.equal(largestOf(rows, "max_abs"), null);
  assert.equal(largestOf(rows, "delta_e"), 2);
});

test("formulas stand by how often they do, traps last; exact forms only where they are not exact", () => {
  /** @param {string} model @param {number} small @param {boolean} [trap] */
  const share = (model, small, trap = false) => ({
    model,
    title: model,
    trap,
    sentence: "",
    kinds: [
      {
        kind: "clear",
        materials: 10,
        within: small,
        undefined: 0,
        median: 0,
        largest: 0,
        largest_of: null,
      },
    ],
  });
  const shares = [
    share("exact", 10),
    share("cos_form", 10),
    share("schlick_four_percent", 9, true),
    share("one_minus_cos", 1),
    share("schlick", 5),
  ];
  const ids = (/** @type {string} */ metric) => told(shares, MODELS, metric).map((s) => s.model);
  assert.deepEqual(ids("max_abs"), ["schlick", "one_minus_cos", "schlick_four_percent"]);
  assert.equal(ids("delta_e")[0], "exact");
});
