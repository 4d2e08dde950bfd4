/** Writing the diagram's words where the plan puts them. */

import { createMeasure } from "../draw/measure.js";
import { moveText, put, px, show } from "../draw/svg.js";
import { setLabel } from "../draw/symbols.js";
import { plan, tickAt } from "./plan.js";

/**
 * @param {import("../plot/theme.js").Theme} theme
 * @returns {import("./plan.js").Faces}
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
  /** @type {import("./plan.js").Faces | null} */
  let widths = null;
  /** @type {ReadonlyMap<string, import("./labels.js").Placed>} */
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
    /** @param {import("../plot/theme.js").Theme} theme */
    useFaces(theme) {
      widths = faces(theme);
    },
    /**
     * @param {import("./plan.js").Drawn} drawn
     * @param {import("./geometry.js").Stage} stage
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
