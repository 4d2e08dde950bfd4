/** The wiring: state -> server -> views. */

import { canBeIncident, createConstants, WAVELENGTH } from "./media/media.js";
import { byId, h } from "./page/dom.js";
import { createRouter } from "./page/router.js";
import { createShell, failure, listenForKeys } from "./page/shell.js";
import { library, onMissing } from "./plot/figure.js";
import {
  completed,
  createAsking,
  createQuery,
  fetchCatalog,
  load,
  onKept,
  Problem,
  startWorker,
} from "./server/api.js";
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
  { id: "atlas", title: "Atlas", load: () => import("./views/atlas.js") },
  { id: "films", title: "Films", load: () => import("./views/films.js") },
  { id: "engines", title: "Engines", load: () => import("./views/engines.js") },
  { id: "preview", title: "Preview", load: () => import("./views/preview.js") },
  { id: "theory", title: "Theory", load: () => import("./views/theory.js") },
];

const WORKED_OUT =
  "What is drawn was worked out here, by the formulas that the server sent before.";
const REFUSED = "A part of the page did not arrive. Is the server running, and are you online?";
const ANSWER_DUE = 80; // ms that a picture in motion waits for its answer
const PRINT_AFTER = 200; // ms, in which the picture is drawn
const KERNELS_AFTER = 1000; // ms after the first answer, if nobody reaches for anything
const PAGE_ANGLE = 64; // where the page starts: R, Rs and Rp are well apart
const SAY_AFTER = 900; // ms of rest before the numbers are spoken
const KEEP_AFTER = 3000; // ms after the last picture until what is needed offline is kept: fetching it slows a drag down

/** @param {Catalog} catalog @returns {Record<string, Field>} the state that all views share */
function sharedFields({ parameters, materials }) {
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
    incident: optional(() => materials.filter(canBeIncident).map((m) => m.id)),
    material: optional(() => materials.map((m) => m.id)),
    wavelength_nm: number({ ...WAVELENGTH, default: null }),
    ...Object.fromEntries(own),
    embed: optional(["1"]),
    present: optional(["1"]),
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

/** @param {LinkProblem[]} problems @returns {string[]} */
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
      const starting = main.querySelector(".starting");
      starting?.toggleAttribute("hidden", true);
      await new Promise((again) => {
        const nothing = "The page draws what its server computes, so there is nothing to show yet.";
        main.append(failure(problem.title, [...lines(problem), nothing], () => again(null)));
      });
      starting?.removeAttribute("hidden");
    }
  }
}

const preparePrint = () =>
  void import("./page/print.js").then((print) => print.preparePrint()).catch(() => {});

/** When the files that the document names are there. */
const loaded = () =>
  new Promise((then) => {
    if (document.readyState === "complete") then(null);
    else window.addEventListener("load", then, { once: true });
  });

