import assert from "node:assert/strict";
import { test } from "node:test";
import { inTurn, matching } from "../../static/js/controls/picker.js";
import { sentence, spread } from "../../static/js/explore/dispersion.js";
import {
  createConstants,
  isDispersive,
  knownAs,
  knownRange,
  mediaAt,
  spreadPaths,
} from "../../static/js/media/media.js";
import { allowedWords, distance, refusals } from "../../static/js/state/state.js";

/** @param {string} id @param {any} [more] @returns {any} */
const medium = (id, more = {}) => ({
  id,
  name: id,
  category: "glass",
  kind: "spectrum",
  rival_of: null,
  n: 1.5,
  n_absolute: more?.n ?? 1.5,
  k: 0,
  wavelength_nm: 587.6,
  n_range_nm: [300, 2500],
  ...more,
});
const MEDIA = [
  medium("Au", { name: "Gold", category: "metal", n: 0.2, k: 3 }),
  medium("Au-Johnson", { name: "Gold (Johnson)", category: "metal" }),
  medium("BK7", { name: "N-BK7 (Schott)", k: 1e-8 }),
  medium("diamond", { name: "Diamond", category: "crystal", n_range_nm: [225, 760] }),
  medium("water-shirley", { name: "Water", category: "liquid", kind: "single", n: 1.333 }),
];
const STATE = {
  incident: null,
  material: "BK7",
  n_i: 1,
  n_t: 1.5,
  k_t: 0,
  wavelength_nm: null,
  light: "white",
  theta_i_deg: 45,
  angle: "deg",
};

test("a medium is found by name, formula, word, category, and in spite of a typo", () => {
  const ids = (/** @type {string} */ text) => matching(MEDIA, text).map((m) => m.id);
  assert.deepEqual(ids("gold"), ["Au", "Au-Johnson"]);
  assert.deepEqual(ids("au"), ["Au", "Au-Johnson"]);
  assert.deepEqual(ids("johnson"), ["Au-Johnson"]);
  assert.deepEqual(ids("metal"), ["Au", "Au-Johnson"]);
  assert.deepEqual(ids("dimond"), ["diamond"]);
  assert.deepEqual(ids("xyzzyx"), []);
  assert.equal(ids("").length, MEDIA.length);
  assert.equal(distance("dimond", "diamond"), 1);
});

test("a word comes before a part of a word, and pages that alone are called so come first", () => {
  const setting = { name: "Platinum", source: "Setting of constants" };
  const media = [medium("Pt", setting), medium("TiN", { name: "Titanium nitride" })];
  const page = (/** @type {string} */ path, name = path) => medium(`rii:main/${path}`, { name });
  const pages = [page("Sn/A", "Sn (Tin), A"), page("ITO/B", "Indium tin oxide"), page("Xe/Martin")];
  const runs = inTurn(media, pages, 1, "tin").map(({ name, rows }) => [
    name,
    rows.map((m) => m.id),
  ]);
  assert.deepEqual(runs, [
    ["refractiveindex.info", ["rii:main/Sn/A"]],
    ["Other media", ["TiN"]],
    ["refractiveindex.info", ["rii:main/ITO/B"]],
    ["Inside other words", ["Pt"]],
    ["refractiveindex.info", ["rii:main/Xe/Martin"]],
  ]);
  const before = inTurn(media, [], 0, "tin").map(({ name, rows }) => [name, rows.length]);
  assert.deepEqual(before.slice(1, 4), [
    [null, 1],
    ["refractiveindex.info", 0],
    [null, 1],
  ]);
});

test("a medium is found by its other names and its authors once they are known", () => {
  const more = [medium("Al", { name: "Aluminium" }), medium("Au", { name: "Gold" })];
  const ids = (/** @type {string} */ text) => matching(more, text).map((m) => m.id);
  assert.deepEqual(ids("aurum"), []);
  Object.assign(more[1] ?? {}, { aliases: ["aurum"], source: "R. L. Olmon, B. Slovick. 2012" });
  assert.deepEqual(ids("aurum"), ["Au"]);
  assert.deepEqual(ids("auram"), ["Au"]);
  assert.deepEqual(ids("olmon"), ["Au"]);
  assert.deepEqual(ids("r"), []);
});

test("a link to a material of one's own that was cut says so, and names no other", () => {
  assert.match(allowedWords(["Au", "Ag"], "own:AYQJ"), /cut or changed on its way/);
  refusals.set("rii:main/Si/Daub", "a page with n; this page has k alone");
  assert.match(
    allowedWords(
      MEDIA.map(({ id }) => id),
      "rii:main/Si/Daub",
    ),
    /has k alone$/,
  );
});

test("of many words the nearest are named, of few all", () => {
  assert.equal(allowedWords(["s", "p"], "x"), "allowed is one of s, p");
  const models = ["schlick", "schlick_tir", "exact", "f82_tint", "lut_1d", "a", "b", "c", "d"];
  const said = allowedWords(models, "Schlik");
  assert.match(said, /none of the 9 allowed; the nearest are schlick, /);
  assert.ok(allowedWords(models, "x".repeat(1e6)).length < 120);
});

