import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { EXAMPLES } from "../../static/js/models/examples.js";
import { addressOf } from "../../static/js/page/links.js";
import { createState } from "../../static/js/state/state.js";
import { chosen, sourceName } from "../../static/js/theory/claims.js";
import { SECTIONS, TOUCHED, theoryFields, UNTOUCHED } from "../../static/js/theory/fields.js";
import { leaning, lessonQueries, settingOf, shareBy } from "../../static/js/theory/lesson.js";
import { isNear } from "../../static/js/theory/mystery.js";
import { decode, encode } from "../../static/js/theory/mystery-code.js";
import { phaseLines } from "../../static/js/theory/planes.js";
import { queries, restCalls } from "../../static/js/theory/queries.js";
import { STEPS } from "../../static/js/theory/steps.js";
import { TRAPS } from "../../static/js/theory/trap-cards.js";
import { SHEETS } from "../../static/js/theory/worksheets.js";
import { PARAMETERS } from "./catalog.js";

const CATALOG = /** @type {any} */ ({
  parameters: PARAMETERS,
  models: [],
  materials: [{ id: "Au" }, { id: "Cu" }],
});

/** @param {string} [query] */
function stateWith(query = "") {
  const store = createState(theoryFields(CATALOG));
  assert.deepEqual(store.fromQuery(query), []);
  return store.get();
}

test("a mystery material's code gives its index back", () => {
  for (const index of [
    { n: 0.01, k: 0 },
    { n: 1.333, k: 0 },
    { n: 0.27, k: 2.9 },
    { n: 10, k: 20 },
    { n: 4.999, k: 19.999 },
  ]) {
    const code = encode(index);
    assert.match(code, /^[0-9a-z]{1,6}$/);
    assert.deepEqual(decode(code), index);
  }
});

test("neighbouring materials have codes that tell nothing of each other", () => {
  const codes = [1.5, 1.501, 1.502].map((n) => Number.parseInt(encode({ n, k: 0 }), 36));
  const [a = 0, b = 0, c = 0] = codes;
  assert.ok(Math.abs(b - a) > 1e6 && Math.abs(c - b) > 1e6);
});

test("what is no code is refused, in a link as well", () => {
  for (const text of ["", "abcdefg", "ABC", "zzzzzz", "-1", "1.5", "00"])
    assert.equal(decode(text), null);
  const store = createState(theoryFields(CATALOG));
  const [problem] = store.fromQuery("mystery=zzzzzz");
  assert.equal(problem?.key, "mystery");
  assert.equal(store.get().mystery, null);
});

test("an answer counts as found within two percent or two hundredths", () => {
  assert.ok(isNear(1.52, 1.5));
  assert.ok(isNear(0.05, 0.06));
  assert.ok(!isNear(1.55, 1.5));
  assert.ok(isNear(5.09, 5));
  assert.ok(!isNear(5.11, 5));
});

test("the solution is asked for and not told", () => {
  const code = encode({ n: 2.417, k: 0 });
  const state = stateWith(`section=mystery&mystery=${code}&own_n=1.9`);
  assert.equal(queries(state).hidden, `/mystery/${code}`);
  assert.ok(queries(state).curves?.includes("n_t=1.9"));
  assert.ok(Object.values(queries(state)).every((path) => !path.includes("2.417")));
  assert.deepEqual(restCalls(state), Object.values(queries(state)));
});

test("a lesson has its own numbers until they are moved", () => {
  const lesson = /** @type {any} */ (STEPS.find((s) => s.id === "brewster"));
  assert.equal(settingOf(stateWith(), lesson).n_t, 1.333);
  const moved = stateWith("own_n=1.7&own_deg=59.5");
  assert.deepEqual(
    { ...settingOf(moved, lesson) },
    { n_i: 1, n_t: 1.7, k_t: 0, deg: 59.5, polarization: "p", of: "Au" },
  );
  assert.equal(lessonQueries(moved, lesson).snell, "/snell?n_t=1.7&theta_i_deg=59.5");
  assert.deepEqual(Object.keys(UNTOUCHED), TOUCHED);
});

test("a share is read between the samples of a curve", () => {
  const answers = {
    curves: {
      theta_i_deg: [0, 40, 90],
      curves: [{ model: "schlick", quantity: "R", values: [0.04, 0.06, 1] }],
    },
  };
  const scene = /** @type {any} */ ({ answers, setting: { deg: 20 } });
  assert.ok(Math.abs((shareBy(scene, "schlick") ?? 0) - 0.05) < 1e-12);
  assert.equal(shareBy(scene, "exact"), null);
  assert.equal(
    shareBy(/** @type {any} */ ({ answers: {}, setting: { deg: 20 } }), "schlick"),
    null,
  );
});

test("the first path goes from water to coats in the order of Shirley's post, and on to films", () => {
  assert.equal(
    STEPS.map((s) => s.id).join(" "),
    "water split polarization brewster below schlick index metals rgb coat films planes",
  );
});

