/** Getting a text from the server by a worker, once that is up. */

/**
 * @param {Worker} worker
 * @returns {Transport}
 */
export function through(worker) {
  let last = 0;
  /** @type {Map<number, (answer: Received) => void>} */
  const waiting = new Map();
  worker.addEventListener("message", ({ data: { id, status, text } }) => {
    waiting.get(id)?.({ status, text });
    waiting.delete(id);
  });
  worker.addEventListener("error", () => {
    for (const answer of waiting.values()) answer({ status: 0, text: "" });
    waiting.clear();
  });
  return (url, signal) =>
    new Promise((resolve, reject) => {
      last += 1;
      const id = last;
      waiting.set(id, resolve);
      worker.postMessage({ id, url: new URL(url, document.baseURI).href });
      signal?.addEventListener("abort", () => {
        waiting.delete(id);
        worker.postMessage({ id });
        reject(signal.reason);
      });
    });
}
