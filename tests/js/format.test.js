import assert from "node:assert/strict";
import { test } from "node:test";
import {
  angle,
  inDegrees,
  inUnit,
  percent,
  plain,
  six,
  snap,
  stepped,
} from "../../static/js/numbers/format.js";

test("six significant digits with a minus sign", () => {
  assert.equal(six(0.11300063), "0.113001");
  assert.equal(six(-0.46517), "−0.465170");
  assert.equal(six(0.04), "0.0400000");
  assert.equal(six(123.456789), "123.457");
  assert.equal(six(1.23456789e-7), "1.23457 × 10⁻⁷");
  assert.equal(six(-3.2e9), "−3.20000 × 10⁹");
});

test("exact zero and one are bare, what is missing is none", () => {
  assert.equal(six(0), "0");
  assert.equal(six(-0), "0");
  assert.equal(six(1), "1");
  assert.equal(six(-1), "−1");
  assert.equal(six(1 - 1e-16), "1.00000");
  assert.equal(six(null), "none");
  assert.equal(six(undefined), "none");
  assert.equal(six(Number.NaN), "none");
});

test("a number as people type it", () => {
  assert.equal(plain(1.5), "1.5");
  assert.equal(plain(1 / 1.5), "0.666667");
  assert.equal(plain(-2), "−2");
});

test("a share is all or nothing only where it is", () => {
  assert.equal(percent(0.113001), "11.3\u00a0%");
  assert.equal(percent(1), "100.0\u00a0%");
  assert.equal(percent(0), "0.0\u00a0%");
  assert.equal(percent(0.99996), "> 99.9\u00a0%");
  assert.equal(percent(1e-9), "< 0.1\u00a0%");
});

test("angles with two decimals in degrees, four in radians", () => {
  assert.equal(angle(56.30993, "deg"), "56.31°");
  assert.equal(angle(180, "rad"), "3.1416\u00a0rad");
  assert.equal(angle(-45, "deg"), "−45.00°");
  assert.equal(angle(-0.0001, "deg"), "0.00°");
  assert.equal(angle(null, "deg"), "none");
  assert.equal(angle(63.96, "deg", 1), "64.0°");
});

test("units go there and back", () => {
  assert.equal(inUnit(90, "rad"), Math.PI / 2);
  assert.equal(inDegrees(Math.PI / 2, "rad"), 90);
  assert.equal(inUnit(33, "deg"), 33);
});

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
