/** A model as code to take away: language, real numbers or colors, copy and save. */

import { createChoice } from "../controls/panel.js";
import { h, setText } from "../page/dom.js";
import { copyText, flash } from "../page/exports.js";
import { loadStyle } from "../page/style.js";
import { createModelChoice } from "./choice.js";
import { LANGUAGES, snippetPath } from "./fields.js";

await loadStyle("css/snippets.css");

/** What the server's word for a check means to who pastes the code. @type {Record<string, string>} */
const CHECKED = {
  run: "Tested: ",
  compiled: "Compiled, not run: ",
  untested: "Untested: ",
};

/**
 * @param {object} options
 * @param {Model[]} options.models
 * @param {Pick<Actions, 'set'>} options.actions
 * @param {(text: string) => void} options.say
 * @param {(name: string, blob: Blob) => void} options.save
 */
export function createSnippets({ models, actions, say, save }) {
  const model = createModelChoice({
    models,
    label: "Model whose code is shown",
    actions,
  });
  const language = createChoice({
    legend: "Language",
    items: LANGUAGES.map(({ id, label }) => ({ value: id, label })),
    onChange: ([value]) => actions.set({ language: value }),
  });
  const channels = createChoice({
    legend: "Arguments",
    items: [
      { value: "1", label: "numbers" },
      { value: "3", label: "colors", note: "adds a function that takes and returns RGB" },
    ],
    onChange: ([value]) => actions.set({ channels: value }),
  });
  const code = h("code", {});
  const box = h("pre", { class: "code", tabindex: "0", role: "group", "aria-label": "Code" }, code);
  const trust = h("span", {});
  const link = h("a", { class: "quiet" }, "as plain text");
  const checked = h("p", { class: "checked" }, trust, " ", link);
  const wrong = h("p", { class: "row-error", role: "status" });
  /** @type {{model: string, language: string} | null} */
  let shown = null;
  const copy = h(
    "button",
    {
      type: "button",
      class: "quiet",
      onclick: async () => {
        const done = await copyText(code.textContent ?? "");
        flash(copy, done);
        say(done ? "The code was copied." : "The browser refused to copy.");
      },
    },
    "Copy code",
  );
  const keep = h(
    "button",
    {
      type: "button",
      class: "quiet",
      onclick: () => {
        if (!shown) return;
        const file = LANGUAGES.find((l) => l.id === shown?.language)?.file ?? "txt";
        save(`${shown.model}.${file}`, new Blob([code.textContent ?? ""], { type: "text/plain" }));
      },
    },
    "Save",
  );
  const element = h(
    "section",
    { class: "column snippets", "aria-label": "Shader code" },
    h(
      "div",
      { class: "heading" },
      h("h2", {}, "Shader code"),
      h("p", { class: "exports" }, copy, keep),
    ),
    h(
      "div",
      { class: "snippet-controls" },
      h("span", { class: "picker" }, model.element),
      language.element,
      channels.element,
    ),
    wrong,
    box,
    checked,
  );

  return {
    element,
    /**
     * @param {State} now
     * @param {readonly string[]} offered ids of the models to choose among
     * @param {any} answer of /shaders/{model}
     * @param {{title: string, lines: string[]} | undefined} problem
     */
    update(now, offered, answer, problem) {
      model.update(now, offered);
      language.update([now.language]);
      channels.update([now.channels]);
      channels.element.hidden = now.language === "python"; // arrays broadcast
      setText(wrong, problem ? problem.lines.join(" · ") || problem.title : "");
      box.hidden = problem !== undefined;
      checked.hidden = problem !== undefined;
      copy.disabled = keep.disabled = problem !== undefined || !answer;
      if (!answer || problem) return;
      shown = answer;
      setText(code, answer.code);
      setText(trust, `${CHECKED[answer.checked] ?? ""}${answer.checked_by}.`);
      link.href = `api/v1${snippetPath(now, offered)}&format=text`;
    },
  };
}
