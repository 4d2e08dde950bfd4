/** The wiring: state -> api -> views. */

import { canBeIncident, WAVELENGTH } from "./controls/media.js";
import { createConstants } from "./media/constants.js";
import { byId, h } from "./page/dom.js";
import { createShell, listenForKeys } from "./page/shell.js";
import { BASE, createQuery, load, onKept, Problem, startWorker } from "./server/api.js";
import { choice, createState, createUndo, number, optional, shortened } from "./state/state.js";

/**
 * A further view is one line here and one file in views/.
 * @type {{id: string, title: string, load: () => Promise<ViewModule>, reads?: 'models'}[]}
 */
const VIEWS = [
  { id: "explore", title: "Explore", load: () => import("./views/explore.js") },
  { id: "compare", title: "Compare", load: () => import("./views/compare.js"), reads: "models" },
  { id: "albedo", title: "Albedo", load: () => import("./views/albedo.js") },
  { id: "materials", title: "Materials", load: () => import("./views/materials.js") },
  { id: "preview", title: "Preview", load: () => import("./views/preview.js") },
  { id: "theory", title: "Theory", load: () => import("./views/theory.js") },
];

/** What every picture needs of the models; the rest is fetched where it is read. */
const MODELS = "/models?fields=id,title,kind,applies_to,parameters,validity";

/** What all views know of every medium; index.html has it on its way before this script runs. */
const MATERIALS = "/materials?fields=id,name,category,n,k,wavelength_nm,kind,rival_of,n_range_nm";

/** By what else a medium is found. */
const FOUND_BY = "/materials?fields=id,aliases,source";

const ANSWER_DUE = 80; // ms that a picture in motion waits for its answer
const PAGE_ANGLE = 64; // where the page starts: R, Rs and Rp are well apart
const SAY_AFTER = 900; // ms of rest before the numbers are spoken
const KEEP_AFTER = 3000; // ms at rest until what is needed offline is kept: fetching it all slows down a drag

/** @param {Catalog} catalog @returns {Record<string, Field>} the state that all views share */
function sharedFields({ parameters, materials }) {
  const ids = materials.map((m) => m.id);
  const own = ["n_i", "n_t", "k_t", "theta_i_deg"].map((name) => {
    const declared = parameters.find((p) => p.name === name);
    if (!declared)
      throw new Problem("The server's parameters cannot be used", { detail: `${name} is missing` });
    const preset = name === "theta_i_deg" ? PAGE_ANGLE : (declared.default ?? declared.minimum);
    return [name, number({ ...declared, default: preset })];
  });
  return {
    view: choice(
      "explore",
      VIEWS.map((v) => v.id),
    ),
    incident: optional(materials.filter(canBeIncident).map((m) => m.id)),
    material: optional(ids),
    wavelength_nm: number({ ...WAVELENGTH, default: null }),
    ...Object.fromEntries(own),
    embed: optional(["1"]),
    polarization: choice("unpolarized", ["s", "p", "unpolarized"]),
    angle: choice("deg", ["deg", "rad"]),
  };
}

/** @param {Problem} problem @returns {string[]} */
function lines({ detail, errors }) {
  const each = errors.map((e) =>
    e.parameter ? `${e.parameter} = ${String(e.value)}: ${e.message}` : e.message,
  );
  return each.length ? each : [detail].filter(Boolean);
}

const MOST_LINES = 4;

/** @param {import('./state/state.js').LinkProblem[]} problems @returns {string[]} */
function linkLines(problems) {
  const each = problems
    .slice(0, MOST_LINES)
    .map((p) => `${shortened(p.key)} = ${shortened(p.text)}: ${p.message}`);
  const rest = problems.length - each.length;
  return rest > 0 ? [...each, `and ${rest} more of the kind`] : each;
}

