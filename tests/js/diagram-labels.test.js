import assert from "node:assert/strict";
import { test } from "node:test";
import {
  arrowSize,
  at,
  direction,
  isRight,
  rightAnglePath,
  seenAt,
  signPlaces,
  stageOf,
} from "../../static/js/diagram/scene.js";
import { description, obstacles, plan, shortened } from "../../static/js/diagram/words.js";
import { boxOf, crosses, overlap, within } from "../../static/js/draw/svg.js";

/** Widths of a typical sans: what matters is that labels are about as wide as on the page. */
const perGlyph = (/** @type {number} */ px) => (/** @type {string} */ label) =>
  label.replace(/[_{}]/gu, "").length * px;
const FACES = {
  name: perGlyph(7.8),
  index: perGlyph(6.4),
  angle: perGlyph(7),
  share: perGlyph(7.3),
  landmark: perGlyph(5.6),
};

/**
 * A drawing; the angle below the surface and the shares are chosen freely, as the layout has to
 * cope with any.
 * @param {{theta_i: number, theta_t: number | null, share: number, size: [number, number], k?: number, unit?: "deg" | "rad"}} made
 */
function drawing({ theta_i, theta_t, share, size, k = 0, unit = "deg" }) {
  const stage = stageOf(...size);
  const tir = theta_t === null;
  const rest = tir ? 0 : 1 - share;
  const back = direction(theta_i, "incident");
  const up = direction(theta_i, "reflected");
  const down = theta_t === null ? null : direction(theta_t, "refracted");
  /** @type {{along: Place, part: number | null}[]} */
  const rays = [
    { along: back, part: null },
    { along: up, part: share },
    ...(down && k === 0 ? [{ along: down, part: rest }] : []),
  ];
  const signs = rays.flatMap(({ along, part }) => {
    const arrow = part === null ? null : arrowSize(part, stage);
    const head = arrow && { from: arrow.length - arrow.head, to: arrow.length };
    const { s, p } = signPlaces(stage, head, true);
    const side = 24 * Math.sqrt(part ?? 1);
    return [s, p].map((place) => boxOf(at(stage, along, place), { width: side, height: side }));
  });
  const drawn = {
    values: {
      interface: { n_i: 1, n_t: 1.5, k_t: k },
      theta_i_deg: theta_i,
      theta_t_deg: theta_t,
      R: share,
      Rs: share,
      Rp: share,
      T: rest,
      tir,
      penetration_depth_wavelengths: 0.2,
      field_penetration_depth_wavelengths: 0.4,
      polarization: /** @type {const} */ ("unpolarized"),
      labels: { incident: "Air", transmitted: "Glass" },
      angleUnit: unit,
      landmarks: [{ deg: 56.31, label: "Brewster" }],
    },
    share,
    rest,
    depth: tir || k > 0 ? 0.2 : null,
    back,
    up,
    down,
    source: at(stage, back, stage.length),
    signs,
  };
  return { stage, drawn };
}

const SIZES = /** @type {[number, number][]} */ ([
  [288, 300],
  [358, 330],
  [440, 520],
  [480, 480],
  [900, 700],
]);
const ANGLES = [0, 0.5, 3, 10, 20, 30, 41.81, 45, 56.31, 60, 70, 80, 85, 89.9, 90];

test("no label covers a ray, an arc, another label or the frame's edge", () => {
  /** @type {object[]} */
  const bad = [];
  for (const size of SIZES) {
    for (const theta_i of ANGLES) {
      for (const theta_t of [null, 0, 5, 20, 36.81, 60, 75, 85, 89.9, 90]) {
        for (const share of [0, 0.04, 0.113, 0.4, 0.7, 0.95, 1]) {
          if (theta_t === null && share < 1) continue;
          if (theta_i === 0 && theta_t !== 0 && theta_t !== null) continue;
          for (const k of theta_t === null ? [0] : [0, 2.9]) {
            const { stage, drawn } = drawing({ theta_i, theta_t, share, size, k });
            const { labels, lines } = plan(drawn, stage, FACES);
            const { segments, boxes } = obstacles(drawn, stage);
            const fixed = [...boxes, ...lines.filter((l) => l.text).map((l) => l.box)];
            labels.forEach((label, index) => {
              const hit =
                segments.some((segment) => crosses(segment, label.box)) ||
                fixed.some((box) => overlap(box, label.box)) ||
                labels.some((other, n) => n < index && overlap(other.box, label.box)) ||
                !within(label.box, { x: 0, y: 0, width: stage.width, height: stage.height });
              if (hit) bad.push({ size: size.join("x"), theta_i, theta_t, share, k, id: label.id });
            });
          }
        }
      }
    }
  }
  assert.deepEqual(bad.slice(0, 12), [], `${bad.length} labels are in the way`);
});

