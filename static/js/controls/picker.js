/** The list of media below a field that is typed into. */

import { add, findPages, isPage, pathOf } from "../media/brought.js";
import { stretch } from "../media/wavelength.js";
import { h } from "../page/dom.js";
import { loadStyle } from "../page/style.js";
import { distance } from "../state/state.js";

/** A letter more, less or other is a slip in a word this long; in a shorter one it is another word. */
const LEAST_WORD = 5;
/** From here on two of them are. */
const LONG_WORD = 8;
const PAUSE = 200; // ms after a key until pages are searched
const PAGES = "refractiveindex.info";

/** The last line of each list: a material that is not in it. @type {any} */
const OWN = { id: "own", name: "Your own…", category: "your own" };
let pickers = 0;

/**
 * Media by what was typed: names and ids that begin so, then words and other names, then what holds it
 * anywhere, then authors, and where nothing does what is spelled nearly so.
 * @template {Pick<Material, 'id' | 'name' | 'category' | 'aliases' | 'source'>} M
 * @param {readonly M[]} materials
 * @param {string} text
 * @returns {M[]}
 */
export function matching(materials, text) {
  const asked = text.trim().toLowerCase();
  if (asked === "") return [...materials];
  /** @param {M} material */
  const rank = ({ id, name, category, aliases = [], source = "" }) => {
    const [own, called] = [id.toLowerCase(), name.toLowerCase()];
    if (own === asked || called === asked) return 0;
    if (called.startsWith(asked)) return 1;
    if (own.startsWith(asked)) return 2;
    const words = [...called.split(/[\s,()]+/), ...aliases.map((alias) => alias.toLowerCase())];
    if (words.some((word) => word.startsWith(asked))) return 3;
    if (asked.length > 2 && (called.includes(asked) || own.includes(asked))) return 4;
    if (category.startsWith(asked)) return 5;
    return asked.length > 2 && source.toLowerCase().includes(asked) ? 6 : 9;
  };
  const ranked = materials.map((m) => ({ m, rank: rank(m) })).filter((r) => r.rank < 9);
  if (ranked.length > 0) return ranked.sort((a, b) => a.rank - b.rank).map((r) => r.m);
  const slips = asked.length < LEAST_WORD ? 0 : asked.length < LONG_WORD ? 1 : 2;
  const near = materials
    .map((m) => {
      const words = [m.id, ...m.name.split(/[\s,()]+/), ...(m.aliases ?? [])]
        .map((w) => w.toLowerCase())
        .filter((word) => word.length >= LEAST_WORD);
      return { m, far: Math.min(...words.map((word) => distance(asked, word))) };
    })
    .filter(({ far }) => far <= slips);
  return near.sort((a, b) => a.far - b.far).map(({ m }) => m);
}

/** @param {string} word */
function capital(word) {
  return word.charAt(0).toUpperCase() + word.slice(1);
}

/** What tells media of one name apart. @param {Material} material */
export function origin({ id, kind, n_range_nm }) {
  if (isPage(id) && n_range_nm) return `${stretch(n_range_nm)} · ${pathOf(id)}`;
  if (kind === "spectrum" && n_range_nm) return stretch(n_range_nm);
  return `${capital(/-([a-z]+)$/.exec(id)?.[1] ?? "")}'s table`;
}

/** @param {Material} material @returns {string} */
function groupOf({ id, category }) {
  if (isPage(id)) return PAGES;
  return id.endsWith("-shirley") ? "Shirley's table, 589 nm" : capital(category);
}