test("every step and every trap has something to touch and to find", () => {
  for (const lesson of [...STEPS, ...TRAPS]) {
    assert.ok(lesson.text.length >= 1, lesson.id);
    assert.ok((lesson.tries ?? []).length >= 1, lesson.id);
    assert.ok(lesson.picture === "coat" || Object.keys(lesson.rows ?? {}).length >= 1, lesson.id);
    assert.match(lesson.formula ?? "model.", /^(model|albedo|angle|conversion)\./, lesson.id);
  }
  const ids = [...STEPS, ...TRAPS].map((l) => l.id);
  assert.equal(new Set(ids).size, ids.length);
});

test("every link of lessons and worksheets names a view", () => {
  const main = readFileSync(new URL("../../static/js/main.js", import.meta.url), "utf8");
  const views = [...main.matchAll(/id: "(\w+)", title/g)].map((match) => match[1]);
  const links = [
    ...[...STEPS, ...TRAPS].flatMap((l) => (l.more ?? []).map(([, view]) => view)),
    ...SHEETS.flatMap((s) => s.tasks).map((task) => {
      const address = /^.+ \[.+\]\((\?.+)\)$/.exec(task)?.[1];
      return new URLSearchParams(address ?? "view=none").get("view") ?? "explore";
    }),
  ];
  for (const view of links) assert.ok(views.includes(view), view);
});

test("an address leaves out what is nothing", () => {
  assert.equal(addressOf("explore"), "./");
  assert.equal(addressOf("explore", { n_t: 1.333 }), "?n_t=1.333");
  assert.equal(addressOf("theory", { section: null, step: "coat" }), "?view=theory&step=coat");
  assert.equal(
    addressOf("compare", { models: "schlick,exact" }),
    "?view=compare&models=schlick,exact",
  );
});

test("claims are chosen by verdict and by source", () => {
  const claims = /** @type {any[]} */ ([
    { id: "a", verdict: "holds", source: { author: "Lagarde", year: 2013 } },
    { id: "b", verdict: "does not hold", source: { author: "Lagarde", year: 2013 } },
    { id: "c", verdict: "holds", source: { author: "Wloka", year: 2002 } },
  ]);
  /** @param {string | null} verdict @param {string | null} by */
  const ids = (verdict, by) => chosen(claims, { verdict, by }).map((c) => c.id);
  assert.deepEqual(ids(null, null), ["a", "b", "c"]);
  assert.deepEqual(ids("holds", null), ["a", "c"]);
  assert.deepEqual(ids("holds", "Lagarde 2013"), ["a"]);
  assert.deepEqual(ids("never", null), []);
  assert.equal(sourceName(claims[2].source), "Wloka 2002");
  assert.ok(EXAMPLES.length > 0);
});

test("each section asks for what it shows and no more", () => {
  const asked = SECTIONS.map(({ id }) => [
    id,
    Object.keys(queries(stateWith(id === "path" ? "" : `section=${id}`))),
  ]);
  assert.deepEqual(Object.fromEntries(asked), {
    path: ["curves", "snell"],
    formulas: ["curve", "formulas"],
    claims: ["claims"],
    traps: ["curves", "snell", "errors"],
    mystery: ["curves", "snell", "hidden"],
    worksheets: [],
  });
  const state = stateWith("section=formulas&formula=model.schlick&own_n=1.7");
  assert.equal(queries(state).curve, "/formulas/model.schlick/curve?n_t=1.7");
});

/** @param {string} d the ends of the lines of a path */
const numbers = (d) =>
  [...d.matchAll(/M(\S+) (\S+)L(\S+) (\S+?)(?=M|$)/g)].map((m) => m.slice(1).map(Number));

test("planes of phase keep step along the surface, and stand across the direction", () => {
  const surface = 105;
  /** @param {number[]} line where it meets the surface */
  const foot = ([x0 = 0, y0 = 0, x1 = 0, y1 = 0]) => x0 + ((surface - y0) / (y1 - y0)) * (x1 - x0);
  // From air at 50 degrees into n = 1.5, a wavelength of 64.
  const theta_t = (Math.asin(Math.sin((50 * Math.PI) / 180) / 1.5) * 180) / Math.PI;
  const feet = [phaseLines(50, 64), phaseLines(theta_t, 64 / 1.5)].map((d) =>
    numbers(d)
      .map(foot)
      .filter((x) => x > 0 && x < 420),
  );
  assert.equal(feet[0]?.length, feet[1]?.length);
  for (const [i, x] of (feet[0] ?? []).entries())
    assert.ok(Math.abs(x - (feet[1]?.[i] ?? 0)) < 0.1);
  for (const [x0 = 0, y0 = 0, x1 = 0, y1 = 0] of numbers(phaseLines(30, 40))) {
    const across = (x1 - x0) * 0.5 + (y1 - y0) * Math.cos(Math.PI / 6);
    assert.ok(Math.abs(across) < 0.05);
  }
});

test("where all is reflected the wave runs along the surface", () => {
  assert.equal(leaning(30), 30);
  const step = STEPS.find(({ id }) => id === "planes");
  const reading = { theta_t_deg: null, field_penetration_depth_wavelengths: 0.245 };
  const said = step?.live?.(/** @type {any} */ ({ reading }));
  assert.match(said ?? "", /lean by 90\.0°.*0\.245 wavelengths/);
  for (const [x0 = 0, , x1 = 1] of numbers(phaseLines(leaning(null), 64)))
    assert.ok(Math.abs(x0 - x1) < 0.01);
});
