/** Getting a text from the server: by the page itself at first, by a worker once that is up. */

/** @typedef {{status: number, text: string}} Answer a status of 0 says that the server is out of reach */
/** @typedef {(url: string, signal?: AbortSignal) => Promise<Answer>} Transport */

/** The worker starts when the page stands: it is for what moves, and would slow down what loads. */
const START_AFTER = 800;

/** @type {Transport} */
async function direct(url, signal) {
  try {
    const response = await fetch(url, signal ? { signal } : {});
    return { status: response.status, text: await response.text() };
  } catch (error) {
    if (error instanceof DOMException && error.name === "AbortError") throw error;
    return { status: 0, text: "" };
  }
}

/**
 * @param {Worker} worker
 * @returns {Transport}
 */
function through(worker) {
  let last = 0;
  /** @type {Map<number, (answer: Answer) => void>} */
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

/** @type {Transport} */
let transport = direct;

/** @type {Transport} */
export const get = (url, signal) => transport(url, signal);

/** Hand the asking over to a worker, soon and where there are any. */
export function startWorker() {
  if (typeof Worker === "undefined") return;
  setTimeout(() => {
    const worker = new Worker(new URL("fetcher.js", import.meta.url), { type: "module" });
    worker.addEventListener(
      "message",
      () => {
        transport = through(worker);
      },
      { once: true },
    );
    worker.addEventListener("error", () => {
      transport = direct;
    });
  }, START_AFTER);
}
