/** Names of marks in the rows above the frame: centred on their line, none over another. */

import { overlap } from "../draw/boxes.js";

const ROW = 17;
const APART = 8;

/**
 * @param {object} task
 * @param {readonly {x: number, width: number}[]} task.marks `x` in px
 * @param {import("../draw/boxes.js").Box} task.frame
 * @param {number} [task.unit]
 * @param {number} task.reserved px at the left of the lower row that the axis title takes
 * @returns {({x: number, y: number} | null)[]} centre of each name, null where there is no room
 */
export function placeMarkNames({ marks, frame, reserved, unit = 1 }) {
  const height = ROW * unit;
  const left = frame.x - 8;
  const right = frame.x + frame.width + 14;
  /** @type {import("../draw/boxes.js").Box[]} */
  const taken = [{ x: 0, y: frame.y - height - 4, width: reserved + APART, height }];
  return marks.map(({ x, width }) => {
    const most = right - width;
    for (const row of [0, 1]) {
      const y = frame.y - height * (row + 1) - 3;
      // centred, then to the left of the line, then to its right
      for (const start of [x - width / 2, x - width + 4, x - 4]) {
        const box = { x: Math.min(Math.max(start, left), most), y, width, height };
        const free = taken.every(
          (other) => !overlap({ ...box, x: box.x - APART, width: width + 2 * APART }, other),
        );
        if (free && box.x >= left) {
          taken.push(box);
          return { x: box.x + width / 2, y: y + height / 2 };
        }
      }
    }
    return null;
  });
}
