/** Mistakes that are easily made and hard to see, each with the right thing beside it. */

import { angle, percent, plain } from "../numbers/format.js";
import { errorOf, shareBy } from "./lesson.js";

/** @typedef {import('./lesson.js').Lesson} Lesson */

/** @param {number | null | undefined} x */
const short = (x) => (x === null || x === undefined ? "…" : plain(x, 3));

/** @param {import('./lesson.js').ReadScene} scene @param {string} model @param {string} name */
function against(scene, model, name) {
  const wrong = shareBy(scene, model);
  const worst = errorOf(scene, model);
  if (wrong === null || !worst) return "";
  return `Here: exact ${percent(scene.reading.R)}, ${name} ${percent(wrong)}. Largest error ${short(worst.max_abs)}, at ${angle(worst.max_abs_at_deg, "deg", 1)}.`;
}

/** What a lesson has about a wrong model: its error is told, and that of the right ones. @param {string} model @param {string} name @param {string[]} [right] */
const mistake = (model, name, right = []) => ({
  models: [model, ...right],
  errors: [model, ...right],
  live: (/** @type {import('./lesson.js').ReadScene} */ scene) => against(scene, model, name),
});

/** @type {Lesson[]} */
export const TRAPS = [
  {
    id: "wrong-angle",
    title: "Schlick with the wrong angle inside glass",
    code: "// the ray leaves the glass\nfloat R = F0 + (1.0 - F0) * pow(1.0 - dot(N, -rayDirection), 5.0);",
    text: [
      "Inside glass Schlick wants the larger of the two angles: the one on the air side, $\\theta_t$. With $\\theta_i$ the curve knows no critical angle, and light leaks out of the glass where it should be caught. It looks plausible, only a little dull, and so it stays.",
      "The cure takes two lines: take $\\cos\\theta_t$ where $n_i>n_t$, and 1 beyond the critical angle.",
    ],
    formula: "model.schlick_tir",
    at: { n_i: 1.5, n_t: 1, deg: 44 },
    names: ["glass", "air"],
    rows: { own_deg: [0, 90], own_i: [1.01, 2.5] },
    ...mistake("schlick_wrong_angle", "with the wrong angle", ["schlick_tir"]),
    tries: [
      {
        say: "Find an angle where the wrong curve misses by more than 0.9.",
        done(scene) {
          const wrong = shareBy(scene, "schlick_wrong_angle");
          return wrong !== null && (scene.reading?.R ?? 0) - wrong > 0.9;
        },
        reply: "Everything is reflected, and the shader says: next to nothing.",
      },
    ],
    more: [
      [
        "The three curves in Compare",
        "compare",
        { n_i: 1.5, n_t: 1, models: "schlick_wrong_angle,schlick_tir" },
      ],
    ],
  },
  {
    id: "f0-srgb",
    title: "F0 taken as an sRGB color",
    code: "vec3 F0 = texture(specularMap, uv).rgb;   // 8-bit sRGB, never decoded",
    text: [
      "A reflectance of 4 % is written as 56 of 255 in an 8-bit sRGB texture. Whoever takes 56/255 for the reflectance has 22 %, five times as much, and glass that looks like chrome.",
      "Colors from pictures, pickers and hex codes are encoded; light adds up in linear numbers only. Decode first, or mark the texture as sRGB so that the hardware does it.",
    ],
    formula: "conversion.f0_srgb",
    at: { n_t: 1.5, deg: 20 },
    names: ["air", "glass"],
    rows: { own_deg: [0, 90], own_n: [1.05, 4], own_k: [0, 6] },
    ...mistake("schlick_f0_srgb", "undecoded", ["schlick"]),
    tries: [
      {
        say: "Find an index for which it is more than 0.2 off.",
        done: (scene) => (errorOf(scene, "schlick_f0_srgb")?.max_abs ?? 0) > 0.2,
        reply:
          "From 1.7 on. Measured against R itself it is worst for the darkest: water looks nearly eight times as bright.",
      },
    ],
    more: [["Linear and sRGB side by side", "compare", { from: "f0", given: "0.04" }]],
  },
  {
    id: "rgb-nk",
    title: "RGB triples of n and k as if they were spectra",
    code: "vec3 n = vec3(0.14, 0.37, 1.45), k = vec3(3.98, 2.38, 1.91);   // gold\nvec3 R = fresnelConductor(cosTheta, n, k);",
    text: [
      "An exact formula does not help if its numbers mean nothing. Red is not one wavelength: it is a wide band, and sRGB's red even takes away from others. Averaging $n$ and $k$ over the band and putting the mean into Fresnel's equations is not the mean of the reflectance.",
      "Average $R$ over the spectrum instead, once, and keep $F_0$, and F82 for the dip. It is cheaper, and right straight on by construction.",
    ],
    formula: "conversion.nk",
    picture: "colors",
    at: { of: "Au", deg: 30 },
    media: ["Au", "Cu", "Fe", "Al"],
    rows: { own_deg: [0, 90] },
    models: ["exact", "f82_tint"],
    tries: [
      {
        say: "Find the metal that forgives the mistake.",
        done: ({ setting }) => setting.of === "Al" || setting.of === "Fe",
        reply: "Gray metals have nearly the same n and k in all three bands: nothing to mix up.",
      },
    ],
    more: [["Copper: spectrum against RGB", "materials", { preset: "Cu" }]],
  },
  {
    id: "complex-index",
    title: "A complex index in the dielectric formula",
    code: "g = sqrt(N*N - 1 + c*c);   // N complex now\nR = abs(0.5 * (g-c)*(g-c)/((g+c)*(g+c)) * (1 + …));",
    text: [
      "Fresnel's equations hold for a complex index, but the compact form for dielectrics does not: it squares the quotients before the modulus is taken, and the square of a modulus is not the modulus of a sum of squares. d'Eon shows the curve as a misunderstood form. His notebook leaves $n_i$ out of it and out of Pharr's form, though it has a slider for it: from $n_i=1.5$ into $1.5+2i$ they are up to 0.117 and 0.107 off his own. Here all curves have it.",
      "Take the modulus of each amplitude first: $R=\\tfrac12(|r_s|^2+|r_p|^2)$. At $k=0$ both agree, which is why a test with glass does not find the mistake.",
    ],
    formula: "model.complex_dielectric",
    at: { n_t: 1.5, k_t: 2, deg: 70 },
    names: ["air", "metal"],
    rows: { own_deg: [0, 90], own_n: [0.1, 4], own_k: [0, 6] },
    ...mistake("complex_dielectric", "misunderstood"),
    tries: [
      {
        say: "Bring $k$ to 0: where has the mistake gone?",
        done: ({ reading }) => reading !== null && reading.interface.k_t === 0,
        reply: "It hides. Test a conductor's code with conductors.",
      },
    ],
    more: [
      [
        "d'Eon's comparison",
        "compare",
        { n_t: 1.5, k_t: 2, models: "schlick,pharr_humphreys,complex_dielectric" },
      ],
    ],
  },
  {
    id: "four-percent",
    title: "4 % for everything",
    code: "vec3 F0 = mix(vec3(0.04), baseColor, metallic);",
    text: [
      "Four percent is the reflectance of an index of 1.5, and a good guess. But water has half of it, gems have several times as much, and under water everything has less: $F_0$ belongs to a pair of media.",
    ],
    formula: "model.schlick_four_percent",
    at: { n_t: 1.333, deg: 0 },
    names: ["air", "water"],
    rows: { own_deg: [0, 90], own_n: [1, 3], own_i: [1, 2] },
    ...mistake("schlick_four_percent", "with 4 %"),
    tries: [
      {
        say: "Put glass, 1.5, under water, 1.333: how much is left of the 4 %?",
        done: ({ reading }) =>
          Math.abs((reading?.interface.n_i ?? 1) - 1.333) < 0.004 &&
          Math.abs((reading?.interface.n_t ?? 1) - 1.5) < 0.004,
        reply: "A third of one percent: that is why a wet stone looks dark and clear.",
      },
    ],
    more: [["F0 seen from water", "compare", { from: "ior", given: "1.5", seen_from: 1.333 }]],
  },
];
