/**
 * The ray at the surface, to scale: arrows as long as the light they carry, angles as they are,
 * media tinted by their index, the light below the surface fading with its true depth.
 *
 * It shows what it is given and reports what the pointer asks for; it computes no optics.
 */

import { listenForDrags } from "./diagram/drag.js";
import { arcChords, arcPath, arrowSize, at, direction, stageOf, tint } from "./diagram/geometry.js";
import { angleCandidates, arrowCandidates, boxOf, placeAll } from "./diagram/labels.js";
import { setArrow, setDecay, setIncident, setLine, setSigns } from "./diagram/paint.js";
import { createScene } from "./diagram/scene.js";
import { depthText, description, indexText } from "./diagram/words.js";
import { createMeasure } from "./draw/measure.js";
import { put, px, show } from "./draw/svg.js";
import { setLabel } from "./draw/symbols.js";
import { angle, percent } from "./format.js";
import { readTheme } from "./plot/theme.js";

/** @typedef {import("./diagram/labels.js").Wish} Wish */
/** @typedef {import("./diagram/labels.js").Placed} Placed */
/** @typedef {import("./draw/boxes.js").Box} Box */
/** @typedef {import("./draw/boxes.js").Segment} Segment */
/** @typedef {import("./diagram/geometry.js").Point} Point */

/**
 * @typedef {object} DiagramValues
 * @property {{n_i: number, n_t: number, k_t: number}} interface
 * @property {number} theta_i_deg
 * @property {number | null} theta_t_deg
 * @property {number} R
 * @property {number} Rs
 * @property {number} Rp
 * @property {number} T
 * @property {number} [Ts]
 * @property {number} [Tp]
 * @property {boolean} tir
 * @property {number | null} penetration_depth_wavelengths
 * @property {"s" | "p" | "unpolarized"} polarization
 * @property {{incident: string, transmitted: string}} labels
 * @property {"deg" | "rad"} angleUnit
 * @property {readonly {deg: number, label: string}[]} landmarks
 */

/** @typedef {import("./diagram/drag.js").DragActions} DiagramActions */

const MARGIN = 8;
const INSET = 16;
const HANDLE = 13;

/**
 * @param {Point} a
 * @param {Point} b
 * @returns {Segment}
 */
const segment = (a, b) => ({ x1: a.x, y1: a.y, x2: b.x, y2: b.y });

/**
 * @param {HTMLElement} element
 * @param {DiagramActions} actions
 */
