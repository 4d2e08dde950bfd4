import assert from "node:assert/strict";
import { test } from "node:test";
import { modelStyle } from "../../static/js/models/look.js";

test("each model has a look of its own, the same wherever it stands", () => {
  const models = ["a", "exact", ..."bcdefghijklmnopqrstuvwx"].map((id) => ({ id }));
  const looks = models.map(({ id }) => JSON.stringify(modelStyle(models, id)));
  assert.equal(new Set(looks).size, models.length);
  assert.deepEqual(modelStyle(models, "exact"), { color: "--R", dash: "solid" });
  assert.equal(modelStyle(models, "a").color, "--model-1");
});

test("the models of d'Eon's figure keep their looks whatever else is registered", () => {
  const models = ["exact", "aa", "schlick", "bb", "pharr_humphreys", "complex_dielectric"].map(
    (id) => ({ id }),
  );
  const looks = models.map(({ id }) => JSON.stringify(modelStyle(models, id)));
  assert.equal(new Set(looks).size, models.length);
  assert.equal(modelStyle(models, "schlick").dash, "dash");
  assert.equal(modelStyle(models, "pharr_humphreys").dash, "dashdot");
  assert.deepEqual(modelStyle([{ id: "schlick" }], "schlick"), modelStyle(models, "schlick"));
});
