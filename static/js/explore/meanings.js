/** What the numbers of Explore are, said where one of them is tapped. */

import { h } from "../page/dom.js";

/** @type {Record<string, string>} */
export const MEANINGS = {
  n_i: "Refractive index of the medium that the light comes from: how much slower light is there than in vacuum. Air 1, water 1.33, glass 1.5.",
  n_t: "Refractive index of the medium that the light meets. Of a metal it is the real part, and may be below 1.",
  k_t: "Extinction of the medium that the light meets: how soon it swallows light. 0 is clear as glass, metals have 2 to 8.",
  theta_i_deg:
    "Angle of incidence, from the normal, which stands upright on the surface: 0° is head on, 90° grazes along it.",
  R: "Reflectance: the share of the light that comes back, here of unpolarized light, the mean of Rs and Rp. 0 is none of it, 1 all.",
  Rs: "Reflectance of s-polarized light: its field swings across the plane that the rays lie in. It only rises with the angle, until all is reflected.",
  Rp: "Reflectance of p-polarized light: its field swings within the plane that the rays lie in. At Brewster’s angle a clear surface reflects none of it.",
  F0: "Reflectance head on, at 0°: 0.04 for glass. It is what renderers ask for, as specular or as the color of a metal.",
  T: "Transmittance: the share of the light that passes into the second medium, 1 − R.",
  Ts: "Transmittance of s-polarized light, 1 − Rs.",
  Tp: "Transmittance of p-polarized light, 1 − Rp.",
  F82: "Reflectance near 82°, where the cosine is 1/7: there metals dip before they turn into mirrors. With F0 it fixes the curve of F82-tint.",
  eta: "η, the index of the second medium over that of the first. Nothing but η and κ, and the angle, decides how much is reflected.",
  kappa:
    "κ, the extinction of the second medium over the index of the first: 0 where it is clear, large in metals.",
  penetration_depth_wavelengths:
    "How deep the light goes before its power has fallen to 1/e, 37 %, in wavelengths: in a metal, or behind a surface that reflects all. None where nothing is damped.",
  field_penetration_depth_wavelengths:
    "How deep until the field has fallen to 1/e, twice as deep as the power, in wavelengths.",
  theta_t:
    "Angle of refraction, from the normal: the direction in which the light goes on. None where all is reflected.",
  brewster:
    "Brewster’s angle: there no p-polarized light is reflected, and reflections are polarized. None where the second medium absorbs.",
  critical:
    "The critical angle: beyond it all light is reflected. There is one only from the denser side, as from below the water.",
  pseudo_brewster:
    "The angle where Rp is least: Brewster’s, if there is one, and what is left of it in a metal.",
  principal: "The angle where the phases of the reflected p- and s-polarized light are 90° apart.",
  "r_s.re":
    "Amplitude of the reflected s-polarized field over the incident one: its size, and by its phase how it is shifted. Its squared modulus is Rs.",
  "r_p.re":
    "Amplitude of the reflected p-polarized field over the incident one. Its squared modulus is Rp.",
  "t_s.re": "Amplitude of the s-polarized field that passes, over the incident one.",
  "t_p.re": "Amplitude of the p-polarized field that passes, over the incident one.",
};

const GAP = 4;
const bubble = h("div", { popover: "auto", id: "meaning" });

/**
 * @param {string} name of a number
 * @param {HTMLElement} at where it was tapped
 * @param {(words: string) => void} say
 */
export function explain(name, at, say) {
  const words = MEANINGS[name] ?? "";
  bubble.textContent = words;
  at.closest("main")?.append(bubble);
  bubble.showPopover();
  const { left, top, bottom } = at.getBoundingClientRect();
  const { offsetWidth: width, offsetHeight: height } = bubble;
  const above = top - GAP - height;
  bubble.style.left = `${Math.max(8, Math.min(left, innerWidth - width - 8))}px`;
  bubble.style.top = `${above > 8 ? above : bottom + GAP}px`;
  say(words);
}
