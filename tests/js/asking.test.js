import assert from "node:assert/strict";
import { test } from "node:test";
import { createAsking, Problem } from "../../static/js/server/api.js";

/** Questions that are answered when the test says so. */
function setting() {
  /** @type {Map<string, {how: any, path: string, cancelled: number}>} */
  const sent = new Map();
  const log = /** @type {string[]} */ ([]);
  const page = {
    moving: false,
    painted: true,
    wanted: /** @type {Record<string, string>} */ ({ curves: "/curves", snell: "/snell" }),
    later: /** @type {Record<string, string>} */ ({}),
    kernels: /** @type {Answerer | null} */ (null),
  };
  let last = "";
  const asking = createAsking({
    questions: () => ({ wanted: page.wanted, later: page.later }),
    moving: () => page.moving,
    kernels: () => page.kernels,
    painted: () => page.painted,
    onAnswer: () => log.push("answer"),
    onProblem: (name, { title }) => {
      log.push(`${name}: ${title}`);
      return title !== "said elsewhere";
    },
    onRecovered: () => log.push("recovered"),
    onBusy: () => {},
    query: (how) => ({
      request(path) {
        last = path;
        sent.set(path, { how, path, cancelled: 0 });
        how.onBusy?.(true);
      },
      cancel() {
        log.push("cancelled");
        how.onBusy?.(false);
      },
    }),
  });
  /** @param {string} path */
  const flight = (path) => {
    const found = sent.get(path);
    assert.ok(found, `${path} was not asked for`);
    return found.how;
  };
  return {
    asking,
    page,
    log,
    asked: () => [...sent.keys()],
    last: () => last,
    /** @param {string} path @param {unknown} data */
    answer(path, data) {
      flight(path).onAnswer(data, path);
      flight(path).onBusy(false);
    },
    /** @param {string} path @param {string} title */
    fail(path, title) {
      flight(path).onProblem(new Problem(title));
      flight(path).onBusy(false);
    },
  };
}

test("an answer is kept under its name, with the path that it answers", () => {
  const { asking, answer, log } = setting();
  asking.ask();
  answer("/curves", { R: 1 });
  assert.deepEqual(asking.answers(), { curves: { R: 1 }, asked: { curves: "/curves" } });
  assert.deepEqual(asking.paths(), ["/curves"]);
  assert.deepEqual(log, ["answer"]);
});

test("while something moves the first question leads, and the others wait for its answer", () => {
  const { asking, page, asked, answer } = setting();
  page.moving = true;
  asking.ask();
  assert.deepEqual(asked(), ["/curves"]);
  assert.ok(asking.leading());
  page.wanted = { curves: "/curves?2", snell: "/snell?2" };
  asking.ask();
  assert.deepEqual(asked(), ["/curves", "/curves?2"]);
  answer("/curves?2", {});
  assert.ok(!asking.leading());
  page.wanted = { curves: "/curves?2", snell: "/snell?3" };
  page.moving = false;
  asking.ask();
  assert.ok(asked().includes("/snell?3"));
});

test("what can wait is asked one after the other, at rest, when all else is answered and painted", () => {
  const { asking, page, asked, answer } = setting();
  page.wanted = { curves: "/curves" };
  page.later = { red: "/red", blue: "/blue" };
  asking.ask();
  assert.deepEqual(asked(), ["/curves"]);
  page.painted = false;
  answer("/curves", {});
  assert.deepEqual(asked(), ["/curves"]);
  assert.ok(asking.waiting());
  page.painted = true;
  asking.askLater();
  assert.deepEqual(asked(), ["/curves", "/red"]);
  answer("/red", {});
  assert.deepEqual(asked(), ["/curves", "/red", "/blue"]);
  assert.ok(!asking.waiting());
});

test("what can wait is given up for a newer question", () => {
  const { asking, page, answer, log } = setting();
  page.wanted = { curves: "/curves" };
  page.later = { red: "/red" };
  asking.ask();
  answer("/curves", {});
  page.moving = true;
  asking.ask();
  assert.deepEqual(log, ["answer", "cancelled"]);
});

