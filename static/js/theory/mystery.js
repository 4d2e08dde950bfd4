/** A material to guess: its curve is given, n and k are to be found. A link sends one to others. */

import { landmarksOf, locate, read, values } from "../curves/reading.js";
import { NEGLIGIBLE } from "../media/constants.js";
import { ExpressionError, evaluate } from "../numbers/entry.js";
import { angle, percent, plain } from "../numbers/format.js";
import { h, setText } from "../page/dom.js";
import { copyText, flash } from "../page/exports.js";
import { addressOf } from "../page/links.js";
import { pieces } from "../page/prose.js";
import { UNTOUCHED } from "./fields.js";
import { settingOf } from "./lesson.js";
import { decode, encode } from "./mystery-code.js";
import { FIRST_MYSTERY, GUESS } from "./queries.js";
import { createRows } from "./rows.js";
import { createStage } from "./stage.js";

/** How near is found: what a slider can be set to without patience. */
const NEAR = { absolute: 0.02, relative: 0.02 };

/** @param {number} guess @param {number} truth */
export const isNear = (guess, truth) =>
  Math.abs(guess - truth) <= Math.max(NEAR.absolute, NEAR.relative * truth);

/** @param {ViewContext} context */
export function createMystery({ catalog, state, actions, say }) {
  const stage = createStage({
    catalog,
    name: "Reflectance of the mystery material and of the guess",
    onTheta: (deg, history) => actions.set({ own_deg: deg }, { history }),
    onSettle: actions.settle,
  });
  const rows = createRows({
    rows: GUESS.rows ?? {},
    presets: settingOf(/** @type {State} */ (UNTOUCHED), GUESS),
    catalog,
    actions,
    prefix: "mystery-",
  });
  const apart = h("p", { class: "lesson-live" });
  const verdict = h("p", { class: "verdict" });
  const check = h("button", { type: "button", class: "forward" }, "Check my answer");
  const hint = h("button", { type: "button", class: "quiet" }, "a hint");
  const again = h("button", { type: "button", class: "quiet" }, "another material");
  const hints = h("ol", { class: "hints" });
  const boxes = ["n", "k"].map((name) =>
    h("input", {
      class: "box",
      type: "text",
      value: name === "n" ? "1.77" : "0",
      "aria-label": `${name} of the material to send`,
      autocomplete: "off",
      spellcheck: "false",
    }),
  );
  const make = h("button", { type: "button", class: "quiet" }, "copy the link");
  const made = h("p", { class: "hint made" });
  const maker = h(
    "details",
    { class: "definitions" },
    h("summary", {}, "Make one for others"),
    h(
      "p",
      {},
      "Whoever opens the link sees the curve; n and k stand in it as a code that tells nothing to the eye.",
    ),
    h(
      "p",
      { class: "maker" },
      ...boxes.map((box, i) => h("label", {}, h("i", {}, i ? "k" : "n"), " ", box)),
      make,
    ),
    made,
  );
  const element = h(
    "div",
    { class: "lessons mystery" },
    h(
      "article",
      { class: "lesson-text" },
      h("h2", {}, "Mystery material"),
      h("h3", { class: "lesson-title" }, "Which n and k?"),
      h(
        "div",
        { class: "prose" },
        h(
          "p",
          {},
          ...pieces(
            "The heavy line was measured on an unknown material in air. Move $n$ and $k$ until your dashed line lies on it, then check.",
          ),
        ),
        h(
          "p",
          {},
          ...pieces(
            "Begin where the line begins: $F_0$ alone leaves a whole circle of $n$ and $k$, and the bend before grazing incidence decides among them. A line that falls to a dip and rises late belongs to a metal.",
          ),
        ),
      ),
      h("p", { class: "lesson-walk" }, check, hint, again),
      verdict,
      hints,
      maker,
    ),
    h(
      "section",
      { class: "lesson-picture", "aria-label": "Picture" },
      stage.element,
      apart,
      rows.element,
    ),
  );
  stage.element.dataset.picture = "guess";

  let told = 0;
  let code = "";
  /** @type {any} */
  let hidden = null;

  /** What can be told, one after the other. */
  function clues() {
    const { kind, F0, brewster_deg, pseudo_brewster_deg } = hidden.interface;
    return [
      "Rₛ and Rₚ are shown too, thin.",
      `Straight on it reflects ${percent(F0)}.`,
      kind === "conductor" ? "It absorbs: k is not 0." : "It is clear: k is 0.",
      brewster_deg === null
        ? `Rₚ is least at ${angle(pseudo_brewster_deg, "deg", 1)}.`
        : `Rₚ vanishes at ${angle(brewster_deg, "deg", 1)}.`,
    ];
  }

  function tell() {
    if (!hidden) return;
    const all = clues();
    hints.replaceChildren(...all.slice(0, told).map((clue) => h("li", {}, clue)));
    hint.disabled = told >= all.length;
  }

  hint.addEventListener("click", () => {
    told += 1;
    tell();
    say(clues()[told - 1] ?? "");
    actions.set({}, { history: "none" });
  });

  check.addEventListener("click", () => {
    const truth = decode(code);
    if (!truth) return;
    const { n_t, k_t } = settingOf(state(), GUESS);
    const right = { n: isNear(n_t, truth.n), k: isNear(k_t, truth.k) };
    const found = right.n && right.k;
    verdict.dataset.found = String(found);
    if (found) {
      const names = catalog.materials
        .filter((m) => isNear(m.n, truth.n) && isNear(m.k ?? 0, truth.k))
        .slice(0, 3)
        .map((m) => m.name.replace(/\s*\(.*\)$/, ""));
      setText(
        verdict,
        `Found: n = ${plain(truth.n)}, k = ${plain(truth.k)}.${names.length ? ` It could be ${[...new Set(names)].join(" or ")}.` : ""}`,
      );
    } else {
      setText(
        verdict,
        right.n || right.k
          ? `Not yet. ${right.n ? "n" : "k"} is right, within two percent.`
          : "Not yet.",
      );
    }
    say(verdict.textContent ?? "");
  });

  again.addEventListener("click", () => {
    const good = catalog.materials.filter(
      ({ n, k }) => n >= 0.05 && n <= 5 && (k ?? 0) <= 8 && Math.abs(n - 1) > 0.05,
    );
    const one = good[Math.floor(Math.random() * good.length)];
    if (!one) return;
    const k = (one.k ?? 0) < NEGLIGIBLE ? 0 : (one.k ?? 0);
    actions.set({ ...UNTOUCHED, mystery: encode({ n: one.n, k }) });
  });

  make.addEventListener("click", async () => {
    try {
      const [n, k] = boxes.map((box) => evaluate(box.value));
      if (n === undefined || k === undefined || !(n >= 0.05 && n <= 5 && k >= 0 && k <= 8))
        throw new ExpressionError("n goes from 0.05 to 5 and k from 0 to 8");
      const href = addressOf("theory", { section: "mystery", mystery: encode({ n, k }) });
      const link = new URL(href, location.href).href;
      const done = await copyText(link);
      flash(make, done);
      made.replaceChildren(h("a", { href }, link));
      say(done ? "Link copied" : "Copying is not allowed here");
    } catch (problem) {
      if (!(problem instanceof ExpressionError)) throw problem;
      setText(made, `${problem.message}.`);
    }
  });

  return {
    element,
    /** @param {State} now @param {Record<string, any>} answers @param {boolean} moving */
    update(now, answers, moving) {
      const next = now.mystery ?? FIRST_MYSTERY;
      if (next !== code) {
        code = next;
        told = 0;
        setText(verdict, "");
        delete verdict.dataset.found;
      }
      const truth = decode(code);
      const { hidden: sent, curves } = answers;
      if (!sent || !curves || sent.interface.n_t !== truth?.n || sent.interface.k_t !== truth?.k)
        return;
      if (sent !== hidden) {
        hidden = sent;
        tell();
      }
      const setting = settingOf(now, GUESS);
      const x = sent.theta_i_deg;
      const mine = { x: curves.theta_i_deg, y: values(curves, "R") };
      /** @type {Trace[]} */
      const lines = [
        ...(told > 0
          ? /** @type {const} */ ([
              ["Rs", "Rₛ", "--Rs", "solid"],
              ["Rp", "Rₚ", "--Rp", "dash"],
            ]).map(([id, label, color, dash]) => ({
              id,
              label,
              x,
              y: values(sent, id),
              color,
              dash,
              width: 1.2,
            }))
          : []),
        {
          id: "hidden",
          label: "measured",
          x,
          y: values(sent, "R"),
          color: "--R",
          dash: "solid",
          width: 2.8,
        },
        { id: "guess", label: "yours", ...mine, color: "--accent", dash: "dash", width: 2 },
      ];
      const reading = stage.update(GUESS, setting, answers, moving, lines);
      rows.update(setting, reading ? landmarksOf(reading.interface) : []);
      const gaps = values(sent, "R").map((y, i) =>
        Math.abs((y ?? 0) - (read(mine.y, locate(mine.x, x[i])) ?? 0)),
      );
      setText(apart, `The two lines are ${plain(Math.max(...gaps), 2)} apart at most.`);
    },
    sentence: () => apart.textContent ?? "",
    theme: () => stage.theme(),
    stop: () => rows.stop(),
    destroy: () => stage.destroy(),
  };
}
