import assert from "node:assert/strict";
import { test } from "node:test";
import { locate, read } from "../../static/js/curves/reading.js";

const xs = [0, 1, 2, 2.5, 3];
const ys = [0, 10, 20, null, 30];

/** @param {number} x */
const at = (x) => read(ys, locate(xs, x));

test("linear between samples, exact at them", () => {
  assert.equal(at(0), 0);
  assert.equal(at(0.25), 2.5);
  assert.equal(at(1), 10);
  assert.equal(at(2), 20);
  assert.equal(at(3), 30);
});

test("a gap stays a gap", () => {
  assert.equal(at(2.2), null);
  assert.equal(at(2.5), null);
  assert.equal(at(2.7), null);
});

test("outside the samples the end value is read", () => {
  assert.equal(at(-1), 0);
  assert.equal(at(4), 30);
  assert.equal(read([], locate([], 1)), null);
});
