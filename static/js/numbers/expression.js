/** Numbers as people type them: 1/1.5, sqrt(2), 2*1.33, 3e-2, 1,5, 56.3°, 1.2 rad. */

export class ExpressionError extends Error {}

const TOKEN = /\s*(?:((?:\d*,\d+|\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)|(sqrt|pi|√|π)|([-+*/^()]))/iy;

/** @param {string} text @returns {(number | string)[]} */
function tokens(text) {
  const clean = text.replace(/[−–]/g, "-").replace(/[×·]/g, "*").replace(/÷/g, "/").trim();
  /** @type {(number | string)[]} */
  const found = [];
  TOKEN.lastIndex = 0;
  while (TOKEN.lastIndex < clean.length) {
    const match = TOKEN.exec(clean);
    if (!match)
      throw new ExpressionError("it is no number and no expression such as 1/1.5 or sqrt(2)");
    if (match[1] !== undefined) found.push(Number(match[1].replace(",", ".")));
    else
      found.push(
        (match[2] ?? match[3] ?? "").toLowerCase().replace("√", "sqrt").replace("π", "pi"),
      );
  }
  return found;
}

/**
 * Evaluate an arithmetic expression of numbers, + - * / ^, parentheses, sqrt and pi.
 * @param {string} text
 * @returns {number} a finite number
 * @throws {ExpressionError} if the text is no such expression or has no finite value
 */
export function evaluate(text) {
  const queue = tokens(text);
  if (queue.length === 0) throw new ExpressionError("it is empty");
  let at = 0;

  /** @returns {number} */
  function sum() {
    let value = product();
    while (queue[at] === "+" || queue[at] === "-") {
      value = queue[at++] === "+" ? value + product() : value - product();
    }
    return value;
  }
  /** @returns {number} */
  function product() {
    let value = sign();
    while (queue[at] === "*" || queue[at] === "/") {
      value = queue[at++] === "*" ? value * sign() : value / sign();
    }
    return value;
  }
  /** @returns {number} */
  function sign() {
    if (queue[at] === "-") {
      at += 1;
      return -sign();
    }
    if (queue[at] === "+") {
      at += 1;
      return sign();
    }
    return power();
  }
  /** @returns {number} */
  function power() {
    const base = atom();
    if (queue[at] !== "^") return base;
    at += 1;
    return base ** sign();
  }
  /** @returns {number} */
  function atom() {
    const token = queue[at++];
    if (typeof token === "number") return token;
    if (token === "pi") return Math.PI;
    if (token === "sqrt") return Math.sqrt(atom());
    if (token === "(") {
      const value = sum();
      if (queue[at++] !== ")") throw new ExpressionError("a parenthesis is not closed");
      return value;
    }
    throw new ExpressionError("it ends too early or two signs stand together");
  }

  const value = sum();
  if (at < queue.length) throw new ExpressionError("something is left over at its end");
  if (!Number.isFinite(value)) throw new ExpressionError("it has no finite value");
  return value;
}

/**
 * An angle: an expression in the page's unit, or with a unit of its own (°, deg, rad).
 * @param {string} text
 * @param {'deg' | 'rad'} unit
 * @returns {{value: number, unit: 'deg' | 'rad'}}
 */
export function evaluateAngle(text, unit) {
  const match = /^(.*?)\s*(°|deg|rad)$/i.exec(text.trim());
  if (!match) return { value: evaluate(text), unit };
  return {
    value: evaluate(match[1] ?? ""),
    unit: match[2]?.toLowerCase() === "rad" ? "rad" : "deg",
  };
}
