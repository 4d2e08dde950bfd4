import assert from "node:assert/strict";
import { test } from "node:test";
import { known, spanned, valueAt, within } from "../../static/js/materials/band.js";
import { COLUMNS, sortedPresets } from "../../static/js/materials/columns.js";
import { materialFields, wavelengths } from "../../static/js/materials/fields.js";
import { queries, restCalls, rivalsOf, shown } from "../../static/js/materials/queries.js";
import { citation, condition, reference } from "../../static/js/materials/source.js";
import { limits, shortName } from "../../static/js/materials/spectrum.js";
import {
  stretch,
  wavelength,
  wavelengthColor,
  wavelengthDash,
  wavelengthProperty,
} from "../../static/js/media/wavelength.js";
import { decoded } from "../../static/js/numbers/srgb.js";
import { arrange } from "../../static/js/plot/arrange.js";
import { bandShapes } from "../../static/js/plot/bands.js";
import { logTicks } from "../../static/js/plot/ticks.js";
import { LinkError } from "../../static/js/state/state.js";
import { off, typed } from "../../static/js/takeaway/use.js";
import { pick } from "./catalog.js";

/** @param {string} id @param {any} [more] @returns {any} */
const preset = (id, more = {}) => ({
  id,
  name: id,
  category: "metal",
  kind: "spectrum",
  rival_of: null,
  n: 1.5,
  n_absolute: more?.n ?? 1.5,
  n_min: null,
  n_max: null,
  k: 0,
  wavelength_nm: 587.6,
  n_range_nm: [400, 800],
  confidence: "high",
  color: { luminance: 0.5 },
  ...more,
});

const CATALOG = /** @type {any} */ ({
  parameters: [],
  models: [],
  materials: [
    preset("Au", { name: "Gold" }),
    preset("Au-Johnson", { name: "Gold (Johnson)", rival_of: "Au" }),
    preset("Au-Babar", { name: "Gold (Babar)", rival_of: "Au" }),
    preset("water", { category: "liquid", n: 1.333, k: null, kind: "single" }),
  ],
});
const FIELDS = materialFields(CATALOG);
const STATE = Object.fromEntries(Object.entries(FIELDS).map(([key, f]) => [key, f.default]));

test("wavelengths in a link are sorted, distinct and within bounds", () => {
  const field = wavelengths();
  assert.deepEqual(field.parse("700, 400 500,400"), [400, 500, 700]);
  assert.equal(field.print(field.parse("700,400")), "400,700");
  assert.equal(field.print(null), "");
  for (const text of ["", "blue", "0", "-5", Array.from({ length: 13 }, (_, i) => 400 + i).join()])
    assert.throws(() => field.parse(text), LinkError, text);
});

test("a link names a preset of the catalog", () => {
  assert.throws(() => FIELDS.preset?.parse("watr"), /water/);
  assert.equal(FIELDS.preset?.default, null);
  assert.equal(FIELDS.preset?.parse("water"), "water");
  assert.throws(() => FIELDS.preset?.parse("Unobtainium"), LinkError);
  assert.throws(() => FIELDS.category?.parse("wood"), LinkError);
});

test("until one is chosen here, the other views' second medium is shown, else gold", () => {
  /** @param {object} more */
  const asked = (more) => queries({ ...STATE, ...more }, CATALOG).detail;
  assert.equal(asked({}), "/materials/Au");
  assert.equal(asked({ material: "water" }), "/materials/water");
  assert.equal(asked({ material: "water", preset: "Au-Babar" }), "/materials/Au-Babar");
  assert.equal(shown(STATE, { ...CATALOG, materials: [preset("glass")] }).preset, "glass");
});

test("only what a preset has is asked for", () => {
  const gold = queries(STATE, CATALOG);
  assert.equal(
    Object.keys(gold).join(" "),
    "list detail use covered index spectrum angles colors map rival:Au-Johnson rival:Au-Babar",
  );
  assert.equal(gold.detail, "/materials/Au");
  assert.equal(gold.angles, "/materials/Au/curves?rgb=false");
  const water = queries({ ...STATE, preset: "water" }, CATALOG);
  assert.deepEqual(Object.keys(water), ["list", "detail", "use", "covered", "index"]);
  assert.equal(water.index, "/curves?n_t=1.333&models=exact,schlick");
  assert.deepEqual(Object.keys(queries(STATE, CATALOG, true)), ["list", "detail"]);
});

test("the choices stand in the calls, the list's only where it is filtered", () => {
  const state = {
    ...STATE,
    find: " zinc & co",
    category: "metal",
    gamut: "clamped",
    illuminant: "E",
    at_nm: 600,
    nm: [500, 600],
    map_of: "Rp",
    rivals: "hidden",
  };
  const calls = restCalls(state, CATALOG);
  assert.equal(calls[0], "/materials?q=zinc%20%26%20co&category=metal&gamut=clamped");
  assert.equal(calls[1], "/materials/Au?wavelength_nm=600&gamut=clamped&illuminant=E");
  assert.ok(calls.includes("/materials/Au/curves?wavelengths_nm=500,600&rgb=false"));
  assert.ok(calls.some((c) => c.includes("/map?quantity=Rp")));
  assert.ok(!restCalls(STATE, CATALOG).includes("/materials"));
});

