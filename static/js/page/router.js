/** Which view is open, and the way from an address to it. */

import { inTodaysWords } from "../state/state.js";

/** @param {RouterOptions} options */
export function createRouter({
  views,
  load,
  make,
  state,
  catalog,
  presets,
  onLeave,
  onFailure,
  onArrival,
}) {
  /** @type {Map<string, Opened>} */
  const opened = new Map();
  /** @type {string | null} */
  let active = null;
  /** @type {{id: string, again: () => Promise<void>} | null} */
  let failed = null;
  /** How many addresses were set out for: the last one counts. */
  let arrivals = 0;

  const current = () => (active === null ? undefined : opened.get(active));

  /** @param {string | null} id */
  function showOnly(id) {
    for (const [key, { host }] of opened) host.hidden = key !== id;
  }

  /** @param {ViewModule} module */
  function learn(module) {
    const fields = module.fields(catalog);
    state.extend(fields);
    for (const [key, field] of Object.entries(fields)) presets[key] = field.default;
  }

  /** @param {string} id @param {string} href that leads there @param {() => Promise<void>} again */
  function fail(id, href, again) {
    active = null; // so that it can be opened again
    failed = { id, again };
    showOnly(null);
    onFailure(id, href, again);
  }

  /**
   * @param {string} id
   * @param {string} href
   * @param {() => Promise<void>} again what "Try again" does
   * @returns {Promise<boolean>} whether it is open now
   */
  async function open(id, href, again) {
    if (active === id) return true;
    current()?.view.deactivate();
    active = id;
    failed = null;
    onLeave(id);
    if (!opened.has(id)) {
      const module = await load(id).catch(() => null);
      // Another tab may have been chosen while this one loaded, and this one again.
      if (active !== id) return false;
      if (!module) {
        fail(id, href, again);
        return false;
      }
      if (!opened.has(id)) {
        learn(module);
        opened.set(id, { module, ...make(id, module) });
      }
    }
    showOnly(id);
    return true;
  }

  /**
   * Become what an address says. Its view is fetched first: the address and the state change as one.
   * @param {string} href
   * @param {{anew?: boolean}} [options] whether it is a further page of the history
   * @returns {Promise<void>}
   */
  async function arrive(href, { anew = false } = {}) {
    arrivals += 1;
    const arrival = arrivals;
    const again = () => arrive(href, { anew });
    const search = inTodaysWords(new URL(href, location.href).search);
    const asked = new URLSearchParams(search);
    const { id } = /** @type {{id: string}} */ (
      views.find((v) => v.id === asked.get("view")) ?? views[0]
    );
    if (!(await open(id, href, again))) return;
    // A link made after a visit to other views carries their state too.
    if ([...asked.keys()].some((key) => !(key in state.get()))) {
      const all = await Promise.all(views.map((v) => load(v.id))).catch(() => null);
      if (arrival !== arrivals) return;
      if (!all) {
        fail(id, href, again);
        return;
      }
      all.forEach(learn);
    }
    if (arrival !== arrivals) return;
    if (anew) history.pushState(null, "", href);
    onArrival(state.fromQuery(search));
  }

  return {
    current,
    arrive,
    /** @returns {Iterable<Opened>} all that were opened so far */
    all: () => opened.values(),
    /** Follow the state, which names another view. */
    async follow() {
      const { view } = state.get();
      if (view !== active) await open(view, location.href, () => arrive(location.href));
    },
    /** A tab is chosen: a link that is under way is not waited for any more. @param {string} id */
    choose(id) {
      arrivals += 1;
      if (failed?.id === id) void failed.again();
      else state.set({ view: id });
    },
  };
}
