import assert from "node:assert/strict";
import { test } from "node:test";
import { homeOf, sideOf } from "../../static/js/albedo/answers.js";
import {
  printDomain,
  printError,
  printHolds,
  rowsOf,
  sortedClaims,
} from "../../static/js/albedo/claims.js";
import {
  albedoFields,
  chosenFits,
  facing,
  gone,
  mapFit,
  place,
  sweepRange,
} from "../../static/js/albedo/fields.js";
import { queries, restCalls } from "../../static/js/albedo/queries.js";
import {
  albedoTraces,
  claimTraces,
  decisive,
  divided,
  errorTraces,
  tamed,
} from "../../static/js/albedo/traces.js";
import { coatPicture, outline } from "../../static/js/coat/picture.js";
import { createState } from "../../static/js/state/state.js";
import { PARAMETERS, pick } from "./catalog.js";

const CATALOG = /** @type {any} */ ({ parameters: PARAMETERS, models: [], materials: [] });

/** @param {Record<string, unknown>} [patch] @returns {Record<string, any>} */
function stateWith(patch = {}) {
  const own = Object.entries(albedoFields(CATALOG)).map(([key, field]) => [key, field.default]);
  return { n_i: 1, n_t: 1.5, k_t: 0, ...Object.fromEntries(own), ...patch };
}

/** @returns {any} */
const DOMAIN = (kind = "dielectric", eta = [1, 3], kappa = [0, 0]) => ({ kind, eta, kappa });
/** @param {string} id @param {any} claim @returns {any} */
const fit = (id, claim) => ({
  id,
  title: `Fit ${id}`,
  quantity: "unpolarized",
  domains: [claim.domain],
  claims: [claim],
});
const LOG = fit("log", {
  domain: DOMAIN(),
  claimed: null,
  relative: false,
  source: "a plot",
  measured: 0.00172,
  at: { eta: 1, kappa: 0 },
  measured_over: DOMAIN(),
  holds: null,
});
const METAL = DOMAIN("conductor", [0.1, 4], [1.7, 8]);
const FIRST = fit("first", {
  domain: METAL,
  claimed: 0.001,
  relative: false,
  source: "d'Eon",
  measured: 0.00309,
  at: { eta: 0.5, kappa: 1.7 },
  measured_over: METAL,
  holds: false,
});
const INSIDE = fit("inside", {
  domain: DOMAIN("dielectric", [0.5, 0.6666666666666666]),
  claimed: 0.006,
  relative: true,
  source: "Mitsuba",
  measured: 0.000781,
  at: { eta: 0.6666666666666666, kappa: 0 },
  measured_over: DOMAIN("dielectric", [0.5, 0.6666666666666666]),
  holds: true,
});

/** @param {any} [more] @returns {any} */
const sweep = (more = {}) => ({
  over: "n_t",
  n_i: 1,
  n_t: null,
  k_t: 3,
  values: [0, 1, 2, 3],
  curves: [
    {
      kind: "exact",
      id: "exact",
      quantity: "unpolarized",
      values: [0, 0.5, 0.5, 0.5],
      error: null,
    },
    { kind: "exact", id: "exact", quantity: "s", values: [0, 0.6, 0.6, 0.6], error: null },
    { kind: "exact", id: "exact", quantity: "p", values: [0, 0.4, 0.4, 0.4], error: null },
    {
      kind: "fit",
      id: "first",
      quantity: "unpolarized",
      values: [9, 0.4, 0.6, 0.5],
      error: [9, -0.1, 0.1, 0],
      in_domain: [1, 3],
    },
  ],
  ...more,
});

test("the default picture is d'Eon's: his fit from outside between 1 and 3", () => {
  const { sweep: path, here, map, coat } = queries(stateWith(), CATALOG);
  assert.equal(path, "/albedo/sweep?over=eta&minimum=1&maximum=3&steps=401&fits=deon_2019_log");
  assert.equal(here, "/albedo");
  assert.match(map ?? "", /^\/albedo\/map\?fit=deon_2019_rational&n_minimum=0\.1&n_maximum=4&/);
  assert.equal(coat, "/albedo/coat?n_t=1.5&body_albedo=0.5");
  assert.equal(restCalls(stateWith(), CATALOG).length, 4);
});

test("while something moves the map is not asked for", () => {
  assert.equal("map" in queries(stateWith(), CATALOG, true), false);
});

