/** Constants and colors of the chosen preset: shown with six digits, copied in full. */

import { createChoices } from "../controls/panel.js";
import { createTyped } from "../controls/typed.js";
import { stretch } from "../media/wavelength.js";
import { ExpressionError, evaluate } from "../numbers/expression.js";
import { plain, six } from "../numbers/format.js";
import { copying, h, setText, symbol } from "../page/dom.js";
import { html, render } from "../page/lit.js";
import { POLICIES } from "./browser.js";
import { told } from "./panel.js";
import { swatch } from "./table.js";

const CONSTANTS = /** @type {const} */ ([
  ["n", "n"],
  ["n_absolute", "n"],
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

/** @param {number | null | undefined} v undefined before there is an answer */
function written(v) {
  if (v === undefined) return "";
  if (v === null) return "not given";
  return v !== 1 && Math.abs(v - 1) < 0.01 ? plain(v, 9) : six(v);
}

/** What was done about a color outside sRGB, and where it is from. @param {any} detail */
function policyOf({ display: { gamut, in_gamut }, color }) {
  const most = Math.max(...color.F0);
  const done =
    gamut === "scaled" && most > 1
      ? `divided by the largest channel, ${plain(most, 6)}`
      : in_gamut
        ? "within sRGB anyway"
        : POLICIES[gamut];
  const outside =
    gamut === "unclamped" && color.outside_0_to_1.length
      ? ` Channels of ${color.outside_0_to_1.join(", ")} leave 0 to 1: engines cut or refuse them.`
      : "";
  return `${gamut}: ${done}. CIE 1931, ${color.illuminant}; luminance Y = ${six(color.luminance)}.${outside}`;
}

/** @param {Pick<ViewContext, 'actions' | 'say'>} context */
export function createNumbers({ actions, say }) {
  const notes = Object.entries(POLICIES).map(([name, note]) => [name, [name, note]]);
  const choices = createChoices(actions, {
    gamut: ["Outside sRGB", Object.fromEntries(notes)],
    illuminant: [
      "Light",
      {
        D65: ["D65", "daylight, the white of sRGB"],
        E: ["E", "equal energy, adapted to D65 by Bradford"],
      },
    ],
  });
  const at = createTyped({
    attributes: { class: "box", id: "at-nm" },
    id: "at-nm-error",
    parse(text) {
      const value = text === "" ? null : evaluate(text);
      if (value !== null && !(value > 0)) throw new ExpressionError("a wavelength is positive");
      return value;
    },
    onChange: (at_nm) => actions.set({ at_nm }),
    words: (text, why) => `λ = “${text}”: ${why}.`,
  });
  const lambda = symbol("\\lambda");
  const constants = CONSTANTS.map(([name, sign]) => ({ name, sign: symbol(sign) }));
  const colors = COLORS.map(([name, sign, note]) => ({ name, sign: symbol(sign), note }));
  const element = h("div.material-numbers");

  /** @param {string} name that is read out @param {number | string | null | undefined} value in full @param {string} text */
  const number = (name, value, text) => html`<button type="button" class="number"
    ?data-none=${value === null} aria-label="${name}: ${text}, copy"
    @click=${copying(() => String(value ?? "none"), say, `${name} copied`)}>${text}</button>`;

  /** @param {typeof colors[number]} color @param {number[]} rgb */
  const row = ({ name, sign, note }, rgb = []) => html`<tr>
    <th scope="row">${sign}<span class="of"> ${note}</span></th>
    ${CHANNELS.map((channel, i) => html`<td>${number(`${name} ${channel}`, rgb[i], rgb.length ? six(rgb[i]) : "")}</td>`)}
    <td class="copy-cell">
      <button type="button" class="quiet copy" aria-label="Copy ${name}, three numbers"
        @click=${copying(() => rgb.join(", "), say, `${name} copied`)}>copy</button>
    </td>
  </tr>`;

  /** @param {any} detail the answer of /materials/{id}, null before there is one */
  function draw(detail) {
    const { constants: known = {}, display = {}, kind = "spectrum" } = detail ?? {};
    const nm = known.wavelength_nm;
    /** Where n was measured in air, both numbers are told apart. @type {Record<string, string>} */
    const media = detail?.relative_to === "air" ? { n: " in air", n_absolute: " in vacuum" } : {};
    const shown = constants.filter(({ name }) => name !== "n_absolute" || name in media);
    const alone = nm ? `${plain(nm)} nm alone` : "no wavelength stated";
    render(
      html`<section class="constants" aria-label="Constants at one wavelength">
          <div class="at">
            <label for="at-nm"><h2>At one wavelength</h2></label>
            <span class="at-box">${lambda} ${at.box} <span>${kind === "spectrum" ? "nm" : alone}</span></span>
          </div>
          ${at.wrong}
          <dl class="numbers">
            ${shown.map(({ name, sign }) => html`<div><dt>${sign}<span class="of">${media[name]}</span></dt><dd>${number(name, known[name], written(known[name]))}</dd></div>`)}
          </dl>
        </section>
        <section class="color-numbers" aria-label="Color">
          <div class="color-head">
            <h2>Linear sRGB</h2>
            <span class="hex">${swatch(display.hex, "large")}
              ${number("sRGB", display.hex, detail ? (display.hex ?? "outside sRGB") : "")}</span>
          </div>
          <table class="colors">
            <caption class="hidden">Colors in linear sRGB</caption>
            <thead><tr><td></td>${CHANNELS.map((c) => html`<th scope="col">${c}</th>`)}<td></td></tr></thead>
            <tbody>${colors.map((one) => row(one, display[one.name]))}</tbody>
          </table>
          <div class="color-choices">${choices.elements.gamut} ${choices.elements.illuminant}</div>
          <p class="hint">${detail && policyOf(detail)}</p>
        </section>`,
      element,
    );
  }
  draw(null); // what is wrong with a wavelength can be said before

  return {
    element,
    /** @param {State} state */
    choices: (state) => choices.update(state),
    /** @param {any} detail @param {State} state */
    update(detail, state) {
      const asked = state.at_nm ?? detail.constants.wavelength_nm;
      const written = asked === null ? "" : plain(asked, 8);
      at.update(written);
      at.box.value ||= written;
      at.box.hidden = detail.kind !== "spectrum";
      at.box.title = detail.n_range_nm ? `known for ${stretch(detail.n_range_nm)}` : "";
      draw(detail);
    },
    /** @param {{title: string, lines: string[]} | undefined} problem */
    problem(problem) {
      setText(at.wrong, told(problem));
      at.box.toggleAttribute("aria-invalid", Boolean(problem));
    },
  };
}
