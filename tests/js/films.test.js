import assert from "node:assert/strict";
import { test } from "node:test";
import { summary } from "../../static/js/films/beside.js";
import { EXAMPLES, isShown, PLAIN, stateOf } from "../../static/js/films/examples.js";
import { filmFields, isAskedFor, mapEnd, panePath, queries } from "../../static/js/films/fields.js";
import { moved } from "../../static/js/layers/drawing.js";
import {
  asked,
  openedAt,
  printLayers,
  readLayers,
  roundAbove,
  shortMedium,
  thicknessText,
  withThickness,
} from "../../static/js/layers/layers.js";
import { brightening, pixels } from "../../static/js/layers/map.js";

test("layers are read as links write them, and written the same", () => {
  for (const text of ["1.38:99.6", "0.055+3.32i:30,BK7:3000000:incoherent", "own:ab1:5,1.5:0"])
    assert.equal(printLayers(readLayers(text) ?? []), text);
  assert.deepEqual(readLayers("own:ab1:5"), [{ medium: "own:ab1", nm: 5, incoherent: false }]);
  assert.equal(readLayers("rii:main/Ag/Johnson:20")?.[0]?.medium, "rii:main/Ag/Johnson");
  const shown = ["MgF2-o", "own:ab1", "rii:main/Ag/Johnson"].map(shortMedium);
  assert.deepEqual(shown, ["MgF2-o", "your own", "Ag/Johnson"]);
  for (const text of ["", "MgF2", "MgF2:", ":5", "MgF2:-1", "MgF2:1e10", "MgF2:5,", "MgF2:5:thick"])
    assert.equal(readLayers(text), null, text);
});

test("the thickness that varies is left open, that of a pane is not", () => {
  const layers = readLayers("1.38:99.6,BK7:3000000:incoherent") ?? [];
  assert.equal(openedAt(layers, 0), "1.38,BK7:3000000:incoherent");
  assert.equal(openedAt(layers, 1), "1.38:99.6,BK7:3000000:incoherent");
  assert.equal(asked("0.05+3i:30,Au:5"), "layers=0.05%2B3i:30,Au:5");
});

test("a thickness is changed where it is, and its layer is then the one at hand", () => {
  const state = { layers: "1.38:99.6,2.3:50", film_layer: 1 };
  assert.deepEqual(withThickness(state, 12.5, 1), { layers: "1.38:99.6,2.3:12.5", film_layer: 2 });
  assert.equal(moved({ nm: 0.5, key: "ArrowLeft", shift: false }), 0);
  assert.equal(moved({ nm: 5, key: "ArrowDown", shift: true }), 5.1);
  assert.equal(moved({ nm: 5, key: "a", shift: false }), null);
});

test("thicknesses are rounded and written in their unit", () => {
  assert.deepEqual([0, 1, 1.2, 330, 4e6].map(roundAbove), [1, 1, 1.5, 500, 5e6]);
  assert.deepEqual([99.6, 12_345, 4e6].map(thicknessText), ["99.6 nm", "12.35 µm", "4 mm"]);
});

test("every example is a state that a link can hold, and is known again", () => {
  const fields = filmFields();
  for (const example of EXAMPLES) {
    const state = stateOf(example);
    assert.ok(isShown(example, state), example.title);
    assert.equal(EXAMPLES.filter((other) => isShown(other, state)).length, 1, example.title);
    for (const [name, field] of Object.entries(fields)) {
      if (!(name in state)) continue;
      assert.deepEqual(field.parse(field.print(state[name])), state[name], name);
    }
  }
});

test("the map reaches beyond the thickness at hand", () => {
  assert.equal(mapEnd({ layers: "1.38:99.6", film_layer: 1, film_to: 1000 }), 1000);
  assert.equal(mapEnd({ layers: "1.38:1200", film_layer: 1, film_to: 1000 }), 1500);
});

