import assert from "node:assert/strict";
import { mock, test } from "node:test";
import { get, startWorker } from "../../static/js/server/api.js";

/** @typedef {{data: unknown}} Message */

/** A worker that the test speaks for. */
class FakeWorker {
  /** @type {FakeWorker[]} */
  static made = [];
  /** @type {Map<string, ((event: any) => void)[]>} */
  listeners = new Map();
  /** @type {any[]} */
  told = [];

  constructor() {
    FakeWorker.made.push(this);
  }

  /** @param {string} type @param {(event: any) => void} listener */
  addEventListener(type, listener) {
    this.listeners.set(type, [...(this.listeners.get(type) ?? []), listener]);
  }

  /** @param {unknown} message */
  postMessage(message) {
    this.told.push(message);
  }

  /** @param {string} type @param {unknown} data */
  say(type, data) {
    for (const listener of this.listeners.get(type) ?? []) listener({ data });
  }
}

const stage = /** @type {any} */ (globalThis);

test("the page asks by itself until a worker is up, then the worker asks", async () => {
  stage.document = { baseURI: "http://localhost:8000/" };
  stage.Worker = FakeWorker;
  stage.fetch = async () => ({ status: 200, text: async () => "by itself" });
  mock.timers.enable({ apis: ["setTimeout"] });
  startWorker();
  assert.equal(FakeWorker.made.length, 0, "not while the page loads");
  mock.timers.tick(5000);
  const [worker] = FakeWorker.made;
  assert.ok(worker);
  assert.deepEqual(await get("api/v1/health"), { status: 200, text: "by itself" });

  worker.say("message", { id: 0, status: 0, text: "" });
  const answer = get("api/v1/curves?n_t=2");
  const [question] = worker.told;
  assert.equal(question.url, "http://localhost:8000/api/v1/curves?n_t=2");
  worker.say("message", { id: question.id, status: 422, text: "{}" });
  assert.deepEqual(await answer, { status: 422, text: "{}" });

  const leaving = new AbortController();
  const given = get("api/v1/curves?n_t=3", leaving.signal);
  leaving.abort();
  await assert.rejects(given, (/** @type {any} */ error) => error.name === "AbortError");
  assert.deepEqual(worker.told.at(-1), { id: worker.told.at(-2).id });

  const lost = get("api/v1/curves?n_t=4");
  worker.say("error", null);
  assert.deepEqual(await lost, { status: 0, text: "" });
  assert.deepEqual(await get("api/v1/health"), { status: 200, text: "by itself" });
  mock.timers.reset();
});
