/**
 * Choosing an abscissa on a plot, by pointer or by keyboard.
 *
 * A mouse picks where it is pressed and wherever it is dragged. A finger may as well be scrolling
 * the page: it picks when it is lifted in place, or once it has moved sideways.
 */

const SIDEWAYS = 6;
const BESIDE = 12;

/**
 * @param {object} task
 * @param {HTMLElement} task.area
 * @param {HTMLElement} task.handle
 * @param {() => Arrangement | null} task.arrangement
 * @param {() => number | null} task.current
 * @param {() => {step: number, fine: number, page: number}} task.steps
 * @param {OnPick} task.onPick
 * @param {(picking: boolean) => void} task.onActive
 * @returns {() => void} stop listening
 */
export function listenForPicks({ area, handle, arrangement, current, steps, onPick, onActive }) {
  const listening = new AbortController();
  const { signal } = listening;
  /** @type {{id: number, x: number, y: number, waiting: boolean} | null} */
  let grip = null;

  /** @param {number} value @param {Arrangement} layout */
  const inRange = (value, { ranges }) =>
    Math.min(Math.max(value, Math.min(...ranges.x)), Math.max(...ranges.x));

  let lastX = 0;
  /** @param {PointerEvent} event @param {boolean} settled */
  const pick = (event, settled) => {
    const layout = arrangement();
    if (!layout) return;
    // a cancelled pointer has no position of its own
    if (event.type !== "pointercancel") lastX = event.clientX;
    const value = layout.xValue(lastX - area.getBoundingClientRect().left);
    onPick(inRange(value, layout), { settled, fine: event.shiftKey, free: event.altKey });
  };

  area.addEventListener(
    "pointerdown",
    (event) => {
      const layout = arrangement();
      if (!layout || !event.isPrimary || event.button !== 0) return;
      const bounds = area.getBoundingClientRect();
      const x = event.clientX - bounds.left;
      const { frame } = layout;
      const y = event.clientY - bounds.top;
      if (x < frame.x - BESIDE || x > frame.x + frame.width + BESIDE || y < frame.y - BESIDE)
        return;
      const waiting = event.pointerType === "touch" && event.target !== handle;
      grip = { id: event.pointerId, x: event.clientX, y: event.clientY, waiting };
      if (waiting) return;
      area.setPointerCapture(event.pointerId);
      onActive(true);
      handle.focus({ preventScroll: true });
      event.preventDefault();
      pick(event, false);
    },
    { signal },
  );

  area.addEventListener(
    "pointermove",
    (event) => {
      if (!grip || event.pointerId !== grip.id) return;
      if (grip.waiting) {
        if (Math.abs(event.clientX - grip.x) < SIDEWAYS) return;
        grip.waiting = false;
        area.setPointerCapture(event.pointerId);
        onActive(true);
      }
      pick(event, false);
    },
    { signal },
  );

  /** @param {PointerEvent} event */
  const release = (event) => {
    if (!grip || event.pointerId !== grip.id) return;
    const scrolled = grip.waiting && event.type !== "pointerup";
    grip = null;
    onActive(false);
    if (!scrolled) pick(event, true);
  };
  area.addEventListener("pointerup", release, { signal });
  area.addEventListener("pointercancel", release, { signal });

  handle.addEventListener(
    "keydown",
    (event) => {
      const layout = arrangement();
      const from = current();
      if (!layout || from === null || event.ctrlKey || event.metaKey) return;
      const { step, fine, page } = steps();
      const arrow = event.shiftKey ? fine : step;
      /** @type {Record<string, number>} */
      const targets = {
        ArrowLeft: from - arrow,
        ArrowDown: from - arrow,
        ArrowRight: from + arrow,
        ArrowUp: from + arrow,
        PageDown: from - page,
        PageUp: from + page,
        Home: Number.NEGATIVE_INFINITY,
        End: Number.POSITIVE_INFINITY,
      };
      const target = targets[event.key];
      if (target === undefined) return;
      event.preventDefault();
      const value = Number(inRange(target, layout).toPrecision(12));
      onPick(value, { settled: true, fine: event.shiftKey, free: true });
    },
    { signal },
  );
  return () => listening.abort();
}
