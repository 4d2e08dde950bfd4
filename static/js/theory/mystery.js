/** A material to guess: its curve is given, n and k are to be found. A link sends one to others. */

import { landmarksOf, locate, read, values } from "../curves/reading.js";
import { NEGLIGIBLE } from "../media/media.js";
import { ExpressionError, evaluate } from "../numbers/expression.js";
import { angle, percent, plain } from "../numbers/format.js";
import { copyText, flash, h } from "../page/dom.js";
import { addressOf } from "../page/links.js";
import { html, nothing, render } from "../page/lit.js";
import { pieces } from "../page/prose.js";
import { load, Problem } from "../server/api.js";
import { UNTOUCHED } from "./fields.js";
import { settingOf } from "./lesson.js";
import { decode, encode } from "./mystery-code.js";
import { FIRST_MYSTERY, GUESS, mysteryPath } from "./queries.js";
import { createRows } from "./rows.js";
import { createStage, LOOKS } from "./stage.js";

/** How near is found: what a slider can be set to without patience. */
const NEAR = { absolute: 0.02, relative: 0.02 };

/** @param {number} guess @param {number} truth */
export const isNear = (guess, truth) =>
  Math.abs(guess - truth) <= Math.max(NEAR.absolute, NEAR.relative * truth);

const CLUES = 4;

/**
 * What `/mystery` sends, as many clues as it was asked for.
 * @typedef {{code: string, theta_i_deg: number[], R: number[], Rs: number[] | null, Rp: number[] | null,
 *   F0: number | null, kind: string | null, pseudo_brewster_deg: number | null}} Hidden
 */

/** What was told, one after the other. @param {Hidden} hidden */
function cluesOf({ Rs, F0, kind, pseudo_brewster_deg: least }) {
  const absorbs = kind === "conductor";
  return [
    ...(Rs ? ["Rₛ and Rₚ are shown too, thin."] : []),
    ...(F0 === null ? [] : [`Straight on it reflects ${percent(F0)}.`]),
    ...(kind ? [absorbs ? "It absorbs: k is not 0." : "It is clear: k is 0."] : []),
    ...(least === null
      ? []
      : [`Rₚ ${absorbs ? "is least" : "vanishes"} at ${angle(least, "deg", 1)}.`]),
  ];
}

