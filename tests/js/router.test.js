import assert from "node:assert/strict";
import { beforeEach, test } from "node:test";
import { createRouter } from "../../static/js/page/router.js";
import { choice, createState, list, number } from "../../static/js/state/state.js";
import { pick } from "./catalog.js";

const VIEWS = [{ id: "explore" }, { id: "compare" }, { id: "theory" }];

/** @type {string[]} */
let pushed = [];

beforeEach(() => {
  pushed = [];
  Object.assign(globalThis, {
    location: { href: "http://page/" },
    history: { pushState: (/** @type {unknown[]} */ ...given) => pushed.push(String(given[2])) },
  });
});

/** A page whose views are loaded when the test says so. */
function page() {
  /** @type {{id: string, come: () => void, fail: () => void}[]} */
  const flights = [];
  const log = /** @type {string[]} */ ([]);
  const hosts = /** @type {Record<string, {hidden: boolean}>} */ ({});
  const state = createState({
    view: choice(
      "explore",
      VIEWS.map((v) => v.id),
    ),
  });
  /** @type {() => Promise<void>} */
  let again = async () => {};
  /** @param {string} id @returns {ViewModule} */
  const module = (id) => ({
    fields: () => ({
      [`${id}_n`]: number({ default: 1, minimum: 0, maximum: 9 }),
      models: list(["schlick"]),
    }),
    createView: () => /** @type {any} */ (null),
    queries: () => ({}),
    restCalls: () => [],
  });
  const router = createRouter({
    views: VIEWS,
    load: (id) =>
      new Promise((resolve, reject) => {
        flights.push({ id, come: () => resolve(module(id)), fail: () => reject(new Error(id)) });
      }),
    make(id) {
      log.push(`made ${id}`);
      hosts[id] = { hidden: false };
      const view = { deactivate: () => log.push(`left ${id}`) };
      return { view: /** @type {any} */ (view), host: /** @type {any} */ (hosts[id]) };
    },
    state,
    catalog: { parameters: [], models: [], materials: [] },
    presets: {},
    onLeave: (id) => log.push(`to ${id}`),
    onFailure(id, href, retry) {
      log.push(`failed ${id} ${href}`);
      again = retry;
    },
    onArrival: (problems) => log.push(`arrived ${problems.length}`),
  });
  state.subscribe(() => router.follow());
  return { router, flights, log, hosts, state, again: () => again() };
}

const turn = () => new Promise((resolve) => setTimeout(resolve, 0));

test("an address opens its view, and its state is taken when that is there", async () => {
  const { router, flights, log, state } = page();
  const arrived = router.arrive("http://page/?view=compare&compare_n=3");
  assert.equal(router.current(), undefined);
  flights[0]?.come();
  await arrived;
  assert.deepEqual(log, ["to compare", "made compare", "arrived 0"]);
  assert.equal(state.get().compare_n, 3);
  assert.equal(state.get().view, "compare");
});

test("an address without a known view opens the first one", async () => {
  const { router, flights } = page();
  const arrived = router.arrive("http://page/?view=nothing");
  assert.deepEqual(pick(flights, "id"), ["explore"]);
  flights[0]?.come();
  await arrived;
});

test("state of other views is read with their help", async () => {
  const { router, flights, state, log } = page();
  const arrived = router.arrive("http://page/?compare_n=4");
  flights[0]?.come();
  await turn();
  for (const flight of flights.slice(1)) flight.come();
  await arrived;
  assert.equal(state.get().compare_n, 4);
  assert.equal(log.at(-1), "arrived 0");
});

test("an old name in an address does not call for the other views", async () => {
  const { router, flights, state, log } = page();
  const arrived = router.arrive("http://page/?view=compare&against=schlick");
  flights[0]?.come();
  await arrived;
  assert.equal(flights.length, 1);
  assert.deepEqual(state.get().models, ["schlick"]);
  assert.equal(log.at(-1), "arrived 0");
});

test("of two addresses the last one counts, and only that becomes a page of the history", async () => {
  const { router, flights, log, state } = page();
  const first = router.arrive("?view=compare", { anew: true }).catch(() => {});
  const last = router.arrive("http://page/?view=theory", { anew: true });
  flights[1]?.come();
  flights[0]?.come();
  await Promise.all([first, last]);
  assert.equal(state.get().view, "theory");
  assert.deepEqual(pushed, ["http://page/?view=theory"]);
  assert.ok(!log.includes("made compare"));
});

test("a view is shown alone, and made once however often its tab is chosen", async () => {
  const { router, flights, log, hosts } = page();
  const arrived = router.arrive("http://page/");
  flights[0]?.come();
  await arrived;
  for (const id of ["compare", "explore", "compare"]) router.choose(id);
  for (const flight of flights.slice(1)) flight.come();
  await turn();
  assert.deepEqual(
    log.filter((line) => line.startsWith("made")),
    ["made explore", "made compare"],
  );
  assert.deepEqual(hosts, { explore: { hidden: true }, compare: { hidden: false } });
});

test("a view that cannot be loaded says so, and can be opened again", async () => {
  const { router, flights, log, hosts, state, again } = page();
  const arrived = router.arrive("http://page/");
  flights[0]?.come();
  await arrived;
  router.choose("compare");
  flights[1]?.fail();
  await turn();
  assert.equal(log.at(-1), "failed compare http://page/");
  assert.equal(router.current(), undefined);
  assert.ok(hosts.explore?.hidden);
  Object.assign(globalThis, { location: { href: "http://page/?view=compare" } }); // as the state writes it
  const retried = again();
  flights[2]?.come();
  await retried;
  assert.equal(hosts.compare?.hidden, false);
  assert.equal(state.get().view, "compare");
});

test("the tab of a view that failed tries again, with all that its link said", async () => {
  const { router, flights, log, state } = page();
  const arrived = router.arrive("http://page/?view=compare&compare_n=3");
  flights[0]?.fail();
  await arrived;
  assert.equal(log.at(-1), "failed compare http://page/?view=compare&compare_n=3");
  router.choose("compare");
  flights[1]?.come();
  await turn();
  assert.equal(state.get().compare_n, 3);
});

test("a failure is of no interest when another view was chosen meanwhile", async () => {
  const { router, flights, log } = page();
  const arrived = router.arrive("http://page/");
  flights[0]?.come();
  await arrived;
  router.choose("compare");
  router.choose("explore");
  flights[1]?.fail();
  await turn();
  assert.ok(!log.some((line) => line.startsWith("failed")));
  assert.equal(router.current()?.host.hidden, false);
});
