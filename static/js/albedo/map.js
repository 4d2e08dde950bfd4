/** The error of a fit over n and k, with what it was made for outlined. */

import { createChoices } from "../controls/panel.js";
import { createSelect } from "../controls/select.js";
import { createEnds } from "../controls/typed.js";
import { ends } from "../curves/reading.js";
import { short } from "../errors/metrics.js";
import { plain, six } from "../numbers/format.js";
import { createChanged } from "../page/changed.js";
import { createDataTables, createExports, h, setText } from "../page/dom.js";
import { html, render } from "../page/lit.js";
import { createTrouble } from "../page/trouble.js";
import { roundUp } from "../plot/cells.js";
import { createHeatmap } from "../plot/heatmap.js";
import { printError } from "./claims.js";
import { mapFit, mapRange } from "./fields.js";

/**
 * @typedef {import('./answers.js').Fit} Fit
 * @typedef {import('./answers.js').AlbedoMap} AlbedoMap
 */

const WHAT = { error: "error", value: "albedo by the fit", exact: "exact albedo" };
/** The range that the page chooses. */
const USUAL = { map_n_low: null, map_n_high: null, map_k_low: null, map_k_high: null };
const N_AXIS = { title: "second index n_t", short: "n_t", column: "n_t" };
const K_AXIS = { title: "extinction k_t", short: "k_t", column: "k_t" };

/** Whether a fit, a claim or a part of a map is about metals. @param {import('./answers.js').Domain} domain */
const ofMetals = ({ kind }) => kind === "conductor";

/** The claim that a line on the map can show: absolute, and about metals. @param {Fit | undefined} fit */
export function claimOf(fit) {
  return fit?.claims.find((c) => c.claimed !== null && !c.relative && ofMetals(c.domain));
}

/**
 * The range of a map that shows a fit's domains of metals whole; null where the page's own does.
 * @param {Fit | undefined} fit
 * @param {State} state
 */
export function rangeFor(fit, state) {
  const { n, k } = mapRange({ ...state, ...USUAL });
  const metals = fit?.domains.filter(ofMetals) ?? [];
  /** @param {number} end @param {number[]} reach */
  const beyond = (end, reach) => {
    const most = Math.max(...reach) * state.n_i;
    return most > end ? most : null;
  };
  const [eta, kappa] = [metals.map((d) => d.eta[1]), metals.map((d) => d.kappa[1])];
  return { ...USUAL, map_n_high: beyond(n[1], eta), map_k_high: beyond(k[1], kappa) };
}

/** @param {AlbedoMap} map @returns {string} */
export function sayLargest({ show, largest, largest_in_domain: inside, domains }) {
  /** @param {import('./answers.js').Largest | null} found */
  const words = (found) =>
    found
      ? `${(show === "error" ? short : six)(found.value)} at n = ${plain(found.n_t, 3)}, k = ${plain(found.k_t, 3)}`
      : "without bound";
  if (show === "exact") return `Largest ${words(largest)}.`;
  if (domains.length === 0) return `Largest error ${words(largest)}.`;
  const what = show === "error" ? "Largest error" : "Largest albedo";
  return inside
    ? `${what} in the outlined domain ${words(inside)}; on the whole map ${words(largest)}.`
    : `${what} on the map ${words(largest)}; the fit was not made for any of it.`;
}

/** Fits by what they are for. @param {readonly Fit[]} fits */
function offered(fits) {
  /** @param {boolean} metals */
  const some = (metals) =>
    Object.fromEntries(
      fits.filter((f) => f.domains.some(ofMetals) === metals).map((f) => [f.id, f.title]),
    );
  return { "for metals": some(true), "for clear media": some(false) };
}

