import assert from "node:assert/strict";
import { test } from "node:test";
import { createState, createUndo, number } from "../../static/js/state/state.js";

function started() {
  const n = number({ default: 1.5, minimum: 0, maximum: 9 });
  const state = createState({ n, k: { ...n, default: 0 } });
  return { state, steps: createUndo(state) };
}

test("each change is taken back by itself, and done again", () => {
  const { state, steps } = started();
  state.set({ n: 2 });
  state.set({ k: 1 });
  assert.equal(steps.undo(), true);
  assert.deepEqual({ ...state.get() }, { n: 2, k: 0 });
  assert.equal(steps.undo(), true);
  assert.equal(steps.undo(), false);
  assert.deepEqual({ ...state.get() }, { n: 1.5, k: 0 });
  steps.redo();
  steps.redo();
  assert.equal(steps.redo(), false);
  assert.deepEqual({ ...state.get() }, { n: 2, k: 1 });
});

test("a gesture is one step, and what changes nothing is none", () => {
  const { state, steps } = started();
  for (const n of [1.6, 1.7, 1.8]) state.set({ n }, { history: "replace" });
  state.settle();
  state.set({ n: 1.8 });
  state.set({}, { history: "none" });
  assert.deepEqual(steps.depth(), { past: 1, future: 0 });
  steps.undo();
  assert.equal(state.get().n, 1.5);
});

test("a new change ends what could be done again", () => {
  const { state, steps } = started();
  state.set({ n: 2 });
  steps.undo();
  state.set({ n: 3 });
  assert.equal(steps.redo(), false);
  steps.undo();
  assert.equal(state.get().n, 1.5);
});

test("what came by a link is a step too", () => {
  const { state, steps } = started();
  state.fromQuery("?n=3");
  steps.undo();
  assert.equal(state.get().n, 1.5);
});

test("what a view brought later goes back to its default", () => {
  const { state, steps } = started();
  state.set({ n: 2 });
  state.extend({ coat: number({ default: 1.5, minimum: 1, maximum: 9 }) });
  state.set({ coat: 3 });
  steps.undo();
  assert.deepEqual({ ...state.get() }, { n: 2, k: 0, coat: 1.5 });
});

test("the number of steps is bounded", () => {
  const { state, steps } = started();
  for (let i = 1; i <= 500; i += 1) state.set({ n: i / 100 });
  assert.ok(steps.depth().past <= 200);
  steps.undo();
  assert.equal(state.get().n, 4.99);
});
