import assert from "node:assert/strict";
import { test } from "node:test";
import { fitStyle } from "../../static/js/albedo/style.js";
import { forMedium, modelStyle } from "../../static/js/models/look.js";

const MODELS = [
  { id: "exact", look: { color: "R", dash: "solid" } },
  { id: "schlick", look: { color: "model-1", dash: "dash" } },
  { id: "pharr_humphreys", look: { color: "model-4", dash: "dashdot" } },
];

test("each model has the look that the server tells, the same wherever it stands", () => {
  for (const models of [MODELS, [...MODELS].reverse(), [{ id: "new" }, ...MODELS]]) {
    assert.deepEqual(modelStyle(models, "exact"), { color: "--R", dash: "solid" });
    assert.deepEqual(modelStyle(models, "schlick"), { color: "--model-1", dash: "dash" });
    assert.deepEqual(modelStyle(models, "pharr_humphreys"), {
      color: "--model-4",
      dash: "dashdot",
    });
  }
});

test("a model that the server tells no look of is drawn all the same", () => {
  assert.deepEqual(modelStyle(MODELS, "new"), { color: "--muted", dash: "dot" });
});

test("fits that are the average of a model's curve look like that model", () => {
  assert.deepEqual(fitStyle("schlick"), modelStyle(MODELS, "schlick"));
  assert.deepEqual(fitStyle("dunkle_1963"), modelStyle(MODELS, "pharr_humphreys"));
});

test("of a metal the models that are made for metals alone come first, traps excepted", () => {
  const made = (/** @type {string} */ id, /** @type {string[]} */ applies_to, trap = false) => ({
    id,
    applies_to,
    trap,
  });
  const models = [
    made("schlick", ["dielectric", "conductor"]),
    made("complex", ["conductor"], true),
    made("f82_tint", ["conductor"]),
    made("lazanyi", ["conductor"]),
  ];
  const ids = (/** @type {number} */ k_t) => forMedium(models, k_t).map(({ id }) => id);
  assert.deepEqual(ids(3), ["f82_tint", "lazanyi", "schlick", "complex"]);
  assert.deepEqual(
    ids(0),
    models.map(({ id }) => id),
  );
});
