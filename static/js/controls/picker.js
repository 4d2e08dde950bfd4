/** The list of media below a field that is typed into. */

import { add, findPages, isPage, pathOf } from "../media/brought.js";
import { stretch } from "../media/wavelength.js";
import { h } from "../page/dom.js";
import { loadStyles } from "../page/style.js";
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

/** From this rank on what was typed is inside a word alone. */
const PART = 6;
const LETTER = /[\p{L}\p{N}]/u;

/** Whether a word of a text begins so. @param {string} text @param {string} asked */
function begins(text, asked) {
  for (let at = text.indexOf(asked); at >= 0; at = text.indexOf(asked, at + 1))
    if (!LETTER.test(text.charAt(at - 1))) return true;
  return false;
}

/**
 * Media by what was typed, those that have it as a word and those that have it inside one: names and ids
 * that begin so, then words and other names, then authors; where nothing does, what is spelled nearly so.
 * @template {Pick<Material, 'id' | 'name' | 'category' | 'aliases' | 'source'>} M
 * @param {readonly M[]} materials
 * @param {string} text
 * @returns {{words: M[], parts: M[]}}
 */
export function sorted(materials, text) {
  const asked = text.trim().toLowerCase();
  if (asked === "") return { words: [...materials], parts: [] };
  /** @param {M} material */
  const rank = ({ id, name, category, aliases = [], source = "" }) => {
    const [own, called] = [id.toLowerCase(), name.toLowerCase()];
    if (own === asked || called === asked) return 0;
    if (called.startsWith(asked)) return 1;
    if (own.startsWith(asked)) return 2;
    const names = [called, own, ...aliases.map((alias) => alias.toLowerCase())];
    if (names.some((one) => begins(one, asked))) return 3;
    if (category.startsWith(asked)) return 4;
    if (asked.length < 3) return 9;
    const paper = source.toLowerCase();
    if (begins(paper, asked)) return 5;
    if (called.includes(asked) || own.includes(asked)) return PART;
    return paper.includes(asked) ? PART + 1 : 9;
  };
  const ranked = materials.map((m) => ({ m, rank: rank(m) })).filter((r) => r.rank < 9);
  ranked.sort((a, b) => a.rank - b.rank);
  /** @param {boolean} inside */
  const those = (inside) => ranked.filter((r) => r.rank >= PART === inside).map(({ m }) => m);
  if (ranked.length > 0) return { words: those(false), parts: those(true) };
  const slips = asked.length < LEAST_WORD ? 0 : asked.length < LONG_WORD ? 1 : 2;
  const near = materials
    .map((m) => {
      const words = [m.id, ...m.name.split(/[\s,()]+/), ...(m.aliases ?? [])]
        .map((w) => w.toLowerCase())
        .filter((word) => word.length >= LEAST_WORD);
      return { m, far: Math.min(...words.map((word) => distance(asked, word))) };
    })
    .filter(({ far }) => far <= slips);
  return { words: near.sort((a, b) => a.far - b.far).map(({ m }) => m), parts: [] };
}

/**
 * The same in one list.
 * @template {Pick<Material, 'id' | 'name' | 'category' | 'aliases' | 'source'>} M
 * @param {readonly M[]} materials
 * @param {string} text
 */
export function matching(materials, text) {
  const { words, parts } = sorted(materials, text);
  return [...words, ...parts];
}

/**
 * What the page has, and pages of refractiveindex.info in the order of their answer: words before parts
 * of words, and each time pages last, but for those that lead. What follows pages has a name.
 * @param {readonly Material[]} materials
 * @param {readonly Material[]} pages
 * @param {number} leading
 * @param {string} text
 * @returns {{name: string | null, rows: Material[]}[]}
 */
export function inTurn(materials, pages, leading, text) {
  const { words, parts } = sorted(materials, text);
  const known = new Set([...words, ...parts].map(({ id }) => id));
  /** @param {readonly Material[]} rows */
  const others = (rows) => rows.filter(({ id }) => !known.has(id));
  const led = others(pages.slice(0, leading));
  const rest = others(pages.slice(leading));
  const worded = new Set(sorted(rest, text).words);
  const after = rest.filter((page) => worded.has(page));
  return [
    { name: PAGES, rows: led },
    { name: led.length ? "Other media" : null, rows: words },
    { name: PAGES, rows: after },
    { name: led.length + after.length ? "Inside other words" : null, rows: parts },
    { name: PAGES, rows: rest.filter((page) => !worded.has(page)) },
  ];
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
  await loadStyles("media-list");
  pickers += 1;
  const own = `media-${pickers}`;
  /** @type {HTMLElement | null} */
  let list = null;
  /** @type {Material[]} */
  let found = [];
  let active = -1;
  /** Whether the line was chosen by keys; else it is the best match, whichever that is. */
  let moved = false;
  /** Pages that fit what was typed, and what that is. @type {{text: string, rows: Material[], leading: number}} */
  let pages = { text: "", rows: [], leading: 0 };
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let searching;

  /** Pages come later. @param {string} text */
  function search(text) {
    clearTimeout(searching);
    if (text.trim() === "" || text === pages.text) return;
    searching = setTimeout(async () => {
      const { rows, leading } = await findPages(text).catch(() => ({ rows: [], leading: 0 }));
      if (!list || input.value !== text) return;
      pages = { text, rows, leading };
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
    const { rows: listed, leading } = pages.text === text ? pages : { rows: [], leading: 0 };
    const runs = inTurn(materials, listed, leading, text);
    const all = [...runs.flatMap(({ rows }) => rows), OWN];
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
    let at = 0;
    for (const { name, rows } of names.length ? [] : runs) {
      const first = list.querySelector(`[data-index="${at}"]`);
      if (name && rows.length) first?.before(h("li.media-group", { role: "presentation" }, name));
      at += rows.length;
    }
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