/** @param {string} name @param {Blob} blob */
function save(name, blob) {
  const url = URL.createObjectURL(blob);
  const link = h("a", { href: url, download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

/** The short table that everybody knows comes first. @param {Material[]} materials */
function byTable(materials) {
  const common = materials.filter((m) => m.id.endsWith("-shirley"));
  return [...common, ...materials.filter((m) => !common.includes(m))];
}

/**
 * What completes rows of the catalog, asked for once, when it is first needed.
 * @param {{id: string}[]} rows
 * @param {string} path
 * @param {string} key of the answer
 * @param {(problem: Problem) => void} onProblem
 * @returns {() => Promise<void>}
 */
function completed(rows, path, key, onProblem) {
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

/** @returns {Promise<Catalog>} */
async function fetchCatalog() {
  const [parameters, models, materials] = await Promise.all([
    load("/parameters"),
    load(MODELS),
    load(MATERIALS),
  ]);
  return {
    parameters: parameters.parameters,
    models: models.models.map((/** @type {object} */ m) => ({
      latex: "",
      reference: "",
      cost: {},
      ...m,
    })),
    materials: byTable(materials.materials),
  };
}

/**
 * The catalog, asked for until it comes: without it there is nothing to show.
 * @param {HTMLElement} main
 * @returns {Promise<Catalog>}
 */
async function firstCatalog(main) {
  for (;;) {
    try {
      return await fetchCatalog();
    } catch (error) {
      const problem =
        error instanceof Problem
          ? error
          : new Problem("The page could not start", { detail: String(error) });
      const again = h("button", { type: "button" }, "Try again");
      const failure = h(
        "section",
        { class: "failure", role: "alert" },
        h("h2", {}, problem.title),
        ...lines(problem).map((line) => h("p", {}, line)),
        h("p", {}, "The page draws what its server computes, so there is nothing to show yet."),
        again,
      );
      const starting = main.querySelector(".starting");
      starting?.toggleAttribute("hidden", true);
      main.append(failure);
      await new Promise((resolve) => again.addEventListener("click", resolve, { once: true }));
      failure.remove();
      starting?.removeAttribute("hidden");
    }
  }
}

async function start() {
  const main = byId("view");
  /** @type {Map<string, {module: ViewModule, view: ReturnType<ViewModule['createView']>, host: HTMLElement}>} */
  const opened = new Map();
  /** @type {string | null} */
  let active = null;
  /** How many addresses were set out for: the last one counts. */
  let arrivals = 0;

  const shell = createShell({
    views: VIEWS,
    onView(id) {
      arrivals += 1; // whoever chooses a tab does not wait for a link any more
      store?.set({ view: id });
    },
    onTheme: () => {
      for (const { view } of opened.values()) view.theme();
    },
  });
  /** @type {import('./state/state.js').StateStore | null} */
  let store = null;

  const catalog = await firstCatalog(main);
  const shared = sharedFields(catalog);
  const constants = createConstants({
    materials: catalog.materials,
    query: createQuery,
    onChange: () => store?.set({}, { history: "none" }),
    onProblem: (problem) =>
      shell.notice(
        "media",
        problem && { title: "The media stay as they were", lines: lines(problem) },
      ),
  });
  const state = createState(shared, { window, implied: constants.implied });
  store = state;
  onKept((since) =>
    shell.notice(
      "kept",
      since && {
        title: "The server does not answer",
        lines: [
          `Shown is what was kept when it did, on ${since.toISOString().slice(0, 16).replace("T", " ")} UTC.`,
          "What was not on the screen before has to wait for it.",
        ],
      },
    ),
  );
  /** @type {State} */
  const presets = { ...state.get() };

  /** @type {Record<string, any>} */
  let answers = {};
  /** @type {Map<string, ReturnType<typeof createQuery>>} */
  const runners = new Map();
  const busy = new Set();
  const broken = new Set();
  let frame = 0;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let speech;

  /** @type {typeof import('./server/offline.js') | null} */
  let keeper = null;
  const onScreen = () => Object.values(answers.asked ?? {}).map((path) => `${BASE}${path}`);

  /** @param {Promise<void>} work that the page can do without, being left or without its server */
  const quietly = (work) => void work.catch(() => {});
  function rest() {
    stopWaiting();
    quietly(import("./page/print.js").then(({ preparePrint }) => preparePrint()));
    if (state.get().embed) return; // it is a guest there
    quietly(load("/health").then((health) => shell.showVersion(health.version)));
    quietly(keep());
  }
  async function keep() {
    const offline = await import("./server/offline.js");
    await offline.keepPage();
    keeper = offline;
    const start = ["/parameters", MODELS, MATERIALS].map((path) => `${BASE}${path}`);
    await keeper.keepAnswers([...start, ...onScreen()]);
  }
  let resting = setTimeout(rest, KEEP_AFTER);
  const stopWaiting = state.subscribe(() => {
    clearTimeout(resting);
    resting = setTimeout(rest, KEEP_AFTER);
  });

  /** @param {string} name */
  function runner(name) {
    let found = runners.get(name);
    if (!found) {
      found = createQuery({
        onAnswer(data, path) {
          // `asked` tells a view which question each answer belongs to.
          answers = { ...answers, [name]: data, asked: { ...answers.asked, [name]: path } };
          recovered(name);
          schedule();
        },
        onProblem(problem) {
          // What concerns one panel of a view is said there.
          if (current()?.view.problem?.(name, { title: problem.title, lines: lines(problem) }))
            return;
          broken.add(name);
          shell.notice("server", {
            title: problem.title,
            lines: [...lines(problem), answers[name] ? "The last good picture stays." : ""].filter(
              Boolean,
            ),
            action: { label: "Try again", run: ask },
          });
        },
        onBusy(on) {
          if (on) busy.add(name);
          else busy.delete(name);
          shell.setBusy(busy.size > 0);
          askLater();
        },
      });
      runners.set(name, found);
    }
    return found;
  }

  /** The notice stays as long as something on the screen is broken. @param {string} name */
  function recovered(name) {
    if (broken.delete(name) && broken.size === 0) shell.notice("server", null);
  }

  /** Formulas, sources and costs of the models, where they are to be read. */
  const describe = completed(catalog.models, "/models", "models", (problem) =>
    shell.notice("server", { title: problem.title, lines: lines(problem) }),
  );

  /** By what else media are found, once somebody looks for one; names will do where that fails. */
  const describeMedia = completed(catalog.materials, FOUND_BY, "materials", () => {});

  function current() {
    return active === null ? undefined : opened.get(active);
  }

  /** The query that a view cannot do without. */
  let first = "";
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let overdue;

  /** What is asked for, one after the other, once all else is answered. @type {[string, string][]} */
  let later = [];
  /** @type {Set<string>} */
  const late = new Set();

  function askLater() {
    // What has been answered is painted first.
    while (frame === 0 && busy.size === 0 && !state.moving()) {
      const one = later.shift();
      if (!one) return;
      late.add(one[0]);
      runner(one[0]).request(one[1]);
    }
  }

  function ask() {
    const here = current();
    if (!here) return;
    later = state.moving() ? [] : Object.entries(here.module.later?.(state.get(), catalog) ?? {});
    for (const name of late) if (busy.has(name)) runner(name).cancel();
    const wanted = here.module.queries(state.get(), catalog, state.moving());
    // What is not asked any more cannot recover.
    if (!state.moving()) {
      const asked = new Set([...Object.keys(wanted), ...later.map(([name]) => name)]);
      for (const name of broken) if (!asked.has(name)) recovered(name);
    }
    first = Object.keys(wanted)[0] ?? "";
    for (const [name, path] of Object.entries(wanted)) {
      // While the first is on its way again and again, the others would only slow it down.
      if (name === first || !state.moving() || !busy.has(first)) runner(name).request(path);
    }
    askLater();
  }

  /** Draw what has just been set: with the answer if that is on its way, else now. */
  function follow() {
    clearTimeout(overdue);
    if (!state.moving() || !busy.has(first)) schedule();
    // A picture drawn twice, without and with its answer, takes the time that the next answer needs.
    else overdue = setTimeout(schedule, ANSWER_DUE);
  }

  function schedule() {
    if (!frame) frame = requestAnimationFrame(draw);
  }

  function draw() {
    frame = 0;
    const here = current();
    if (!here) return;
    const now = state.get();
    here.view.update(now, answers, state.moving());
    if (later.length) requestAnimationFrame(() => setTimeout(askLater));
    clearTimeout(speech);
    if (state.moving()) return;
    shell.showCalls(here.module.restCalls(now, catalog));
    if (now.embed) shell.showWhole(state.toQuery());
    speech = setTimeout(() => {
      shell.say(here.view.sentence(now, answers));
      void keeper?.keepAnswers(onScreen());
    }, SAY_AFTER);
  }

  /** @param {string} id */
  async function open(id) {
    if (active === id) return;
    current()?.view.deactivate();
    later = [];
    for (const one of runners.values()) one.cancel();
    runners.clear();
    late.clear();
    for (const name of broken) recovered(name);
    answers = {};
    active = id;
    shell.showTab(id);
    if (!opened.has(id)) {
      const entry = VIEWS.find((v) => v.id === id);
      if (!entry) return;
      const [module] = await Promise.all([entry.load(), entry.reads && describe()]);
      const fresh = module.fields(catalog);
      state.extend(fresh);
      for (const [key, field] of Object.entries(fresh)) presets[key] = field.default;
      const host = h("div", { class: `view view-${id}` });
      // In the document before the view is made: plots read their colours and sizes from it.
      main.querySelector(".starting")?.remove();
      main.append(host);
      const actions = { set: state.set, settle: state.settle };
      const view = module.createView({
        element: host,
        views: VIEWS,
        catalog,
        presets,
        state: state.get,
        actions,
        say: shell.say,
        save,
        describe,
        describeMedia,
        typeset: async (latex, element) =>
          (await import("./page/prose.js")).typeset(latex, element),
      });
      opened.set(id, { module, view, host });
    }
    if (active !== id) return; // another tab was chosen while this one loaded
    for (const [key, { host }] of opened) host.hidden = key !== id;
  }

  /** What the last link came to: its notice stays until something is changed. */
  let linked = "";

  /**
   * Become what an address says. Its view is fetched first: the address and the state change as one.
   * @param {string} href
   * @param {{anew?: boolean}} [options] whether it is a further page of the history
   */
  async function arrive(href, { anew = false } = {}) {
    arrivals += 1;
    const arrival = arrivals;
    const { search } = new URL(href, location.href);
    const asked = new URLSearchParams(search).get("view");
    await open(VIEWS.some((v) => v.id === asked) ? /** @type {string} */ (asked) : "explore");
    // A link made after a visit to other views carries their state too.
    if ([...new URLSearchParams(search).keys()].some((key) => !(key in state.get()))) {
      for (const { fields } of await Promise.all(VIEWS.map((v) => v.load()))) {
        const more = fields(catalog);
        state.extend(more);
        for (const [key, field] of Object.entries(more)) presets[key] ??= field.default;
      }
    }
    if (arrival !== arrivals) return;
    if (anew) history.pushState(null, "", href);
    const problems = state.fromQuery(search);
    linked = state.toQuery();
    shell.notice(
      "link",
      problems.length === 0
        ? null
        : {
            title: "The link says something that cannot be shown",
            lines: linkLines(problems),
          },
    );
  }

  await arrive(location.href);
  let arrived = Promise.resolve();
  const steps = createUndo(state);
  const orders = {
    find: async () => (await import("./page/finder.js")).openFinder(found),
    help: async () => (await import("./page/help.js")).openHelp(),
    // A link that is under way is the step that is meant.
    undo: () => arrived.then(() => shell.say(steps.undo() ? "Undone" : "Nothing to undo")),
    redo: () => arrived.then(() => shell.say(steps.redo() ? "Done again" : "Nothing to redo")),
  };
  /** @type {import('./page/finder.js').FinderOptions} */
  const found = {
    catalog,
    views: VIEWS,
    view: () => state.get().view,
    set: state.set,
    describeMedia,
    formulas: () => load("/formulas"),
    actions: [
      { name: "Undo", note: "Ctrl Z", run: orders.undo },
      { name: "Redo", note: "Ctrl Shift Z", run: orders.redo },
      { name: "Keys", note: "?", run: orders.help },
      { name: "Copy the HTML that embeds this view", note: "iframe", run: copyEmbed },
    ],
  };
  async function copyEmbed() {
    const [{ copyText }, { embedCode }] = await Promise.all([
      import("./page/exports.js"),
      import("./page/embed.js"),
    ]);
    const done = await copyText(embedCode(location.href, document.title));
    shell.notice("embed", {
      title: done ? "Copied: the HTML that embeds this view" : "Copying is not allowed here",
      lines: [embedCode(location.href, document.title)],
    });
  }
  listenForKeys(orders);
  byId("open-finder").addEventListener("click", orders.find);
  byId("help").addEventListener("click", orders.help);
  state.subscribe(async (now, moving) => {
    if (now.view !== active) await open(now.view);
    if (!moving && state.toQuery() !== linked) shell.notice("link", null);
    constants.follow(now);
    ask();
    follow();
  });
  window.addEventListener("popstate", () => {
    arrived = arrive(location.href);
  });
  window.addEventListener("followlink", (event) => {
    const { detail } = /** @type {CustomEvent<string>} */ (event);
    arrived = arrive(detail, { anew: true }).then(() => {
      window.scrollTo(0, 0);
      // The link may be hidden now with its view; readers go on where they have come to.
      if (!document.activeElement?.checkVisibility()) main.focus({ preventScroll: true });
    });
  });
  constants.follow(state.get());
  ask();
  schedule();
}

void start().then(startWorker);