async function start() {
  const main = byId("view");
  /** @type {ReturnType<typeof createRouter> | undefined} */
  let router;
  const shell = createShell({
    views: VIEWS,
    onView: (id) => router?.choose(id),
    onPresent: () => state.set({ present: "1" }),
    onTheme: () => {
      for (const { view } of router?.all() ?? []) view.theme();
    },
  });

  // On a phone the curves that the server drew stay until they are seen: Plotly comes then.
  const wide = matchMedia(/** @type {HTMLLinkElement} */ (byId("plotly")).media).matches;
  const early = wide || !main.querySelector(".first-curves");
  const missing = new Promise((then) => {
    onMissing((again) => {
      then(null);
      const title = "The plots could not be drawn";
      const action = again && { label: "Try again", run: again };
      shell.notice("plots", action && { title, lines: [REFUSED], action });
    });
  });
  /** When the first picture stands: what can wait is not to keep its files from coming. */
  const pictured = Promise.all([loaded(), early && Promise.race([library(), missing])]);
  const catalog = await firstCatalog(main);
  /** Media that the catalog has not, of the link or besides. @param {unknown} [besides] */
  async function bring(besides) {
    if (besides || /(own|rii)(:|%3A)/i.test(location.search))
      await (await import("./own/kept.js")).bring(catalog, location.search);
  }
  await bring(localStorage.getItem("own-materials"));
  const constants = createConstants({
    materials: catalog.materials,
    query: createQuery,
    onChange: () => state.set({}, { history: "none" }),
    onProblem: (problem) =>
      shell.notice(
        "media",
        problem && { title: "The media stay as they were", lines: lines(problem) },
      ),
  });
  const state = createState(sharedFields(catalog), { window, implied: constants.implied });
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

  /** Formulas, sources and costs of the models, where they are to be read. */
  const describe = completed(catalog.models, "/models", "models", (problem) =>
    shell.notice("server", { title: problem.title, lines: lines(problem) }),
  );
  /** By what else media are found, once somebody looks for one; names will do where that fails. */
  const describeMedia = completed(
    catalog.materials,
    "/materials?fields=id,aliases,source",
    "materials",
    () => {},
  );

  const asking = createAsking({
    questions() {
      const module = router?.current()?.module;
      if (!module) return null;
      const now = state.get();
      return {
        wanted: module.queries(now, catalog, state.moving()),
        later: module.later?.(now, catalog) ?? {},
      };
    },
    moving: state.moving,
    painted: () => !due,
    kernels: () => answerer,
    onAnswer() {
      schedule();
      if (!answerer) pictured.then(() => setTimeout(fetchKernels, KERNELS_AFTER));
    },
    onProblem(name, problem) {
      fetchKernels();
      const { title } = problem;
      // What concerns one panel of a view is said there.
      if (router?.current()?.view.problem?.(name, { title, lines: lines(problem) })) return false;
      const stays = asking.worksOut()
        ? [WORKED_OUT]
        : asking.answers()[name]
          ? ["The last good picture stays."]
          : [];
      shell.notice("server", {
        title,
        lines: [...lines(problem), ...stays],
        action: { label: "Try again", run: asking.ask },
      });
      return true;
    },
    onRecovered: () => shell.notice("server", null),
    onBusy: shell.setBusy,
  });

  /** The formulas, once the first picture stands. @type {Answerer | null} */
  let answerer = null;
  let fetching = false;
  async function fetchKernels() {
    if (fetching) return;
    fetching = true;
    try {
      const [{ createAnswers }, { models }] = await Promise.all([
        import("./kernels/answers.js"),
        import(new URL("kernels.js", document.baseURI).href),
      ]);
      answerer = createAnswers(models, catalog);
      asking.ask(); // what has failed is said anew
      schedule();
    } catch {
      fetching = false; // the server goes on drawing, and the next answer is an occasion to ask again
    }
  }

  /** @type {Promise<(on: boolean) => void> | null} */
  let presenting = null;
  /** @param {State} now */
  async function present({ present: on }) {
    document.documentElement.toggleAttribute("data-present", on !== null);
    if (on)
      presenting ??= import("./page/present.js").then(({ createPresent }) =>
        createPresent(() => state.set({ present: null })),
      );
    (await presenting)?.(state.get().present !== null);
  }

  let frame = 0;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let overdue;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let speech;

  let due = false;
  function schedule() {
    due = true;
    if (!frame) frame = requestAnimationFrame(draw);
  }

  /** Draw what has just been set: with the answer if that is on its way, else now. */
  function follow() {
    clearTimeout(overdue);
    if (!asking.leading()) schedule();
    // A picture drawn twice, without and with its answer, takes the time that the next answer needs.
    else overdue = setTimeout(schedule, ANSWER_DUE);
  }

  function draw() {
    // What is moved in a frame is drawn in that frame, and not in every other one.
    frame = state.moving() ? requestAnimationFrame(draw) : 0;
    const here = router?.current();
    if (!here || !due) return;
    due = false;
    const now = state.get();
    here.view.update(now, asking.answers(), state.moving());
    if (asking.waiting()) requestAnimationFrame(() => setTimeout(asking.askLater));
    clearTimeout(speech);
    if (state.moving()) return;
    restLater();
    shell.showCalls(here.module.restCalls(now, catalog));
    if (now.embed) shell.showWhole(state.toQuery());
    speech = setTimeout(() => {
      shell.say(here.view.sentence(now, asking.answers()));
      keep();
    }, SAY_AFTER);
  }

  // Whoever reaches for something will move it.
  for (const kind of ["pointermove", "pointerdown", "keydown"])
    window.addEventListener(kind, fetchKernels, { once: true, passive: true });

  /** Keeps what is on the screen for when the server does not answer. */
  let keep = () => {};
  let rested = false;
  async function rest() {
    rested = true;
    const { settleDown } = await import("./page/rest.js");
    const guest = Boolean(state.get().embed);
    keep = settleDown({ guest, paths: asking.paths, showVersion: shell.showVersion });
  }
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let resting;
  async function restLater() {
    await pictured;
    clearTimeout(resting);
    if (!rested) resting = setTimeout(() => rest().catch(() => {}), KEEP_AFTER);
  }
  state.subscribe(restLater);

  /** Views that could not be loaded before. @type {Set<string>} */
  const refused = new Set();
  /** @type {HTMLElement | undefined} */
  let refusal;
  /** What the last link came to: its notice stays until something is changed. */
  let linked = "";
  const titleOf = (/** @type {string} */ id) => VIEWS.find((v) => v.id === id)?.title;

  router = createRouter({
    views: VIEWS,
    async load(id) {
      const entry = /** @type {typeof VIEWS[number]} */ (VIEWS.find((v) => v.id === id));
      const [module] = await Promise.all([entry.load(), entry.reads && describe()]);
      return module;
    },
    make(id, module) {
      const host = h("div", { class: `view view-${id}` });
      // In the document before the view is made: plots read their colours and sizes from it.
      const first = /** @type {HTMLElement | null} */ (main.querySelector(".starting"));
      first?.remove();
      main.append(host);
      const view = module.createView({
        element: host,
        first,
        views: VIEWS,
        catalog,
        presets,
        state: state.get,
        actions: { set: state.set, settle: state.settle },
        say: shell.say,
        save,
        describe,
        describeMedia,
        typeset: async (latex, element) =>
          (await import("./page/prose.js")).typeset(latex, element),
      });
      return { view, host };
    },
    state,
    catalog,
    presets,
    onLeave(id) {
      refusal?.remove();
      asking.clear();
      shell.showTab(id);
    },
    onFailure(id, href, again) {
      main.querySelector(".starting")?.remove();
      // A browser may remember that a script could not be had: then only a fresh page asks again.
      const run = refused.has(id) ? () => location.assign(href) : again;
      refused.add(id);
      refusal = failure(`${titleOf(id)} could not be loaded`, [REFUSED], run);
      main.append(refusal);
    },
    onArrival(problems) {
      linked = state.toQuery();
      const title = "Part of this link is not valid";
      shell.notice("link", problems.length ? { title, lines: linkLines(problems) } : null);
    },
  });
  const { arrive } = router;

  await arrive(location.href);
  let arrived = Promise.resolve();
  const steps = createUndo(state);
  const orders = {
    find: async () => (await import("./page/finder.js")).openFinder(found),
    help: async () => (await import("./page/help.js")).openHelp(),
    own: async (/** @type {OwnGiven} */ given = {}) =>
      (await import("./own/sheet.js")).openSheet(
        { catalog, set: state.set, say: shell.say },
        given,
      ),
    // A link that is under way is the step that is meant.
    undo: () => arrived.then(() => shell.say(steps.undo() ? "Undone" : "Nothing to undo")),
    redo: () => arrived.then(() => shell.say(steps.redo() ? "Done again" : "Nothing to redo")),
  };
  /** @type {FinderOptions} */
  const found = {
    catalog,
    views: VIEWS,
    view: () => state.get().view,
    set: state.set,
    notice: shell.notice,
    describeMedia,
    formulas: () => load("/formulas"),
    async places() {
      const [{ SECTIONS }, { STEPS }, { TRAPS }, { SHEETS }, { TARGETS }, { engines }] =
        await Promise.all([
          import("./theory/fields.js"),
          import("./theory/steps.js"),
          import("./theory/trap-cards.js"),
          import("./theory/worksheets.js"),
          import("./takeaway/use.js"),
          load("/engines").catch(() => ({ engines: [] })),
        ]);
      return {
        sections: SECTIONS,
        steps: STEPS,
        traps: TRAPS,
        sheets: SHEETS,
        targets: TARGETS,
        engines,
      };
    },
    actions: [
      { name: "Undo", note: "Ctrl Z", run: orders.undo },
      { name: "Redo", note: "Ctrl Shift Z", run: orders.redo },
      { name: "Keys", note: "?", run: orders.help },
      { name: "Light or dark", note: "theme", run: () => byId("theme").click() },
      { name: "Copy the link", note: "link", run: () => byId("copy-link").click() },
      { name: "Print", note: "Ctrl P", run: () => print() },
      { name: "Present", note: "in large type, alone", run: () => state.set({ present: "1" }) },
      { name: "Your own material…", note: "a file or a table", run: () => orders.own() },
    ],
  };
  listenForKeys(orders);
  for (const kind of ["dragenter", "ownmaterial"])
    window.addEventListener(kind, async (event) =>
      (await import("./own/coming.js")).on(event, orders.own),
    );
  byId("open-finder").addEventListener("click", orders.find);
  byId("help").addEventListener("click", orders.help);
  state.subscribe(async (now, moving) => {
    void present(now);
    await router.follow();
    if (!moving && state.toQuery() !== linked) shell.notice("link", null);
    constants.follow(now);
    asking.ask();
    follow();
  });
  window.addEventListener("popstate", () => {
    arrived = bring().then(() => arrive(location.href));
  });
  window.addEventListener("followlink", (event) => {
    const { detail } = /** @type {CustomEvent<string>} */ (event);
    arrived = arrive(detail, { anew: true }).then(() => {
      window.scrollTo(0, 0);
      // The link may be hidden now with its view; readers go on where they have come to.
      if (!document.activeElement?.checkVisibility()) main.focus({ preventScroll: true });
    });
  });
  void present(state.get());
  void pictured.then(() => {
    setTimeout(preparePrint, PRINT_AFTER);
    startWorker();
  });
  constants.follow(state.get());
  asking.ask();
  schedule();
}

void start();
