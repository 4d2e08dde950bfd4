/**
 * The index of a mystery material as a short code: not a secret, but nothing that a reader sees by
 * accident. n and k are whole thousandths, multiplied modulo a prime.
 */

const PRIME = 2147483647n;
const FACTOR = 48271n;
const STEPS = 1000;
const MOST = { n: 10, k: 20 };
const ROOM = BigInt(MOST.k * STEPS + 1);

/** The factor's inverse, by Fermat's little theorem. */
const INVERSE = power(FACTOR, PRIME - 2n);

/** @param {bigint} base @param {bigint} exponent */
function power(base, exponent) {
  let result = 1n;
  for (let square = base, rest = exponent; rest > 0n; rest >>= 1n) {
    if (rest & 1n) result = (result * square) % PRIME;
    square = (square * square) % PRIME;
  }
  return result;
}

/**
 * @typedef {{n: number, k: number}} Index
 * @param {Index} index n from 0.01 to 10, k from 0 to 20
 * @returns {string}
 */
export function encode({ n, k }) {
  const packed = BigInt(Math.round(n * STEPS)) * ROOM + BigInt(Math.round(k * STEPS));
  return ((packed * FACTOR) % PRIME).toString(36);
}

/** @param {string} code @returns {Index | null} null for what is no code */
export function decode(code) {
  if (!/^[0-9a-z]{1,6}$/.test(code)) return null;
  const packed = (BigInt(Number.parseInt(code, 36)) * INVERSE) % PRIME;
  const index = { n: Number(packed / ROOM) / STEPS, k: Number(packed % ROOM) / STEPS };
  const known = index.n >= 0.01 && index.n <= MOST.n && index.k <= MOST.k;
  return known && encode(index) === code ? index : null;
}
