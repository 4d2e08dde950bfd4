/** The only module that talks to the server, and what all views know from it: the catalog. */

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

/** @type {Transport} */
let transport = direct;

/** @type {Transport} */
export const get = (url, signal) => transport(url, signal);

/** Hand the asking over to a worker, soon and where there are any. */
export function startWorker() {
  if (typeof Worker === "undefined") return;
  setTimeout(() => {
    const worker = new Worker(new URL("js/server/fetcher.js", document.baseURI), {
      type: "module",
    });
    const up = () => {
      transport = through(worker);
    };
    worker.addEventListener("message", up, { once: true });
    worker.addEventListener("error", () => {
      transport = direct;
    });
  }, START_AFTER);
}

/** Of each model and each medium what every picture needs; the rest is fetched where it is read. */
export const CATALOG_PATHS = [
  "/parameters",
  "/models?fields=id,title,kind,applies_to,parameters,takes_color,validity,look",
  "/materials?fields=id,name,category,n,n_absolute,k,wavelength_nm,kind,rival_of,n_range_nm,n_max",
];

/** The short table that everybody knows comes first. @param {Material[]} materials */
function byTable(materials) {
  const common = materials.filter((m) => m.id.endsWith("-shirley"));
  return [...common, ...materials.filter((m) => !common.includes(m))];
}

/** index.html has it on its way before any script runs. @returns {Promise<Catalog>} */
export async function fetchCatalog() {
  const [{ parameters }, { models }, { materials }] = await Promise.all(
    CATALOG_PATHS.map((path) => load(path)),
  );
  return {
    parameters,
    models: models.map((/** @type {object} */ m) => ({ latex: "", reference: "", cost: {}, ...m })),
    materials: byTable(materials),
  };
}

/**
 * What completes rows of the catalog, asked for once, when it is first needed.
 * @param {{id: string}[]} rows
 * @param {string} path
 * @param {string} key of the answer
 * @param {(problem: Problem) => void} onProblem
 * @returns {() => Promise<void>}
 */
export function completed(rows, path, key, onProblem) {
  /** @type {Promise<void> | null} */
  let done = null;
  return () => {
    done ??= load(path).then(
      (answer) => {
        const more = new Map(answer[key].map((/** @type {{id: string}} */ one) => [one.id, one]));
        for (const row of rows) Object.assign(row, more.get(row.id));
      },
      (problem) => {
        done = null;
        onProblem(problem);
      },
    );
    return done;
  };
}

/** Requests under way at a time. */
const MOST_FLIGHTS = 2;

/**
 * A question that is asked again and again while something moves: one request is in flight, beside one
 * that is slow a second, and of those that wait only the newest is kept. None is given up for being slow,
 * as its answer may be the only one to come for a while; one that is overtaken is.
 * @param {QueryOptions} options
 */
export function createQuery({
  onAnswer,
  onProblem,
  onBusy = () => {},
  get = load,
  patience = 300,
}) {
  /** The oldest first. @type {{path: string, started: number, abort: AbortController}[]} */
  let flights = [];
  /** @type {string | null} */
  let waiting = null;
  /** @type {string | null} */
  let answered = null;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;

  /** @param {string} path */
  async function send(path) {
    const own = { path, started: Date.now(), abort: new AbortController() };
    flights.push(own);
    onBusy(true);
    try {
      const data = await get(path, own.abort.signal);
      if (!flights.includes(own)) return;
      for (const overtaken of flights.splice(0, flights.indexOf(own))) overtaken.abort.abort();
      answered = path;
      onAnswer(data, path);
    } catch (error) {
      if (!flights.includes(own)) return;
      // A newer question waits: what went wrong with this one is of no interest.
      if (waiting === null && flights.at(-1) === own) {
        answered = null;
        onProblem(
          error instanceof Problem
            ? error
            : new Problem("The answer could not be shown", { detail: String(error) }),
        );
      }
    }
    flights = flights.filter((flight) => flight !== own);
    next();
  }

  /** Send what waits, now or when what is under way has had its time. */
  function next() {
    clearTimeout(timer);
    const last = flights.at(-1);
    if (waiting === null || (!last && waiting === answered)) {
      waiting = null;
      if (!last) onBusy(false);
      return;
    }
    if (flights.length >= MOST_FLIGHTS) return;
    const rest = last ? patience - (Date.now() - last.started) : 0;
    if (rest > 0) {
      timer = setTimeout(next, rest);
      return;
    }
    const path = waiting;
    waiting = null;
    void send(path);
  }

  return {
    /** @param {string} path */
    request(path) {
      if (path === (flights.at(-1)?.path ?? answered)) {
        waiting = null;
        clearTimeout(timer);
        return;
      }
      waiting = path;
      next();
    },

    /** Forget what is asked and what was answered; the next request is sent in any case. */
    cancel() {
      clearTimeout(timer);
      for (const { abort } of flights) abort.abort();
      flights = [];
      waiting = null;
      answered = null;
      onBusy(false);
    },
  };
}

