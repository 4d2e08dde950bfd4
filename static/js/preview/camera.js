/** Where the scene is seen from, and where its balls are in the picture. */

/** What the camera turns about. */
const TARGET = /** @type {const} */ ([0, 0.72, 0]);
const DEG = Math.PI / 180;
/** Half the angle that the shorter side of the picture sees. */
const HALF_ANGLE = 19.5 * DEG;

/**
 * @typedef {object} Camera
 * @property {[number, number, number]} eye
 * @property {number[]} axes right, up, forward, one after the other
 * @property {number} lens tangent of half the angle that the shorter side sees
 */

/**
 * @param {{yaw: number, pitch: number, distance: number}} orbit angles in degrees; pitch is above the water
 * @returns {Camera}
 */
export function cameraAt({ yaw, pitch, distance }) {
  const [cy, sy] = [Math.cos(yaw * DEG), Math.sin(yaw * DEG)];
  const [cp, sp] = [Math.cos(pitch * DEG), Math.sin(pitch * DEG)];
  const forward = [-sy * cp, -sp, -cy * cp];
  const eye = TARGET.map((t, i) => t - distance * /** @type {number} */ (forward[i]));
  return {
    eye: /** @type {[number, number, number]} */ (eye),
    axes: [cy, 0, -sy, -sy * sp, cp, -cy * sp, ...forward],
    lens: Math.tan(HALF_ANGLE),
  };
}

/**
 * @param {Camera} camera
 * @param {number[]} point
 * @returns {[number, number, number]} along right, up and forward
 */
function seenAt({ eye, axes }, point) {
  const away = point.map((x, i) => x - /** @type {number} */ (eye[i]));
  /** @param {number} k */
  const along = (k) => away.reduce((sum, x, i) => sum + x * /** @type {number} */ (axes[k + i]), 0);
  return [along(0), along(3), along(6)];
}

/**
 * The pixels that a ball covers, as x, y, width, height from the lower left; null where none.
 * @param {Camera} camera
 * @param {{center: number[], radius: number}} ball
 * @param {readonly [number, number]} size
 * @returns {[number, number, number, number] | null}
 */
export function boundsOf(camera, { center, radius }, size) {
  const [x, y, z] = seenAt(camera, center);
  const near = z * z - radius * radius;
  if (z < 0 || near <= 0) return null;
  const unit = Math.min(...size) / 2 / camera.lens;
  /** @param {number} a @param {number} extent @returns {[number, number]} */
  const range = (a, extent) => {
    const spread = radius * Math.sqrt(a * a + near);
    const low = Math.floor(((a * z - spread) / near) * unit + extent / 2) - 2;
    const high = Math.ceil(((a * z + spread) / near) * unit + extent / 2) + 2;
    return [Math.max(0, low), Math.min(extent, high)];
  };
  const [left, right] = range(x, size[0]);
  const [low, high] = range(y, size[1]);
  return right > left && high > low ? [left, low, right - left, high - low] : null;
}

/**
 * The rectangle of the water that shows a ball, mirrored or below it; null where none does.
 * @param {Camera} camera
 * @param {{center: number[], radius: number}} ball
 * @param {readonly [number, number]} size
 * @returns {[number, number, number, number] | null}
 */
export function inWater(camera, { center, radius }, size) {
  const [x = 0, y = 0, z = 0] = center;
  // Ripples bend the picture, and what is below the water is lifted toward its surface.
  const wide = 1.12 * radius;
  const mirrored = boundsOf(camera, { center: [x, -y, z], radius: wide }, size);
  const below =
    y < radius ? boundsOf(camera, { center: [x, 0.6 * y, z], radius: wide }, size) : null;
  if (!mirrored || !below) return mirrored ?? below;
  const [left, low] = [Math.min(mirrored[0], below[0]), Math.min(mirrored[1], below[1])];
  const right = Math.max(mirrored[0] + mirrored[2], below[0] + below[2]);
  const high = Math.max(mirrored[1] + mirrored[3], below[1] + below[3]);
  return [left, low, right - left, high - low];
}

/** How far a ball's center is. @param {Camera} camera @param {{center: number[]}} ball */
export function distanceTo(camera, { center }) {
  return Math.hypot(...seenAt(camera, center));
}

/** Rows of pixels below the horizon. @param {Camera} camera @param {readonly [number, number]} size */
export function rowsBelow({ axes, lens }, size) {
  const slope = -(/** @type {number} */ (axes[7])) / /** @type {number} */ (axes[4]);
  const row = (slope / lens) * (Math.min(...size) / 2) + size[1] / 2;
  return Math.min(size[1], Math.max(0, Math.ceil(row - 0.5)));
}