test("the depth is said to be that of the power, beside that of the field", () => {
  const depthIn = (/** @type {[number, number]} */ size) => {
    const { stage, drawn } = drawing({ theta_i: 45, theta_t: null, share: 1, size });
    return plan(drawn, stage, FACES).lines.find(({ key }) => key === "depth")?.text;
  };
  assert.equal(depthIn([900, 700]), "penetration depth of power 0.2 λ, of field 0.4 λ");
  assert.equal(depthIn([440, 520]), "power 0.2 λ, field 0.4 λ deep");
  assert.equal(depthIn([288, 300]), "power 0.2 λ deep");
  const { drawn } = drawing({ theta_i: 45, theta_t: null, share: 1, size: [440, 440] });
  const said = description({ ...drawn.values, reflected: 1, passed: 0, depth: 0.2 });
  assert.match(said, /The power falls to 1\/e in 0.2 vacuum wavelengths, the field in 0.4\.$/);
});

test("every angle and share is named, and stands in its own quadrant", () => {
  for (const theta_i of ANGLES) {
    const { stage, drawn } = drawing({
      theta_i,
      theta_t: theta_i / 2,
      share: 0.3,
      size: [440, 440],
    });
    const { labels } = plan(drawn, stage, FACES);
    const found = new Map(labels.map((label) => [label.id, label]));
    for (const [id, right, below] of /** @type {[string, boolean, boolean][]} */ ([
      ["θ_i", false, false],
      ["F_R", true, false],
      ["θ_t", true, true],
      ["F_T", true, true],
    ])) {
      const label = found.get(id);
      assert.ok(label, `${id} at ${theta_i}`);
      assert.equal(label.x > stage.x, right, `${id} at ${theta_i}`);
      assert.equal(label.y > stage.y, below, `${id} at ${theta_i}`);
    }
  }
});

test("a small turn of the ray does not make a label jump", () => {
  const { stage, drawn } = drawing({ theta_i: 50, theta_t: 30.7, share: 0.06, size: [440, 440] });
  let { labels, standing } = plan(drawn, stage, FACES);
  for (let theta = 50.1; theta < 52; theta += 0.1) {
    const next = drawing({ theta_i: theta, theta_t: 30.7, share: 0.06, size: [440, 440] });
    const planned = plan(next.drawn, stage, FACES, standing);
    for (const label of planned.labels) {
      const before = labels.find(({ id }) => id === label.id);
      if (!before || label.id.startsWith("landmark")) continue;
      const moved = Math.hypot(label.x - before.x, label.y - before.y);
      assert.ok(moved < 6, `${label.id} moved ${moved.toFixed(1)} px at ${theta.toFixed(1)}`);
    }
    ({ labels, standing } = planned);
  }
});

test("a name too long for its corner is cut with an ellipsis", () => {
  assert.equal(shortened("Air", FACES.name, 100), "Air");
  const cut = shortened("Titanium dioxide, rutile, ordinary ray", FACES.name, 100);
  assert.ok(cut.endsWith("…") && FACES.name(cut) <= 100, cut);
});

test("seen from below, each line of words is still read from the top down", () => {
  const { drawn, stage } = drawing({ theta_i: 60, theta_t: null, share: 1, size: [520, 420] });
  const below = { ...stage, mirror: true };
  const { lines } = plan(drawn, below, FACES);
  const seen = new Map(
    lines.map(({ key, y, text }) => [key, text ? seenAt(below, y) : Number.NaN]),
  );
  const y = (/** @type {any} */ key) => seen.get(key) ?? Number.NaN;
  // The light comes from below: its medium is the lower one.
  assert.ok(y("upperName") > stage.y && y("lowerName") < stage.y);
  assert.ok(y("upperName") < y("upperIndex"));
  assert.ok(y("lowerName") < y("lowerIndex") && y("lowerIndex") < y("depth"));
  assert.ok(y("total") < stage.y);
});

test("the right angle between the rays is marked at Brewster's angle and nowhere else", () => {
  const brewster = (Math.atan(1.5) * 180) / Math.PI;
  const at_brewster = { theta_i_deg: brewster, theta_t_deg: 90 - brewster };
  assert.ok(isRight({ ...at_brewster, interface: { k_t: 0 } }));
  assert.ok(!isRight({ ...at_brewster, interface: { k_t: 0.1 } }));
  assert.ok(!isRight({ theta_i_deg: 56, theta_t_deg: 33.55, interface: { k_t: 0 } }));
  assert.ok(!isRight({ theta_i_deg: 60, theta_t_deg: null, interface: { k_t: 0 } }));
  const stage = stageOf(400, 400);
  const [up, down] = [direction(brewster, "reflected"), direction(90 - brewster, "refracted")];
  const corners = [...rightAnglePath(stage, up, down).matchAll(/[ML](-?[\d.]+),(-?[\d.]+)/gu)].map(
    ([, x, y]) => [Number(x) - stage.x, Number(y) - stage.y],
  );
  assert.equal(corners.length, 3);
  const [[ax = 0, ay = 0], , [cx = 0, cy = 0]] = /** @type {[number[], number[], number[]]} */ (
    corners
  );
  assert.ok(Math.abs(ax * cx + ay * cy) < 0.5); // its sides lie along the rays
});
