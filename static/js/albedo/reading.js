/** The interface at hand: its exact albedos from both sides, and what the fits make of it. */

import { short } from "../errors/metrics.js";
import { sample } from "../models/look.js";
import { plain, six } from "../numbers/format.js";
import { h, setText, symbol } from "../page/dom.js";
import { copyText, flash } from "../page/exports.js";
import { sideOf } from "./answers.js";
import { chosenFits, facing, isMetal } from "./fields.js";
import { fitStyle } from "./style.js";

/**
 * @typedef {import('./answers.js').Fit} Fit
 * @typedef {import('./answers.js').Here} Here
 */

const QUANTITIES = /** @type {const} */ (["unpolarized", "s", "p"]);

/** @param {Here["interface"]} media @param {boolean} back @returns {string} which way the light goes, in words */
export function direction({ n_i, n_t, k_t }, back) {
  const [from, into] = back ? [n_t, n_i] : [n_i, n_t];
  const second = k_t > 0 ? `${plain(n_t, 4)} + ${plain(k_t, 4)}i` : plain(into, 4);
  return `from ${plain(from, 4)} into ${second}`;
}

/** @param {Here} here @param {boolean} back @returns {string} */
export function meaning(here, back) {
  const { n_i, n_t, k_t } = here.interface;
  if (k_t > 0) return "";
  const inside = back ? n_t > n_i : n_i > n_t;
  return inside ? "internal diffuse reflectance" : "external diffuse reflectance";
}

/** A condition as people write it. @param {string} reason */
export function written(reason) {
  return reason
    .replaceAll("<=", "≤")
    .replaceAll(">=", "≥")
    .replace(/\beta\b/g, "η")
    .replace(/\bkappa\b/g, "κ");
}

/** @param {(text: string) => void} say */
export function createReading(say) {
  /** @type {{name: string, value: HTMLButtonElement, number: number | null}[]} */
  const cells = [];
  /** @param {string} name */
  function cell(name) {
    const value = h("button", { type: "button", class: "number" });
    const entry = { name, value, number: /** @type {number | null} */ (null) };
    value.addEventListener("click", async () => {
      const done = await copyText(entry.number === null ? "none" : String(entry.number));
      flash(value, done);
      say(done ? `${name} copied` : "Copying is not allowed here");
    });
    cells.push(entry);
    return entry;
  }
  /** @param {string} name */
  function line(name) {
    const way = h("span", { class: "way" });
    const what = h("span", { class: "meaning" });
    const entries = QUANTITIES.map((q) => cell(`${name} albedo, ${q}`));
    const tr = h(
      "tr",
      {},
      h("th", { scope: "row" }, way, what),
      ...entries.map((e) => h("td", {}, e.value)),
    );
    return { tr, way, what, entries };
  }
  const forward = line("forward");
  const back = line("reverse");
  const flat = cell("flatland albedo");
  const exact = h(
    "table",
    { class: "exact-albedos" },
    h("caption", { class: "hidden" }, "Exact albedos of the interface"),
    h(
      "thead",
      {},
      h("tr", {}, h("td"), ...["A", "A_s", "A_p"].map((s) => h("th", { scope: "col" }, symbol(s)))),
    ),
    h(
      "tbody",
      {},
      forward.tr,
      back.tr,
      h(
        "tr",
        {},
        h(
          "th",
          { scope: "row" },
          "in flatland",
          h("span", { class: "meaning" }, "two dimensions, unpolarized"),
        ),
        h("td", {}, flat.value),
        h("td"),
        h("td"),
      ),
    ),
  );
  const body = h("tbody", {});
  const fitTable = h(
    "table",
    { class: "fit-values" },
    h("caption", { class: "hidden" }, "The fits for this interface"),
    h(
      "thead",
      {},
      h("tr", {}, ...["fit", "albedo", "error"].map((text) => h("th", { scope: "col" }, text))),
    ),
    body,
  );
  const side = h("p", { class: "reason" });
  const method = h("p", { class: "reason" });
  const element = h("div", { class: "reading" }, exact, method, side, fitTable);

  /** @param {{value: HTMLButtonElement, name: string, number: number | null}} entry @param {number | null} number */
  function put(entry, number) {
    entry.number = number;
    setText(entry.value, six(number));
    entry.value.toggleAttribute("data-none", number === null);
    const label = `${entry.name}: ${entry.value.textContent}, copy`;
    if (entry.value.ariaLabel !== label) entry.value.ariaLabel = label;
  }

  return {
    element,
    /** @param {State} state @param {Here | undefined} here @param {readonly Fit[]} fits */
    update(state, here, fits) {
      if (!here) return;
      setText(forward.way, direction(here.interface, false));
      setText(forward.what, meaning(here, false));
      setText(back.way, here.reverse ? direction(here.interface, true) : "from inside");
      setText(
        back.what,
        here.reverse ? meaning(here, true) : "an absorber is met from outside alone",
      );
      QUANTITIES.forEach((q, i) => {
        put(/** @type {typeof flat} */ (forward.entries[i]), here.exact[q]);
        put(/** @type {typeof flat} */ (back.entries[i]), here.reverse?.exact[q] ?? null);
      });
      put(flat, here.flatland);
      setText(method, `exact by ${here.exact.method}`);
      const forwards = isMetal(state.surface) || facing(state);
      const { approximations } = sideOf(here, forwards);
      const rows = chosenFits(state).flatMap((id) => {
        const found = approximations.find((a) => a.id === id);
        return found ? [found] : [];
      });
      setText(
        side,
        rows.length ? `Fits ${direction(here.interface, !forwards && here.reverse !== null)}:` : "",
      );
      fitTable.hidden = rows.length === 0;
      body.replaceChildren(
        ...rows.map((row) =>
          h(
            "tr",
            { "data-fit": row.id, "data-outside": !row.in_domain },
            h(
              "th",
              { scope: "row" },
              h("span", { class: "overlay-name" }, sample(fitStyle(fits, row.id)), row.title),
              row.reason
                ? h("span", { class: "beyond" }, `outside its domain: ${written(row.reason)}`)
                : null,
            ),
            h("td", {}, six(row.value)),
            h("td", {}, short(row.error)),
          ),
        ),
      );
    },
  };
}
