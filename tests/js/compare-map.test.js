import assert from "node:assert/strict";
import { test } from "node:test";
import { contour, roundUp, scaleOf, stops } from "../../static/js/plot/cells.js";
import { nearest } from "../../static/js/plot/heatmap.js";
import { gridCsv } from "../../static/js/plot/table.js";

test("the scale is round, symmetric where signs matter, and not ruled by one corner", () => {
  assert.deepEqual(scaleOf([[0.1, -0.18]], "signed"), {
    kind: "signed",
    low: -0.2,
    high: 0.2,
    capped: false,
  });
  const flat = Array.from({ length: 100 }, (_, i) => (i === 0 ? 50 : 0.02));
  const scale = scaleOf([flat], "size");
  assert.equal(scale.high, 0.02);
  assert.ok(scale.capped);
  assert.equal(scaleOf([[null, null]], "size").low, 0);
  assert.equal(roundUp(0.011), 0.015);
  assert.equal(roundUp(0), 1e-6);
});

test("the middle of a signed scale is the paper", () => {
  const colors = stops("signed", (name) => name);
  assert.deepEqual(colors[3], [0.5, "--map-0"]);
  assert.deepEqual(colors[0], [0, "--map-n3"]);
  assert.deepEqual(stops("size", (name) => name)[0], [0, "--map-0"]);
});

test("a contour of a plane is its straight line, and gaps have none", () => {
  const x = [0, 1, 2, 3];
  const y = [0, 1, 2];
  const z = y.map(() => x.map((value) => value));
  const segments = contour(x, y, z, 1.25);
  assert.equal(segments.length, 2);
  assert.ok(segments.flat().every(([at]) => Math.abs(at - 1.25) < 1e-12));
  assert.deepEqual(contour(x, y, [[0, 1, 2, 3], x.map(() => null), [0, 1, 2, 3]], 1.25), []);
  // a saddle has two
  assert.equal(
    contour(
      [0, 1],
      [0, 1],
      [
        [1, 0],
        [0, 1],
      ],
      0.5,
    ).length,
    2,
  );
});

test("the nearest cell, also beyond the ends", () => {
  assert.equal(nearest([0, 0.5, 1], 0.6), 1);
  assert.equal(nearest([0, 0.5, 1], 9), 2);
  assert.equal(nearest([0, 0.5, 1], -9), 0);
});

test("a map's file has a line for each cell, with headings and gaps", () => {
  const csv = gridCsv(
    { x: [0, 90], y: [1.5], z: [[0.1, null]] },
    { title: "angle", column: "theta_i_deg" },
    { title: "n_t" },
    "error, signed",
  );
  assert.equal(csv, 'theta_i_deg,nt,"error, signed"\r\n0,1.5,0.1\r\n90,1.5,\r\n');
});