test("sweeps of metals hold the other index and follow the medium in front", () => {
  const state = stateWith({ surface: "metal-n", n_i: 1.33, k_t: 3 });
  assert.deepEqual(sweepRange(state), [0.133, 5.32]);
  const { sweep: path } = queries(state, CATALOG);
  assert.match(path ?? "", /over=n_t&minimum=0\.133&maximum=5\.32/);
  assert.match(path ?? "", /&n_i=1\.33&k_t=3$/);
  const over = queries(stateWith({ surface: "metal-k", n_t: 0.2, k_t: 3 }), CATALOG).sweep ?? "";
  assert.match(over, /over=k_t&minimum=0&maximum=8/);
  assert.match(over, /&n_t=0\.2$/);
});

test("the fits follow the figure until they are chosen; none is a choice", () => {
  assert.deepEqual(chosenFits(stateWith()), ["deon_2019_log"]);
  assert.equal(chosenFits(stateWith({ surface: "metal-n" })).length, 3);
  assert.deepEqual(chosenFits(stateWith({ fits: [] })), []);
  assert.doesNotMatch(queries(stateWith({ fits: [] }), CATALOG).sweep ?? "", /fits=/);
  const state = createState(albedoFields(CATALOG));
  state.set({ fits: Object.freeze([]) });
  assert.equal(state.toQuery(), "fits=none");
  state.set({ fits: null });
  assert.equal(state.toQuery(), "");
  assert.deepEqual(state.fromQuery("?fits=a,b,a&lights=none"), []);
  assert.deepEqual(state.get().fits, ["a", "b"]);
  assert.deepEqual(state.get().lights, []);
  assert.equal(state.fromQuery("?fits=Drop%20it").length, 1);
});

test("a map shows the first fit of the metals on the plot, or the one that is named", () => {
  assert.equal(mapFit(stateWith()), "deon_2019_rational");
  assert.equal(mapFit(stateWith({ surface: "metal-n", fits: ["large_k"] })), "large_k");
  assert.equal(mapFit(stateWith({ map_fit: "schlick" })), "schlick");
});

test("the interface of all views is marked from the side that the figure shows", () => {
  assert.equal(place(stateWith()), 1.5);
  assert.equal(place(stateWith({ surface: "inside" })), 1 / 1.5);
  assert.equal(place(stateWith({ n_i: 1.5, n_t: 1, surface: "inside" })), 1 / 1.5);
  assert.equal(place(stateWith({ n_i: 1.5, n_t: 1 })), 1.5);
  assert.equal(place(stateWith({ k_t: 3 })), null);
  assert.equal(place(stateWith({ surface: "metal-k", k_t: 3 })), 3);
  assert.equal(facing(stateWith({ n_i: 1.5, n_t: 1 })), false);
});

test("going to a place keeps which medium the light comes from", () => {
  assert.equal(gone(stateWith(), 2).n_t, 2);
  assert.equal(gone(stateWith({ surface: "inside" }), 0.5).n_t, 2);
  assert.equal(gone(stateWith({ n_i: 1.5, n_t: 1, surface: "inside" }), 0.5).n_t, 0.75);
  assert.deepEqual(gone(stateWith({ surface: "metal-k" }), 4), { k_t: 4, material: null });
  assert.deepEqual(gone(stateWith({ surface: "metal-n", k_t: 3 }), 0.2), {
    n_t: 0.2,
    material: null,
  });
});

test("a curve is divided at its domain, and the parts meet", () => {
  assert.deepEqual(divided([0, 1, 2, 3], [5, 6, 7, 8], [1, 2]), {
    inside: [null, 6, 7, null],
    beyond: [5, 6, 7, 8],
  });
  assert.deepEqual(divided([0, 1, 2, 3], [5, 6, 7, 8], [2, 9]), {
    inside: [null, null, 7, 8],
    beyond: [5, 6, 7, null],
  });
  assert.equal(divided([0, 1], [5, 6], [0, 1]).beyond, null);
  assert.deepEqual(divided([0, 1], [5, 6], null).inside, [null, null]);
});

test("the plot shows unpolarized light always, s and p where they are asked for", () => {
  /** @param {string[]} lights */
  const ids = (lights) =>
    albedoTraces(sweep(), { lights, relative: false }, [FIRST]).map((t) => t.id);
  assert.deepEqual(ids([]), ["exact.unpolarized", "first.outside", "first"]);
  assert.deepEqual(ids(["s", "p"]).slice(0, 3), ["exact.unpolarized", "exact.s", "exact.p"]);
});

test("a fit of one polarization brings the exact albedo it stands for", () => {
  const curves = sweep().curves.map((/** @type {any} */ c) =>
    c.kind === "fit" ? { ...c, quantity: "p" } : c,
  );
  const ids = albedoTraces(sweep({ curves }), { lights: [], relative: false }, []).map((t) => t.id);
  assert.ok(ids.includes("exact.p"));
  assert.ok(!ids.includes("exact.s"));
});

