/** White light at the surface: where each wavelength goes, from the curves that the server computed. */

import { locate, read, values } from "../curves/reading.js";
import { knownRange, spreadPaths } from "../media/media.js";
import { wavelengthColor } from "../media/wavelength.js";
import { angle } from "../numbers/format.js";
import { h, setText } from "../page/dom.js";
import { loadStyles } from "../page/style.js";

/**
 * The refracted rays of white light at the page's angle, as far as their curves have come.
 * @param {State} state
 * @param {Material[]} materials
 * @param {Record<string, any>} answers
 * @returns {ColoredRay[]}
 */
export function spread(state, materials, answers) {
  const dark = globalThis.document?.documentElement.dataset.theme === "dark";
  return Object.keys(spreadPaths(state, materials)).flatMap((name) => {
    const curves = answers[name];
    // The answer may still be that of the media before.
    if (!curves || !isOf(curves.interface, state, materials)) return [];
    const nm = Number(name.split(":")[1]);
    const place = locate(curves.theta_i_deg, state.theta_i_deg);
    const theta_t_deg = read(values(curves, "theta_t_deg"), place);
    return [{ nm, theta_t_deg, color: wavelengthColor(nm, dark) }];
  });
}

/** @param {any} media @param {State} state @param {Material[]} materials */
function isOf(media, { incident, material, n_i, n_t, k_t }, materials) {
  /** @param {string | null} id */
  const varies = (id) => materials.find((m) => m.id === id)?.kind === "spectrum";
  const front = varies(incident) ? media.incident?.id === incident : media.n_i === n_i;
  const back = varies(material)
    ? media.material?.id === material
    : media.n_t === n_t && media.k_t === k_t;
  return front && back;
}

/** The angles of refraction side by side, magnified until they can be told apart. */
export async function createDispersion() {
  await loadStyles("dispersion");
  const strip = h("div.spread-strip", { "aria-hidden": "true" });
  const text = h("p.spread-text");
  const element = h("section.spread", { "aria-label": "White light", hidden: true }, strip, text);
  let shown = "";
  return {
    element,
    /** @param {ColoredRay[]} rays @param {State} state @param {Material[]} materials */
    update(rays, state, materials) {
      const on = state.light === "white";
      if (element.hidden === on) element.hidden = !on;
      if (!on) return;
      const look = JSON.stringify([rays, state.angle, state.incident, state.material]);
      if (look === shown) return;
      shown = look;
      const refracted = rays.filter((r) => r.theta_t_deg !== null);
      const angles = refracted.map((r) => r.theta_t_deg ?? 0);
      const [low, high] = [Math.min(...angles), Math.max(...angles)];
      strip.hidden = refracted.length < 2 || high - low < 1e-9;
      if (!strip.hidden)
        strip.replaceChildren(
          ...refracted.map(({ nm, color, theta_t_deg }, index) => {
            const line = h(
              "span.spread-ray",
              { "data-row": index % 2 },
              h("span.spread-nm", String(nm)),
            );
            const part = ((theta_t_deg ?? 0) - low) / (high - low);
            line.style.setProperty("--at", part.toFixed(4));
            line.style.setProperty("--ray", color);
            return line;
          }),
        );
      setText(text, sentence(rays, state, knownRange(materials, state) !== null));
    },
  };
}

/** @param {ColoredRay[]} rays @param {State} state @param {boolean} varies */
export function sentence(rays, state, varies) {
  if (!varies) return "White light: name a medium whose indices vary with the wavelength.";
  const [first] = rays;
  const last = rays.at(-1);
  if (!first || !last) return "";
  const inside = rays.filter((r) => r.theta_t_deg !== null);
  if (inside.length === 0) return "White light is totally reflected.";
  const [from, to] = [inside[0], inside.at(-1)];
  const apart = Math.abs((from?.theta_t_deg ?? 0) - (to?.theta_t_deg ?? 0));
  const kept = rays.length - inside.length;
  const digits = state.angle === "rad" ? 5 : 3;
  return `${from?.nm} nm at ${angle(from?.theta_t_deg, state.angle)}, ${to?.nm} nm at ${angle(to?.theta_t_deg, state.angle)}: ${angle(apart, state.angle, digits)} apart.${
    kept ? ` ${kept} of ${rays.length} wavelengths are totally reflected.` : ""
  }`;
}
