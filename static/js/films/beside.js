/** A renderer's shortcut beside the exact colors, and by how much eyes see the difference. */

import { createSelect } from "../controls/select.js";
import { angleAxis, ends } from "../curves/reading.js";
import { createMap } from "../layers/map.js";
import { inDegrees, inUnit, plain, significant } from "../numbers/format.js";
import { createChanged } from "../page/changed.js";
import { createDataTables, createExports, h, setText } from "../page/dom.js";
import { createHeatmap } from "../plot/heatmap.js";
import { isAskedFor, NO_MODEL } from "./fields.js";

/**
 * @typedef {{film_n: number, n_t: number, k_t: number, max_abs: number, max_delta_e: number, mean_delta_e: number}} Deviation
 * @typedef {{id: string, title: string, reference: string, validity: string, measured: Deviation[]}} FilmModel
 */

const SEEN = 2.3; // a difference that is just seen
const ROUND = [1, 2, 5, 10, 20, 50, 100, 200];

/** @param {readonly number[][]} values a row each thickness @param {readonly number[]} degrees @param {number} upTo */
export function summary(values, degrees, upTo) {
  const columns = degrees.filter((deg) => deg <= upTo).length;
  const all = values.flatMap((row) => row.slice(0, columns));
  return { most: Math.max(...all), mean: all.reduce((sum, v) => sum + v, 0) / all.length };
}

/**
 * @param {ViewContext} context
 * @param {(nm: number, deg: number, settled: boolean) => void} onPick
 */
export function createBeside({ actions, state, save }, onPick) {
  const select = createSelect("Shortcut of a renderer", (film_model) =>
    actions.set({ film_model }),
  );
  const map = createMap("Thickness and angle on the map of the shortcut", onPick, actions.settle);
  const host = h("div.frame");
  const reason = h("p.reason");
  const said = h("p.film-off");
  const validity = h("p.reason");
  const source = h("p.reason");
  let drawn = false;
  const tables = createDataTables("Color differences as a table", {
    "Table of the color differences": () => (errors && drawn ? [errors.table()] : []),
  });
  const exports = createExports({
    what: "the color differences",
    name: () => "fresnel-film-error",
    make: async (format) => {
      if (!errors) throw new Error("there is no map yet");
      return errors.exportAs(format);
    },
    save,
  });
  const pictures = h(
    "div.film-pair",
    { hidden: true },
    h("div", map.element),
    h(
      "div",
      h("div.heading", h("h3", "Difference, ΔE"), exports),
      h("div.film-errors", host),
      tables.element,
    ),
  );
  const element = h(
    "section.column.film-beside",
    { "aria-label": "A renderer's shortcut" },
    h("div.heading", h("h2", "As renderers shorten it"), select.element),
    reason,
    said,
    pictures,
    validity,
    source,
  );
  /** Made when there is something to draw, since it reads its size. @type {ReturnType<typeof createHeatmap> | null} */
  let errors = null;
  const changed = createChanged();

  /** @param {State} now @param {import("../layers/map.js").ColorMap} found @param {number[][]} delta @param {FilmModel | undefined} model */
  function drawErrors(now, found, delta, model) {
    errors ??= createHeatmap(host, {
      name: "Color difference over thickness and angle",
      x: { title: "" },
      y: { title: "" },
      z: { title: "ΔE", kind: "size", print: (v) => (v === null ? "none" : significant(v, 3)) },
      onPick: (nm, theta) => onPick(nm, Number(inDegrees(theta, state().angle).toFixed(2)), true),
    });
    const y = found.theta_i_deg.map((deg) => inUnit(deg, now.angle));
    const { most } = summary(delta, found.theta_i_deg, 85);
    const axis = angleAxis(/** @type {any} */ (now));
    void errors.draw(
      {
        x: found.thickness_nm,
        y,
        z: y.map((_, column) => delta.map((row) => row[column] ?? null)),
      },
      {
        name: `${model?.title ?? "Shortcut"}: color difference over thickness and angle`,
        x: {
          title: `thickness of layer ${found.layer} (nm)`,
          short: "d",
          column: "thickness_nm",
          range: ends(found.thickness_nm),
        },
        y: { ...axis, title: "angle of incidence θᵢ", short: "θᵢ" },
        z: {
          title: "ΔE (CIEDE2000)",
          kind: "size",
          print: (v) => (v === null ? "none" : significant(v, 3)),
          level: SEEN,
          range: [0, ROUND.find((top) => top >= most) ?? 200],
        },
      },
    );
    drawn = true;
    tables.fill();
  }

  return {
    element,
    /**
     * @param {State} now
     * @param {number} nm
     * @param {import("../layers/map.js").ColorMap | undefined} found
     * @param {readonly FilmModel[]} models
     * @param {number | null} factor
     * @param {boolean} moving
     */
    update(now, nm, found, models, factor, moving) {
      const { wanted, why } = isAskedFor(now);
      const colors = wanted
        ? found?.colors.find((each) => each.model === now.film_model)
        : undefined;
      pictures.hidden = !colors;
      if (found && colors) map.update(now, nm, found, colors, factor);
      errors?.marker(nm, inUnit(now.theta_i_deg, now.angle));
      if (moving) return;
      select.update(now.film_model, {
        [NO_MODEL]: "none",
        ...Object.fromEntries(models.map((m) => [m.id, m.title])),
      });
      const model = models.find((m) => m.id === now.film_model);
      setText(reason, why);
      setText(validity, model?.validity ?? "");
      setText(source, model?.reference ?? "");
      if (!found || !colors?.delta_e) {
        setText(said, "");
        return;
      }
      if (changed(colors, now.angle)) drawErrors(now, found, colors.delta_e, model);
      errors?.marker(nm, inUnit(now.theta_i_deg, now.angle));
      const { most, mean } = summary(colors.delta_e, found.theta_i_deg, 85);
      setText(
        said,
        `ΔE (CIEDE2000) against the exact color: ${plain(mean, 3)} in the mean, at most ${plain(most, 3)} up to 85°. The line is at ${SEEN}, which is just seen.`,
      );
    },
    theme: () => errors?.theme(),
    destroy: () => errors?.destroy(),
  };
}
