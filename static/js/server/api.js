/** The only module that talks to the server. */

export const BASE = "api/v1";

/** @type {(since: Date | null) => void} */
let tellKept = () => {};
/** @type {Date | null} */
let kept = null;

/**
 * @param {(since: Date | null) => void} listener is told the date of an answer that was kept, given because
 *   the server does not answer, and null when it answers again
 */
export function onKept(listener) {
  tellKept = listener;
  if (kept) listener(kept);
}

/** What was kept of an answer, if it was. @param {string} url @returns {Promise<any>} */
async function keptBody(url) {
  try {
    const answer = await (await import("./offline.js")).keptAnswer(url);
    if (!answer) return null;
    const body = JSON.parse(answer.text);
    if (!kept) tellKept(answer.since);
    kept ??= answer.since;
    return body;
  } catch {
    return null; // nothing can be loaded, not even what is kept
  }
}

/** An error answer (RFC 9457), a broken connection, or an answer that cannot be read. */
export class Problem extends Error {
  /**
   * @param {string} title
   * @param {{status?: number, detail?: string, errors?: {parameter?: string, value?: unknown, message: string}[]}} [rest]
   */
  constructor(title, { status = 0, detail = "", errors = [] } = {}) {
    super(title);
    this.title = title;
    this.status = status;
    this.detail = detail;
    this.errors = errors;
  }
}

/**
 * @param {string} path below the API's prefix, with its leading slash
 * @param {AbortSignal} [signal]
 * @returns {Promise<any>}
 */
export async function load(path, signal) {
  const { status, text } = await get(`${BASE}${path}`, signal);
  if (status === 0) {
    const old = await keptBody(`${BASE}${path}`);
    if (old !== null) return old;
    throw new Problem("The server does not answer", {
      detail: "Is it running, and are you online?",
    });
  }
  if (kept) tellKept(null);
  kept = null;
  let body = null;
  try {
    body = JSON.parse(text);
  } catch {
    // what is wrong with it is said below
  }
  if (status < 200 || status > 299) {
    throw new Problem(body?.title ?? `The server answered ${status}`, {
      status,
      detail: body?.detail ?? "",
      errors: Array.isArray(body?.errors) ? body.errors : [],
    });
  }
  if (body === null) throw new Problem("The server's answer cannot be read", { status });
  return body;
}

/**
 * A question that is asked again and again while something moves: one request is in flight, of those
 * that wait only the newest is kept, and a request that is slow while a newer one waits is aborted.
 * @param {object} options
 * @param {(data: any, path: string) => void} options.onAnswer
 * @param {(problem: Problem) => void} options.onProblem
 * @param {(busy: boolean) => void} [options.onBusy]
 * @param {(path: string, signal?: AbortSignal) => Promise<any>} [options.get]
 * @param {number} [options.patience] ms that a stale request may still take
 */
export function createQuery({
  onAnswer,
  onProblem,
  onBusy = () => {},
  get = load,
  patience = 300,
}) {
  /** @type {{path: string, started: number, abort: AbortController} | null} */
  let flight = null;
  /** @type {string | null} */
  let waiting = null;
  /** @type {string | null} */
  let answered = null;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;

  /** @param {string} path */
  async function send(path) {
    const own = { path, started: Date.now(), abort: new AbortController() };
    flight = own;
    onBusy(true);
    try {
      const data = await get(path, own.abort.signal);
      if (flight !== own) return;
      answered = path;
      onAnswer(data, path);
    } catch (error) {
      if (flight !== own) return;
      // A newer question waits: what went wrong with this one is of no interest.
      if (waiting === null) {
        answered = null;
        onProblem(
          error instanceof Problem
            ? error
            : new Problem("The answer could not be shown", { detail: String(error) }),
        );
      }
    }
    next();
  }

  function next() {
    clearTimeout(timer);
    flight = null;
    const path = waiting;
    waiting = null;
    if (path === null || path === answered) onBusy(false);
    else void send(path);
  }

  return {
    /** @param {string} path */
    request(path) {
      if (!flight) {
        if (path !== answered) void send(path);
        return;
      }
      if (flight.path === path) {
        waiting = null;
        clearTimeout(timer);
        return;
      }
      if (waiting === null) {
        const stale = flight;
        timer = setTimeout(
          () => {
            if (flight !== stale) return;
            stale.abort.abort();
            next();
          },
          Math.max(0, patience - (Date.now() - flight.started)),
        );
      }
      waiting = path;
    },

    /** Forget what is asked and what was answered; the next request is sent in any case. */
    cancel() {
      clearTimeout(timer);
      flight?.abort.abort();
      flight = null;
      waiting = null;
      answered = null;
      onBusy(false);
    },
  };
}

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
