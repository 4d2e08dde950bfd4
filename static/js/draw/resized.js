/** Pictures that are drawn anew where their frame changes its size. */

/**
 * @param {Element} frame
 * @param {() => void} draw in the next frame, once however often the size changes before
 * @returns {() => void} ends it
 */
export function onResize(frame, draw) {
  let waiting = 0;
  const observer = new ResizeObserver(() => {
    cancelAnimationFrame(waiting);
    waiting = requestAnimationFrame(draw);
  });
  observer.observe(frame);
  return () => {
    cancelAnimationFrame(waiting);
    observer.disconnect();
  };
}
