import assert from "node:assert/strict";
import { test } from "node:test";
import { overlap, plainText, plotlyText, runs, within } from "../../static/js/draw/svg.js";
import { unitSuffix } from "../../static/js/numbers/format.js";
import { arrange } from "../../static/js/plot/arrange.js";
import { createPixels, curvePath } from "../../static/js/plot/fast.js";
import { dashArray } from "../../static/js/plot/legend.js";
import { placeLabels, placeMarkNames } from "../../static/js/plot/overlay.js";
import { shortTitle } from "../../static/js/plot/plotly.js";
import { pickedRows, toCsv } from "../../static/js/plot/table.js";
import { axisTicks, roundRange } from "../../static/js/plot/ticks.js";
import { pick } from "./catalog.js";

/** An axis of 100 px with values 0 … 1 from the bottom up. */
const AXIS = { _length: 100, l2p: (/** @type {number} */ v) => 100 - 100 * v };

test("a path has a point for each sample and a new piece after each gap", () => {
  assert.equal(curvePath([0, 1, 2], [0, 0.5, 1], AXIS), "M0,100L1,50L2,0");
  assert.equal(curvePath([0, 1, 2, 3, 4], [0, null, 1, 0.5, null], AXIS), "M0,100M2,0L3,50");
  assert.equal(curvePath([0, 1], [null, null], AXIS), "");
  assert.equal(curvePath([0, 1], [Number.NaN, 1], AXIS), "M1,0");
});

test("a curve that Plotly would clip is left to Plotly", () => {
  assert.equal(curvePath([0, 1], [0, 30], AXIS), null);
  assert.equal(curvePath([0, 1], [0, -30], AXIS), null);
});

test("the pixels of an abscissa are worked out once for equal abscissas", () => {
  let asked = 0;
  const pixels = createPixels({
    _length: 1,
    l2p: (v) => {
      asked += 1;
      return v * 2;
    },
  });
  assert.deepEqual(pixels([1, 2]), [2, 4]);
  assert.deepEqual(pixels([1, 2]), [2, 4]);
  assert.equal(asked, 2);
  assert.deepEqual(pixels([1, 3]), [2, 6]);
});

test("CSV keeps every digit, leaves gaps empty and quotes what needs it", () => {
  const x = [0, 0.1, 90];
  const traces = [
    { id: "Rs", label: "R_s", color: "--Rs", x, y: [0.04000000000000001, 1e-17, 1] },
    { id: 'a "b", c', label: "", color: "", x, y: [1, null, 3] },
  ];
  assert.equal(
    toCsv("theta_i_deg", traces),
    'theta_i_deg,Rs,"a ""b"", c"\r\n0,0.04000000000000001,1\r\n0.1,1e-17,\r\n90,1,3\r\n',
  );
});

test("CSV of curves over different abscissas has a row for each of them", () => {
  const traces = [
    { id: "a", label: "", color: "", x: [0, 2], y: [1, 2] },
    { id: "b", label: "", color: "", x: [0, 1], y: [3, 4] },
  ];
  assert.equal(toCsv("x", traces), "x,a,b\r\n0,1,3\r\n1,,4\r\n2,2,\r\n");
});

test("ticks of an angle are 0, 15 … 90 and thin out without losing the ends", () => {
  const axis = { unit: "°" };
  const labels = (/** @type {number} */ length) =>
    axisTicks(axis, [0, 90], length, 40).map((tick) => tick.label);
  assert.deepEqual(labels(480), ["0°", "15°", "30°", "45°", "60°", "75°", "90°"]);
  assert.deepEqual(labels(2000), labels(480));
  assert.deepEqual(labels(150), ["0°", "30°", "60°", "90°"]);
  assert.deepEqual(labels(60), ["0°", "90°"]);
});

