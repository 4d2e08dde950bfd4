/** sRGB's encoding of linear light, and the way back (IEC 61966-2-1). */

/** @param {number} c linear, from 0 to 1 */
export const encoded = (c) => (c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055);

/** @param {number} c encoded, from 0 to 1 */
export const decoded = (c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
