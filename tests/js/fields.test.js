import assert from "node:assert/strict";
import { test } from "node:test";
import { albedoFields } from "../../static/js/albedo/fields.js";
import { compareFields } from "../../static/js/compare/fields.js";
import { materialFields } from "../../static/js/materials/fields.js";
import { previewFields } from "../../static/js/preview/fields.js";
import { theoryFields } from "../../static/js/theory/fields.js";
import { PARAMETERS } from "./catalog.js";

const CATALOG = /** @type {any} */ ({
  parameters: PARAMETERS,
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
