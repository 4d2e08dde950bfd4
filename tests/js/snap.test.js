import assert from "node:assert/strict";
import { test } from "node:test";
import { snap, stepped } from "../../static/js/numbers/format.js";

test("a value near a landmark snaps to the nearest one", () => {
  assert.equal(snap(56, [56.31, 41.8], 1), 56.31);
  assert.equal(snap(50, [56.31, 41.8], 1), 50);
  assert.equal(snap(1.05, [1, 1.08], 0.1), 1.08);
  assert.equal(snap(7, [], 1), 7);
});

test("steps land on their grid", () => {
  assert.equal(stepped(1.5, 0.01, []), 1.51);
  assert.equal(stepped(1.5, -0.01, []), 1.49);
  assert.equal(stepped(0.1, 0.1, []), 0.2);
  assert.equal(stepped(64.3, 0.5, []), 64.5);
  assert.equal(stepped(64.3, -0.5, []), 64);
  let value = 1;
  for (let i = 0; i < 100; i++) value = stepped(value, 0.01, []);
  assert.equal(value, 2);
});

test("a step stops at a landmark on its way and leaves it again", () => {
  assert.equal(stepped(56, 0.5, [56.31]), 56.31);
  assert.equal(stepped(56.31, 0.5, [56.31]), 56.5);
  assert.equal(stepped(56.5, -0.5, [56.31]), 56.31);
  assert.equal(stepped(56.31, -0.5, [56.31]), 56);
  assert.equal(stepped(50, 10, [52, 57]), 52);
});