test("what can wait is asked again after it was given up at rest", () => {
  const { asking, page, asked, answer, last } = setting();
  page.wanted = { curves: "/curves" };
  page.later = { red: "/red", blue: "/blue" };
  asking.ask();
  answer("/curves", {});
  answer("/red", {});
  page.wanted = { curves: "/curves?2" };
  page.later = { blue: "/blue?2", red: "/red?2" };
  asking.ask(); // while blue is on its way
  assert.deepEqual(asked(), ["/curves", "/red", "/blue", "/curves?2"]);
  answer("/curves?2", {});
  assert.equal(last(), "/blue?2");
  answer("/blue?2", {});
  assert.equal(last(), "/red?2");
});

test("a problem stays until its question is answered", () => {
  const { asking, fail, answer, log } = setting();
  asking.ask();
  fail("/curves", "broken");
  fail("/snell", "broken too");
  answer("/curves", {});
  assert.deepEqual(log, ["curves: broken", "snell: broken too", "answer"]);
  answer("/snell", {});
  assert.deepEqual(log.slice(3), ["recovered", "answer"]);
});

test("a problem ends with its question, and one that is said elsewhere does not stay", () => {
  const { asking, page, fail, log } = setting();
  asking.ask();
  fail("/curves", "said elsewhere");
  fail("/snell", "broken");
  page.wanted = { curves: "/curves" };
  asking.ask();
  assert.deepEqual(log, ["curves: said elsewhere", "snell: broken", "recovered"]);
});

test("another view starts without answers and without what is under way", () => {
  const { asking, fail, answer, log } = setting();
  asking.ask();
  answer("/curves", {});
  fail("/snell", "broken");
  asking.clear();
  assert.deepEqual(asking.answers(), {});
  assert.deepEqual(log.slice(2), ["cancelled", "cancelled", "recovered"]);
});

/** Formulas that answer whole questions but for those of a lookup table. @param {string} path @param {any} last */
function formulas(path, last) {
  if (path.startsWith("/map")) return null;
  return { answer: { path, last }, complete: !path.includes("lut") };
}

test("while something moves formulas answer alone, and at rest until the server has", () => {
  const { asking, page, asked, answer } = setting();
  page.kernels = formulas;
  page.moving = true;
  asking.ask();
  assert.deepEqual(asked(), []);
  const drawn = asking.answers();
  assert.deepEqual(drawn.curves, { path: "/curves", last: undefined });
  assert.deepEqual(drawn.asked, { curves: "/curves", snell: "/snell" });
  assert.equal(asking.answers().curves, drawn.curves, "worked out once");
  assert.deepEqual(asking.paths(), [], "the server has said nothing");
  page.moving = false;
  asking.ask();
  assert.deepEqual(asked(), ["/curves", "/snell"]);
  assert.equal(asking.answers().curves, drawn.curves);
  answer("/curves", { R: 1 });
  assert.deepEqual(asking.answers().curves, { R: 1 });
  assert.deepEqual(asking.paths(), ["/curves"]);
  page.wanted = { curves: "/curves?2" };
  page.moving = true;
  asking.ask();
  assert.deepEqual(asking.answers().curves, { path: "/curves?2", last: { R: 1 } });
});

test("where formulas do not reach, the server is asked while something moves, too", () => {
  const { asking, page, asked, answer } = setting();
  page.kernels = formulas;
  page.moving = true;
  page.wanted = { curves: "/curves?lut", map: "/map" };
  asking.ask();
  assert.deepEqual(asked(), ["/curves?lut"]);
  assert.ok(!asking.leading(), "what formulas say is drawn at once");
  assert.deepEqual(asking.answers().asked, undefined);
  answer("/curves?lut", { lut: 1 });
  page.wanted = { curves: "/curves?lut2", map: "/map" };
  asking.ask();
  assert.deepEqual(asking.answers().curves, { path: "/curves?lut2", last: { lut: 1 } });
  assert.equal(asking.answers().map, undefined);
});

test("a server that is away is made up for, as far as formulas reach", () => {
  const { asking, page, answer, fail } = setting();
  page.kernels = formulas;
  page.wanted = { curves: "/curves", map: "/map" };
  asking.ask();
  fail("/map", "gone");
  assert.ok(asking.worksOut());
  assert.deepEqual(Object.keys(asking.answers()), ["curves", "asked"]);
  answer("/curves", {});
  assert.ok(!asking.worksOut());
});
