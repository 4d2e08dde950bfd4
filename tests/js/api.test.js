import assert from "node:assert/strict";
import { test } from "node:test";
import { createQuery, Problem } from "../../static/js/server/api.js";
import { pick } from "./catalog.js";

/** A server whose answers come when the test says so. */
function fakeServer() {
  /** @type {{path: string, signal?: AbortSignal | undefined, answer: (data: unknown) => void, fail: (error: Error) => void}[]} */
  const asked = [];
  /** @param {string} path @param {AbortSignal} [signal] */
  const get = (path, signal) =>
    new Promise((answer, fail) => {
      asked.push({ path, signal, answer, fail });
    });
  return { asked, get };
}

/** @param {{patience?: number}} [options] */
function query({ patience = 10_000 } = {}) {
  const server = fakeServer();
  const answers = /** @type {unknown[]} */ ([]);
  /** @type {Problem[]} */
  const problems = [];
  const busy = /** @type {boolean[]} */ ([]);
  const asking = createQuery({
    get: server.get,
    patience,
    onAnswer: (data) => answers.push(data),
    onProblem: (problem) => problems.push(problem),
    onBusy: (on) => busy.push(on),
  });
  return { ...server, answers, problems, busy, asking };
}

const turn = () => new Promise((resolve) => setTimeout(resolve, 0));

test("one request is in flight, and of those that wait only the newest is sent", async () => {
  const { asking, asked, answers, busy } = query();
  for (const path of ["/1", "/2", "/3", "/4"]) asking.request(path);
  assert.deepEqual(pick(asked, "path"), ["/1"]);
  asked[0]?.answer("one");
  await turn();
  assert.deepEqual(pick(asked, "path"), ["/1", "/4"]);
  asked[1]?.answer("four");
  await turn();
  assert.deepEqual(answers, ["one", "four"]);
  assert.equal(busy.at(-1), false);
});

test("what was just answered or is under way is not asked again", async () => {
  const { asking, asked } = query();
  asking.request("/1");
  asking.request("/1");
  asked[0]?.answer(1);
  await turn();
  asking.request("/1");
  assert.equal(asked.length, 1);
});

test("going back to what is in flight forgets what waited", async () => {
  const { asking, asked, answers } = query();
  asking.request("/1");
  asking.request("/2");
  asking.request("/1");
  asked[0]?.answer("one");
  await turn();
  assert.equal(asked.length, 1);
  assert.deepEqual(answers, ["one"]);
});

const patience = () => new Promise((resolve) => setTimeout(resolve, 30));

test("a slow request goes on, with a newer one beside it, and both are shown in their order", async () => {
  const { asking, asked, answers, busy } = query({ patience: 5 });
  for (const path of ["/slow", "/new", "/newer"]) asking.request(path);
  await patience();
  assert.deepEqual(pick(asked, "path"), ["/slow", "/newer"]);
  asking.request("/newest");
  await patience();
  assert.equal(asked.length, 2, "no more than two at a time");
  asked[0]?.answer("slow");
  await patience();
  assert.deepEqual(pick(asked, "path"), ["/slow", "/newer", "/newest"]);
  asked[1]?.answer("newer");
  asked[2]?.answer("newest");
  await turn();
  assert.deepEqual(answers, ["slow", "newer", "newest"]);
  assert.equal(busy.at(-1), false);
});

test("a request that is overtaken is given up, and its late answer dropped", async () => {
  const { asking, asked, answers } = query({ patience: 5 });
  asking.request("/slow");
  asking.request("/new");
  await patience();
  assert.equal(asked[0]?.signal?.aborted, false);
  asked[1]?.answer("new");
  await turn();
  assert.equal(asked[0]?.signal?.aborted, true);
  asked[0]?.answer("late");
  await turn();
  assert.deepEqual(answers, ["new"]);
});

test("what went wrong with an old request is not told while a newer one is under way", async () => {
  const { asking, asked, answers, problems } = query({ patience: 5 });
  asking.request("/slow");
  asking.request("/new");
  await patience();
  asked[0]?.fail(new Problem("stale"));
  await turn();
  asked[1]?.answer("new");
  await turn();
  assert.deepEqual([answers, problems], [["new"], []]);
});

test("an error is told unless a newer question waits, and the same may be asked again", async () => {
  const { asking, asked, answers, problems } = query();
  asking.request("/1");
  asking.request("/2");
  asked[0]?.fail(new Problem("stale"));
  await turn();
  assert.equal(problems.length, 0);
  asked[1]?.fail(new Problem("broken", { status: 500 }));
  await turn();
  assert.equal(problems[0]?.status, 500);
  asking.request("/2");
  asked[2]?.answer("well");
  await turn();
  assert.deepEqual(answers, ["well"]);
});

test("cancel forgets everything", async () => {
  const { asking, asked, answers, busy } = query();
  asking.request("/1");
  asking.request("/2");
  asking.cancel();
  assert.equal(asked[0]?.signal?.aborted, true);
  asked[0]?.answer("one");
  await turn();
  assert.deepEqual(answers, []);
  assert.equal(busy.at(-1), false);
  asking.request("/1");
  assert.equal(asked.length, 2);
});
