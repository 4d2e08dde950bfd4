import assert from "node:assert/strict";
import { test } from "node:test";
import { ExpressionError, evaluate, evaluateAngle } from "../../static/js/numbers/expression.js";

test("what people type into a number box", () => {
  for (const [text, value] of /** @type {[string, number][]} */ ([
    ["1.5", 1.5],
    [" .5 ", 0.5],
    ["1/1.5", 1 / 1.5],
    ["sqrt(2)", Math.SQRT2],
    ["√2", Math.SQRT2],
    ["2*1.33", 2.66],
    ["2 × 1.33", 2.66],
    ["3 ÷ 2", 1.5],
    ["1.5e-2", 0.015],
    ["−2 + 3", 1],
    ["2^3^2", 512],
    ["-2^2", -4],
    ["2^-1", 0.5],
    ["(1 + 2) * 3 - 4 / 2", 7],
    ["8/4/2", 1],
    ["10-3-2", 5],
    ["sqrt(sqrt(16))", 2],
    ["1,5", 1.5], // as a numeric pad types it in much of Europe
    ["1/1,25", 0.8],
    [",5", 0.5],
    ["pi/2", Math.PI / 2],
    ["2*π", 2 * Math.PI],
  ])) {
    assert.equal(evaluate(text), value, text);
  }
});

test("nonsense is refused with a reason", () => {
  const words = "glass 1.5.5 1/ (1 1) 1/0 sqrt(-1) NaN Infinity 1e999 alert(1) constructor";
  for (const text of [
    "",
    "  ",
    "2 3",
    ...words.split(" "),
    ..."1,2,3 1.234,5 1,234.5 1, 0x10 -- 1**2 __proto__ 1;2".split(" "),
  ])
    assert.throws(() => evaluate(text), ExpressionError, text);
  assert.throws(() => evaluate("1/0"), /finite/);
});

test("a deep nest of parentheses does not hang", () => {
  assert.equal(evaluate(`${"(".repeat(500)}1${")".repeat(500)}`), 1);
});

test("an angle may carry its unit", () => {
  assert.deepEqual(evaluateAngle("56.31°", "rad"), { value: 56.31, unit: "deg" });
  assert.deepEqual(evaluateAngle("1.2 rad", "deg"), { value: 1.2, unit: "rad" });
  assert.deepEqual(evaluateAngle("180/4 deg", "rad"), { value: 45, unit: "deg" });
  assert.deepEqual(evaluateAngle("pi/4", "rad"), { value: Math.PI / 4, unit: "rad" });
  assert.throws(() => evaluateAngle("°", "deg"), ExpressionError);
});