test("given ticks are thinned to the room", () => {
  const ticks = { values: [0, 1, 2, 3, 4, 5, 6], text: ["0", "a", "b", "c", "d", "e", "f"] };
  const labels = (/** @type {number} */ length) =>
    axisTicks({ ticks }, [0, 6], length, 40).map((tick) => tick.label);
  assert.deepEqual(labels(300), ["0", "a", "b", "c", "d", "e", "f"]);
  assert.deepEqual(labels(150), ["0", "b", "d", "f"]);
  assert.deepEqual(pick(axisTicks({}, [-1, 1], 200, 40), "label"), ["−1", "−0.5", "0", "0.5", "1"]);
});

test("given ticks of a logarithmic axis are thinned by their ratios", () => {
  const values = [2, 4, 8, 16, 32, 64, 128];
  const ticks = { values, text: values.map(String) };
  const labels = (/** @type {number} */ length) =>
    axisTicks({ ticks, scale: "log" }, [2, 128], length, 40).map((tick) => tick.label);
  assert.deepEqual(labels(300), values.map(String));
  assert.deepEqual(labels(150), ["2", "8", "32", "128"]);
});

test("a range that follows the data is round and holds it", () => {
  assert.deepEqual(roundRange([[0.013, null, 0.87]]), [0, 1]);
  assert.deepEqual(roundRange([[-0.0357, 0.001]]), [-0.04, 0.005]);
  assert.deepEqual(roundRange([[null]]), [0, 1]);
  assert.deepEqual(roundRange([[0, 0]]), [0, 1]);
  const [low, high] = roundRange([[7, 7]]);
  assert.ok(low < 7 && high > 7);
});

test("symbols are told from words", () => {
  assert.deepEqual(
    runs("R_s").map((run) => [run.text, run.italic, run.sub]),
    [
      ["R", true, false],
      ["s", true, true],
    ],
  );
  assert.equal(plainText("angle of incidence θᵢ (degrees)"), "angle of incidence θi (degrees)");
  assert.equal(plotlyText("F<sub>R</sub> < 1"), "<i>F</i><sub><i>R</i></sub> &lt; 1");
  assert.deepEqual(runs("Schlick"), [{ text: "Schlick", italic: false, sub: false }]);
  assert.equal(runs("T")[0]?.italic, true);
  assert.equal(shortTitle("angle of incidence θᵢ (degrees)"), "θᵢ");
  assert.equal(shortTitle("wavelength"), "wavelength");
  assert.equal(unitSuffix("°"), "°");
  assert.equal(unitSuffix(" rad"), " rad");
});

test("dashes are Plotly's", () => {
  assert.equal(dashArray("solid", 2), null);
  assert.equal(dashArray("dash", 2), "9 9");
  assert.equal(dashArray("8px 3px 2px 3px", 2), "8 3 2 3");
});

test("rows of the data table are equally spaced and keep both ends", () => {
  assert.deepEqual(pickedRows(3), [0, 1, 2]);
  const rows = pickedRows(181);
  assert.ok(rows.length <= 41);
  assert.equal(rows[0], 0);
  assert.equal(rows[rows.length - 1], 180);
});

const FRAME = { x: 40, y: 40, width: 480, height: 320 };
const X = Array.from({ length: 181 }, (_, i) => FRAME.x + (FRAME.width * i) / 180);
/** @param {(t: number) => number | null} f of 0 … 1, giving 0 … 1 */
const curve = (/** @type {string} */ id, f, width = 20) => ({
  id,
  width,
  height: 19,
  x: X,
  y: X.map((_, i) => {
    const y = f(i / 180);
    return y === null ? null : FRAME.y + FRAME.height * (1 - y);
  }),
});
/** @param {ReturnType<typeof curve>[]} curves @param {number[]} [uprights] */
function boxes(curves, uprights = []) {
  const placed = placeLabels({ curves, frame: FRAME, uprights });
  return curves.flatMap(({ id, width, height }) => {
    const place = placed.get(id);
    return place ? [{ id, x: place.x - width / 2, y: place.y - height / 2, width, height }] : [];
  });
}
/** @param {ReturnType<typeof curve>} one @param {Box} box */
const through = (one, box) =>
  one.x.some((x, i) => {
    const y = one.y[i];
    return (
      y !== null &&
      y !== undefined &&
      x > box.x &&
      x < box.x + box.width &&
      y > box.y &&
      y < box.y + box.height
    );
  });