test("rivals are all other measurements of a material, whichever is shown", () => {
  assert.deepEqual(rivalsOf(CATALOG, "Au"), ["Au-Johnson", "Au-Babar"]);
  assert.deepEqual(rivalsOf(CATALOG, "Au-Babar"), ["Au", "Au-Johnson"]);
  assert.deepEqual(rivalsOf(CATALOG, "water"), []);
  // Of another that is set beside it, that one too.
  assert.deepEqual(rivalsOf(CATALOG, "water", "Au-Babar"), ["Au", "Au-Johnson", "Au-Babar"]);
  assert.deepEqual(rivalsOf(CATALOG, "Au", "Au-Babar"), ["Au-Johnson", "Au-Babar"]);
  assert.equal(shortName(CATALOG.materials[1]), "Johnson");
  assert.equal(shortName(preset("x", { name: "Moissanite (6H-SiC)" })), "Moissanite (6H-SiC)");
});

test("presets sort by a column, what has no value last in either order", () => {
  const some = [preset("b", { k: null }), preset("a", { k: 2 }), preset("c", { k: 1 })];
  const ids = (/** @type {any[]} */ all) => all.map((m) => m.id).join("");
  assert.equal(ids(sortedPresets(some, "match", "up")), "bac");
  assert.equal(ids(sortedPresets(some, "k", "up")), "cab");
  assert.equal(ids(sortedPresets(some, "k", "down")), "acb");
  assert.equal(ids(sortedPresets(some, "name", "up")), "abc");
  const trust = [preset("h"), preset("l", { confidence: "low" })];
  assert.equal(ids(sortedPresets(trust, "confidence", "up")), "lh");
});

test("numbers of the table fit their column and invent nothing", () => {
  const print = (/** @type {string} */ name, /** @type {object} */ more) =>
    COLUMNS.find((c) => c.name === name)?.print(preset("x", more));
  assert.equal(print("n", { n: 1.00027717 }), "1.000277");
  assert.equal(print("n", { n: 1.81, n_min: 1.73, n_max: 1.89 }), "1.73–1.89");
  assert.equal(print("k", { k: null }), "–");
  assert.equal(print("k", { k: 0 }), "0");
  assert.equal(print("k", { k: 9.76e-9 }), "9.8 × 10⁻⁹");
  assert.equal(print("F0", { color: { luminance: 1e-8 } }), "< 0.001");
  assert.equal(wavelength(24930), "24.9\u00a0µm");
  assert.equal(stretch([300, 830]), "300–830\u00a0nm");
  assert.equal(stretch([300, 24930]), "300\u00a0nm – 24.9\u00a0µm");
});

test("a band spans at least two measurements and ends with them", () => {
  const a = { x: [400, 500, 600], y: [1, 2, 3] };
  const b = { x: [500, 700], y: [5, 7] };
  const band = spanned([a, b], [400, 700], 4);
  assert.deepEqual(band.x, [400, 500, 600, 700]);
  assert.deepEqual(band.low, [null, 2, 3, null]);
  assert.deepEqual(band.high, [null, 5, 6, null]);
  assert.deepEqual(spanned([a], [400, 600], 2).low, [null, null]);
});

test("a series is never read outside its range", () => {
  const a = { x: [400, 500], y: [1, 2] };
  assert.equal(valueAt(a, 399), null);
  assert.equal(valueAt(a, 450), 1.5);
  assert.equal(valueAt(a, 500), 2);
  assert.deepEqual(within(a, [450, 600]), { x: [450, 500], y: [1.5, 2] });
  assert.deepEqual(within(a, [600, 700]), { x: [], y: [] });
  assert.deepEqual(known([1, 2, 3], [null, 5, null]), { x: [2], y: [5] });
});

test("a band is drawn in pieces around its gaps", () => {
  const theme = /** @type {any} */ ({ color: () => "#123456" });
  const band = {
    id: "n",
    x: [1, 2, 3, 4, 5],
    low: [0, 1, null, 2, 3],
    high: [1, 2, null, 3, 4],
    color: "--n",
  };
  const shapes = bandShapes([band], theme);
  assert.deepEqual(pick(shapes, "path"), ["M1,1L2,2L2,1L1,0Z", "M4,3L5,4L5,3L4,2Z"]);
});

test("a logarithmic axis gives equal room to equal ratios, and back", () => {
  const x = { title: "", range: [100, 10_000], scale: /** @type {const} */ ("log") };
  const { frame, xPixel, xValue, ticks } = arrange({
    size: { width: 600, height: 400 },
    axes: { x, y: { title: "", range: [0, 1] }, y2: null },
    traces: [],
    measure: () => 20,
    marksRow: false,
  });
  assert.equal(xPixel(100), frame.x);
  assert.ok(Math.abs(xPixel(1000) - (frame.x + frame.width / 2)) < 1e-9);
  assert.ok(Math.abs(xValue(xPixel(350)) - 350) < 1e-9);
  assert.ok(ticks.x.some((t) => t.value === 1000));
});

