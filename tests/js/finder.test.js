import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { matching } from "../../static/js/controls/picker.js";
import { led, TRADE } from "../../static/js/page/trade.js";

/** @type {{presets: any[]}} */
const { presets } = JSON.parse(
  readFileSync(new URL("../../materials/index.json", import.meta.url), "utf8"),
);
const ACTIONS = ["Keys", "Present", "Light or dark"];
const MEDIA = presets.map((one) => ({ ...one, source: one.source ?? "" }));
/** @param {string} text */
const found = (text) => {
  const leading = led(MEDIA, text);
  return [...leading, ...matching(MEDIA, text).filter((m) => !leading.includes(m))];
};

test("words of the trade lead to the media that are meant", () => {
  /** @type {Record<string, string>} */
  const meant = {
    plastic: "PMMA",
    acrylic: "PMMA",
    chrome: "Cr",
    steel: "stainless",
    glass: "default-shirley",
  };
  for (const [word, id] of Object.entries(meant)) assert.equal(found(word)[0]?.id, id, word);
  assert.equal(found("plastics")[0]?.id, "PMMA");
  assert.equal(found("chro")[0]?.id, "Cr");
});

test("every medium that a word leads to is in the catalog", () => {
  const ids = new Set(MEDIA.map((m) => m.id));
  const media = Object.values(TRADE)
    .flat()
    .filter((id) => /^[A-Z]|-shirley$|^(stainless|soda|poly)/.test(id));
  const missing = media.filter((id) => !ids.has(id) && !ACTIONS.includes(id));
  assert.deepEqual(missing, []);
});

test("scattered letters are no match", () => {
  for (const word of ["help", "gltf", "blender", "unreal", "worksheet", "skin"])
    assert.deepEqual(
      matching(MEDIA, word).map((m) => m.id),
      [],
      word,
    );
});

test("a slip in a long word is none", () => {
  assert.ok(matching(MEDIA, "dimond").some((m) => m.id.startsWith("diamond")));
  assert.ok(matching(MEDIA, "polycarbonat").length > 0);
});
