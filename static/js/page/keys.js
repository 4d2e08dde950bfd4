/** The keys that work everywhere. What they open is loaded when it is first asked for. */

const WRITTEN_IN = "input:not([type=range], [type=checkbox], [type=radio]), textarea, select";

/**
 * @typedef {object} Orders
 * @property {() => void} find
 * @property {() => void} help
 * @property {() => void} undo
 * @property {() => void} redo
 * @param {Orders} orders
 */
export function listenForKeys(orders) {
  /** The box that holds something not yet taken over: its own undo comes first. @type {EventTarget | null} */
  let draft = null;
  document.addEventListener("input", ({ target }) => {
    draft = target;
  });
  for (const end of ["change", "focusout"])
    document.addEventListener(end, () => {
      draft = null;
    });

  document.addEventListener("keydown", (event) => {
    if (event.key === "Enter") draft = null;
    if (event.defaultPrevented || event.altKey) return;
    const order = orderOf(event, draft);
    if (!order || document.querySelector("dialog[open]")) return;
    event.preventDefault();
    orders[order]();
  });
}

/** @param {KeyboardEvent} event @param {EventTarget | null} draft @returns {keyof Orders | null} */
function orderOf(event, draft) {
  const { target } = event;
  const key = event.key.toLowerCase();
  if (event.ctrlKey || event.metaKey) {
    if (key === "k" && !event.shiftKey) return "find";
    if (draft !== null && draft === target && /** @type {Element} */ (target).matches(WRITTEN_IN))
      return null;
    if (key === "z") return event.shiftKey ? "redo" : "undo";
    return key === "y" && !event.shiftKey ? "redo" : null;
  }
  const writing = target instanceof Element && target.matches(WRITTEN_IN);
  return key === "?" && !writing ? "help" : null;
}
