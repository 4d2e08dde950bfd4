/** The error of a fit over n and k, with what it was made for outlined. */

import { createChoice } from "../controls/panel.js";
import { short } from "../errors/metrics.js";
import { plain, six } from "../numbers/format.js";
import { h, setText } from "../page/dom.js";
import { createDataTables, createExports } from "../page/exports.js";
import { createTrouble } from "../page/trouble.js";
import { roundUp } from "../plot/cells.js";
import { createHeatmap } from "../plot/heatmap.js";
import { createBounds } from "./bounds.js";
import { printError } from "./claims.js";
import { mapFit, mapRange } from "./fields.js";

/**
 * @typedef {import('./answers.js').Fit} Fit
 * @typedef {import('./answers.js').AlbedoMap} AlbedoMap
 * @typedef {import('../page/trouble.js').Problem} Problem
 */

const WHAT = { error: "error", value: "albedo by the fit", exact: "exact albedo" };

/** The claim that a line on the map can show: absolute, and about metals. @param {Fit | undefined} fit */
export function claimOf(fit) {
  return fit?.claims.find(
    (c) => c.claimed !== null && !c.relative && c.domain.kind === "conductor",
  );
}

/** The boxes of a fit's domains that have an area, or at least a length, on a map. @param {AlbedoMap} map */
export function regionsOf({ domains }) {
  return domains.map(({ n_t, k_t }) => ({ x: n_t, y: k_t }));
}

/**
 * The range of a map that shows a fit's domains of metals whole; null where the page's own does.
 * @param {Fit | undefined} fit
 * @param {State} state
 */
export function rangeFor(fit, state) {
  const { n, k } = mapRange({
    ...state,
    map_n_low: null,
    map_n_high: null,
    map_k_low: null,
    map_k_high: null,
  });
  const metals = fit?.domains.filter((d) => d.kind === "conductor") ?? [];
  /** @param {number} end @param {number[]} reach */
  const beyond = (end, reach) => {
    const most = Math.max(...reach) * state.n_i;
    return metals.length && most > end ? most : null;
  };
  return {
    map_n_low: null,
    map_n_high: beyond(
      n[1],
      metals.map((d) => d.eta[1]),
    ),
    map_k_low: null,
    map_k_high: beyond(
      k[1],
      metals.map((d) => d.kappa[1]),
    ),
  };
}

/** @param {AlbedoMap} map @returns {string} */
export function sayLargest({ show, largest, largest_in_domain: inside, domains }) {
  /** @param {import('./answers.js').Largest | null} found */
  const words = (found) =>
    found
      ? `${(show === "error" ? short : six)(found.value)} at n = ${plain(found.n_t, 3)}, k = ${plain(found.k_t, 3)}`
      : "none";
  if (show === "exact") return `Largest ${words(largest)}.`;
  if (domains.length === 0) return `Largest error ${words(largest)}.`;
  const what = show === "error" ? "Largest error" : "Largest albedo";
  return inside
    ? `${what} in the outlined domain ${words(inside)}; on the whole map ${words(largest)}.`
    : `${what} on the map ${words(largest)}; the fit was not made for any of it.`;
}

/**
 * @param {HTMLElement} parent in the document: the map reads its colours and size from it
 * @param {object} options
 * @param {Pick<Actions, 'set'>} options.actions
 * @param {() => State} options.state
 * @param {(name: string, blob: Blob) => void} options.save
 */
