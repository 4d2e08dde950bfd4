/**
 * Moving the incident ray by pointer and by keys.
 *
 * The handle and the ray can be taken by any pointer; a mouse may also press anywhere above the
 * surface. A finger elsewhere scrolls the page.
 */

import { angleAt } from "./geometry.js";

/**
 * @typedef {object} DragActions
 * @property {(theta_i_deg: number, how: {fine: boolean, free: boolean}) => void} onTheta
 * @property {() => void} [onSettle]
 * @property {(kind: "+" | "-" | "fine+" | "fine-" | "page+" | "page-" | "home" | "end") => void} [onStep]
 */

/** With Shift the ray turns by this share of the pointer's turn. */
const FINE = 0.1;

/**
 * @param {object} task
 * @param {HTMLElement} task.host
 * @param {HTMLElement} task.handle
 * @param {SVGElement} task.grip
 * @param {() => import("./geometry.js").Stage} task.stage
 * @param {() => number} task.theta
 * @param {DragActions} task.actions
 * @returns {() => void} stop listening
 */
export function listenForDrags({ host, handle, grip, stage, theta, actions }) {
  const listening = new AbortController();
  const { signal } = listening;
  /** @type {{id: number, from: number, pointer: number, fine: boolean} | null} */
  let held = null;

  /** @param {PointerEvent} event */
  const pointed = (event) => {
    const bounds = host.getBoundingClientRect();
    return angleAt(stage(), { x: event.clientX - bounds.left, y: event.clientY - bounds.top });
  };

  host.addEventListener(
    "pointerdown",
    (event) => {
      if (!event.isPrimary || event.button !== 0) return;
      const taken = event.target === handle || event.target === grip;
      const { y } = stage();
      const above = event.clientY - host.getBoundingClientRect().top < y;
      if (!taken && (event.pointerType === "touch" || !above)) return;
      host.setPointerCapture(event.pointerId);
      handle.focus({ preventScroll: true });
      event.preventDefault();
      host.toggleAttribute("data-dragging", true);
      const pointer = pointed(event);
      // The handle stays under the point where it was taken; elsewhere the ray comes to the pointer.
      held = {
        id: event.pointerId,
        from: taken ? theta() : pointer,
        pointer,
        fine: event.shiftKey,
      };
      if (!taken) actions.onTheta(pointer, { fine: event.shiftKey, free: event.altKey });
    },
    { signal },
  );

  host.addEventListener(
    "pointermove",
    (event) => {
      if (!held || event.pointerId !== held.id) return;
      const pointer = pointed(event);
      if (event.shiftKey !== held.fine) {
        held = { id: held.id, from: theta(), pointer, fine: event.shiftKey };
      }
      const turned = (pointer - held.pointer) * (held.fine ? FINE : 1);
      const value = Math.min(90, Math.max(0, held.from + turned));
      actions.onTheta(value, { fine: event.shiftKey, free: event.altKey });
    },
    { signal },
  );

  /** @param {PointerEvent} event */
  const release = (event) => {
    if (!held || event.pointerId !== held.id) return;
    held = null;
    host.removeAttribute("data-dragging");
    actions.onSettle?.();
  };
  host.addEventListener("pointerup", release, { signal });
  host.addEventListener("pointercancel", release, { signal });

  /** @param {KeyboardEvent} event */
  const kindOf = (event) => {
    const arrow = event.shiftKey ? "fine" : "";
    /** @type {Record<string, string>} */
    const kinds = {
      ArrowRight: `${arrow}+`,
      ArrowUp: `${arrow}+`,
      ArrowLeft: `${arrow}-`,
      ArrowDown: `${arrow}-`,
      PageUp: "page+",
      PageDown: "page-",
      Home: "home",
      End: "end",
    };
    return /** @type {Parameters<NonNullable<DragActions["onStep"]>>[0] | undefined} */ (
      kinds[event.key]
    );
  };
  handle.addEventListener(
    "keydown",
    (event) => {
      const kind = kindOf(event);
      if (!kind || event.ctrlKey || event.metaKey) return;
      event.preventDefault();
      actions.onStep?.(kind);
    },
    { signal },
  );
  handle.addEventListener(
    "keyup",
    (event) => {
      if (kindOf(event)) actions.onSettle?.();
    },
    { signal },
  );
  return () => listening.abort();
}
