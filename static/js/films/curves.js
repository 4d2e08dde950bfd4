/** R, T and A over the wavelength and over the angle, each curve in its color. */

import { angleAxis, locate, read } from "../curves/reading.js";
import { inUnit } from "../numbers/format.js";
import { createChanged } from "../page/changed.js";
import { createDataTables, createExports, h } from "../page/dom.js";
import { createPlot } from "../plot/plot.js";
import { wavelengthOf } from "./fields.js";

/** @type {Record<string, {label: string, color: string, dash: string, width: number}>} */
const LOOKS = {
  R: { label: "R", color: "--R", dash: "solid", width: 2.6 },
  Rs: { label: "R_s", color: "--Rs", dash: "solid", width: 1.8 },
  Rp: { label: "R_p", color: "--Rp", dash: "dash", width: 1.8 },
  T: { label: "T", color: "--T", dash: "solid", width: 2 },
  A: { label: "A", color: "--model-2", dash: "dashdot", width: 1.8 },
};
const TOPS = [0.02, 0.05, 0.1, 0.2, 0.5, 1];

/** @param {readonly {quantity: string, values: number[]}[]} curves @param {number[]} x @param {readonly string[]} show @returns {Trace[]} */
function tracesOf(curves, x, show) {
  return show.flatMap((quantity) => {
    const found = curves.find((curve) => curve.quantity === quantity);
    return found
      ? [{ id: quantity, x, y: found.values, .../** @type {any} */ (LOOKS[quantity]) }]
      : [];
  });
}

/** @param {readonly Trace[]} traces */
const topOf = (traces) => {
  const most = Math.max(0, ...traces.flatMap((t) => t.y.map((v) => v ?? 0)));
  return TOPS.find((top) => top >= most) ?? 1;
};

/**
 * @param {ViewContext} context
 * @param {(patch: State, settled: boolean) => void} onPick
 */
export function createCurves({ element, state, save }, onPick) {
  const hosts = { spectrum: h("div.plot-host"), angles: h("div.plot-host") };
  /** @type {Record<string, {heading: string, what: string, filename: string, call: string}>} */
  const words = {
    spectrum: {
      heading: "Over the wavelength",
      what: "the spectrum",
      filename: "fresnel-film-spectrum",
      call: "/films/spectrum",
    },
    angles: {
      heading: "Over the angle",
      what: "the curves over the angle",
      filename: "fresnel-film-angles",
      call: "/curves",
    },
  };
  const names = /** @type {const} */ (["spectrum", "angles"]);
  const tables = createDataTables("Curves as tables", {
    "Table over the wavelength": () => (settled ? [plots.spectrum.table()] : []),
    "Table over the angle": () => (settled ? [plots.angles.table()] : []),
  });
  element.append(
    h(
      "section.column.film-curves",
      { "aria-label": "Curves" },
      ...names.flatMap((name) => [
        h(
          "div.heading",
          h("h2", words[name].heading),
          createExports({
            what: words[name].what,
            name: () => words[name].filename,
            make: (format) => plots[name].exportAs(format),
            print: {
              figures: () => [plots[name]],
              call: words[name].call,
              behind: () => ({ state: state(), indices: [] }),
            },
            save,
          }),
        ),
        hosts[name],
      ]),
      tables.element,
    ),
  );
  const plots = {
    spectrum: createPlot(hosts.spectrum, {
      name: "Reflectance against the wavelength",
      filename: words.spectrum.filename,
      x: { title: "" },
      y: { title: "" },
      onPick: (x, { settled: rests }) => onPick({ wavelength_nm: Math.round(10 * x) / 10 }, rests),
    }),
    angles: createPlot(hosts.angles, {
      name: "Reflectance against the angle of incidence",
      filename: words.angles.filename,
      x: { title: "" },
      y: { title: "" },
      onPick(x, { settled: rests }) {
        const deg = state().angle === "rad" ? (x * 180) / Math.PI : x;
        onPick({ theta_i_deg: Math.min(Math.max(Number(deg.toFixed(2)), 0), 90) }, rests);
      },
    }),
  };
  const changed = createChanged();
  let settled = false;
  let look = "";
  let top = 1;
  /** @type {Record<"spectrum" | "angles", Trace[]>} */
  let shown = { spectrum: [], angles: [] };

  /** @param {State} now @param {number[]} nm @returns {Record<"spectrum" | "angles", {x: Axis, name: string}>} */
  const axes = (now, nm) => ({
    spectrum: {
      name: "Films against the wavelength",
      x: {
        title: "wavelength λ (nm)",
        range: [nm[0] ?? 380, nm.at(-1) ?? 780],
        unit: " nm",
        short: "λ",
        column: "wavelength_nm",
        steps: { step: 1, fine: 0.1, page: 10 },
      },
    },
    angles: {
      name: "Films against the angle of incidence",
      x: angleAxis(/** @type {any} */ (now)),
    },
  });

  return {
    /** @param {State} now @param {any} spectrum @param {any} curves @param {boolean} moving */
    update(now, spectrum, curves, moving) {
      if (spectrum && curves) {
        const key = JSON.stringify([now.film_show, now.angle]);
        if (changed(key, spectrum, curves) || (!moving && !settled)) {
          const degrees = curves.theta_i_deg.map((/** @type {number} */ deg) =>
            inUnit(deg, now.angle),
          );
          shown = {
            spectrum: tracesOf(spectrum.curves, spectrum.wavelength_nm, now.film_show),
            angles: tracesOf(curves.curves, degrees, now.film_show),
          };
          // At 90 degrees all is reflected: the one top would leave most pictures of the spectrum flat.
          const needed = topOf(shown.spectrum);
          top = moving ? Math.max(top, needed) : needed;
          const all = axes(now, spectrum.wavelength_nm);
          const next = JSON.stringify([key, all.spectrum.x.range, top]);
          const title = now.film_show.includes("T") ? "part of the light" : "reflectance";
          for (const name of names) {
            if (moving && next === look) plots[name].fast(shown[name]);
            else {
              const y = { title, range: [0, name === "spectrum" ? top : 1], labels: 40 };
              plots[name].axes({ ...all[name], y });
              void plots[name].draw(shown[name]);
            }
          }
          look = next;
          settled = !moving;
          tables.fill();
        }
      }
      const at = { spectrum: wavelengthOf(now), angles: inUnit(now.theta_i_deg, now.angle) };
      for (const name of names) {
        const x = at[name];
        const reached = shown[name].map((t) => ({ id: t.id, y: read(t.y, locate(t.x, x)) }));
        plots[name].marker(x, reached);
      }
    },
    theme() {
      for (const name of names) plots[name].theme();
    },
    destroy() {
      for (const name of names) plots[name].destroy();
    },
  };
}