/**
 * The questions of the open view, each under a name, and the answer to each. At rest the server is asked.
 * What it has not answered yet is answered by formulas, as far as they reach; while something moves they
 * alone are asked, and where they do not reach the first question leads: the others wait for its answer.
 * @param {AskingOptions} options
 */
export function createAsking({
  questions,
  moving,
  painted,
  onAnswer,
  onProblem,
  onRecovered,
  onBusy,
  kernels = () => null,
  query = createQuery,
}) {
  /** The server's. @type {Answers} */
  let answers = {};
  /** What is asked now, by name. @type {Record<string, string>} */
  let wanted = {};
  /** Answers by formulas, by name, each with the question and the server's last answer. @type {Map<string, {path: string, last: unknown, own: KernelAnswer | null}>} */
  const worked = new Map();
  /** @type {Map<string, ReturnType<typeof createQuery>>} */
  const runners = new Map();
  /** @type {Set<string>} */
  const busy = new Set();
  /** @type {Set<string>} */
  const broken = new Set();
  /** The query that a view cannot do without. */
  let first = "";
  /** Asked one after the other, once all else is answered. @type {[string, string][]} */
  let later = [];
  /** @type {Set<string>} */
  const late = new Set();

  /** @param {string} name */
  function runner(name) {
    const found =
      runners.get(name) ??
      query({
        onAnswer(data, path) {
          // `asked` tells a view which question each answer belongs to.
          answers = { ...answers, [name]: data, asked: { ...answers.asked, [name]: path } };
          recovered(name);
          onAnswer();
        },
        onProblem(problem) {
          if (onProblem(name, problem)) broken.add(name);
        },
        onBusy(on) {
          if (on) busy.add(name);
          else busy.delete(name);
          onBusy(busy.size > 0);
          askLater();
        },
      });
    runners.set(name, found);
    return found;
  }

  /** What formulas say to the question of a name. @param {string} name @returns {KernelAnswer | null} */
  function own(name) {
    const answerer = kernels();
    const path = wanted[name];
    if (!answerer || path === undefined) return null;
    const before = worked.get(name);
    const last = answers[name];
    if (before?.path === path && before.last === last) return before.own;
    const now = { path, last, own: answerer(path, last) };
    worked.set(name, now);
    return now.own;
  }

  /** The answers to show: the server's to this very question, else that by formulas, else the last one. */
  function shown() {
    /** @type {Answers} */
    const all = { ...answers };
    for (const [name, path] of Object.entries(wanted)) {
      if (answers.asked?.[name] === path) continue;
      const found = own(name);
      if (!found) continue;
      all[name] = found.answer;
      if (found.complete) all.asked = { ...all.asked, [name]: path };
    }
    return all;
  }

  /** @param {string} name */
  function recovered(name) {
    if (broken.delete(name) && broken.size === 0) onRecovered();
  }

  function askLater() {
    // What has been answered is painted first.
    while (painted() && busy.size === 0 && !moving()) {
      const one = later.shift();
      if (!one) return;
      late.add(one[0]);
      runner(one[0]).request(one[1]);
    }
  }

  return {
    answers: shown,
    /** Whether formulas answer what the server has not. */
    worksOut: () =>
      Object.entries(wanted).some(
        ([name, path]) => answers.asked?.[name] !== path && own(name)?.complete,
      ),
    /** The paths that the server has answered. @returns {string[]} */
    paths: () => Object.values(answers.asked ?? {}),
    /** Whether an answer is on its way without which a picture in motion would be drawn twice. */
    leading: () => moving() && busy.has(first) && !own(first),
    waiting: () => later.length > 0,
    askLater,

    ask() {
      const asked = questions();
      if (!asked) return;
      wanted = asked.wanted;
      // Nothing is asked anew before all that is late is given up, or it would be given up too.
      later = [];
      for (const name of late) if (busy.has(name)) runner(name).cancel();
      later = moving() ? [] : Object.entries(asked.later);
      // What is not asked any more cannot recover.
      if (!moving()) {
        const names = new Set([...Object.keys(wanted), ...later.map(([name]) => name)]);
        for (const name of broken) if (!names.has(name)) recovered(name);
      }
      first = Object.keys(wanted)[0] ?? "";
      for (const [name, path] of Object.entries(wanted)) {
        if (moving() && own(name)?.complete) continue;
        // While the first is on its way again and again, the others would only slow it down.
        if (name === first || !moving() || !busy.has(first)) runner(name).request(path);
      }
      askLater();
    },

    /** Another view is opened: nothing that is under way concerns it. */
    clear() {
      later = [];
      for (const one of runners.values()) one.cancel();
      runners.clear();
      late.clear();
      for (const name of broken) recovered(name);
      answers = {};
      wanted = {};
      worked.clear();
    },
  };
}
