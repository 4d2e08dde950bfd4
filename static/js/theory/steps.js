/**
 * The first path: from the look of water to metals and coats, in the order in which P. Shirley tells it
 * (Fresnel Equations, Schlick Approximation, Metals, and Dielectrics, 2020), in our words; total
 * reflection and the albedo he does not tell.
 */

import { angle, percent, plain } from "../numbers/format.js";
import { errorOf, leaning, shareBy } from "./lesson.js";

/** @typedef {import('./lesson.js').Lesson} Lesson */

/** @param {number | null | undefined} a @param {number} b @param {number} within */
const near = (a, b, within) => a !== null && a !== undefined && Math.abs(a - b) <= within;

/** @param {number | null | undefined} x */
const short = (x) => (x === null || x === undefined ? "…" : plain(x, 3));

/** The preset Fe, at the D line. */
const IRON = { n_t: 2.29924, k_t: 3.23668 };

/** @type {Lesson[]} */
export const STEPS = [
  {
    id: "water",
    title: "Look at water",
    text: [
      "Stand at a pond and look at your feet: you see the ground. Look across the pond: you see the sky. It is the same water. What has changed is the angle at which you look.",
      "Angles are measured from the **normal**, the line that stands upright on the surface: $\\theta_i=0^\\circ$ is straight down, $90^\\circ$ skims along the surface. The share of light that is thrown back is called the reflectance $R$.",
      "In the picture the length of each arrow is the share of light it carries. Drag the bright ray, or move the slider by the arrow keys.",
    ],
    at: { n_t: 1.333, deg: 40 },
    names: ["air", "water"],
    rows: { own_deg: [0, 90] },
    live: ({ reading }) =>
      `At ${angle(reading.theta_i_deg, "deg", 1)} water reflects ${percent(reading.R)}.`,
    tries: [
      {
        say: "Look straight down: how much is reflected?",
        done: ({ reading }) => (reading?.theta_i_deg ?? 90) < 1,
        reply: "Two percent: that is why you see the ground.",
      },
      {
        say: "Find the angle at which water is half a mirror.",
        done: ({ reading }) => near(reading?.R, 0.5, 0.02),
        reply:
          "It happens late, at about 84 degrees, and then everything changes within a hand's breadth.",
      },
    ],
  },
  {
    id: "split",
    title: "Reflected and transmitted are one",
    text: [
      "Nothing is lost at a clear surface. What is not reflected goes through: $R+T=1$.",
      "It does not matter which way the light goes. Reverse it, and your eye sees the sum of both sides: $R$ of the light from above and $T$ of the light from below. For what is lit from above, by sun and sky, this is the recipe of a ray tracer's water: trace both rays and weigh their colors by $R$ and $T$. A lamp in the water needs a third factor: rays that leave the water fan out, and their radiance, which is what a ray carries, changes by $(n_i/n_t)^2$ besides $T$, here 0.56. Light from above was bundled by the inverse as it went in, so for it the two cancel.",
      "Where the second ray goes is **Snell's law**: $n_i\\sin\\theta_i=n_t\\sin\\theta_t$, with the refractive index $n$ of either side, the factor by which light is slower there. The rest of this path is about the two weights.",
    ],
    formula: "angle.refraction",
    at: { n_t: 1.333, deg: 60 },
    names: ["air", "water"],
    rows: { own_deg: [0, 90] },
    quantities: ["R", "T"],
    live: ({ reading }) =>
      `color = ${reading.T.toFixed(2)} × color from below + ${reading.R.toFixed(2)} × color from above`,
    tries: [
      {
        say: "Find the 23 % reflected and 77 % let through of Shirley's picture.",
        done: ({ reading }) => near(reading?.R, 0.23, 0.005),
        reply: "Such a ray is 76 degrees off the normal, and its refracted part 47.",
      },
    ],
  },
  {
    id: "polarization",
    title: "Two kinds of light: s and p",
    text: [
      "Light swings sideways to the way it goes. The incoming and the reflected ray span a plane, the plane of incidence; what swings across that plane is called **s**, what swings within it **p**. Surfaces treat the two differently, so there are two reflectances:",
      "$R_s=\\left(\\frac{n_i\\cos\\theta_i-n_t\\cos\\theta_t}{n_i\\cos\\theta_i+n_t\\cos\\theta_t}\\right)^2$ and $R_p=\\left(\\frac{n_i\\cos\\theta_t-n_t\\cos\\theta_i}{n_i\\cos\\theta_t+n_t\\cos\\theta_i}\\right)^2$.",
      "These are **Fresnel's equations**. Sunlight and lamps are an even mix, and so renderers take the mean, $R=\\tfrac12(R_s+R_p)$. Straight on there is no plane of incidence, and both are the same.",
    ],
    formula: "model.cos_form",
    at: { n_t: 1.5, deg: 50 },
    names: ["air", "glass"],
    rows: { own_deg: [0, 90] },
    polarized: true,
    quantities: ["Rs", "Rp", "R"],
    live: ({ reading }) =>
      `s reflects ${percent(reading.Rs)}, p ${percent(reading.Rp)}, the mean is ${percent(reading.R)}.`,
    tries: [
      {
        say: "Choose p, and find an angle at which less is reflected than straight on.",
        done: ({ reading, setting }) =>
          setting.polarization === "p" && reading !== null && reading.Rp < reading.interface.F0 / 2,
        reply:
          "Tilting the surface makes it a worse mirror for p: strange, and very useful, as the next step shows.",
      },
      {
        say: "Choose s, and look for the same.",
        done: ({ reading, setting }) =>
          setting.polarization === "s" && (reading?.theta_i_deg ?? 0) > 75,
        reply: "There is none: s only rises.",
      },
    ],
  },
  {
    id: "brewster",
    title: "Brewster's angle",
    text: [
      "At one angle a clear surface reflects no p light at all: where the refracted ray and the reflected one would stand at right angles. From Snell's law follows $\\tan\\theta_B=n_t/n_i$.",
      "What is reflected there is pure s light. Polarizing sunglasses stop s light from level surfaces, and with it the glare on water: you look into it as if the sky were gone. A photographer turns a filter for the same reason.",
    ],
    formula: "angle.brewster",
    at: { n_t: 1.333, deg: 35, polarization: "p" },
    names: ["air", "water"],
    rows: { own_deg: [0, 90], own_n: [1, 3] },
    polarized: true,
    quantities: ["Rs", "Rp"],
    live: ({ reading }) =>
      reading?.interface.brewster_deg
        ? `Brewster's angle is ${angle(reading.interface.brewster_deg, "deg")} here; at ${angle(reading.theta_i_deg, "deg")} p reflects ${percent(reading.Rp)}.`
        : "",
    tries: [
      {
        say: "Bring the p reflection to nothing. The slider holds at the mark.",
        done: ({ reading }) =>
          reading !== null && reading.Rp < 1e-9 && reading.interface.n_t !== reading.interface.n_i,
        reply: "Nothing at all: the reflected arrow is gone, and all light goes through.",
      },
      {
        say: "Find the index for which Brewster's angle is 60 degrees.",
        done: ({ reading }) => near(reading?.interface.brewster_deg, 60, 0.3),
        reply: "The tangent of 60 degrees is the root of 3, 1.732.",
      },
    ],
  },
  {
    id: "below",
    title: "From below: total reflection",
    text: [
      "Now let the light come from the denser side, as a diver sees it. The refracted ray bends away from the normal, and at the **critical angle** $\\sin\\theta_c=n_t/n_i$ it lies flat on the surface. Beyond it nothing goes through: $R$ is exactly 1.",
      "No mirror is that good. Light in a glass fiber is reflected this way a million times. The diver sees all of the sky within a round window overhead, and mirrored ground around it.",
      "The picture lets light come from above as always: turn it over in your mind. The glow beyond the surface is the evanescent wave, light that reaches out by a fraction of a wavelength and comes back.",
    ],
    formula: "angle.critical",
    at: { n_i: 1.333, n_t: 1, deg: 30 },
    names: ["water", "air"],
    rows: { own_deg: [0, 90], own_i: [1, 2.5] },
    quantities: ["Rs", "Rp", "R"],
    live: ({ reading }) => {
      const critical = reading.interface.critical_deg;
      if (critical === null) return "With n_i at most n_t there is no critical angle.";
      const state = reading.tir ? "all is reflected" : `${percent(reading.R)} is reflected`;
      return `The critical angle is ${angle(critical, "deg")}; at ${angle(reading.theta_i_deg, "deg")} ${state}.`;
    },
    tries: [
      {
        say: "Stand exactly at the critical angle.",
        done: ({ reading, setting }) => near(reading?.interface.critical_deg, setting.deg, 1e-6),
        reply: "The refracted ray lies in the surface and carries nothing any more.",
      },
      {
        say: "Keep the ray at 45° and raise $n_i$ until all of it is caught.",
        done: ({ reading, setting }) => near(setting.deg, 45, 0.01) && reading?.tir === true,
        reply:
          "From the root of 2, 1.414, on: every glass does it, which is how prisms turn light in binoculars.",
      },
    ],
  },
  {
    id: "schlick",
    title: "Schlick's shortcut",
    text: [
      "For such a smooth curve these are costly equations, and leaving out polarization has made them approximate already. C. Schlick proposed a polynomial in 1994 that nearly every renderer uses:",
      "$R\\approx F_0+(1-F_0)(1-\\cos\\theta_i)^5$ with $F_0=\\left(\\frac{n_t-n_i}{n_t+n_i}\\right)^2$, the reflectance straight on, which Fresnel's equations give too.",
      "It is right at both ends. In between it is too high or too low, by how much depends on the index.",
    ],
    formula: "model.schlick",
    at: { n_t: 1.5, deg: 80 },
    names: ["air", "glass"],
    rows: { own_deg: [0, 90], own_n: [1.02, 4] },
    models: ["schlick"],
    errors: ["schlick"],
    live(scene) {
      const schlick = shareBy(scene, "schlick");
      const worst = errorOf(scene, "schlick");
      if (schlick === null || !worst) return "";
      return `Here: exact ${percent(scene.reading.R)}, Schlick ${percent(schlick)}. For this index it is ${short(worst.max_abs)} off at most, at ${angle(worst.max_abs_at_deg, "deg", 1)}.`;
    },
    tries: [
      {
        say: "Find an index for which Schlick is never more than 0.0325 off.",
        done: (scene) => (errorOf(scene, "schlick")?.max_abs ?? 1) < 0.0325,
        reply: "Around 1.65, among the glasses: that is where it is best.",
      },
      {
        say: "Make it fail: more than 0.1 off.",
        done: (scene) => (errorOf(scene, "schlick")?.max_abs ?? 0) > 0.1,
        reply:
          "An index near 1 or above 2.7 does it. For those take the exact equations, they are only slower.",
      },
    ],
    more: [["Every approximation against the exact curve", "compare", { n_t: 1.5 }]],
  },
  {
    id: "index",
    title: "Where does n come from?",
    text: [
      "From tables. Air counts as 1, water is 1.333, glasses lie around 1.5, diamond is 2.42. Choose one and see what it does. When in doubt, take 1.5: plastics, wood finish and skin are not far from it.",
      "All that an index says can be said by $F_0$ instead: 2 % for water, 4 % for 1.5, 17 % for diamond. Game engines ask for $F_0$, film renderers for $n$; each gives the other.",
      "The index depends on the wavelength, a little: that is **dispersion**, and why a prism and a diamond show colors. A renderer with three colors leaves it out.",
    ],
    formula: "conversion.f0",
    at: { n_t: 1.52, deg: 0 },
    names: ["air", "window glass"],
    rows: { own_deg: [0, 90], own_n: [1, 3] },
    media: [
      "water-shirley",
      "ice-shirley",
      "olive-oil-shirley",
      "window-glass-shirley",
      "sapphire-shirley",
      "diamond-shirley",
    ],
    live: ({ reading }) =>
      `n = ${plain(reading.interface.n_t, 4)} has F0 = ${percent(reading.interface.F0)}.`,
    tries: [
      {
        say: "Which index has an F0 of 10 %?",
        done: ({ reading }) => near(reading?.interface.F0, 0.1, 0.001),
        reply: "1.925: heavier than any window glass, lighter than diamond.",
      },
    ],
    more: [
      ["The materials with their papers", "materials", {}],
      ["Convert between n, F0 and engine values", "compare", { from: "ior" }],
      ["White light through glass", "explore", { light: "white", material: "BK7" }],
    ],
  },
  {
    id: "metals",
    title: "Metals",
    text: [
      "This is iron, as it was measured. Metals reflect far more than glass, for the light does not get into them: it is absorbed within a fraction of a wavelength. The equations stay the same if the index becomes complex, $N=n+ik$, where $k$ says how quickly light dies out.",
      "$R$ starts high and hardly rises. There is no Brewster's angle any more, but a **pseudo-Brewster angle** where $R_p$ is least and not 0; just before grazing incidence the curve dips, which Schlick's polynomial does not know. Take other metals, and move $n$ and $k$ away from them.",
    ],
    formula: "model.exact",
    at: { ...IRON, deg: 60 },
    names: ["air", "iron"],
    media: ["Fe", "Al", "Ag", "Cu", "Ni"],
    rows: { own_deg: [0, 90], own_n: [0.05, 4], own_k: [0, 8] },
    models: ["schlick"],
    quantities: ["Rs", "Rp", "R"],
    live: ({ reading }) =>
      `F0 is ${percent(reading.interface.F0)}; p is least at ${angle(reading.interface.pseudo_brewster_deg, "deg", 1)}${reading.penetration_depth_wavelengths ? `; ${short(reading.penetration_depth_wavelengths)} wavelengths deep its power has fallen to 1/e` : ""}.`,
    tries: [
      {
        say: "Keep iron's $n$ and take its $k$ away.",
        done: ({ setting }) => setting.k_t === 0 && near(setting.n_t, IRON.n_t, 0.01),
        reply: "What is left is a clear stone, nearly diamond, which reflects a quarter as much.",
      },
      {
        say: "Now raise $k$ until four fifths of the light are reflected straight on.",
        done: ({ reading }) => (reading?.interface.F0 ?? 0) >= 0.8,
        reply:
          "Absorbing more means reflecting more: the strongest absorbers are the best mirrors.",
      },
      {
        say: "Make it silver: $n=0.05$ and $k=4$.",
        done: ({ reading }) =>
          near(reading?.interface.n_t, 0.05, 0.02) && near(reading?.interface.k_t, 4, 0.15),
        reply: "Over 98 % at every angle. With so little n, hardly anything is absorbed either.",
      },
    ],
    more: [["Gold in Explore, with its depth", "explore", { material: "Au", theta_i_deg: 60 }]],
  },
  {
    id: "rgb",
    title: "Why gold is golden",
    text: [
      "For metals $n$ and $k$ change much with the wavelength, and so does $F_0$: gold reflects red and absorbs blue. A renderer with three colors therefore keeps an $F_0$ of three numbers, and applies Schlick to each.",
      "Toward grazing incidence every color goes to 1: the rim of a golden ball is white.",
      "An $F_0$ is a share of light, so it is **linear**. A color picked from a picture is sRGB-encoded: decode it first. Dielectrics keep one number, since their index hardly changes; that is why engines have two kinds of material.",
    ],
    formula: "conversion.f0_srgb",
    picture: "colors",
    at: { of: "Au", deg: 40 },
    media: ["Au", "Cu", "Ag", "Al", "Fe"],
    rows: { own_deg: [0, 90] },
    models: ["schlick"],
    tries: [
      {
        say: "Find the metal whose three curves nearly are one.",
        done: ({ setting }) => setting.of === "Ag" || setting.of === "Al",
        reply: "Silver and aluminium have no color of their own: they are mirrors.",
      },
      {
        say: "Look at gold close to grazing incidence: where is its color?",
        done: ({ setting }) => setting.of === "Au" && setting.deg > 85,
        reply: "Gone: at 90 degrees everything is white.",
      },
    ],
    more: [["Copper over angle and wavelength", "materials", { preset: "Cu" }]],
  },
  {
    id: "coat",
    title: "Paint, plastic, skin: a coat over a body",
    text: [
      "Most things are neither glass nor metal. Paint is a clear binder with grains in it: the surface reflects like glass, by Fresnel, without color. What gets in is scattered by the grains and comes out colored, but on its way out it meets the surface from the dense side, and more than half is thrown back, again and again.",
      "For the surface take Schlick with $F_0=4\\,\\%$. For the body the light that enters is $1-R$, which even a simple renderer should subtract; the share for light from everywhere is the **albedo** of the surface.",
    ],
    formula: "albedo.coat",
    picture: "coat",
    at: {},
    tries: [
      {
        say: "Make the body perfectly white: where does the light go now?",
        done: ({ state }) => state.coat_body === 1,
        reply: "All of it comes out in the end, however often it is thrown back.",
      },
      {
        say: "Give the coat the index of diamond.",
        done: ({ state }) => state.coat_n >= 2.4,
        reply: "The body hardly gets its light out: a dense coat makes dark colors darker.",
      },
    ],
    more: [
      ["Albedos and their fits", "albedo", {}],
      ["Now beware of the traps", "theory", { section: "traps" }],
      ["Guess a mystery material", "theory", { section: "mystery" }],
    ],
  },
  {
    id: "films",
    title: "Two boundaries: why soap goes black and gold leaf is green",
    text: [
      "A film has two boundaries, and the waves from both add: $r=\\dfrac{r_{12}+r_{23}e^{2i\\delta}}{1+r_{12}r_{23}e^{2i\\delta}}$ with $\\delta=\\dfrac{2\\pi n d\\cos\\theta}{\\lambda}$. The second wave has gone to the far side and back, so what it adds depends on the color, the thickness and the angle: a soap film, which has no color of its own, shows all of them.",
      "Where soap gets very thin it goes **black**. The wave from the far side then lags by nothing, but it comes off water into air, which turns it over: $r_{23}=-r_{12}$. The two cancel in every color. Shortly after, the film bursts.",
      "Gold absorbs, and yet a leaf of a ten-thousandth of a millimeter lets light through. It reflects red and yellow and absorbs blue; what is left for the far side is **green**. That is Shirley's remark about gold, seen from behind.",
    ],
    formula: "model.exact",
    picture: "films",
    at: { deg: 0 },
    rows: { own_deg: [0, 90] },
    tries: [
      {
        say: "Thin the soap until it is black.",
        done: ({ state }) => state.thin_film === "soap" && state.thin_nm <= 15,
        reply: "Below 15 nm nothing is left of any color: the two reflections cancel.",
      },
      {
        say: "Take gold leaf of 50 nm or more and look at it from behind.",
        done: ({ state }) => state.thin_film === "gold" && state.thin_nm >= 50,
        reply: "Green, darker and bluer the thicker it is; 200 nm let next to nothing through.",
      },
    ],
    more: [
      ["Films of your own, exact and as renderers shorten them", "films", {}],
      ["Gold leaf in full", "films", { layers: "Au:50", n_t: 1, film_to: 200, film_side: "T" }],
      ["A soap bubble", "preview", { layers: "water:330", n_t: 1, body: "clear" }],
    ],
  },
  {
    id: "planes",
    title: "Inside an absorber: two kinds of planes",
    text: [
      "Does light refract into a metal? It does, but it is absorbed quickly. Snell's law then holds with complex numbers, and so does the angle of refraction.",
      "What remains real are planes. Those of **equal phase** stand across the direction in which the wave runs, and lean by $\\theta_t$ with $\\tan\\theta_t=\\sin\\theta_i/\\operatorname{Re}\\sqrt{N^2-\\sin^2\\theta_i}$. Those of **equal strength** lie parallel to the surface whatever the angle, for the light dies with depth. The two do not coincide: such a wave is called inhomogeneous.",
      "The picture begins with a weak absorber, in which both can be seen. In a metal the field has fallen to $1/e$ before a single wavelength has passed: hence a gold leaf must be so thin.",
    ],
    formula: "angle.penetration_depth",
    planes: true,
    at: { n_t: 1.3, k_t: 0.25, deg: 55 },
    names: ["air", "absorber"],
    rows: { own_deg: [0, 90], own_n: [0.05, 4], own_k: [0, 8] },
    live: ({ reading }) => {
      const deep = reading.field_penetration_depth_wavelengths;
      const leans = `The planes of equal phase lean by ${angle(leaning(reading.theta_t_deg), "deg", 1)}`;
      return deep === null
        ? `${leans}, and without absorption the wave is as strong everywhere.`
        : `${leans}, those of equal strength not at all; ${short(deep)} wavelengths deep the field has fallen to 1/e.`;
    },
    tries: [
      {
        say: "Let the two kinds of planes coincide.",
        done: ({ reading }) =>
          (reading?.theta_i_deg ?? 90) < 0.5 && (reading?.interface.k_t ?? 0) > 0,
        reply: "Straight on they do: only there the wave is homogeneous.",
      },
      {
        say: "Make it gold: $n=0.27$ and $k=2.9$.",
        done: ({ reading }) =>
          near(reading?.interface.n_t, 0.27, 0.03) && near(reading?.interface.k_t, 2.9, 0.15),
        reply: "A twentieth of a wavelength, 30 nanometers, and hardly a plane of phase is left.",
      },
    ],
    more: [["Depths in Explore", "explore", { n_t: 0.27, k_t: 2.9, theta_i_deg: 55 }]],
  },
];
