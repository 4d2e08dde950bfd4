import assert from "node:assert/strict";
import { test } from "node:test";
import { albedoFields } from "../../static/js/albedo/fields.js";
import { compareFields } from "../../static/js/compare/fields.js";
import { materialFields } from "../../static/js/materials/fields.js";
import { previewFields } from "../../static/js/preview/fields.js";
import { theoryFields } from "../../static/js/theory/fields.js";

const n = { name: "n_t", minimum: 0.001, maximum: 100, default: 1.5 };
const CATALOG = /** @type {any} */ ({
  parameters: ["n_i", "n_t", "k_t", "theta_i_deg"].map((name) => ({ ...n, name })),
  models: [
    { id: "schlick", title: "Schlick", parameters: [], applies_to: [], kind: "approximation" },
  ],
  materials: [{ id: "Au", name: "Gold", category: "metals" }],
});

test("views that share a name in the link mean the same by it", () => {
  /** @type {Record<string, unknown>} */
  const known = {};
  for (const fields of [albedoFields, compareFields, materialFields, previewFields, theoryFields]) {
    for (const [key, field] of Object.entries(fields(CATALOG))) {
      if (key in known) assert.deepEqual(field.default, known[key], key);
      else known[key] = field.default;
    }
  }
});