/** @param {ListOptions} options */
export async function createList({
  input,
  materials,
  note,
  refusal,
  describe,
  onPick,
  written,
  chosen,
}) {
  await loadStyle("css/media-list.css");
  pickers += 1;
  const own = `media-${pickers}`;
  /** @type {HTMLElement | null} */
  let list = null;
  /** @type {Material[]} */
  let found = [];
  let active = -1;
  /** Whether the line was chosen by keys; else it is the best match, whichever that is. */
  let moved = false;
  /** Pages that fit what was typed, and what that is. @type {{text: string, rows: Material[]}} */
  let pages = { text: "", rows: [] };
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let searching;

  /** Pages come after what the page has, and later. @param {string} text */
  function search(text) {
    clearTimeout(searching);
    if (text.trim() === "" || text === pages.text) return;
    searching = setTimeout(async () => {
      const rows = await findPages(text).catch(() => []);
      if (!list || input.value !== text) return;
      pages = { text, rows };
      renew();
    }, PAUSE);
  }

  /** List again, with more than before; what is chosen and what is seen stay. */
  function renew() {
    if (!list) return;
    const [at, { scrollTop }] = [found[active]?.id, list];
    open(input.value);
    const again = found.findIndex(({ id }) => id === at);
    if (moved && again >= 0) activate(again);
    list.scrollTop = scrollTop;
  }

  /** @param {Material} material @param {number} index */
  function option(material, index) {
    const why = material === OWN ? null : refusal(material);
    return h(
      "li",
      {
        id: `${own}-${index}`,
        role: "option",
        "aria-selected": "false",
        "aria-disabled": why === null ? null : "true",
        "data-index": index,
        "data-id": material.id,
        title: why ?? (isPage(material.id) ? (material.source ?? null) : null),
      },
      h("span.media-name", material.name),
      h(
        "span.note",
        material === OWN ? "a file or a table" : `${note(material)} · ${origin(material)}`,
      ),
    );
  }

  /** @param {string} text what is searched for; everything, in groups, where it is empty */
  function open(text) {
    const known = matching(materials, text);
    const more = pages.text === text ? pages.rows : [];
    const others = more.filter(({ id }) => !known.some((m) => m.id === id));
    const all = [...known, ...others, OWN];
    const names = text.trim() === "" ? [...new Set(all.map(groupOf))] : [];
    found = names.length ? names.flatMap((name) => all.filter((m) => groupOf(m) === name)) : all;
    search(text);
    if (!list) {
      list = h("ul.media-list", { id: own, role: "listbox", "aria-label": "Media" });
      // A press must not take the focus from the field.
      list.addEventListener("pointerdown", (event) => event.preventDefault());
      list.addEventListener("click", (event) => {
        const row = /** @type {HTMLElement} */ (event.target).closest("li[data-index]");
        if (row instanceof HTMLElement) take(Number(row.dataset.index));
      });
      input.after(list);
      input.setAttribute("aria-expanded", "true");
      input.setAttribute("aria-controls", own);
    }
    let index = 0;
    const rows = names.map((name) => {
      const members = found
        .filter((m) => groupOf(m) === name)
        .map((m) => {
          index += 1;
          return option(m, index - 1);
        });
      return h(
        "li",
        { role: "presentation" },
        h(
          "ul",
          { role: "group", "aria-label": name },
          h("li.media-group", { role: "presentation" }, name),
          ...members,
        ),
      );
    });
    list.replaceChildren(...(names.length ? rows : found.map(option)));
    if (others.length)
      list
        .querySelector(`[data-index="${known.length}"]`)
        ?.before(h("li.media-group", { role: "presentation" }, PAGES));
    if (found.length === 1) list.prepend(h("li.media-group", { role: "presentation" }, "no match"));
    if (text.trim() === "") activate(found.findIndex((m) => m.id === chosen()));
    else activate(found.length > 1 ? 0 : -1);
  }

  function close() {
    list?.remove();
    list = null;
    active = -1;
    input.setAttribute("aria-expanded", "false");
    input.removeAttribute("aria-controls");
    input.removeAttribute("aria-activedescendant");
    input.value = written();
  }

  /** @param {number} index */
  function activate(index) {
    const before = list?.querySelector(`[data-index="${active}"]`);
    before?.setAttribute("aria-selected", "false");
    active = found[index] ? index : -1;
    const now = list?.querySelector(`[data-index="${active}"]`);
    if (!now) {
      input.removeAttribute("aria-activedescendant");
      return;
    }
    now.setAttribute("aria-selected", "true");
    input.setAttribute("aria-activedescendant", now.id);
    now.scrollIntoView({ block: "nearest" });
  }

  /** @param {number} index */
  function take(index) {
    const material = found[index];
    if (!material || (material !== OWN && refusal(material) !== null)) return;
    if (isPage(material.id)) add(/** @type {Material[]} */ (materials), material);
    close();
    onPick(material.id);
    input.value = written(material.id);
    input.select();
  }

  /** @type {Record<string, (event: Event) => void>} */
  const answers = {
    click() {
      if (!list) open("");
    },
    async focus() {
      await describe();
      if (input.value !== written()) renew();
    },
    input() {
      moved = false;
      open(input.value);
    },
    blur: close,
    keydown(event) {
      const { key, ctrlKey, metaKey } = /** @type {KeyboardEvent} */ (event);
      if (ctrlKey || metaKey) return;
      const step = { ArrowDown: 1, ArrowUp: -1, PageDown: 10, PageUp: -10 }[key];
      if (step !== undefined) {
        if (!list) open("");
        else {
          moved = true;
          activate(Math.min(Math.max(active + step, 0), found.length - 1));
        }
      } else if (key === "Enter" && list) take(active);
      else if (key === "Escape" && list) {
        close();
        input.select();
      } else return;
      event.preventDefault();
    },
  };
  return {
    isOpen: () => list !== null,
    /** @param {Event} event of the field */
    on: (event) => answers[event.type]?.(event),
  };
}