/** @param {ViewContext} context */
export function createMap({ element: parent, actions, state, save }) {
  /** @type {readonly Fit[]} */
  let fits = [];
  const choices = createChoices(actions, {
    map_show: ["Shown", { error: "error", value: "fit", exact: "exact" }],
  });
  const select = createSelect("Fit of the map", (id) => {
    const fit = fits.find((f) => f.id === id);
    actions.set({ map_fit: id, ...rangeFor(fit, state()) });
  });
  const onChange = actions.set;
  const bounds = {
    n: createEnds({ letter: "n", names: ["map_n_low", "map_n_high"], onChange }),
    k: createEnds({ letter: "k", names: ["map_k_low", "map_k_high"], onChange }),
  };
  const host = h("div.frame");
  const waiting = h("p.figure-note", "…");
  const largest = h("p.largest");
  const trouble = createTrouble("Back to the usual fit and range", () =>
    actions.set({ map_fit: null, ...USUAL }),
  );
  let drawn = false;
  const tables = createDataTables("This map as a table", {
    "Table of the map": () => (drawn ? [map.table()] : []),
  });
  const exports = createExports({
    what: "the map",
    name: () => "fresnel-albedo-map",
    make: (format) => map.exportAs(format),
    print: {
      figures: () => [map],
      call: "/albedo/map",
      behind: () => ({ state: state(), indices: ["n_i"] }),
    },
    save,
  });
  const element = h("section.column.over-nk", { "aria-label": "Error over n and k" });
  render(
    html`<div class="heading"><h2>Over n and k</h2>${exports}</div>
      <div class="map-controls">${choices.elements.map_show}${select.element}</div>
      <div class="map-host">${host}${waiting}</div>
      ${trouble.element}${largest}
      <div class="figure-foot">
        ${bounds.n.element}${bounds.k.element}
        <p class="hint">Click to go there.</p>
      </div>
      ${tables.element}`,
    element,
  );
  parent.append(element);
  const map = createHeatmap(host, {
    name: "Map of the albedo",
    x: { ...N_AXIS, range: [0, 1] },
    y: { ...K_AXIS, range: [0, 1] },
    z: { title: "", kind: "size", print: short },
    onPick: (n_t, k_t) => actions.set({ n_t, k_t, material: null }),
  });

  /** @param {AlbedoMap} answer */
  function draw(answer) {
    const { show: shown } = answer;
    const fit = fits.find((f) => f.id === answer.fit);
    const claim = shown === "error" ? claimOf(fit) : undefined;
    const high = roundUp(Math.abs(answer.largest_in_domain?.value ?? 0));
    void map.draw(
      { x: answer.n_t, y: answer.k_t, z: answer.values },
      {
        name: fit ? `${fit.title}: ${WHAT[shown]}` : "Exact albedo",
        ids: fit && shown !== "exact" ? [fit.id] : [],
        x: { ...N_AXIS, range: ends(answer.n_t) },
        y: { ...K_AXIS, range: ends(answer.k_t) },
        z: {
          title: WHAT[shown],
          kind: shown === "error" ? "signed" : "size",
          print: shown === "error" ? short : six,
          level: claim?.claimed ?? null,
          ...(shown !== "error"
            ? { range: [0, 1] }
            : answer.largest_in_domain?.value && { range: [-high, high] }),
        },
        regions:
          shown === "exact" ? [] : answer.domains.map(({ n_t, k_t }) => ({ x: n_t, y: k_t })),
      },
    );
    const claimed = claim
      ? ` The line is at the claimed ${printError(claim.claimed ?? 0, false)}.`
      : "";
    setText(largest, sayLargest(answer) + claimed);
    drawn = true;
    tables.fill();
  }

  const changed = createChanged();
  return {
    /** @param {State} now @param {AlbedoMap | undefined} answer @param {readonly Fit[]} known @param {import('../page/trouble.js').Problem | undefined} problem */
    update(now, answer, known, problem) {
      if (known.length) fits = known;
      choices.update(now);
      select.element.hidden = now.map_show === "exact";
      select.update(mapFit(now), offered(fits));
      const { n, k } = mapRange(now);
      bounds.n.update(n);
      bounds.k.update(k);
      const moved = Object.keys(USUAL).some((name) => now[name] !== null);
      trouble.update(problem, now.map_fit !== null || moved);
      waiting.hidden = Boolean(answer) || Boolean(problem);
      if (!answer || fits.length === 0) return;
      if (changed(answer, fits)) draw(answer);
      map.marker(now.n_t, now.k_t);
    },
    theme: map.theme,
    destroy: map.destroy,
  };
}
