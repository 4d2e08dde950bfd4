/** Pictures that are drawn anew where their frame changes its size, and know it without asking for a layout. */

/**
 * @param {HTMLElement} frame
 * @param {() => void} draw in the next frame, once however often the size changes before
 * @returns {{size: Size, stop: () => void}} its size, px, nothing before it stands on the page
 */
export function onResize(frame, draw) {
  /** @type {Size} */
  const size = { width: 0, height: 0 };
  let waiting = 0;
  const observer = new ResizeObserver(() => {
    size.width = frame.clientWidth;
    size.height = frame.clientHeight;
    cancelAnimationFrame(waiting);
    waiting = requestAnimationFrame(draw);
  });
  observer.observe(frame);
  return {
    size,
    stop() {
      cancelAnimationFrame(waiting);
      observer.disconnect();
    },
  };
}
