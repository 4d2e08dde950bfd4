/**
 * What the server answers to /curves and /snell, worked out here: by the formulas that it sent as
 * kernels.js. No formula stands in this file; it lays the values out as the server does.
 */

import { locate, read } from "../curves/reading.js";

const SAMPLES = 181;
const COLORS = ["R_red", "R_green", "R_blue"];
const POWERS = ["R", "Rs", "Rp", "T"];
const PHASES = ["phase_s_deg", "phase_p_deg"];
const REFRACTION = [
  "theta_t_deg",
  "penetration_depth_wavelengths",
  "field_penetration_depth_wavelengths",
];
const LANDMARKS = ["brewster_deg", "critical_deg", "pseudo_brewster_deg", "principal_deg"];
const AMPLITUDES = /** @type {const} */ (["r_s", "r_p", "t_s", "t_p"]);
const MEDIA = ["n_i", "n_t", "k_t"];
/** What may be asked besides the media and the models' parameters. @type {Record<string, string[]>} */
const ASKED = {
  "/curves": ["models", "samples", "landmarks", "refraction", "phase"],
  "/snell": ["theta_i_deg"],
};

/** @param {number} x @returns {number | null} */
const defined = (x) => (Number.isFinite(x) ? x : null);

/** @param {Kernel} f @param {Record<string, number>} numbers by name */
const value = (f, numbers) => f(...f.takes.map((name) => numbers[name] ?? Number.NaN));

/** The cosine, exact at both ends. @param {number} degrees */
function cosine(degrees) {
  const radians = Math.PI / 180;
  return degrees > 45 ? Math.sin((90 - degrees) * radians) : Math.cos(degrees * radians);
}

/**
 * @param {KernelModels} kernels
 * @param {Catalog} catalog
 */
