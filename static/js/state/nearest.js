/** What was meant by a word that is none of those allowed. */

const MOST_NAMED = 8;
const NEAREST = 3;

/** @param {string} a @param {string} b @returns {number} letters to insert, leave out or change */
export function distance(a, b) {
  let row = Array.from({ length: b.length + 1 }, (_, i) => i);
  for (let i = 1; i <= a.length; i += 1) {
    const next = [i];
    for (let j = 1; j <= b.length; j += 1)
      next.push(
        Math.min(
          (row[j] ?? 0) + 1,
          (next[j - 1] ?? 0) + 1,
          (row[j - 1] ?? 0) + (a[i - 1] === b[j - 1] ? 0 : 1),
        ),
      );
    row = next;
  }
  return row[b.length] ?? 0;
}

/**
 * The words allowed: all where they are few, else those spelled most like the one that was given.
 * @param {readonly string[]} options
 * @param {string} word
 */
export function allowedWords(options, word) {
  if (options.length <= MOST_NAMED) return `allowed is one of ${options.join(", ")}`;
  const given = word.slice(0, 40).toLowerCase();
  const far = new Map(options.map((one) => [one, distance(given, one.toLowerCase())]));
  const near = [...options].sort((a, b) => (far.get(a) ?? 0) - (far.get(b) ?? 0)).slice(0, NEAREST);
  return `it is none of the ${options.length} allowed; the nearest are ${near.join(", ")}`;
}
