/**
 * The diagram's words and their places: near what they name, off rays, arcs and each other, and where
 * they stood before unless that has become worse.
 */

import {
  boxOf,
  createMeasure,
  crosses,
  grown,
  moveText,
  overlap,
  put,
  px,
  reach,
  setLabel,
  show,
  within,
} from "../draw/svg.js";
import { angle, percent, plain } from "../numbers/format.js";
import { arcChords, arrowSize, at, direction, isRight, RIGHT_SIZE, seenAt } from "./scene.js";

const MARGIN = 8;
const HANDLE = 28;
const LINE = 18;
const TICK = 5;

/**
 * @param {Place} a
 * @param {Place} b
 * @returns {Segment}
 */
const segment = (a, b) => ({ x1: a.x, y1: a.y, x2: b.x, y2: b.y });

/**
 * @param {string} text
 * @param {Measure} measure
 * @param {number} room px
 */
export function shortened(text, measure, room) {
  if (measure(text) <= room) return text;
  let kept = text;
  while (kept.length > 3 && measure(`${kept}…`) > room) kept = kept.slice(0, -1).trimEnd();
  return `${kept}…`;
}

/**
 * The lines with a place of their own: the media in their corners, and total internal reflection.
 * @param {Drawn} drawn
 * @param {Stage} stage
 * @param {DiagramFaces} face
 * @returns {FixedLine[]}
 */
export function fixedLines({ values, depth }, stage, face) {
  const { width, height, inset, unit } = stage;
  const { n_i, n_t, k_t } = values.interface;
  const room = width / 2 - inset - MARGIN;
  const line = LINE * unit;
  const top = inset + 7 * unit;
  const bottom = height - inset - 6 * unit - (depth === null ? 0 : line);
  const deep = depthTexts(depth, values.field_penetration_depth_wavelengths).find(
    (text) => face.index(text) <= room,
  );
  const words = "total internal reflection";
  const gap = 14 * unit;
  const fits = face.share(words) <= width / 2 - gap - MARGIN;
  const [total, rest] = !values.tir
    ? ["", ""]
    : fits
      ? [words, ""]
      : ["total internal", "reflection"];
  const middle = stage.x + gap;
  const below = stage.y + 22 * unit;
  // Turned over, lines that stand one below the other change places, so that each is read as before.
  const ups = [top, top + line * 1.05];
  const downs = [bottom - line * 1.05, bottom, ...(depth === null ? [] : [bottom + line])];
  const totals = rest ? [below, below + line] : [below];
  for (const ys of stage.mirror ? [ups, downs, totals] : []) ys.reverse();
  const [upName = top, upIndex = top] = ups;
  const [name = bottom, index = bottom, depths = bottom] = downs;
  const [first = below, second = below] = totals;
  /** @type {[FixedLine["key"], string, number, number, Measure][]} */
  const lines = [
    ["upperName", shortened(values.labels.incident, face.name, room), inset, upName, face.name],
    ["upperIndex", indexText("n_i", n_i, 0), inset, upIndex, face.index],
    ["lowerName", shortened(values.labels.transmitted, face.name, room), inset, name, face.name],
    ["lowerIndex", indexText("n_t", n_t, k_t), inset, index, face.index],
    ["depth", deep ?? "", inset, depths, face.index],
    ["total", total ?? "", middle, first, face.share],
    ["totalRest", rest ?? "", middle, second, face.share],
  ];
  return lines.map(([key, text, x, y, measure]) => ({
    key,
    text,
    x,
    y,
    box: { x, y: y - line / 2, width: text ? measure(text) + 6 : 0, height: text ? line : 0 },
  }));
}

/**
 * Everything that is drawn, as segments and boxes.
 * @param {Drawn} drawn
 * @param {Stage} stage
 * @returns {{segments: Segment[], boxes: Box[]}}
 */