export function createAnswers(kernels, { models, parameters }) {
  const exact = /** @type {Record<string, any>} */ (kernels.exact);
  /** @param {string} name of what every interface and ray has */
  const known = (name) => /** @type {Kernel} */ (exact[name]);

  /** @param {Media} media @returns {{facts: any, numbers: Record<string, number>}} an `Interface`, and its numbers */
  function interfaceOf({ n_i, n_t, k_t }) {
    const ratios = { n_i, n_t, k_t, eta: n_t / n_i, kappa: k_t / n_i };
    const F0 = value(known("F0"), ratios);
    const numbers = { ...ratios, F0, F82: value(known("F82"), ratios) };
    const angles = LANDMARKS.map((name) => [name, defined(value(known(name), numbers))]);
    const facts = {
      ...numbers,
      kind: k_t > 0 ? "conductor" : "dielectric",
      ...Object.fromEntries(angles),
      incident: null,
      material: null,
    };
    return { facts, numbers };
  }

  /**
   * @param {Kernel} f
   * @param {readonly number[]} cosines
   * @param {Record<string, number>} numbers
   */
  function over(f, cosines, numbers) {
    const rest = f.takes.slice(1).map((name) => numbers[name] ?? Number.NaN);
    return cosines.map((mu) => defined(f(mu, ...rest)));
  }

  /**
   * The values of a model's parameters, of one channel: given, the default, or worked out.
   * @param {Model} model
   * @param {URLSearchParams} query
   * @param {Record<string, number>} numbers
   * @param {number} channel
   * @returns {Record<string, number> | null} null where one has to be left to the server
   */
  function own(model, query, numbers, channel) {
    const all = { ...numbers };
    /** @type {Record<string, number>} */
    const mine = {};
    for (const { name, default: preset, choices } of model.parameters) {
      const given = query.get(`${model.id}.${name}`);
      const solve = kernels[model.id]?.solve?.[name];
      if (given !== null) {
        const parts = given.split(",");
        const text = parts[parts.length > 1 ? channel : 0] ?? "";
        mine[name] = choices?.find(([word]) => word === text)?.[1] ?? Number(text);
      } else if (preset !== null) mine[name] = preset;
      else if (solve) mine[name] = value(solve, all);
      else return null;
      all[name] = /** @type {number} */ (mine[name]);
    }
    return mine;
  }

  /**
   * @param {Model} model
   * @param {URLSearchParams} query
   * @param {Record<string, number>} numbers
   * @param {readonly number[]} cosines
   * @returns {Curve[] | null} null where there is no formula to work it out with
   */
  function curvesOf(model, query, numbers, cosines) {
    const f = kernels[model.id]?.R;
    if (!f) return null;
    const three = model.parameters.some((p) => query.get(`${model.id}.${p.name}`)?.includes(","));
    const curves = [];
    for (const [channel, quantity] of (three ? COLORS : ["R"]).entries()) {
      const parameters = own(model, query, numbers, channel);
      if (!parameters) return null;
      const values = over(f, cosines, { ...numbers, ...parameters });
      curves.push({ model: model.id, quantity, values, reason: null, parameters });
    }
    return curves;
  }

  /**
   * @param {Media} media
   * @param {URLSearchParams} query
   * @param {Curves | undefined} last what the server said last
   */
  function curves(media, query, last) {
    const { facts, numbers } = interfaceOf(media);
    const samples = Number(query.get("samples") ?? SAMPLES);
    const even = Array.from({ length: samples }, (_, i) => (i * 90) / (samples - 1));
    const marks = query.get("landmarks") === "true" ? LANDMARKS.map((name) => facts[name]) : [];
    const theta_i_deg = [...new Set([...even, ...marks.filter((m) => m !== null)])].sort(
      (a, b) => a - b,
    );
    const cosines = theta_i_deg.map(cosine);
    const quantities = [
      ...POWERS,
      ...(query.get("phase") === "true" ? PHASES : []),
      ...(query.get("refraction") === "true" ? REFRACTION : []),
    ];
    const found = [];
    let complete = true;
    for (const id of (query.get("models") ?? "exact").split(",")) {
      const model = models.find((m) => m.id === id);
      const before = last?.curves.filter((c) => c.model === id) ?? [];
      if (id === "exact") {
        for (const quantity of quantities)
          found.push({ model: id, quantity, values: over(known(quantity), cosines, numbers) });
        continue;
      }
      const own = model ? curvesOf(model, query, numbers, cosines) : null;
      complete &&= own !== null;
      // What a model is not made for stays said; one without a formula here stays as it was drawn last.
      for (const curve of own ?? moved(before, last?.theta_i_deg ?? [], theta_i_deg))
        found.push({ ...curve, reason: before[0]?.reason ?? null });
    }
    return { answer: { interface: facts, theta_i_deg, curves: found }, complete };
  }

  /** @param {Media} media @param {URLSearchParams} query */
  function snell(media, query) {
    const { facts, numbers } = interfaceOf(media);
    const theta_i_deg = Number(query.get("theta_i_deg") ?? 0);
    const here = { ...numbers, mu: cosine(theta_i_deg) };
    const at = (/** @type {string} */ name) => defined(value(known(name), here));
    const amplitudes = AMPLITUDES.map((name) => {
      const [re, im] = [at(`${name}_re`) ?? 0, at(`${name}_im`) ?? 0];
      const turn = at(name === "r_s" ? "phase_s_deg" : "phase_p_deg");
      const phase_deg = name.startsWith("r") ? turn : (Math.atan2(im, re) * 180) / Math.PI;
      return [name, { re, im, abs: Math.hypot(re, im), phase_deg }];
    });
    const theta_t_deg = at("theta_t_deg");
    const powers = [...POWERS, "Ts", "Tp", ...REFRACTION.slice(1)].map((name) => [name, at(name)]);
    const answer = {
      interface: facts,
      theta_i_deg,
      theta_t_deg,
      total_internal_reflection: theta_t_deg === null,
      ...Object.fromEntries(amplitudes),
      ...Object.fromEntries(powers),
    };
    return { answer, complete: true };
  }

  /**
   * @param {string} path as it would be asked of the server
   * @param {any} last the server's last answer of the kind, if there is one
   * @returns {KernelAnswer | null} null where this is no question for formulas
   */
  return (path, last) => {
    const [route = "", text = ""] = path.split("?");
    const query = new URLSearchParams(text);
    const words = ASKED[route];
    if (!words) return null;
    for (const name of query.keys())
      if (!words.includes(name) && !MEDIA.includes(name) && !name.includes(".")) return null;
    const media = Object.fromEntries(
      MEDIA.map((name) => {
        const preset = parameters.find((p) => p.name === name)?.default;
        return [name, Number(query.get(name) ?? preset)];
      }),
    );
    return route === "/snell"
      ? snell(/** @type {any} */ (media), query)
      : curves(/** @type {any} */ (media), query, last);
  };
}

/**
 * Curves at other angles, between their values.
 * @param {Curve[]} curves
 * @param {number[]} from
 * @param {number[]} to
 */
function moved(curves, from, to) {
  const places = to.map((x) => locate(from, x));
  return curves.map((curve) => ({ ...curve, values: places.map((p) => read(curve.values, p)) }));
}
