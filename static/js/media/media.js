/**
 * The media at the surface: what the named ones are at the wavelength that is shown, and their
 * controls, a preset for each side and a row for each index. The catalog tells each preset's indices
 * at its own wavelength; those at any other are asked of the server and kept.
 */

import { createRow, INDEX_STEPS } from "../controls/panel.js";
import { put } from "../draw/svg.js";
import { plain, significant } from "../numbers/format.js";
import { h, setText, symbol as symbolOf } from "../page/dom.js";

/** From the far ultraviolet to radio, whatever a source covers. */
export const WAVELENGTH = {
  name: "wavelength_nm",
  symbol: "\\lambda",
  minimum: 1,
  maximum: 1e9,
};

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
 * At which wavelength the media are taken: that of the page, else of their sources. Nothing where none varies.
 * @param {Material[]} materials
 * @param {State} state
 */
export function atWavelength(materials, { incident, material, wavelength_nm }) {
  const used = [incident, material].flatMap((id) => {
    const found = materials.find((m) => m.id === id);
    const nm = isDispersive(found) ? (wavelength_nm ?? found?.wavelength_nm) : null;
    return nm == null ? [] : [`${plain(nm)}\u00a0nm`];
  });
  return used.length ? `at ${[...new Set(used)].join(" and ")}` : "";
}

/** @param {ConstantsOptions} options */
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

  /** @param {string | null} id @param {number | null} nm @returns {{n_absolute: number, k: number | null} | undefined} */
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
      return {
        ...(from && { n_i: from.n_absolute }),
        ...(into && { n_t: into.n_absolute, k_t: visible(into.k) }),
      };
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

/**
 * What asks for the band of R where the source of the second medium gives n from one value to another.
 * @param {State} state
 * @param {Catalog} catalog
 * @returns {Record<string, string>}
 */
