/** What stands around every view: tabs, theme, notices, the line that shows work, the footer, the keys. */

import { byId, copying, h, setText } from "./dom.js";
import { clicked, follow } from "./links.js";

const NOTICEABLE = 250; // ms: work that is done sooner is not shown
const THEMES = /** @type {const} */ (["auto", "light", "dark"]);

/** @param {ShellOptions} options */
export function createShell({ views, onView, onPresent, onTheme }) {
  const root = document.documentElement;
  const said = byId("said");
  const work = byId("work");
  const notices = byId("notices");
  const calls = byId("calls");

  const nav = /** @type {HTMLElement} */ (document.querySelector(".views"));
  const tabs = views.map(({ id }) => {
    const link = /** @type {HTMLElement} */ (nav.querySelector(`[data-view="${id}"]`));
    link.addEventListener("click", (event) => {
      if (event.ctrlKey || event.metaKey || event.shiftKey) return;
      event.preventDefault();
      onView(id);
    });
    return { id, link };
  });
  // One stop for the Tab key each, so that the picture is not far.
  moveByArrows(tabs.map(({ link }) => link));
  const starters = [
    .../** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll("#intro a:not(.door)")),
  ];
  for (const link of starters.slice(1)) link.tabIndex = -1;
  moveByArrows(starters);
  for (const link of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll("#intro a")))
    link.addEventListener(
      "click",
      clicked(() => follow(link.getAttribute("href") ?? "./")),
    );

  const theme = byId("theme");
  function showTheme() {
    const choice = root.dataset.themeChoice ?? "auto";
    setText(theme, choice.charAt(0).toUpperCase() + choice.slice(1));
    theme.setAttribute("aria-label", `Theme: ${choice}`);
  }
  theme.addEventListener("click", () => {
    const at = THEMES.indexOf(/** @type {any} */ (root.dataset.themeChoice ?? "auto"));
    root.dispatchEvent(
      new CustomEvent("themechoice", { detail: THEMES[(at + 1) % THEMES.length] }),
    );
  });
  root.addEventListener("themechange", () => {
    showTheme();
    onTheme();
  });
  showTheme();

  const link = byId("copy-link");
  link.addEventListener(
    "click",
    copying(() => location.href, say, "Link copied"),
  );
  link.after(h("button.quiet", { type: "button", id: "present", onclick: onPresent }, "Present"));

  /** @param {string} text */
  function say(text) {
    setText(said, text);
  }

  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let waiting;
  /** @type {Map<string, HTMLElement>} */
  const open = new Map();

  return {
    say,

    /** @param {string} active */
    showTab(active) {
      root.dataset.view = active;
      for (const { id, link } of tabs) {
        link.tabIndex = id === active ? 0 : -1;
        if (id === active) {
          link.setAttribute("aria-current", "page");
          link.scrollIntoView({ block: "nearest", inline: "nearest" });
        } else link.removeAttribute("aria-current");
      }
      const title = views.find((v) => v.id === active)?.title ?? "";
      document.title = `${title} · Fresnel Explorer`;
      setText(byId("view-title"), title);
    },

    /** @param {boolean} busy */
    setBusy(busy) {
      clearTimeout(waiting);
      if (busy) waiting = setTimeout(() => work.toggleAttribute("data-busy", true), NOTICEABLE);
      else if (work.hasAttribute("data-busy")) work.removeAttribute("data-busy");
    },

    /**
     * Show a notice, or take it away. One notice for each id.
     * @param {string} id
     * @param {{title: string, lines?: string[], action?: {label: string, run: () => void}} | null} notice
     */
    notice: function show(id, notice) {
      open.get(id)?.remove();
      open.delete(id);
      if (!notice) return;
      const close = h(
        "button.quiet",
        {
          type: "button",
          "aria-label": "Dismiss",
          onclick: () => show(id, null),
        },
        "×",
      );
      const { action } = notice;
      const element = h(
        "div.notice",
        { role: "alert", "data-notice": id },
        h("div", h("b", notice.title), ...(notice.lines ?? []).map((line) => h("p", line))),
        action ? h("button.quiet", { type: "button", onclick: action.run }, action.label) : null,
        close,
      );
      open.set(id, element);
      notices.append(element);
    },

    /** Where an embedded view stands in the whole page. @param {string} query */
    showWhole(query) {
      const search = new URLSearchParams(query);
      search.delete("embed");
      byId("whole").setAttribute("href", search.size ? `?${search}` : "./");
    },

    /** @param {string[]} paths of the REST calls that give what is on the screen */
    showCalls(paths) {
      while (calls.children.length > paths.length) calls.lastElementChild?.remove();
      paths.forEach((path, index) => {
        const line = calls.children[index] ?? calls.appendChild(callLine());
        const code = /** @type {HTMLElement} */ (line.querySelector("code"));
        setText(code, `GET /api/v1${path}`);
        code.title = path;
      });
    },

    /** @param {string} version */
    showVersion(version) {
      setText(byId("version"), `v${version}`);
    },
  };

  function callLine() {
    const code = h("code");
    const address = () =>
      new URL((code.textContent ?? "").replace(/^GET \//, ""), document.baseURI).href;
    const label = "Copy the address of this call";
    const onclick = copying(address, say, "Address copied");
    return h(
      "p",
      code,
      h("button.quiet", { type: "button", "aria-label": label, onclick }, "copy"),
    );
  }
}

/** @param {readonly HTMLElement[]} links between which arrows move */
function moveByArrows(links) {
  const last = links.length - 1;
  for (const [at, link] of links.entries())
    link.addEventListener("keydown", (event) => {
      const next = { ArrowRight: at + 1, ArrowLeft: at - 1, Home: 0, End: last }[event.key];
      const to = next === undefined ? undefined : links[next];
      if (!to || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      to.focus();
    });
}

/**
 * What stands in place of what cannot be shown.
 * @param {string} title
 * @param {readonly string[]} lines
 * @param {() => void} again
 */
export function failure(title, lines, again) {
  const element = h(
    "section.failure",
    { role: "alert" },
    h("h2", title),
    ...lines.map((line) => h("p", line)),
    h(
      "button",
      {
        type: "button",
        onclick() {
          element.remove();
          again();
        },
      },
      "Try again",
    ),
  );
  return element;
}

/** In these a key writes. */
const WRITTEN_IN = "input:not([type=range], [type=checkbox], [type=radio]), textarea, select";

/** The keys that work everywhere. What they open is loaded when it is first asked for. @param {Orders} orders */
export function listenForKeys(orders) {
  /** The box that holds something not yet taken over: its own undo comes first. @type {EventTarget | null} */
  let draft = null;
  document.addEventListener("input", ({ target }) => {
    draft = target;
  });
  for (const end of ["change", "focusout"])
    document.addEventListener(end, () => {
      draft = null;
    });

  document.addEventListener("keydown", (event) => {
    if (event.key === "Enter") draft = null;
    if (event.defaultPrevented || event.altKey) return;
    const order = orderOf(event, draft);
    if (!order || document.querySelector("dialog[open]")) return;
    event.preventDefault();
    orders[order]();
  });
}

/** @param {KeyboardEvent} event @param {EventTarget | null} draft @returns {keyof Orders | null} */
function orderOf(event, draft) {
  const { target } = event;
  const key = event.key.toLowerCase();
  if (event.ctrlKey || event.metaKey) {
    if (key === "k" && !event.shiftKey) return "find";
    if (draft !== null && draft === target && /** @type {Element} */ (target).matches(WRITTEN_IN))
      return null;
    if (key === "z") return event.shiftKey ? "redo" : "undo";
    return key === "y" && !event.shiftKey ? "redo" : null;
  }
  const writing = target instanceof Element && target.matches(WRITTEN_IN);
  return key === "?" && !writing ? "help" : null;
}