export function obstacles({ values, depth, back, up, down, source, signs }, stage) {
  const { x, y, length, width, height, inset, wavelength, unit } = stage;
  const head = { width: 14 * unit, height: 14 * unit };
  const boxes = [
    boxOf(source, { width: HANDLE * unit, height: HANDLE * unit }),
    boxOf(at(stage, back, length * 0.54), head),
    ...signs,
  ];
  if (depth !== null) {
    const wide = 34 * unit;
    const scale = { x: width - inset - wide, y: height - inset - wavelength };
    boxes.push({ ...scale, width: wide, height: wavelength });
  }
  const segments = [
    segment(source, stage),
    segment(stage, at(stage, up, length)),
    segment({ x, y: stage.normal.top }, { x, y: stage.normal.bottom }),
    segment({ x: 0, y }, { x: width, y }),
    ...arcChords(stage, stage.arc, values.theta_i_deg, "incident"),
    ...values.landmarks.map(({ deg }) => tickAt(stage, deg)),
  ];
  if (down && values.theta_t_deg !== null) {
    segments.push(segment(stage, at(stage, down, length)));
    segments.push(...arcChords(stage, stage.arc, values.theta_t_deg, "refracted"));
  }
  if (down && isRight(values)) {
    const size = stage.arc * RIGHT_SIZE;
    boxes.push(boxOf(at(at(stage, up, size / 2), down, size / 2), { width: size, height: size }));
  }
  return { boxes, segments };
}

/**
 * The tick of a landmark on the protractor.
 * @param {Stage} stage
 * @param {number} degrees
 */
export function tickAt(stage, degrees) {
  const along = direction(degrees, "incident");
  const tick = TICK * stage.unit;
  return segment(at(stage, along, stage.length - tick), at(stage, along, stage.length + tick));
}

/**
 * @param {Drawn} drawn
 * @param {Stage} stage
 * @param {DiagramFaces} face
 * @returns {{text: string, wish: Wish}[]}
 */
function movingLabels({ values, share, rest, up, down }, stage, face) {
  const { unit } = stage;
  const { theta_i_deg, theta_t_deg, angleUnit, landmarks } = values;
  const height = LINE * unit;
  /** @param {string} id @param {number} degrees @param {"incident" | "refracted"} ray */
  const name = (id, degrees, ray) => {
    const text = `${id} ${angle(degrees, angleUnit)}`;
    const size = { width: face.angle(text), height };
    return { text, wish: { id, size, candidates: angleCandidates(stage, degrees, ray, size) } };
  };
  /** @param {string} id @param {number} part @param {Place} along @param {"reflected" | "refracted"} ray */
  const count = (id, part, along, ray) => {
    const text = `${id} ${percent(part)}`;
    const size = { width: face.share(text), height };
    const { length } = arrowSize(part, stage);
    const candidates = arrowCandidates(stage, along, length, size, 9 * unit, ray);
    return { text, wish: { id, size, candidates } };
  };
  return [
    name("θ_i", theta_i_deg, "incident"),
    count("F_R", share, up, "reflected"),
    ...(down && theta_t_deg !== null
      ? [name("θ_t", theta_t_deg, "refracted"), count("F_T", rest, down, "refracted")]
      : []),
    ...landmarks.map((landmark, index) => landmarkName(landmark, index, stage, face)),
  ];
}

/**
 * A landmark's name: level with its tick, a little higher or lower if need be, else left out.
 * @param {Landmark} landmark
 * @param {number} index
 * @param {Stage} stage
 * @param {DiagramFaces} face
 */
function landmarkName({ deg, label }, index, stage, face) {
  const along = direction(deg, "incident");
  const size = { width: face.landmark(label) + 4, height: 14 * stage.unit };
  const candidates = [0, -10, 10, -20, 20].flatMap((shift) =>
    [1, -1].map((outside) => {
      const end = at(stage, along, stage.length + outside * 2 * TICK * stage.unit);
      return {
        slot: `${outside} ${shift}`,
        x: end.x - (outside * size.width) / 2,
        y: end.y + shift * stage.unit,
        cost: Math.abs(shift) / 8 + (outside === 1 ? 0 : 1.5),
      };
    }),
  );
  return { text: label, wish: { id: `landmark ${index}`, size, candidates, optional: true } };
}

/**
 * All words of a drawing with their places.
 * @param {Drawn} drawn
 * @param {Stage} stage
 * @param {DiagramFaces} face
 * @param {ReadonlyMap<string, Placed>} [previous]
 * @returns {{lines: FixedLine[], labels: PlacedText[], standing: Map<string, Placed>}}
 */
