/**
 * What the named media are at the wavelength that is shown. The catalog tells each preset's indices
 * at its own wavelength; those at any other are asked of the server and kept.
 */

/**
 * @typedef {{id: string, wavelength_nm: number | null, n: number, k: number | null}} Resolved
 * @typedef {import('../server/api.js').Problem} Problem
 */

/** k below which light goes 40 mm before it falls to 1/e. */
export const NEGLIGIBLE = 1e-6;

/** @param {number | null} k */
const visible = (k) => (k === null || k < NEGLIGIBLE ? 0 : k);

/** Whether a preset has indices at more than one wavelength. @param {Material | undefined} material */
export function isDispersive(material) {
  return material?.kind === "spectrum";
}

/**
 * The media of a state as the server's parameters: presets at a wavelength where that makes a
 * difference, numbers elsewhere. Null where it makes none.
 * @param {Material[]} materials
 * @param {State} state
 * @param {number | null} nm
 * @returns {string[] | null}
 */
export function mediaAt(materials, { incident, material, n_i, n_t, k_t }, nm) {
  /** @param {string | null} id */
  const varies = (id) => id !== null && isDispersive(materials.find((m) => m.id === id));
  if (nm === null || !(varies(incident) || varies(material))) return null;
  return [
    varies(incident) ? `incident=${incident}` : `n_i=${n_i}`,
    ...(varies(material) ? [`material=${material}`] : [`n_t=${n_t}`, `k_t=${k_t}`]),
    `wavelength_nm=${nm}`,
  ];
}

/**
 * Wavelengths at which all is known that varies with them.
 * @param {Material[]} materials
 * @param {State} state
 * @returns {[number, number] | null} null where nothing does; a low end above the high one where no
 *   wavelength is known of both
 */
export function knownRange(materials, { incident, material }) {
  const ranges = [incident, material].flatMap((id) => {
    const found = materials.find((m) => m.id === id);
    return isDispersive(found) && found?.n_range_nm ? [found.n_range_nm] : [];
  });
  if (ranges.length === 0) return null;
  return [Math.max(...ranges.map((r) => r[0])), Math.min(...ranges.map((r) => r[1]))];
}

/**
 * @param {object} options
 * @param {Material[]} options.materials
 * @param {() => void} options.onChange what is implied has changed
 * @param {(problem: Problem | null) => void} options.onProblem
 * @param {(how: {onAnswer: (data: any) => void, onProblem: (problem: Problem) => void}) =>
 *   {request: (path: string) => void}} options.query
 */
export function createConstants({ materials, onChange, onProblem, query }) {
  /** @type {Map<string, Resolved>} */
  const known = new Map();
  /** The last that was known of a preset, until the next is. @type {Map<string, Resolved>} */
  const latest = new Map();
  let path = "";
  let refused = "";

  const asked = query({
    onAnswer(data) {
      for (const one of [data.interface.incident, data.interface.material]) {
        if (!one) continue;
        known.set(`${one.id}@${one.wavelength_nm}`, one);
        latest.set(one.id, one);
      }
      settle();
      onChange();
    },
    onProblem(problem) {
      refused = path;
      onProblem(problem);
    },
  });

  function settle() {
    if (refused) onProblem(null);
    refused = "";
  }

  /** @param {string | null} id */
  const preset = (id) => materials.find((m) => m.id === id);

  /** @param {string | null} id @param {number | null} nm @returns {{n: number, k: number | null} | undefined} */
  function at(id, nm) {
    const found = preset(id);
    if (!found || nm === null || !isDispersive(found)) return found;
    return known.get(`${id}@${nm}`) ?? latest.get(found.id) ?? found;
  }

  return {
    /**
     * The indices that follow from the presets. A k too weak to see is left out, as the control of the
     * media says: glass would have no Brewster's angle for it.
     * @param {State} state
     * @returns {State}
     */
    implied({ incident, material, wavelength_nm }) {
      const from = at(incident, wavelength_nm);
      const into = at(material, wavelength_nm);
      return { ...(from && { n_i: from.n }), ...(into && { n_t: into.n, k_t: visible(into.k) }) };
    },
    /** Ask for what is not known yet; where nothing can be known the control says so. @param {State} state */
    follow(state) {
      const { incident, material, wavelength_nm: nm } = state;
      const media = mediaAt(materials, state, nm);
      const range = knownRange(materials, state);
      const missing = [incident, material].some(
        (id) => isDispersive(preset(id)) && !known.has(`${id}@${nm}`),
      );
      if (!media || !range || !missing || nm < range[0] || nm > range[1]) {
        settle();
        return;
      }
      path = `/snell?${[...media, "theta_i_deg=0"].join("&")}`;
      if (path !== refused) asked.request(path);
    },
  };
}

/** From violet to red, in nm. */
const COLORS = [400, 450, 500, 550, 600, 650, 700];
const SAMPLES = 361;

/**
 * The curves of each wavelength at which the media are known, if white light is to be seen.
 * @param {State} state
 * @param {Material[]} materials
 * @returns {Record<string, string>}
 */
export function spreadPaths(state, materials) {
  const range = knownRange(materials, state);
  if (state.light !== "white" || !range) return {};
  const known = COLORS.filter((nm) => nm >= range[0] && nm <= range[1]);
  return Object.fromEntries(
    known.map((nm) => [
      `white:${nm}`,
      `/curves?${[...(mediaAt(materials, state, nm) ?? []), "refraction=true", `samples=${SAMPLES}`].join("&")}`,
    ]),
  );
}
