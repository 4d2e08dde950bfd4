/**
 * What the diagram has to say, where each word could stand and what it must keep clear of. Pure:
 * widths come in as functions, places go out as numbers.
 */

import { boxOf } from "../draw/boxes.js";
import { createMeasure, moveText, put, px, setLabel, show } from "../draw/svg.js";
import { angle, percent, plain } from "../numbers/format.js";
import { arcChords, arrowSize, at, direction } from "./geometry.js";
import { angleCandidates, arrowCandidates, placeAll } from "./labels.js";

/** @typedef {Record<"name" | "index" | "angle" | "share" | "landmark", Measure>} Faces */
/** @typedef {"upperName" | "upperIndex" | "lowerName" | "lowerIndex" | "depth" | "total" | "totalRest"} Fixed */
/** @typedef {{key: Fixed, text: string, x: number, y: number, box: Box}} Line left end, middle height */
/** @typedef {{id: string, text: string, x: number, y: number, box: Box, clear: boolean}} Label centre */

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
 * @param {Faces} face
 * @returns {Line[]}
 */
export function fixedLines({ values, depth }, stage, face) {
  const { width, height, inset, unit } = stage;
  const { n_i, n_t, k_t } = values.interface;
  const room = width / 2 - inset - MARGIN;
  const line = LINE * unit;
  const top = inset + 7 * unit;
  const bottom = height - inset - 6 * unit - (depth === null ? 0 : line);
  const long = depthText(depth);
  const deep = [long, long.replace("penetration ", "")].find((text) => face.index(text) <= room);
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
  /** @type {[Fixed, string, number, number, Measure][]} */
  const lines = [
    ["upperName", shortened(values.labels.incident, face.name, room), inset, top, face.name],
    ["upperIndex", indexText("n_i", n_i, 0), inset, top + line * 1.05, face.index],
    [
      "lowerName",
      shortened(values.labels.transmitted, face.name, room),
      inset,
      bottom - line * 1.05,
      face.name,
    ],
    ["lowerIndex", indexText("n_t", n_t, k_t), inset, bottom, face.index],
    ["depth", deep ?? "", inset, bottom + line, face.index],
    ["total", total ?? "", middle, below, face.share],
    ["totalRest", rest ?? "", middle, below + line, face.share],
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
 * @param {Faces} face
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
 * The name of a landmark: level with its tick, outside the protractor or inside it, a little higher
 * or lower if need be, and not at all where there is no room.
 * @param {{deg: number, label: string}} landmark
 * @param {number} index
 * @param {Stage} stage
 * @param {Faces} face
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
 * @param {Faces} face
 * @param {ReadonlyMap<string, Placed>} [previous]
 * @returns {{lines: Line[], labels: Label[], standing: Map<string, Placed>}}
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
 * @param {Theme} theme
 * @returns {Faces}
 */
function faces({ family, symbolFamily, unit }) {
  /** @param {number} size @param {number} symbolSize @param {number} [weight] */
  const face = (size, symbolSize, weight = 400) =>
    createMeasure({
      family,
      symbolFamily,
      size: size * unit,
      symbolSize: symbolSize * unit,
      weight,
    });
  // the sizes of diagram.css
  return {
    name: face(14, 16, 600),
    index: face(12, 14),
    angle: face(13, 16),
    share: face(13, 15, 600),
    landmark: face(11, 13),
  };
}

/**
 * @param {import("./scene.js").Scene} scene
 */
export function createAnnotations(scene) {
  /** @type {Faces | null} */
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
      widths = faces(theme);
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
        moveText(node, x, y);
      }
      for (const [id, node] of nodes) show(node, standing.has(id));
      for (const { id, text, x, y } of planned.labels) {
        const node = nodes.get(id);
        if (!node) continue;
        setLabel(node, text);
        moveText(node, x, y);
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

/** @param {number | null} depth in vacuum wavelengths */
export function depthText(depth) {
  if (depth === null) return "";
  const size = depth >= 1000 ? "> 1000" : depth < 0.001 ? "< 0.001" : plain(depth, 3);
  return `penetration depth ${size} λ`;
}

/**
 * @param {object} values
 * @param {{n_i: number, n_t: number, k_t: number}} values.interface
 * @param {{incident: string, transmitted: string}} values.labels
 * @param {number} values.theta_i_deg
 * @param {number | null} values.theta_t_deg
 * @param {boolean} values.tir
 * @param {number} values.reflected share
 * @param {number} values.passed share
 * @param {number | null} values.depth
 * @param {string} values.polarization
 * @param {"deg" | "rad"} values.angleUnit
 */
export function description({
  interface: media,
  labels,
  theta_i_deg,
  theta_t_deg,
  tir,
  reflected,
  passed,
  depth,
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
  const deep = depth === null ? "" : `The ${depthText(depth).replace("λ", "vacuum wavelengths")}.`;
  return [first, then, deep].filter(Boolean).join(" ");
}