/** @param {ViewContext} context */
export function createMystery({ catalog, state, actions, say }) {
  const stage = createStage({
    catalog,
    name: "Reflectance of the mystery material and of the guess",
    actions,
  });
  stage.element.dataset.picture = "guess";
  const rows = createRows({
    rows: GUESS.rows ?? {},
    presets: settingOf(UNTOUCHED, GUESS),
    catalog,
    actions,
    prefix: "mystery-",
  });
  const prose = [
    "The heavy line was measured on an unknown material in air. Move $n$ and $k$ until your dashed line lies on it, then check.",
    "Begin where the line begins: $F_0$ alone leaves a whole circle of $n$ and $k$, and the bend before grazing incidence decides among them. A line that falls to a dip and rises late belongs to a metal.",
  ].map((paragraph) => html`<p>${pieces(paragraph)}</p>`);
  const element = h("div.lessons.mystery");

  let code = "";
  /** The material with the clues that were asked for. @type {Hidden | null} */
  let told = null;
  /** How many those are, the ones on their way included. */
  let asked = 0;
  /** Why no clue came. */
  let silence = "";
  let apart = "";
  let verdict = "";
  let found = false;
  /** What became of the link to send. @type {unknown} */
  let made = nothing;

  const clues = () => (told ? cluesOf(told) : []);

  async function hint() {
    const of = code;
    asked += 1;
    try {
      const next = await load(mysteryPath(state(), asked));
      if (of !== code) return;
      if (cluesOf(next).length > clues().length) told = next;
      silence = "";
      say(clues().at(-1) ?? "");
    } catch (problem) {
      if (!(problem instanceof Problem)) throw problem;
      if (of !== code) return;
      asked = clues().length;
      silence = `${problem.message}.`;
    }
    actions.set({}, { history: "none" });
  }

  function check() {
    const truth = decode(code);
    if (!truth) return;
    const { n_t, k_t } = settingOf(state(), GUESS);
    const [n, k] = [isNear(n_t, truth.n), isNear(k_t, truth.k)];
    found = n && k;
    if (found) {
      const names = catalog.materials
        .filter((m) => isNear(m.n, truth.n) && isNear(m.k ?? 0, truth.k))
        .slice(0, 3)
        .map((m) => m.name.replace(/\s*\(.*\)$/, ""));
      const likely = names.length ? ` It could be ${[...new Set(names)].join(" or ")}.` : "";
      verdict = `Found: n = ${plain(truth.n)}, k = ${plain(truth.k)}.${likely}`;
    } else {
      verdict = n || k ? `Not yet. ${n ? "n" : "k"} is right, within two percent.` : "Not yet.";
    }
    say(verdict);
    draw();
  }

  function another() {
    const good = catalog.materials.filter(
      ({ n, k }) => n >= 0.05 && n <= 5 && (k ?? 0) <= 8 && Math.abs(n - 1) > 0.05,
    );
    const one = good[Math.floor(Math.random() * good.length)];
    if (!one) return;
    const k = (one.k ?? 0) < NEGLIGIBLE ? 0 : (one.k ?? 0);
    actions.set({ ...UNTOUCHED, mystery: encode({ n: one.n, k }) });
  }

  /** @param {Event} event */
  async function make({ currentTarget }) {
    try {
      const boxes = [...element.querySelectorAll("input")].filter((box) => box.closest(".maker"));
      const [n, k] = boxes.map((box) => evaluate(box.value));
      if (n === undefined || k === undefined || !(n >= 0.05 && n <= 5 && k >= 0 && k <= 8))
        throw new ExpressionError("n goes from 0.05 to 5 and k from 0 to 8");
      const href = addressOf("theory", { section: "mystery", mystery: encode({ n, k }) });
      const whole = new URL(href, location.href);
      whole.searchParams.delete("embed");
      const link = whole.href;
      const done = await copyText(link);
      flash(/** @type {HTMLElement} */ (currentTarget), done);
      made = html`<a href=${href}>${link}</a>`;
      say(done ? "Link copied" : "Copying is not allowed here");
    } catch (problem) {
      if (!(problem instanceof ExpressionError)) throw problem;
      made = `${problem.message}.`;
    }
    draw();
  }

  /** @param {string} name @param {string} value */
  const box = (
    name,
    value,
  ) => html`<label><i>${name}</i> <input class="box" type="text" value=${value}
    aria-label="${name} of the material to send" autocomplete="off" spellcheck="false"></label>`;

  function draw() {
    render(
      html`<article class="lesson-text">
          <h2>Mystery material</h2>
          <h3 class="lesson-title">Which n and k?</h3>
          <div class="prose">${prose}</div>
          <p class="lesson-walk">
            <button type="button" class="forward" @click=${check}>Check my answer</button>
            <button type="button" class="quiet" ?disabled=${asked >= CLUES}
              @click=${hint}>a hint</button>
            <button type="button" class="quiet" @click=${another}>another material</button>
          </p>
          <p class="verdict" data-found=${verdict ? found : nothing}>${verdict}</p>
          <ol class="hints">${clues().map((clue) => html`<li>${clue}</li>`)}</ol>
          <p class="row-error" role="status">${silence}</p>
          <details class="definitions">
            <summary>Make one for others</summary>
            <p>Whoever opens the link sees the curve; n and k stand in it as a code that tells nothing to the eye.</p>
            <p class="maker">
              ${box("n", "1.77")} ${box("k", "0")}
              <button type="button" class="quiet" @click=${make}>copy the link</button>
            </p>
            <p class="hint made">${made}</p>
          </details>
        </article>
        <section class="lesson-picture" aria-label="Picture">
          ${stage.element}
          <p class="lesson-live">${apart}</p>
          ${rows.element}
        </section>`,
      element,
    );
  }

  draw();
  return {
    element,
    /** @param {State} now @param {Record<string, any>} answers @param {boolean} moving */
    update(now, answers, moving) {
      const next = now.mystery ?? FIRST_MYSTERY;
      if (next !== code) {
        code = next;
        told = null;
        asked = 0;
        silence = "";
        verdict = "";
      }
      const { hidden, curves } = answers;
      /** @type {Hidden} */
      const sent = told ?? hidden;
      if (sent?.code === code && curves) {
        const setting = settingOf(now, GUESS);
        const x = sent.theta_i_deg;
        const mine = { x: curves.theta_i_deg, y: values(curves, "R") };
        /** @param {'R' | 'Rs' | 'Rp'} id @param {number[] | null} y @param {object} look @returns {Trace[]} */
        const line = (id, y, look) => (y ? [{ ...LOOKS[id], x, y, ...look }] : []);
        const lines = [
          ...line("Rs", sent.Rs, { width: 1.2 }),
          ...line("Rp", sent.Rp, { width: 1.2 }),
          ...line("R", sent.R, { id: "hidden", label: "measured", width: 2.8 }),
          { id: "guess", label: "yours", ...mine, color: "--accent", dash: "dash", width: 2 },
        ];
        const reading = stage.update(GUESS, setting, answers, moving, lines);
        rows.update(setting, reading ? landmarksOf(reading.interface) : []);
        const gaps = sent.R.map((y, i) => Math.abs(y - (read(mine.y, locate(mine.x, x[i])) ?? 0)));
        apart = `The two lines are ${plain(Math.max(...gaps), 2)} apart at most.`;
      }
      draw();
    },
    sentence: () => apart,
    theme: () => stage.theme(),
    stop: () => rows.stop(),
    destroy: () => stage.destroy(),
  };
}