test("relative errors are in percent and undefined where the albedo is 0", () => {
  const all = errorTraces(sweep(), { lights: [], relative: true }, [FIRST]);
  const own = all.find((t) => t.id === "first");
  assert.deepEqual(own?.y, [null, -20, 20, 0]);
  assert.equal(all.find((t) => t.id === "first.outside")?.y[0], null);
});

test("claims are drawn where they apply, in the kind of error they are about", () => {
  assert.deepEqual(pick(claimTraces(sweep(), [FIRST], false), "y"), [
    [null, 0.001, 0.001, 0.001],
    [null, -0.001, -0.001, -0.001],
  ]);
  assert.deepEqual(claimTraces(sweep(), [FIRST], true), []);
  assert.deepEqual(claimTraces(sweep({ k_t: 1 }), [FIRST], false), []);
});

test("an axis is made for what lies in the domains, without what runs away", () => {
  const all = errorTraces(sweep(), { lights: [], relative: false }, [FIRST]);
  assert.deepEqual(pick(decisive(all), "id"), ["zero", "first"]);
  const y = Array.from({ length: 100 }, (_, i) => (i === 0 ? 3000 : 1));
  const wild = [{ id: "a", label: "", color: "", x: y.map((_, i) => i), y }];
  assert.equal(tamed(wild)[0]?.y[0], null);
  assert.equal(tamed(wild)[0]?.y[1], 1);
});

test("broken claims come first, in words and with their size", () => {
  const rows = sortedClaims(rowsOf([LOG, INSIDE, FIRST]), "holds", "up");
  assert.deepEqual(
    rows.map((r) => r.fit.id),
    ["first", "inside", "log"],
  );
  assert.deepEqual(rows.map(printHolds), [
    "does not hold: 3.1 times as large",
    "holds",
    "nothing claimed",
  ]);
  assert.equal(printError(0.00936, true), "0.936\u00a0%");
  assert.equal(printError(6e-5, false), "0.00006");
  assert.equal(printDomain(METAL), "n 0.1 – 4, k 1.7 – 8");
  assert.equal(printDomain(INSIDE.domains[0]), "η 0.5 – 0.667");
});

test("fits are at home outside, inside or at metals", () => {
  assert.deepEqual(LOG.domains.map(homeOf), ["outside"]);
  assert.deepEqual(INSIDE.domains.map(homeOf), ["inside"]);
  assert.deepEqual(FIRST.domains.map(homeOf), ["metal-n"]);
  const here = /** @type {any} */ ({ exact: { s: 1 }, reverse: { exact: { s: 2 } } });
  assert.equal(sideOf(here, true).exact.s, 1);
  assert.equal(sideOf(here, false).exact.s, 2);
});

const SIZE = { width: 400, height: 280, line: 17 };

test("the bands of the paint are as wide as their shares", () => {
  const split = { surface: 0.1, body: 0.3, absorbed: 0.6 };
  const { bands } = coatPicture(split, SIZE);
  /** @param {string} name */
  const width = (name) => {
    const points = bands.find((b) => b.name === name)?.points ?? [];
    return (points[1]?.[0] ?? 0) - (points[0]?.[0] ?? 0);
  };
  const all = width("incoming");
  assert.ok(Math.abs(width("surface") / all - 0.1) < 1e-9);
  assert.ok(Math.abs(width("entering") / all - 0.9) < 1e-9);
  assert.ok(Math.abs(width("body") / all - 0.3) < 1e-9);
  assert.ok(Math.abs(width("absorbed") / all - 0.6) < 1e-9);
});

test("what does not happen is not drawn, and all that is drawn stays in the picture", () => {
  for (const split of [
    { surface: 1, body: 0, absorbed: 0 },
    { surface: 0.09, body: 0.91, absorbed: 0 },
    { surface: 0, body: 0, absorbed: 1 },
  ]) {
    for (const size of [SIZE, { width: 290, height: 250, line: 17 }]) {
      const { bands } = coatPicture(split, size);
      const names = new Set(bands.map((b) => b.name));
      for (const [name, share] of Object.entries(split))
        assert.equal(names.has(/** @type {any} */ (name)), share > 0, name);
      for (const [x, y] of bands.flatMap((b) => b.points)) {
        assert.ok(x >= 0 && x <= size.width, `x = ${x}`);
        assert.ok(y >= 0 && y <= size.height, `y = ${y}`);
      }
      assert.match(outline(/** @type {any} */ (bands[0])), /^M[\d.,L-]+Z$/);
    }
  }
});