const FAMILIES = {
  glass: [
    curve("R", (t) => 0.04 + 0.96 * t ** 6),
    curve("Rs", (t) => 0.04 + 0.96 * t ** 3),
    curve("Rp", (t) => Math.abs(0.04 - 0.05 * t) + 0.95 * t ** 9),
  ],
  total: [
    curve("R", (t) => (t > 0.46 ? 1 : 0.04 + t ** 4)),
    curve("Rs", (t) => (t > 0.46 ? 1 : 0.04 + t ** 3)),
    curve("Rp", (t) => (t > 0.46 ? 1 : 0.03)),
    curve("T", (t) => (t > 0.46 ? 0 : 0.96 - t ** 4)),
  ],
  gap: [curve("a", (t) => (t > 0.3 ? null : 0.5)), curve("b", (t) => (t > 0.3 ? 0.5 : null))],
  flat: [curve("a", () => 0), curve("b", () => 0), curve("c", () => 1, 120)],
};

for (const [name, curves] of Object.entries(FAMILIES)) {
  test(`names of curves stay inside the frame, off each other and off their curve: ${name}`, () => {
    const found = boxes(curves);
    assert.equal(found.length, curves.length);
    found.forEach((box, index) => {
      assert.ok(within(box, FRAME), box.id);
      const own = curves.find(({ id }) => id === box.id);
      assert.ok(own && !through(own, box), box.id);
      for (const other of found.slice(0, index)) assert.ok(!overlap(box, other), box.id);
    });
  });
}

test("names of curves make way for the marker", () => {
  const curves = FAMILIES.glass;
  for (let marker = FRAME.x; marker <= FRAME.x + FRAME.width; marker += 7) {
    for (const box of boxes(curves, [marker])) {
      assert.ok(marker < box.x || marker > box.x + box.width, `${box.id} at ${marker}`);
    }
  }
});

test("no other curve runs through a name where there is room", () => {
  for (const box of boxes(FAMILIES.glass)) {
    for (const other of FAMILIES.glass)
      assert.ok(!through(other, box), `${other.id} through ${box.id}`);
  }
});

test("names of marks stand in two rows and never on each other", () => {
  const widths = [94, 90];
  for (let apart = 0; apart < 200; apart += 5) {
    const marks = widths.map((width, i) => ({ x: FRAME.x + 60 + i * apart, width }));
    const places = placeMarkNames({ marks, frame: FRAME, reserved: 70 });
    const found = places.map((place, i) => {
      assert.ok(place, `no room ${apart}`);
      return {
        x: place.x - (widths[i] ?? 0) / 2,
        y: place.y - 8,
        width: widths[i] ?? 0,
        height: 16,
      };
    });
    const [a, b] = found;
    assert.ok(a && b && !overlap(a, b), `on each other ${apart}`);
  }
});

test("a layout keeps its frame positive from a phone to 4k, and pixels and values agree", () => {
  for (const [width, height] of /** @type {[number, number][]} */ ([
    [280, 260],
    [320, 300],
    [900, 600],
    [2000, 1200],
  ])) {
    const axes = {
      x: { title: "x", range: [0, 90], unit: "°" },
      y: { title: "y", range: [0, 1] },
      y2: null,
    };
    const layout = arrange({
      size: { width, height },
      axes,
      traces: [],
      measure: (l) => 7 * l.length,
      marksRow: true,
    });
    assert.ok(layout.frame.width > width * 0.75 && layout.frame.height > height * 0.5);
    assert.ok(Math.abs(layout.xValue(layout.xPixel(56.31)) - 56.31) < 1e-9);
    // both ends of the range lie just inside the frame, so that a line there keeps its width
    assert.ok(
      layout.yPixel(1) > layout.frame.y && layout.yPixel(0) < layout.frame.y + layout.frame.height,
    );
  }
});
