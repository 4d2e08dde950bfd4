import assert from "node:assert/strict";
import { test } from "node:test";
import { createChanged } from "../../static/js/page/changed.js";
import { createProblems, sayProblem } from "../../static/js/page/trouble.js";

test("a problem is told by the view that says so, until its question is answered", () => {
  const problems = createProblems(["map"]);
  const problem = { title: "Refused", lines: ["n_minimum = 5", "below n_maximum"] };
  const answers = { map: { values: [] }, sweep: 1 };
  assert.equal(problems.add("sweep", problem, answers), false);
  assert.equal(problems.of("sweep", answers), undefined);
  assert.equal(problems.add("map", problem, answers), true);
  assert.equal(problems.of("map", { ...answers, sweep: 2 }), problem);
  assert.equal(problems.of("map", { ...answers, map: {} }), undefined);
  assert.equal(sayProblem(problem), "n_minimum = 5 · below n_maximum");
  assert.equal(sayProblem({ title: "Refused", lines: [] }), "Refused");
  assert.equal(sayProblem(undefined), "");
});

test("what is drawn from the same values is not drawn again", () => {
  const changed = createChanged();
  const answer = {};
  assert.equal(changed(answer, "look"), true);
  assert.equal(changed(answer, "look"), false);
  assert.equal(changed(answer, "other"), true);
  assert.equal(changed(answer, "other", 1), true);
  assert.equal(changed({}, "other", 1), true);
});