test("ticks of a logarithmic axis keep their distance", () => {
  for (const [low, high] of /** @type {[number, number][]} */ ([
    [300, 900],
    [187.9, 1937],
    [2, 1e6],
    [1e-3, 1e12],
  ])) {
    const at = (/** @type {number} */ v) => (Math.log10(v / low) / Math.log10(high / low)) * 500;
    const ticks = logTicks([low, high], 500, 40);
    assert.ok(ticks.length >= 2, `${low} to ${high}`);
    ticks.slice(1).forEach((tick, i) => {
      assert.ok(at(tick.value) - at(ticks[i]?.value ?? 0) >= 39.9, `${low}: ${tick.label}`);
    });
  }
});

test("wavelengths are told apart by lightness, dash and name", () => {
  for (const dark of [false, true]) {
    const colors = [400, 500, 600, 700, 800].map((nm) => wavelengthColor(nm, dark));
    assert.equal(new Set(colors).size, 5);
    for (const color of colors) assert.match(color, /^#[0-9a-f]{6}$/);
  }
  for (const nm of [1, 100, 2500, 1e6]) assert.match(wavelengthColor(nm, true), /^#[0-9a-f]{6}$/);
  assert.equal(new Set([0, 1, 2, 3, 4, 5].map(wavelengthDash)).size, 6);
  assert.equal(wavelengthProperty(587.6), "--nm-587_6");
});

test("the lines of every wavelength stand out from the page", () => {
  /** @param {string} hex */
  const luminance = (hex) =>
    [1, 3, 5]
      .map((i) => Number.parseInt(hex.slice(i, i + 2), 16) / 255)
      .map(decoded)
      .reduce((sum, c, i) => sum + c * ([0.2126, 0.7152, 0.0722][i] ?? 0), 0);
  const contrast = (/** @type {string} */ a, /** @type {string} */ b) => {
    const [low = 0, high = 0] = [luminance(a), luminance(b)].sort((x, y) => x - y);
    return (high + 0.05) / (low + 0.05);
  };
  for (let nm = 300; nm <= 1200; nm += 10) {
    assert.ok(contrast(wavelengthColor(nm, false), "#faf9f6") >= 3, `${nm} nm, light`);
    assert.ok(contrast(wavelengthColor(nm, true), "#0e1115") >= 3, `${nm} nm, dark`);
  }
});

test("the ends of the data are marked where the axis shows them", () => {
  const spectrum = { n_range_nm: [300, 760], k_range_nm: [400, 760] };
  assert.deepEqual(pick(limits(spectrum, [360, 830]), "label"), [
    "n to 760\u00a0nm",
    "k from 400\u00a0nm",
    "k to 760\u00a0nm",
  ]);
  const both = { n_range_nm: [300, 760], k_range_nm: [300, 760] };
  assert.deepEqual(pick(limits(both, [360, 830]), "label"), ["to 760\u00a0nm"]);
});

test("what n was measured against is said, and where nobody says", () => {
  const glass = reference({ relative_to: "air", wavelength_in: "air" });
  assert.equal(glass, "air: what is computed takes n times air’s index; wavelengths in air");
  assert.equal(
    reference({ relative_to: "vacuum", wavelength_in: null }),
    "vacuum; wavelengths not said to be in air or vacuum",
  );
  assert.match(reference({ relative_to: null }), /^not stated: n counts as absolute/);
});

test("conditions and citations read as sentences", () => {
  assert.equal(condition("temperature_k", 293), "temperature 293\u00a0K");
  assert.equal(condition("film_thickness_nm", 25), "film thickness 25\u00a0nm");
  assert.equal(condition("direction", "o"), "direction o");
  const cited = citation({
    source: "Someone, 1972",
    doi: ["10.1/x"],
    provenance: { database: "refractiveindex.info", tag: "v1", page: "main/Au/Johnson" },
  });
  assert.equal(
    cited,
    "Someone, 1972. https://doi.org/10.1/x. refractiveindex.info v1, main/Au/Johnson",
  );
});

test("what is typed in an engine is shown short, and how far it is off with its source", () => {
  assert.equal(typed(1.5), "1.5");
  assert.equal(typed([0.25, 0.5, 1]), "0.25, 0.5, 1");
  assert.equal(typed([360, 1, 365, 2, 370, 3]), "360, 1, 365, 2, … (6 numbers)");
  assert.ok(typed("360, ".repeat(90)).endsWith("…"));
  const error = { max_abs: 0.2, at_deg: 83.25, channel: "red", delta_e: 7.4, delta_e_at_deg: 82 };
  const measured = {
    model: "schlick",
    engine: "three",
    version: "0.187.0",
    way: "color",
    note: "",
  };
  assert.match(
    off({ ...error, measured_with: measured }),
    /0\.2 at 83\.25° in red.*three 0\.187\.0/,
  );
  const told = {
    model: null,
    engine: null,
    version: null,
    way: null,
    note: "its formula; not run",
  };
  assert.match(off({ ...error, measured_with: told }), /: its formula; not run\.$/);
});