export function plan(drawn, stage, face, previous) {
  const lines = fixedLines(drawn, stage, face);
  const { boxes, segments } = obstacles(drawn, stage);
  const moving = movingLabels(drawn, stage, face);
  const standing = placeAll({
    wishes: moving.map(({ wish }) => wish),
    frame: {
      x: MARGIN,
      y: MARGIN,
      width: stage.width - 2 * MARGIN,
      height: stage.height - 2 * MARGIN,
    },
    segments,
    boxes: [...boxes, ...lines.filter(({ text }) => text).map(({ box }) => box)],
    ...(previous && { previous }),
  });
  const labels = moving.flatMap(({ text, wish: { id, size } }) => {
    const found = standing.get(id);
    if (!found) return [];
    const { x, y, clear } = found;
    return [{ id, text, x, y, clear, box: boxOf(found, size) }];
  });
  return { lines, labels, standing };
}

/**
 * @param {import("./scene.js").Scene} scene
 */
export function createAnnotations(scene) {
  /** @type {DiagramFaces | null} */
  let widths = null;
  /** @type {ReadonlyMap<string, Placed>} */
  let standing = new Map();
  /** @type {Map<string, SVGTextElement>} */
  const nodes = new Map([
    ["θ_i", scene.thetaIncident],
    ["F_R", scene.shareReflected],
    ["θ_t", scene.thetaRefracted],
    ["F_T", scene.shareRefracted],
    ...scene.marks.map(
      ({ name }, index) => /** @type {[string, SVGTextElement]} */ ([`landmark ${index}`, name]),
    ),
  ]);

  return {
    /** @param {Theme} theme */
    useFaces(theme) {
      // the sizes of explore.css
      widths = {
        name: createMeasure(theme, 14, 16, 600),
        index: createMeasure(theme, 12, 14),
        angle: createMeasure(theme, 13, 16),
        share: createMeasure(theme, 13, 15, 600),
        landmark: createMeasure(theme, 11, 13),
      };
    },
    /**
     * @param {Drawn} drawn
     * @param {Stage} stage
     */
    write(drawn, stage) {
      if (!widths) return;
      const planned = plan(drawn, stage, widths, standing);
      standing = planned.standing;
      for (const { key, text, x, y } of planned.lines) {
        const node = scene[key];
        show(node, text !== "");
        if (!text) continue;
        setLabel(node, text);
        moveText(node, x, seenAt(stage, y));
      }
      for (const [id, node] of nodes) show(node, standing.has(id));
      for (const { id, text, x, y } of planned.labels) {
        const node = nodes.get(id);
        if (!node) continue;
        setLabel(node, text);
        moveText(node, x, seenAt(stage, y));
      }
      for (const [index, { line }] of scene.marks.entries()) {
        const landmark = drawn.values.landmarks[index];
        show(line, landmark !== undefined);
        if (!landmark) continue;
        for (const [name, value] of Object.entries(tickAt(stage, landmark.deg))) {
          put(line, name, px(value));
        }
      }
    },
  };
}

/**
 * @param {"n_i" | "n_t"} symbol
 * @param {number} n
 * @param {number} k
 */
export function indexText(symbol, n, k) {
  return k > 0 ? `${symbol} = ${plain(n, 5)} + ${plain(k, 5)} i` : `${symbol} = ${plain(n, 5)}`;
}

/** @param {number} depth in vacuum wavelengths */
const deepAs = (depth) =>
  depth >= 1000 ? "> 1000" : depth < 0.001 ? "< 0.001" : `${plain(depth, 3)}`;

/**
 * How deep the power and the field go, in fewer and fewer words.
 * @param {number | null} power depth in vacuum wavelengths
 * @param {number | null} field
 */
export function depthTexts(power, field) {
  if (power === null || field === null) return [];
  const [p, e] = [deepAs(power), deepAs(field)];
  return [
    `penetration depth of power ${p} λ, of field ${e} λ`,
    `depth of power ${p} λ, of field ${e} λ`,
    `power ${p} λ, field ${e} λ deep`,
    `power ${p} λ deep`,
  ];
}