export function createDiagram(element, actions) {
  element.classList.add("diagram");
  element.setAttribute("role", "figure");
  element.setAttribute("aria-label", "Ray at the surface");
  const scene = createScene();
  const handle = document.createElement("div");
  handle.className = "diagram-handle";
  handle.tabIndex = 0;
  handle.setAttribute("role", "slider");
  handle.setAttribute("aria-label", "Incident ray, angle of incidence");
  handle.setAttribute("aria-valuemin", "0");
  handle.setAttribute("aria-valuemax", "90");
  const said = document.createElement("p");
  said.className = "diagram-said";
  element.append(scene.root, handle, said);

  let stage = stageOf(480, 480);
  /** @type {DiagramValues | null} */
  let values = null;
  /** @type {ReadonlyMap<string, Placed>} */
  let standing = new Map();

  const faces = () => {
    const { family, symbolFamily } = readTheme(element);
    return {
      label: createMeasure({ family, symbolFamily, size: 13, weight: 600, symbolSize: 16 }),
      angle: createMeasure({ family, symbolFamily, size: 13, symbolSize: 16 }),
      small: createMeasure({ family, symbolFamily, size: 12, symbolSize: 15 }),
      name: createMeasure({ family, symbolFamily, size: 14, weight: 600 }),
      tiny: createMeasure({ family, symbolFamily, size: 11 }),
    };
  };
  let widths = faces();

  /** What depends on the size alone. */
  const layStage = () => {
    const { width, height, x, y, length } = stage;
    const { root, upper, lower, dark, light, normal, surface, protractor } = scene;
    put(root, "viewBox", `0 0 ${width} ${height}`);
    put(upper, "width", width);
    put(upper, "height", y);
    for (const rect of [lower, dark, light]) {
      put(rect, "y", y);
      put(rect, "width", width);
      put(rect, "height", height - y);
    }
    setLine(
      normal,
      { x, y: Math.max(INSET, y - length * 1.12) },
      { x, y: Math.min(height - INSET, y + length * 1.12) },
    );
    setLine(surface, { x: 0, y }, { x: width, y });
    put(protractor, "d", arcPath(stage, length, 90, "incident"));
    const bottom = height - INSET;
    const right = width - INSET;
    const top = bottom - stage.wavelength;
    put(
      scene.scaleBar,
      "d",
      `M${right - 6},${top}H${right}M${right - 3},${top}V${bottom}M${right - 6},${bottom}H${right}`,
    );
    put(scene.scaleText, "x", right - 12);
    put(scene.scaleText, "y", (top + bottom) / 2);
    setLabel(scene.scaleText, "1 λ");
  };

  /**
   * The names of the media in their corners.
   * @param {DiagramValues} now
   * @param {number | null} depth
   * @returns {Box[]} what they cover
   */
  const writeMedia = (now, depth) => {
    const { n_i, n_t, k_t } = now.interface;
    const lines = [
      { node: scene.upperName, text: now.labels.incident, y: 27, width: widths.name },
      { node: scene.upperIndex, text: indexText("n_i", n_i, 0), y: 46, width: widths.small },
      {
        node: scene.lowerName,
        text: now.labels.transmitted,
        y: stage.height - (depth === null ? 44 : 61),
        width: widths.name,
      },
      {
        node: scene.lowerIndex,
        text: indexText("n_t", n_t, k_t),
        y: stage.height - (depth === null ? 25 : 42),
        width: widths.small,
      },
      { node: scene.depth, text: depthText(depth), y: stage.height - 23, width: widths.small },
    ];
    return lines
      .filter(({ text, node }) => {
        show(node, text !== "");
        return text !== "";
      })
      .map(({ node, text, y, width }) => {
        put(node, "x", INSET);
        put(node, "y", y);
        setLabel(node, text);
        return { x: INSET, y: y - 10, width: width(text), height: 20 };
      });
  };

  /** @param {boolean} tir @returns {Box[]} */
  const writeTotal = (tir) => {
    const { total, totalRest } = scene;
    show(total, tir);
    show(totalRest, false);
    if (!tir) return [];
    const words = "total internal reflection";
    const room = stage.width / 2 - INSET - 14;
    const fits = widths.label(words) <= room;
    const lines = fits ? [words] : ["total internal", "reflection"];
    const x = stage.x + 14;
    const y = stage.y + 26;
    setLabel(total, lines[0] ?? "");
    put(total, "x", x);
    put(total, "y", y);
    const rest = lines[1];
    show(totalRest, rest !== undefined);
    if (rest !== undefined) {
      setLabel(totalRest, rest);
      put(totalRest, "x", x);
      put(totalRest, "y", y + 18);
    }
    return lines.map((line, row) => ({
      x,
      y: y - 10 + 18 * row,
      width: widths.label(line),
      height: 20,
    }));
  };

  /**
   * @param {DiagramValues["landmarks"]} landmarks
   * @returns {Wish[]}
   */
  const markLandmarks = (landmarks) =>
    scene.marks.flatMap(({ line, name }, index) => {
      const landmark = landmarks[index];
      show(line, Boolean(landmark));
      show(name, false);
      if (!landmark) return [];
      const along = direction(landmark.deg, "incident");
      setLine(line, at(stage, along, stage.length - 5), at(stage, along, stage.length + 5));
      setLabel(name, landmark.label);
      const size = { width: widths.tiny(landmark.label), height: 14 };
      // level with its tick, outside the protractor or inside it; a little higher or lower if need be
      const candidates = [0, -12, 12, -24, 24].flatMap((shift) =>
        [1, -1].map((outside) => {
          const tick = at(stage, along, stage.length + outside * 9);
          return {
            slot: `${outside} ${shift}`,
            x: tick.x - (outside * size.width) / 2,
            y: tick.y + shift,
            cost: Math.abs(shift) / 8 + (outside === 1 ? 0 : 1.5),
          };
        }),
      );
      return [{ id: `landmark ${index}`, size, candidates, optional: true }];
    });

  const render = () => {
    if (!values) return;
    const now = values;
    const { theta_i_deg, theta_t_deg, tir, polarization, angleUnit } = now;
    const [reflected, passed] = {
      s: [now.Rs, now.Ts ?? 1 - now.Rs],
      p: [now.Rp, now.Tp ?? 1 - now.Rp],
      unpolarized: [now.R, now.T],
    }[polarization];
    const share = reflected ?? 0;
    const rest = tir ? 0 : (passed ?? 0);
    const absorbing = now.interface.k_t > 0;
    const depth = tir || absorbing ? now.penetration_depth_wavelengths : null;
    element.toggleAttribute("data-absorbing", absorbing);
    element.style.setProperty("--tint-upper", `${(tint(now.interface.n_i) * 100).toFixed(1)}%`);
    element.style.setProperty("--tint-lower", `${(tint(now.interface.n_t) * 100).toFixed(1)}%`);
    setDecay(scene.dark, scene.darkness, stage, absorbing ? depth : null);
    setDecay(scene.light, scene.glow, stage, tir ? depth : null);
    show(scene.scaleBar, depth !== null);
    show(scene.scaleText, depth !== null);

    const back = direction(theta_i_deg, "incident");
    const up = direction(theta_i_deg, "reflected");
    const down = tir || theta_t_deg === null ? null : direction(theta_t_deg, "refracted");
    const source = at(stage, back, stage.length);
    setIncident(scene.incident, stage, back);
    setLine(scene.grip, source, stage);
    setLine(scene.pathReflected, stage, at(stage, up, stage.length));
    setArrow(scene.reflected, stage, up, share);
    show(scene.pathRefracted, down !== null);
    show(scene.arcRefracted, down !== null);
    show(scene.refracted.group, false);
    if (down && theta_t_deg !== null) {
      setLine(scene.pathRefracted, stage, at(stage, down, stage.length));
      setArrow(scene.refracted, stage, down, rest);
      put(scene.arcRefracted, "d", arcPath(stage, stage.arc, theta_t_deg, "refracted"));
    }
    put(scene.arcIncident, "d", arcPath(stage, stage.arc, theta_i_deg, "incident"));
    const both = polarization === "unpolarized";
    const is = { s: both || polarization === "s" ? 1 : 0, p: both || polarization === "p" ? 1 : 0 };
    setSigns(scene.signs.incident, stage, back, is, both);
    setSigns(scene.signs.reflected, stage, up, { s: is.s * now.Rs, p: is.p * now.Rp }, both);
    show(scene.signs.refracted.group, down !== null);
    if (down) {
      const shares = { s: is.s * (now.Ts ?? 1 - now.Rs), p: is.p * (now.Tp ?? 1 - now.Rp) };
      setSigns(scene.signs.refracted, stage, down, shares, both);
    }

    place({ now, share, rest, depth, back, up, down, source });

    handle.style.transform = `translate(${px(source.x)}px,${px(source.y)}px)`;
    handle.setAttribute("aria-valuenow", String(Number(theta_i_deg.toFixed(4))));
    handle.setAttribute("aria-valuetext", angle(theta_i_deg, angleUnit));
    said.textContent = description({
      ...now,
      reflected: share,
      passed: rest,
      depth,
    });
  };

  /**
   * @param {{now: DiagramValues, share: number, rest: number, depth: number | null, back: Point, up: Point, down: Point | null, source: Point}} drawn
   */
  const place = ({ now, share, rest, depth, back, up, down, source }) => {
    const { theta_i_deg, theta_t_deg, tir, angleUnit } = now;
    const { x, y, length, width, height } = stage;
    const boxes = [
      ...writeMedia(now, depth),
      ...writeTotal(tir),
      boxOf(source, { width: 2 * HANDLE, height: 2 * HANDLE }),
    ];
    if (depth !== null) {
      boxes.push({
        x: width - INSET - 32,
        y: height - INSET - stage.wavelength,
        width: 32,
        height: stage.wavelength,
      });
    }
    const segments = [
      segment(source, stage),
      segment(stage, at(stage, up, length)),
      segment({ x, y: y - length * 1.12 }, { x, y: y + length * 1.12 }),
      segment({ x: 0, y }, { x: width, y }),
      ...arcChords(stage, stage.arc, theta_i_deg, "incident"),
    ];
    if (down && theta_t_deg !== null) {
      segments.push(segment(stage, at(stage, down, length)));
      segments.push(...arcChords(stage, stage.arc, theta_t_deg, "refracted"));
    }
    // the signs of polarization reach out to both sides of their rays
    const signs = [back, up, ...(down ? [down] : [])];
    for (const along of signs) {
      for (const distance of [0.68, 0.75, 0.82]) {
        boxes.push(boxOf(at(stage, along, length * distance), { width: 18, height: 18 }));
      }
    }
    boxes.push(boxOf(at(stage, back, length * 0.54), { width: 14, height: 14 }));

    /** @type {{wish: Wish, node: SVGTextElement, text: string}[]} */
    const labels = [];
    const thetaText = `θ_i ${angle(theta_i_deg, angleUnit)}`;
    const thetaSize = { width: widths.angle(thetaText), height: 18 };
    labels.push({
      node: scene.thetaIncident,
      text: thetaText,
      wish: {
        id: "theta_i",
        size: thetaSize,
        candidates: angleCandidates(stage, theta_i_deg, "incident", thetaSize),
      },
    });
    const shareText = `F_R ${percent(share)}`;
    const shareSize = { width: widths.label(shareText), height: 18 };
    const arrow = arrowSize(share, length);
    labels.push({
      node: scene.shareReflected,
      text: shareText,
      wish: {
        id: "F_R",
        size: shareSize,
        candidates: arrowCandidates(stage, up, arrow.length, shareSize, 10),
      },
    });
    if (down && theta_t_deg !== null) {
      const text = `θ_t ${angle(theta_t_deg, angleUnit)}`;
      const size = { width: widths.angle(text), height: 18 };
      labels.push({
        node: scene.thetaRefracted,
        text,
        wish: {
          id: "theta_t",
          size,
          candidates: angleCandidates(stage, theta_t_deg, "refracted", size),
        },
      });
      const passedText = `F_T ${percent(rest)}`;
      const passedSize = { width: widths.label(passedText), height: 18 };
      labels.push({
        node: scene.shareRefracted,
        text: passedText,
        wish: {
          id: "F_T",
          size: passedSize,
          candidates: arrowCandidates(stage, down, arrowSize(rest, length).length, passedSize, 10),
        },
      });
    }
    show(scene.thetaRefracted, down !== null);
    show(scene.shareRefracted, down !== null);
    const landmarkWishes = markLandmarks(now.landmarks);
    standing = placeAll({
      wishes: [...labels.map(({ wish }) => wish), ...landmarkWishes],
      frame: { x: MARGIN, y: MARGIN, width: width - 2 * MARGIN, height: height - 2 * MARGIN },
      segments,
      boxes,
      previous: standing,
    });
    for (const { wish, node, text } of labels) {
      const found = standing.get(wish.id);
      show(node, Boolean(found));
      if (!found) continue;
      setLabel(node, text);
      put(node, "x", px(found.x));
      put(node, "y", px(found.y));
    }
    landmarkWishes.forEach(({ id }, index) => {
      const found = standing.get(id);
      const name = scene.marks[index]?.name;
      if (!name) return;
      show(name, Boolean(found));
      if (!found) return;
      put(name, "x", px(found.x));
      put(name, "y", px(found.y));
    });
  };

  const measure = () => {
    const { clientWidth, clientHeight } = element;
    if (clientWidth < 40 || clientHeight < 40) return;
    stage = stageOf(clientWidth, clientHeight);
    layStage();
    render();
  };
  const observer = new ResizeObserver(measure);
  observer.observe(element);
  layStage();
  void document.fonts?.ready.then(() => {
    widths = faces();
    render();
  });

  const stopDragging = listenForDrags({
    host: element,
    handle,
    grip: scene.grip,
    stage: () => stage,
    theta: () => values?.theta_i_deg ?? 0,
    actions,
  });

  return {
    /** @param {DiagramValues} next */
    update(next) {
      values = next;
      render();
    },
    destroy() {
      observer.disconnect();
      stopDragging();
      element.replaceChildren();
    },
  };
}
