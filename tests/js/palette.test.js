import assert from "node:assert/strict";
import { test } from "node:test";
import { modelStyle } from "../../static/js/palette.js";

test("each model has a look of its own, the same wherever it stands", () => {
  const models = ["a", "exact", ..."bcdefghijklmnopqrstuvwx"].map((id) => ({ id }));
  const looks = models.map(({ id }) => JSON.stringify(modelStyle(models, id)));
  assert.equal(new Set(looks).size, models.length);
  assert.deepEqual(modelStyle(models, "exact"), { color: "--R", dash: "solid" });
  assert.equal(modelStyle(models, "a").color, "--model-1");
});