/** @param {DescriptionOptions} values */
export function description({
  interface: media,
  labels,
  theta_i_deg,
  theta_t_deg,
  tir,
  reflected,
  passed,
  depth,
  field_penetration_depth_wavelengths: field,
  polarization,
  angleUnit,
}) {
  const light =
    polarization === "unpolarized" ? "Unpolarized light" : `${polarization}-polarized light`;
  const index = media.k_t > 0 ? `${plain(media.n_t)} + ${plain(media.k_t)} i` : plain(media.n_t);
  const first = `${light} in ${labels.incident} (index ${plain(media.n_i)}) meets ${labels.transmitted} (index ${index}) at ${angle(theta_i_deg, angleUnit)} from the normal.`;
  const then = tir
    ? "All of it is reflected: total internal reflection."
    : `${percent(reflected)} is reflected, ${percent(passed)} is transmitted${
        theta_t_deg === null ? "" : ` at ${angle(theta_t_deg, angleUnit)}`
      }.`;
  const deep =
    depth === null || field === null
      ? ""
      : `The power falls to 1/e in ${deepAs(depth)} vacuum wavelengths, the field in ${deepAs(field)}.`;
  const right = isRight({ theta_i_deg, theta_t_deg, interface: media })
    ? "The reflected and the refracted ray are at right angles."
    : "";
  return [first, then, right, deep].filter(Boolean).join(" ");
}

const GAP = 6;
const BLOCKED = 1000;
const LOYALTY = 1.2;
/** Closer than this to anything is in the way; closer than that is a little worse. */
const CLEAR = 2.5;
const AIRY = 6;
const TIGHT = 0.7;
/** A place that costs less than this is near what it names. */
const GOOD = 1.2;

/**
 * Whether a label lies in the quadrant of what it names.
 * @param {Place} place
 * @param {Size} size
 * @param {Stage} stage
 * @param {"incident" | "reflected" | "refracted"} ray
 */
function inQuadrant(place, size, stage, ray) {
  const right = place.x - stage.x;
  const down = place.y - stage.y;
  return (
    (ray === "incident" ? -right : right) > size.width / 2 &&
    (ray === "refracted" ? down : -down) > size.height / 2
  );
}

/**
 * Places for the name of an angle: outside its arc, inside it, or on the far side of the ray where
 * the angle is too small to hold it.
 * @param {Stage} stage
 * @param {number} degrees
 * @param {"incident" | "refracted"} ray
 * @param {Size} size
 * @returns {Candidate[]}
 */
export function angleCandidates(stage, degrees, ray, size) {
  /** @type {Candidate[]} */
  const out = [];
  const gap = GAP * stage.unit;
  for (const share of [0.5, 0.62, 0.38, 0.74, 0.26]) {
    const along = direction(degrees * share, ray);
    const half = reach(size, along.x, along.y);
    const away = Math.abs(share - 0.5) * 4;
    const outside = at(stage, along, stage.arc + gap + half);
    out.push({ slot: `outside ${share}`, ...outside, cost: away });
    const inside = at(stage, along, stage.arc - gap - half);
    out.push({ slot: `inside ${share}`, ...inside, cost: 1 + away });
    const far = at(stage, along, stage.arc + 2.2 * gap + 2 * half);
    out.push({ slot: `far ${share}`, ...far, cost: 2.2 + away });
  }
  const along = direction(degrees, ray);
  // away from the normal, at right angles to the ray
  const beside = { x: along.y, y: -along.x };
  for (const share of [1, 0.85, 0.7, 0.5, 1.15, 1.35, 1.7, 2.1]) {
    const distance = stage.arc * share;
    const slot = `beside ${share}`;
    const point = at(at(stage, along, distance), beside, gap + reach(size, beside.x, beside.y));
    out.push({ slot, ...point, cost: 1.8 + Math.abs(distance - stage.arc) / 40 });
  }
  return out.filter((place) => inQuadrant(place, size, stage, ray));
}

/**
 * Places for the name of an arrow: to either side of its direction, from the tip on.
 * @param {Stage} stage
 * @param {Place} along unit vector of the arrow
 * @param {number} length px of the arrow
 * @param {Size} size
 * @param {number} clearance px from the arrow's middle line
 * @param {"reflected" | "refracted"} ray
 * @returns {Candidate[]}
 */