export function bandPaths({ material, n_i }, { materials }) {
  const ranged = materials.find((m) => m.id === material)?.n_max;
  return ranged ? { band: `/curves?n_i=${n_i}&material=${material}&band=true` } : {};
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

/** A value of one's own is no preset any more. @type {Record<string, "incident" | "material">} */
const PRESETS = { n_i: "incident", n_t: "material", k_t: "material" };

/** @param {Material} material */
export function indices({ n, k }) {
  return (k ?? 0) >= NEGLIGIBLE ? `${plain(n, 4)} + ${plain(k ?? 0, 4)}i` : plain(n);
}

/** Whether a medium absorbs, but too little to see. @param {Material | undefined} material */
function isFaint(material) {
  return (material?.k ?? 0) > 0 && (material?.k ?? 0) < NEGLIGIBLE;
}

/** Whether a medium can be on the incident side, where the index is real. @param {Material} material */
export function canBeIncident({ k }) {
  return (k ?? 0) < NEGLIGIBLE;
}

/** How the indices are moved, unless a view has its own ranges. @type {Record<string, RowManner>} */
const MANNERS = {
  n_i: { label: "incident index", range: [1, 3], wide: [0.1, 10] },
  n_t: { label: "second index", range: [1, 3], wide: [0.1, 10] },
  k_t: { label: "extinction", range: [0, 5], wide: [0, 20] },
};

/** The rows of the indices, and the media as presets. @param {InterfaceOptions} options */
export function createInterface({
  catalog,
  presets,
  state,
  actions,
  prefix,
  manners = MANNERS,
  term,
  describeMedia,
}) {
  const { materials } = catalog;
  const rows = Object.entries(manners).flatMap(([name, manner]) => {
    const parameter = catalog.parameters.find((p) => p.name === name);
    if (!parameter) return [];
    const row = createRow({
      parameter,
      prefix,
      preset: presets[name],
      term: term?.(name, symbolOf(parameter.symbol)),
      ...manner,
      steps: INDEX_STEPS,
      onChange: (value, moving) =>
        actions.set(
          { [name]: value, [PRESETS[name]]: null },
          { history: moving ? "replace" : "push" },
        ),
      onSettle: actions.settle,
    });
    return [{ name, symbol: parameter.symbol, row, print: () => plain(state()[name], 4) }];
  });

  /** @param {"incident" | "material"} side @param {string} label @param {ListOptions["refusal"]} refusal */
  const field = (side, label, refusal) =>
    createField({
      label,
      materials,
      note: indices,
      refusal,
      describe: describeMedia,
      onPick(id) {
        if (materials.some((m) => m.id === id)) actions.set({ [side]: id });
        else window.dispatchEvent(new CustomEvent("ownmaterial", { detail: side }));
      },
    });
  const from = field("incident", "Incident medium", (m) =>
    canBeIncident(m) ? null : "n_i is real: an absorbing medium cannot be on this side",
  );
  const into = field("material", "Second medium", () => null);
  const reason = h("p.reason", { id: "swap-reason" });
  const swap = h(
    "button.swap",
    {
      type: "button",
      "aria-label": "Swap the media",
      "aria-describedby": "swap-reason",
      onclick() {
        if (swap.getAttribute("aria-disabled") === "true") return;
        const { n_i, n_t, incident, material } = state();
        actions.set({ n_i: n_t, n_t: n_i, incident: material, material: incident });
      },
    },
    "⇅",
  );
  const wavelengthPlace = h("div", { hidden: true });
  const element = h(
    "div.media",
    h("div.side", h("span", "from"), from.element),
    h("div.side", h("span", "into"), into.element),
    swap,
    reason,
    wavelengthPlace,
  );
  /** Fetched when a medium is named whose indices vary. @type {ReturnType<typeof import("../controls/wavelength.js").createWavelength> | null} */
  let wavelength = null;
  let shown = "";

  async function showWavelength() {
    const { createWavelength } = await import("../controls/wavelength.js");
    if (!wavelength) {
      wavelength = createWavelength({ materials, actions, prefix });
      wavelengthPlace.replaceWith(wavelength.element);
    }
    wavelength.update(state());
  }

  const media = {
    element,
    stop: () => wavelength?.stop(),
    /** @param {State} now */
    update(now) {
      if (wavelength) wavelength.update(now);
      else if (knownRange(materials, now)) void showWavelength();
      const { incident, material, n_i, n_t, k_t } = now;
      const surface = JSON.stringify([incident, material, n_i, n_t, k_t]);
      if (surface === shown) return;
      shown = surface;
      from.show(knownAs(materials, incident, n_i, 0, presets));
      into.show(knownAs(materials, material, n_t, k_t, presets));
      put(swap, "aria-disabled", String(k_t > 0));
      const left = materials.find((m) => m.id === incident)?.k;
      const why = [
        left ? `n_i is real: k = ${significant(left, 2)} is left out.` : "",
        isFaint(materials.find((m) => m.id === material)) ? "k < 10⁻⁶ is left out." : "",
        k_t > 0 ? "No swap: n_i is real, and the second medium absorbs." : "",
      ];
      setText(reason, why.filter(Boolean).join(" "));
    },
  };
  return { rows, media };
}

/** What a field does when somebody comes to it. */
const EVENTS = /** @type {const} */ (["focus", "click", "input", "keydown", "blur"]);

/** One of the catalog's media: a field that is typed into. Its list is fetched with the first touch. @param {FieldOptions} options */
export function createField({ label, placeholder = "own value", ...options }) {
  const { materials, note } = options;
  const input = h("input.preset", {
    type: "text",
    role: "combobox",
    autocomplete: "off",
    spellcheck: "false",
    placeholder,
    "aria-label": label,
    "aria-expanded": "false",
    "aria-autocomplete": "list",
    "aria-haspopup": "listbox",
  });
  const element = h("span.picker.media-picker", input);
  /** @type {string | null} */
  let chosen = null;
  let own = "";
  /** @param {string | null} [id] */
  const written = (id = chosen) => {
    const material = materials.find((m) => m.id === id);
    return material ? `${material.name}\u2003${note(material)}` : own;
  };

  /** @type {Awaited<ReturnType<typeof import("../controls/picker.js").createList>> | null} */
  let list = null;
  /** What happened before the list had come. @type {Event[]} */
  let early = [];
  async function fetchList() {
    const { createList } = await import("../controls/picker.js");
    list = await createList({ ...options, input, written, chosen: () => chosen });
    for (const event of early) list.on(event);
    early = [];
  }
  for (const kind of EVENTS)
    input.addEventListener(kind, (event) => {
      if (kind === "click" && !list?.isOpen()) input.select();
      if (list) list.on(event);
      else if (early.push(event) === 1) void fetchList();
    });

  return {
    element,
    /** @param {Known} known */
    show({ id, like }) {
      const found = materials.find((m) => m.id === like);
      const said = found ? `like ${found.name}\u2003${note(found)}` : "";
      if (id === chosen && said === own) return;
      chosen = id;
      own = said;
      if (!list?.isOpen()) input.value = written();
      input.title = written(); // a long one is cut off
    },
  };
}

/**
 * The preset that the state names, else the first one with exactly these indices.
 * @param {Material[]} materials
 * @param {string | null} id
 * @param {number} n
 * @param {number} k
 * @returns {string | null}
 */
function nameable(materials, id, n, k) {
  if (id !== null) return id;
  let known = named.get(materials);
  if (!known) {
    // from the end, so that the first of several with the same indices stays
    known = new Map(
      materials
        .map((m) => /** @type {const} */ ([indexKey(m.n_absolute, visible(m.k)), m.id]))
        .reverse(),
    );
    named.set(materials, known);
  }
  return known.get(indexKey(n, k)) ?? null;
}

/**
 * @typedef {{id: string | null, like: string | null}} Known
 */

/**
 * What a medium is: a preset, by its name or where the page starts, or numbers of one's own, which may be
 * like a preset's.
 * @param {Material[]} materials
 * @param {string | null} id
 * @param {number} n
 * @param {number} k
 * @param {State} presets where the page starts
 * @returns {Known}
 */
export function knownAs(materials, id, n, k, presets) {
  const found = nameable(materials, id, n, k);
  const start = k === 0 && (n === presets.n_i || n === presets.n_t);
  const named = id !== null || start;
  return named ? { id: found, like: null } : { id: null, like: found };
}

/** The presets by their indices: every frame of a drag asks. @type {WeakMap<Material[], Map<string, string>>} */
const named = new WeakMap();

/** @param {number | null} n @param {number | null} k */
function indexKey(n, k) {
  return `${n} ${k ?? 0}`;
}
