import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { test } from "node:test";

const FOLDER = new URL("../../static/css/", import.meta.url);
/** A class alone as one of a rule's selectors. */
const ALONE = /^ *\.([\w-]+) ?[{,]$/gmu;
/** Present is for all views; the sheets of a pair hold together. */
const NO_VIEWS = ["print.css", "present.css"];
/** @type {Record<string, string>} */
const TOGETHER = { "explore.css": "base.css", "compare-errors.css": "compare.css" };

test("no two style sheets have rules for the same class alone", () => {
  // Sheets stay when their view is left: what two of them call alike looks as the last one that came has it.
  /** @type {Map<string, Set<string>>} */
  const sheets = new Map();
  for (const name of readdirSync(FOLDER).filter((one) => !NO_VIEWS.includes(one)))
    for (const [, found = ""] of readFileSync(new URL(name, FOLDER), "utf8").matchAll(ALONE))
      sheets.set(found, (sheets.get(found) ?? new Set()).add(TOGETHER[name] ?? name));
  const twice = [...sheets].filter(([, names]) => names.size > 1);
  assert.ok(sheets.size > 200, `${sheets.size}`);
  assert.deepEqual(
    twice.map(([found, names]) => `.${found}: ${[...names].join(", ")}`),
    [],
  );
});