export function arrowCandidates(stage, along, length, size, clearance, ray) {
  /** @type {Candidate[]} */
  const out = [];
  for (const [side, sign] of /** @type {["right" | "left", number][]} */ ([
    ["right", 1],
    ["left", -1],
  ])) {
    // "right" is away from the normal for both arrows, which leave to the right
    const away = ray === "reflected" ? sign : -sign;
    const beside = { x: -along.y * away, y: along.x * away };
    for (const lift of [0, 8, 18]) {
      const offset = clearance + lift * stage.unit + reach(size, beside.x, beside.y);
      for (let step = 0; step <= 16; step += 1) {
        const distance = (stage.length * step) / 14;
        const point = at(at(stage, along, distance), beside, offset);
        const far = Math.abs(distance - length) / (28 * stage.unit);
        const cost = far + lift / 12 + (side === "right" ? 0 : 0.8);
        out.push({ slot: `${side} ${step} ${lift}`, ...point, cost });
      }
    }
  }
  // straight ahead of the tip
  const ahead = at(stage, along, length + GAP * stage.unit + reach(size, along.x, along.y));
  out.push({ slot: "ahead", ...ahead, cost: 1.5 });
  return out.filter((place) => inQuadrant(place, size, stage, ray));
}

/**
 * Choose a place for each label, in the order given; where that leaves one in the way of another,
 * in the opposite order.
 * @param {PlaceAllOptions} task
 * @returns {Map<string, Placed>}
 */
export function placeAll({ wishes, frame, segments, boxes, previous = new Map() }) {
  const needed = wishes.filter((wish) => !wish.optional);
  const optional = wishes.filter((wish) => wish.optional);
  /** @param {readonly Wish[]} order */
  const inOrder = (order) => {
    const taken = [...boxes];
    /** @type {Map<string, Placed>} */
    const placed = new Map();
    let blocked = 0;
    for (const wish of order) {
      const found = placeOne(wish, { frame, segments, taken, before: previous.get(wish.id)?.slot });
      if (!found || (wish.optional && !found.clear)) continue;
      if (!found.clear) blocked += 1;
      taken.push(boxOf(found, wish.size));
      placed.set(wish.id, found);
    }
    return { placed, blocked };
  };
  const first = inOrder([...needed, ...optional]);
  if (first.blocked === 0) return first.placed;
  const second = inOrder([...needed.reverse(), ...optional]);
  return second.blocked < first.blocked ? second.placed : first.placed;
}

/**
 * @param {Wish} wish
 * @param {{frame: Box, segments: readonly Segment[], taken: readonly Box[], before: string | undefined}} place
 * @returns {Placed | null}
 */
function placeOne({ id, size, candidates }, { frame, segments, taken, before }) {
  // Where it stood, if that is good and airy: then nothing else is tried.
  const stood = candidates.find(({ slot }) => slot === before);
  if (stood && stood.cost < GOOD) {
    const box = boxOf(stood, size);
    const airy = grown(box, AIRY);
    const free =
      within(box, frame) &&
      !taken.some((other) => overlap(airy, other)) &&
      !segments.some((segment) => crosses(segment, airy));
    if (free) return { id, slot: stood.slot, x: stood.x, y: stood.y, clear: true };
  }
  /** @type {Candidate | null} */
  let best = null;
  let lowest = Number.POSITIVE_INFINITY;
  for (const candidate of candidates) {
    let cost = candidate.cost - (candidate.slot === before ? LOYALTY : 0);
    if (cost >= lowest) continue;
    const box = boxOf(candidate, size);
    if (!within(box, frame)) continue;
    const near = grown(box, CLEAR);
    const airy = grown(box, AIRY);
    for (const other of taken) {
      if (overlap(airy, other)) cost += overlap(near, other) ? BLOCKED : TIGHT;
    }
    if (cost >= lowest) continue;
    for (const segment of segments) {
      if (crosses(segment, airy)) cost += crosses(segment, near) ? BLOCKED : TIGHT;
    }
    if (cost >= lowest) continue;
    lowest = cost;
    best = candidate;
  }
  if (!best) return null;
  return { id, slot: best.slot, x: best.x, y: best.y, clear: lowest < BLOCKED / 2 };
}