test("a pane is one thick layer of a clear medium in air", () => {
  const glass = { id: "glass", n: 1.5, n_absolute: 1.5004, k: 1e-7, wavelength_nm: 500 };
  const catalog = /** @type {any} */ ({ materials: [glass] });
  const state = { layers: "glass:4e6:incoherent", n_i: 1, n_t: 1, k_t: 0 };
  const found = new URLSearchParams(panePath(state, catalog)?.split("?")[1]);
  assert.equal(found.get("n"), "1.5004");
  assert.equal(found.get("thickness_mm"), "4");
  // K = 4 pi k / lambda: 0.8 pi per meter
  assert.ok(Math.abs(Number(found.get("absorption_per_m")) - 0.8 * Math.PI) < 1e-12);
  /** @param {object} changes */
  const without = (changes) => panePath({ ...state, ...changes }, catalog);
  assert.equal(without({ layers: "glass:4e6" }), null);
  assert.equal(without({ layers: "glass:4e6:incoherent,1.38:100" }), null);
  assert.equal(without({ layers: "unobtainium:4e6:incoherent" }), null);
  assert.equal(without({ layers: "1.5+0.1i:4e6:incoherent" }), null);
  assert.equal(without({ layers: "1.5:2e8:incoherent" }), null);
  assert.equal(without({ n_i: 1.33 }), null);
  assert.equal(without({ k_t: 3 }), null);
  assert.match(without({ layers: "1.5:4e6:incoherent" }) ?? "", /absorption_per_m=0&/);
});

test("a drag asks for the curves alone, where all media are known", () => {
  const catalog = {
    parameters: [
      { name: "n_i", default: 1 },
      { name: "n_t", default: 1.5 },
      { name: "k_t", default: 0 },
    ],
    materials: [{ id: "ZnS", kind: "spectrum", n_range_nm: [404.7, 13_000] }],
    models: [],
  };
  const state = {
    ...stateOf(EXAMPLES[0]),
    layers: "ZnS:50",
    theta_i_deg: 0,
    film_layer: 1,
  };
  const all = queries(state, /** @type {any} */ (catalog));
  const moving = queries(state, /** @type {any} */ (catalog), true);
  assert.deepEqual(Object.keys(moving), ["shortcuts", "spectrum", "curves"]);
  assert.deepEqual(Object.keys(all), ["shortcuts", "spectrum", "curves", "here"]);
  assert.equal(moving.shortcuts, all.shortcuts);
  assert.match(
    all.spectrum,
    /^\/films\/spectrum\?n_t=1&layers=ZnS:50&theta_i_deg=0&minimum_nm=405&maximum_nm=780/,
  );
});

test("colors are brightened alike until the brightest below 60 degrees fits", () => {
  const rows = [
    [
      [0.1, 0.05, 0],
      [1, 1, 1],
    ],
    [
      [0.02, 0.25, -0.1],
      [1, 1, 1],
    ],
  ];
  assert.equal(brightening(rows, [0, 90]), 4);
  const { width, height, data } = pixels(rows, 4);
  assert.deepEqual([width, height], [2, 2]);
  // the lower row is normal incidence; 0.25 times 4 is white, a channel below 0 none
  assert.deepEqual([...data.slice(12, 16)], [80, 255, 0, 255]);
  assert.deepEqual([...pixels(rows, null).data.slice(8, 11)], [255, 188, 0]);
});

test("a shortcut is asked for where renderers know the films, else it is said why not", () => {
  const state = { ...PLAIN, layers: "1.33:300", film_model: "cycles_film" };
  assert.deepEqual(isAskedFor({ ...state, film_model: "none" }), { wanted: false, why: "" });
  assert.deepEqual(isAskedFor(state), { wanted: true, why: "" });
  for (const [patch, why] of /** @type {const} */ ([
    [{ layers: "1.33:300,1.5:9" }, /several/],
    [{ layers: "1.5:3e6:incoherent" }, /interference/],
    [{ n_i: 1.5 }, /air/],
    [{ film_side: "T" }, /reflected/],
  ])) {
    const asked = isAskedFor({ ...state, ...patch });
    assert.equal(asked.wanted, false);
    assert.match(asked.why, why);
  }
});

test("differences are summed up to an angle", () => {
  const rows = [
    [1, 2, 90],
    [3, 6, 90],
  ];
  assert.deepEqual(summary(rows, [0, 45, 90], 85), { most: 6, mean: 3 });
});
