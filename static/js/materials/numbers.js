/** Constants and colors of the chosen preset: shown with six digits, copied in full. */

import { createChoice } from "../controls/panel.js";
import { ExpressionError, evaluate } from "../numbers/entry.js";
import { plain, significant, six, stretch } from "../numbers/format.js";
import { h, setText, symbol } from "../page/dom.js";
import { copyText, flash } from "../page/exports.js";
import { POLICIES } from "./browser.js";
import { paint } from "./table.js";

const CONSTANTS = /** @type {const} */ ([
  ["n", "n"],
  ["k", "k"],
  ["F0", "F_0"],
  ["F82", "F_{82}"],
]);
const COLORS = /** @type {const} */ ([
  ["F0", "F_0", "normal incidence"],
  ["F82", "F_{82}", "cos θ = 1/7"],
  ["F82_tint", "F_{82}", "tint of the F82-tint model"],
]);
const CHANNELS = ["R", "G", "B"];

/**
 * @param {object} options
 * @param {Pick<Actions, 'set'>} options.actions
 * @param {(text: string) => void} options.say
 */
export function createNumbers({ actions, say }) {
  /** @type {any} */
  let detail = null;

  /**
   * @param {string} name that is read out
   * @param {(detail: any) => number | string | null} value
   * @param {(value: number | string | null) => string} print
   */
  function number(name, value, print) {
    const button = h("button", { type: "button", class: "number" });
    button.addEventListener("click", async () => {
      if (!detail) return;
      const done = await copyText(String(value(detail) ?? "none"));
      flash(button, done);
      say(done ? `${name} copied` : "Copying is not allowed here");
    });
    return {
      button,
      update() {
        const text = print(value(detail));
        setText(button, text);
        button.toggleAttribute("data-none", value(detail) === null);
        button.ariaLabel = `${name}: ${text}, copy`;
      },
    };
  }

  /** @param {number | string | null} v */
  const written = (v) =>
    typeof v !== "number"
      ? (v ?? "not given")
      : Math.abs(v - 1) < 0.01 && v !== 1
        ? plain(v, 9)
        : six(v);
  const constants = CONSTANTS.map(([name, sign]) => ({
    sign,
    cell: number(name, (d) => d.constants[name], written),
  }));
  const rows = COLORS.map(([key, sign, note]) => {
    const cells = CHANNELS.map((channel, i) =>
      number(
        `${key} ${channel}`,
        (d) => d.display[key][i],
        (v) => significant(Number(v), 6),
      ),
    );
    const all = h("button", { type: "button", class: "quiet copy" }, "copy");
    all.ariaLabel = `Copy ${key}, three numbers`;
    all.addEventListener("click", async () => {
      if (!detail) return;
      const done = await copyText(detail.display[key].join(", "));
      flash(all, done);
      say(done ? `${key} copied` : "Copying is not allowed here");
    });
    return {
      cells,
      tr: h(
        "tr",
        {},
        h("th", { scope: "row" }, symbol(sign), h("span", { class: "of" }, ` ${note}`)),
        ...cells.map((c) => h("td", {}, c.button)),
        h("td", { class: "copy-cell" }, all),
      ),
    };
  });
  const hex = number(
    "sRGB",
    (d) => d.display.hex,
    (v) => String(v ?? "outside sRGB"),
  );
  const swatch = h("span", { class: "swatch large", "aria-hidden": "true" });

  const at = h("input", {
    class: "box",
    type: "text",
    id: "at-nm",
    autocomplete: "off",
    spellcheck: "false",
    "aria-describedby": "at-nm-error",
  });
  const wrong = h("p", { class: "row-error", id: "at-nm-error", role: "alert" });
  const unit = h("span", {}, "nm");
  at.addEventListener("change", () => {
    const text = at.value.trim();
    try {
      const value = text === "" ? null : evaluate(text);
      if (value !== null && !(value > 0)) throw new ExpressionError("a wavelength is positive");
      setText(wrong, "");
      actions.set({ at_nm: value });
    } catch (problem) {
      if (!(problem instanceof ExpressionError)) throw problem;
      setText(wrong, `λ = “${text}”: ${problem.message}.`);
    }
  });

  const gamut = createChoice({
    legend: "Outside sRGB",
    items: ["scaled", "clamped", "unclamped"].map((value) => ({
      value,
      label: value,
      note: POLICIES[value],
    })),
    onChange: ([value]) => actions.set({ gamut: value }),
  });
  const illuminant = createChoice({
    legend: "Light",
    items: [
      { value: "D65", label: "D65", note: "daylight, the white of sRGB" },
      { value: "E", label: "E", note: "equal energy, adapted to D65 by Bradford" },
    ],
    onChange: ([value]) => actions.set({ illuminant: value }),
  });
  const said = h("p", { class: "hint" });

  const element = h(
    "div",
    { class: "material-numbers" },
    h(
      "section",
      { class: "constants", "aria-label": "Constants at one wavelength" },
      h(
        "div",
        { class: "at" },
        h("label", { for: "at-nm" }, h("h2", {}, "At one wavelength")),
        h("span", { class: "at-box" }, symbol("\\lambda"), at, unit),
      ),
      wrong,
      h(
        "dl",
        { class: "numbers" },
        ...constants.map(({ sign, cell }) =>
          h("div", {}, h("dt", {}, symbol(sign)), h("dd", {}, cell.button)),
        ),
      ),
    ),
    h(
      "section",
      { class: "color-numbers", "aria-label": "Color" },
      h(
        "div",
        { class: "color-head" },
        h("h2", {}, "Linear sRGB"),
        h("span", { class: "hex" }, swatch, hex.button),
      ),
      h(
        "table",
        { class: "colors" },
        h("caption", { class: "hidden" }, "Colors in linear sRGB"),
        h(
          "thead",
          {},
          h("tr", {}, h("td"), ...CHANNELS.map((c) => h("th", { scope: "col" }, c)), h("td")),
        ),
        h("tbody", {}, ...rows.map((r) => r.tr)),
      ),
      h("div", { class: "color-choices" }, gamut.element, illuminant.element),
      said,
    ),
  );

  return {
    element,
    /** @param {State} state */
    choices(state) {
      gamut.update([state.gamut]);
      illuminant.update([state.illuminant]);
    },
    /** @param {any} next the answer of /materials/{id} @param {State} state */
    update(next, state) {
      detail = next;
      for (const { cell } of constants) cell.update();
      for (const { cells } of rows) for (const cell of cells) cell.update();
      hex.update();
      paint(swatch, next.display);
      const shown = next.constants.wavelength_nm;
      if (document.activeElement !== at || !at.value) {
        const asked = state.at_nm ?? shown;
        at.value = asked === null ? "" : plain(asked, 8);
      }
      const single = next.kind !== "spectrum";
      at.hidden = single;
      setText(
        unit,
        !single ? "nm" : shown === null ? "no wavelength stated" : `${plain(shown)} nm alone`,
      );
      at.title = next.n_range_nm ? `known for ${stretch(next.n_range_nm)}` : "";
      const most = Math.max(...next.color.F0);
      const policy =
        next.display.gamut === "scaled" && most > 1
          ? `scaled: divided by the largest channel, ${plain(most, 6)}`
          : next.display.in_gamut
            ? `${next.display.gamut}: within sRGB anyway`
            : `${next.display.gamut}: ${POLICIES[next.display.gamut]}`;
      setText(
        said,
        `${policy}. CIE 1931, ${next.color.illuminant}; luminance Y = ${six(next.color.luminance)}.`,
      );
    },
    /** @param {{title: string, lines: string[]} | undefined} problem */
    problem: (problem) => {
      setText(wrong, problem ? problem.lines.join(" ") || problem.title : "");
      at.toggleAttribute("aria-invalid", Boolean(problem));
    },
  };
}
