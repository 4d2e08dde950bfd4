/** Play: a value sweeps back and forth between the ends of its slider. */

const SWEEP_SECONDS = 8;
const STILL_STEPS = 24; // with reduced motion the sweep goes in so many visible steps

/** @param {PlayerOptions} options */
export function createPlayer({ now, onValue, onPlaying }) {
  let frame = 0;
  let direction = 1;
  let speed = 1;
  let last = 0;
  let position = 0;
  let shown = Number.NaN;

  /** @param {number} time */
  function tick(time) {
    const { value, low, high, fine } = now();
    // The user moved it meanwhile: go on from there.
    if (value !== shown) position = value;
    const elapsed = Math.min(0.1, (time - last) / 1000);
    const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
    if (still && time - last < 500) {
      frame = requestAnimationFrame(tick);
      return;
    }
    last = time;
    const stride = still
      ? (high - low) / STILL_STEPS
      : (elapsed * speed * (high - low)) / SWEEP_SECONDS;
    position += direction * stride;
    if (position >= high) {
      position = high;
      direction = -1;
    } else if (position <= low) {
      position = low;
      direction = 1;
    }
    shown = Math.min(high, Math.max(low, Number((Math.round(position / fine) * fine).toFixed(9))));
    if (shown !== value) onValue(shown);
    frame = requestAnimationFrame(tick);
  }

  function stop() {
    if (!frame) return;
    cancelAnimationFrame(frame);
    frame = 0;
    onPlaying(false);
  }

  return {
    toggle() {
      if (frame) {
        stop();
        return;
      }
      last = performance.now();
      shown = now().value;
      position = shown;
      frame = requestAnimationFrame(tick);
      onPlaying(true);
    },
    stop,
    /** @param {number} factor */
    setSpeed(factor) {
      speed = factor;
    },
  };
}
