import assert from "node:assert/strict";
import { test } from "node:test";
import {
  choice,
  createState,
  createUndo,
  inTodaysWords,
  list,
  number,
  optional,
} from "../../static/js/state/state.js";
import { pick } from "./catalog.js";

const FIELDS = () => ({
  n: number({ default: 1.5, minimum: 0.001, maximum: 100 }),
  k: number({ default: 0, minimum: 0, maximum: 100 }),
  unit: choice("deg", ["deg", "rad"]),
  models: list(["schlick", "cos_form"]),
  material: optional(["water", "gold"]),
});

/** A window whose history is a list. */
function fakeWindow(search = "") {
  const log = /** @type {string[]} */ ([]);
  const location = { pathname: "/", search };
  /** @param {string} verb */
  const write =
    (verb) =>
    (/** @type {unknown} */ _state, /** @type {string} */ _title, /** @type {string} */ url) => {
      location.search = url.slice(1);
      log.push(`${verb} ${url}`);
    };
  const history = { pushState: write("push"), replaceState: write("replace") };
  return { log, window: /** @type {any} */ ({ location, history }) };
}

test("only what differs from the defaults stands in the link", () => {
  const state = createState(FIELDS());
  assert.equal(state.toQuery(), "");
  state.set({ n: 1.33, models: ["cos_form", "schlick"] });
  assert.equal(state.toQuery(), "n=1.33&models=cos_form,schlick");
  state.set({ n: 1.5, models: [] });
  assert.equal(state.toQuery(), "");
});

test("a link gives back exactly the state that wrote it", () => {
  const state = createState(FIELDS());
  state.set({ n: 1 / 1.5, k: 1e-7, unit: "rad", models: ["schlick"], material: null });
  const other = createState(FIELDS());
  assert.deepEqual(other.fromQuery(`?${state.toQuery()}`), []);
  assert.deepEqual(other.get(), state.get());
});

test("what a link may not say is reported and left at its default", () => {
  const state = createState(FIELDS());
  const problems = state.fromQuery(
    "?n=400&k=x&unit=grad&models=schlick,foo&material=mud&colour=red&__proto__=1&n=2",
  );
  assert.deepEqual(pick(problems, "key"), [
    "n",
    "k",
    "unit",
    "models",
    "material",
    "colour",
    "__proto__",
    "n",
  ]);
  assert.match(problems[0]?.message ?? "", /0\.001 to 100/);
  assert.equal(state.get().n, 1.5);
  assert.deepEqual(state.get().models, []);
});

test("numbers of a link are plain decimal numbers", () => {
  const state = createState(FIELDS());
  for (const text of ["NaN", "Infinity", "1e400", "", " 2", "0x10", "2;", "1/2", "-1"]) {
    assert.equal(state.fromQuery(`?n=${encodeURIComponent(text)}`).length, 1, text);
  }
  assert.deepEqual(state.fromQuery("?n=2.5e0"), []);
  assert.equal(state.get().n, 2.5);
});

test("a preset implies its indices and keeps them out of the link", () => {
  const state = createState(FIELDS(), {
    implied: ({ material }) => (material === "gold" ? { n: 0.2, k: 3 } : {}),
  });
  state.set({ material: "gold" });
  assert.equal(state.get().k, 3);
  assert.equal(state.toQuery(), "material=gold");
  state.set({ material: null, n: 0.3 });
  assert.equal(state.toQuery(), "n=0.3&k=3");
  const [problem] = state.fromQuery("?material=gold&n=1.7");
  assert.equal(problem?.key, "n");
  assert.equal(state.get().n, 0.2);
});

test("a gesture makes one entry in the history", () => {
  const { log, window } = fakeWindow();
  let clock = 0;
  const state = createState(FIELDS(), { window, now: () => clock });
  for (const n of [1.6, 1.7, 1.8]) {
    clock += 10;
    state.set({ n }, { history: "replace" });
    assert.equal(state.moving(), true);
  }
  clock += 2000;
  state.set({ n: 1.9 }, { history: "replace" });
  state.set({ n: 2 }, { history: "replace" });
  state.settle();
  assert.equal(state.moving(), false);
  assert.deepEqual(log, ["push /?n=1.6", "replace /?n=1.9", "replace /?n=2"]);
  state.settle();
  state.set({ k: 1 });
  state.set({ k: 1 });
  assert.deepEqual(log.slice(3), ["push /?n=2&k=1"]);
});

test("listeners hear of every change and may leave", () => {
  const state = createState(FIELDS());
  /** @type {[number, boolean][]} */
  const heard = [];
  const leave = state.subscribe((now, moving) => heard.push([now.n, moving]));
  state.set({ n: 2 }, { history: "replace" });
  state.settle();
  leave();
  state.set({ n: 3 });
  assert.deepEqual(heard, [
    [2, true],
    [2, false],
  ]);
});

test("a field that nobody declared cannot be set; one declared later can", () => {
  const state = createState(FIELDS());
  assert.throws(() => state.set({ over: 1 }), /over/);
  state.extend({ over: number({ default: 1, minimum: 0, maximum: 9 }) });
  state.set({ over: 2 });
  assert.equal(state.toQuery(), "over=2");
});

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

test("a link that says against as Compare once did is read as one that says models", () => {
  const read = (/** @type {string} */ search) =>
    Object.fromEntries(new URLSearchParams(inTodaysWords(search)));
  assert.equal(inTodaysWords("?n=2&models=schlick"), "?n=2&models=schlick");
  assert.deepEqual(read("?view=compare&against=schlick,cos_form&n=2"), {
    view: "compare",
    models: "schlick,cos_form",
    n: "2",
  });
  // Each view once had models of its own: those of the view that is opened count.
  assert.equal(read("?view=compare&models=cos_form&against=none").models, "none");
  assert.equal(read("?models=cos_form&against=schlick").models, "cos_form");
});
