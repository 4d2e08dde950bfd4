/** Whether what a picture is made from has changed since it was last asked. */

/** @returns {(...now: unknown[]) => boolean} true at first, and whenever one of the values is another */
export function createChanged() {
  /** @type {unknown[] | null} */
  let before = null;
  return (...now) => {
    const same = now.length === before?.length && now.every((value, i) => value === before?.[i]);
    before = now;
    return !same;
  };
}
