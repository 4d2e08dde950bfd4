/** Steps back and forth over the state. They are not the browser's: each is a further page of its history. */

/** @typedef {import('./state.js').StateStore} StateStore */

const MOST = 200;

/** @param {Pick<StateStore, 'get' | 'set' | 'defaults' | 'subscribe' | 'toQuery'>} state */
export function createUndo(state) {
  /** @type {Record<string, any>[]} */
  let past = [];
  /** @type {Record<string, any>[]} */
  let future = [];
  let now = state.get();
  let link = state.toQuery();
  let stepping = false;

  state.subscribe((next, moving) => {
    if (moving) return; // a gesture is one step
    const text = state.toQuery();
    if (text !== link && !stepping) {
      past = [...past.slice(1 - MOST), now];
      future = [];
    }
    // What is implied (a preset's index at another wavelength) may be news without being a step.
    now = next;
    link = text;
  });

  /** @param {Record<string, any>[]} from @param {Record<string, any>[]} to @returns {boolean} whether there was one */
  function step(from, to) {
    const target = from.pop();
    if (!target) return false;
    to.push(now);
    stepping = true;
    try {
      // Views that were opened since have brought fields of their own.
      state.set({ ...state.defaults(), ...target });
    } finally {
      stepping = false;
    }
    return true;
  }

  return {
    undo: () => step(past, future),
    redo: () => step(future, past),
    depth: () => ({ past: past.length, future: future.length }),
  };
}
