/** What the server's answers about errors hold, in the words of this view. */

/**
 * @typedef {import('./metrics.js').Row} Row
 * @typedef {{model: string, over: string, x: number[], metrics: Record<string, (number | null)[]>}} Sweep
 * @typedef {{model: string, metric: string, pointwise: boolean, x: number[], y: number[], z: (number | null)[][]}} ErrorMap
 * @typedef {{model: string, title: string, weighted_cost: number, parameters: Record<string, number | null>,
 *   figures: Record<string, number | null> | null, reason: string | null}} Candidate
 */

/** @param {any} answer of /errors @returns {Row[]} */
export function rowsOf(answer) {
  return answer?.errors ?? [];
}

/** @param {any} answer of /errors/sweep @returns {Sweep} */
export function sweepOf(answer) {
  return { model: answer.model, over: answer.over, x: answer.values, metrics: answer };
}

/** @param {any} answer of /errors/map @returns {ErrorMap} */
export function mapOf(answer) {
  return {
    model: answer.model,
    metric: answer.metric,
    pointwise: answer.x.name === "theta_i_deg",
    x: answer.x.values,
    y: answer.y.values,
    z: answer.values,
  };
}

/** @param {any} answer of /recommend @returns {{good: Candidate[], bad: Candidate[]}} */
export function candidatesOf(answer) {
  return { good: answer?.models ?? [], bad: answer?.refused ?? [] };
}