export function createMap(parent, { actions, state, save }) {
  const show = createChoice({
    legend: "Shown",
    items: [
      { value: "error", label: "error" },
      { value: "value", label: "fit" },
      { value: "exact", label: "exact" },
    ],
    onChange: ([value]) => actions.set({ map_show: value }),
  });
  /** @type {readonly Fit[]} */
  let fits = [];
  const select = h("select", {
    class: "preset",
    "aria-label": "Fit of the map",
    onchange: () => {
      const fit = fits.find((f) => f.id === select.value);
      actions.set({ map_fit: select.value, ...rangeFor(fit, state()) });
    },
  });
  const picker = h("span", { class: "picker" }, select);
  const bounds = [
    createBounds({ letter: "n", names: ["map_n_low", "map_n_high"], onChange: actions.set }),
    createBounds({ letter: "k", names: ["map_k_low", "map_k_high"], onChange: actions.set }),
  ];
  const host = h("div", { class: "frame" });
  const waiting = h("p", { class: "figure-note" }, "…");
  const largest = h("p", { class: "largest" });
  const trouble = createTrouble("Back to the usual fit and range", () =>
    actions.set({
      map_fit: null,
      map_n_low: null,
      map_n_high: null,
      map_k_low: null,
      map_k_high: null,
    }),
  );
  const tables = createDataTables("This map as a table", {
    "Table of the map": () => (drawn.map ? [map.table()] : []),
  });
  const element = h(
    "section",
    { class: "column over-nk", "aria-label": "Error over n and k" },
    h(
      "div",
      { class: "heading" },
      h("h2", {}, "Over n and k"),
      createExports({
        what: "the map",
        name: () => "fresnel-albedo-map",
        make: (format) => map.exportAs(format),
        print: {
          figures: () => [map],
          call: "/albedo/map",
          behind: () => ({ state: state(), indices: ["n_i"] }),
        },
        save,
      }),
    ),
    h("div", { class: "map-controls" }, show.element, picker),
    h("div", { class: "map-host" }, host, waiting),
    trouble.element,
    largest,
    h(
      "div",
      { class: "figure-foot" },
      ...bounds.map((b) => b.element),
      h("p", { class: "hint" }, "Click to go there."),
    ),
    tables.element,
  );
  parent.append(element);
  const map = createHeatmap(host, {
    name: "Map of the albedo",
    x: { title: "second index n_t", short: "n_t", column: "n_t", range: [0, 1] },
    y: { title: "extinction k_t", short: "k_t", column: "k_t", range: [0, 1] },
    z: { title: "", kind: "size", print: short },
    onPick: (n_t, k_t) => actions.set({ n_t, k_t, material: null }),
  });

  /** @param {readonly Fit[]} next */
  function fill(next) {
    fits = next;
    /** @param {'conductor' | 'dielectric'} kind @param {string} label */
    const group = (kind, label) =>
      h(
        "optgroup",
        { label },
        ...fits
          .filter((f) => f.domains.some((d) => d.kind === "conductor") === (kind === "conductor"))
          .map((f) => h("option", { value: f.id }, f.title)),
      );
    select.replaceChildren(
      group("conductor", "for metals"),
      group("dielectric", "for clear media"),
    );
  }

  let drawn = { map: /** @type {AlbedoMap | null} */ (null), fits: /** @type {unknown} */ (null) };
  /** @param {AlbedoMap} answer */
  function draw(answer) {
    const fit = fits.find((f) => f.id === answer.fit);
    const claim = answer.show === "error" ? claimOf(fit) : undefined;
    const inside = Math.abs(answer.largest_in_domain?.value ?? 0);
    const high = inside > 0 ? roundUp(inside) : null;
    const range = { x: ends(answer.n_t), y: ends(answer.k_t) };
    void map.draw(
      { x: answer.n_t, y: answer.k_t, z: answer.values },
      {
        name: fit ? `${fit.title}: ${WHAT[answer.show]}` : "Exact albedo",
        ids: fit && answer.show !== "exact" ? [fit.id] : [],
        x: { title: "second index n_t", short: "n_t", column: "n_t", range: range.x },
        y: { title: "extinction k_t", short: "k_t", column: "k_t", range: range.y },
        z: {
          title: WHAT[answer.show],
          kind: answer.show === "error" ? "signed" : "size",
          print: answer.show === "error" ? short : six,
          level: claim?.claimed ?? null,
          ...(answer.show !== "error"
            ? { range: [0, 1] }
            : high !== null && { range: [-high, high] }),
        },
        regions: answer.show === "exact" ? [] : regionsOf(answer),
      },
    );
    const claimed = claim
      ? ` The line is at the claimed ${printError(claim.claimed ?? 0, false)}.`
      : "";
    setText(largest, sayLargest(answer) + claimed);
    tables.fill();
  }

  return {
    /** @param {State} now @param {AlbedoMap | undefined} answer @param {readonly Fit[]} nextFits @param {Problem | undefined} problem */
    update(now, answer, nextFits, problem) {
      if (nextFits.length && nextFits !== fits) fill(nextFits);
      show.update([now.map_show]);
      picker.hidden = now.map_show === "exact";
      select.value = mapFit(now);
      const { n, k } = mapRange(now);
      bounds[0]?.update(n);
      bounds[1]?.update(k);
      trouble.update(
        problem,
        [now.map_fit, now.map_n_low, now.map_n_high, now.map_k_low, now.map_k_high].some(
          (v) => v !== null,
        ),
      );
      waiting.hidden = Boolean(answer) || Boolean(problem);
      if (!answer || fits.length === 0) return;
      if (answer !== drawn.map || fits !== drawn.fits) {
        draw(answer);
        drawn = { map: answer, fits };
      }
      map.marker(now.n_t, now.k_t);
    },
    theme: () => map.theme(),
    destroy: () => map.destroy(),
  };
}

/** @param {readonly number[]} values @returns {[number, number]} */
function ends(values) {
  return [values[0] ?? 0, values.at(-1) ?? 1];
}