test("only media with a spectrum are asked for at a wavelength", () => {
  assert.ok(isDispersive(MEDIA[2]) && !isDispersive(MEDIA[4]) && !isDispersive(undefined));
  assert.equal(mediaAt(MEDIA, STATE, null), null);
  assert.equal(mediaAt(MEDIA, { ...STATE, material: "water-shirley" }, 500), null);
  assert.deepEqual(mediaAt(MEDIA, { ...STATE, incident: "water-shirley", n_i: 1.333 }, 500), [
    "n_i=1.333",
    "material=BK7",
    "wavelength_nm=500",
  ]);
  assert.deepEqual(knownRange(MEDIA, { ...STATE, incident: "diamond" }), [300, 760]);
  assert.equal(knownRange(MEDIA, { ...STATE, material: null }), null);
});

test("indices at a wavelength are the server's; until it answers the last ones stay", () => {
  /** @type {any} */
  let how;
  /** @type {string[]} */
  const asked = [];
  /** @type {unknown[]} */
  const problems = [];
  let changes = 0;
  const constants = createConstants({
    materials: MEDIA,
    onChange: () => {
      changes += 1;
    },
    onProblem: (problem) => problems.push(problem),
    query: (given) => {
      how = given;
      return { request: (path) => asked.push(path) };
    },
  });
  assert.deepEqual(constants.implied(STATE), { n_t: 1.5, k_t: 0 });
  constants.follow(STATE);
  assert.deepEqual(asked, []);
  const violet = { ...STATE, wavelength_nm: 400 };
  constants.follow(violet);
  assert.deepEqual(asked, ["/snell?n_i=1&material=BK7&wavelength_nm=400&theta_i_deg=0"]);
  assert.deepEqual(constants.implied(violet), { n_t: 1.5, k_t: 0 });
  how.onAnswer({
    interface: {
      incident: null,
      material: { id: "BK7", wavelength_nm: 400, n: 1.53, n_absolute: 1.5304, k: 1e-8 },
    },
  });
  assert.equal(changes, 1);
  assert.deepEqual(constants.implied(violet), { n_t: 1.5304, k_t: 0 });
  constants.follow(violet);
  assert.equal(asked.length, 1);
  // Beyond what is known nothing is asked: the control says so.
  constants.follow({ ...STATE, wavelength_nm: 100 });
  assert.equal(asked.length, 1);
  // What was refused is not asked again.
  const red = { ...STATE, wavelength_nm: 700 };
  constants.follow(red);
  how.onProblem({ title: "no" });
  constants.follow(red);
  assert.equal(asked.length, 2);
  assert.equal(problems.length, 1);
  constants.follow(violet);
  assert.equal(problems.at(-1), null);
});

test("white light is asked for at the wavelengths that the media are known at", () => {
  assert.equal(Object.keys(spreadPaths(STATE, MEDIA)).length, 7);
  const red = { ...STATE, material: "deep" };
  const known = [medium("deep", { n_range_nm: [520, 640] })];
  assert.deepEqual(Object.keys(spreadPaths(red, known)), ["white:550", "white:600"]);
  assert.deepEqual(spreadPaths({ ...STATE, light: "one" }, MEDIA), {});
  assert.deepEqual(spreadPaths({ ...STATE, material: null }, MEDIA), {});
});

test("rays are read from the curves of the media at hand", () => {
  const curves = (/** @type {number} */ end) => ({
    interface: { n_i: 1, incident: null, material: { id: "BK7" } },
    theta_i_deg: [0, 90],
    curves: [{ model: "exact", quantity: "theta_t_deg", values: [0, end] }],
  });
  const answers = { "white:400": curves(40), "white:700": curves(42) };
  const rays = spread(STATE, MEDIA, answers);
  assert.deepEqual(
    rays.map((r) => [r.nm, r.theta_t_deg]),
    [
      [400, 20],
      [700, 21],
    ],
  );
  assert.match(sentence(rays, STATE, true), /400 nm at 20\.00°, 700 nm at 21\.00°: 1\.000° apart/);
  assert.deepEqual(spread({ ...STATE, material: "diamond" }, MEDIA, answers), []);
  const kept = rays.map((r) => ({ ...r, theta_t_deg: null }));
  assert.match(sentence(kept, STATE, true), /totally reflected/);
  assert.match(sentence([], STATE, false), /name a medium/);
});

test("an index of one's own stays one, and is like a medium that has it", () => {
  const materials = [medium("air", { n_absolute: 1 }), medium("quartz", { n_absolute: 1.544 })];
  const presets = { n_i: 1, n_t: 1.5 };
  /** @param {string | null} id @param {number} n @param {number} [k] */
  const known = (id, n, k = 0) => knownAs(materials, id, n, k, presets);
  assert.deepEqual(known(null, 1.544), { id: null, like: "quartz" });
  assert.deepEqual(known("quartz", 1.544), { id: "quartz", like: null });
  assert.deepEqual(known(null, 1.5441), { id: null, like: null });
  assert.deepEqual(known(null, 1.544, 0.1), { id: null, like: null });
  assert.deepEqual(known(null, 1), { id: "air", like: null }); // where the page starts
});
