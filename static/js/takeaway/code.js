/** A model as code to take away: language, real numbers or colors, copy and save. */

import { createChoices } from "../controls/panel.js";
import { createSelect } from "../controls/select.js";
import { copyText, flash, h } from "../page/dom.js";
import { aside } from "../page/links.js";
import { html, nothing, render } from "../page/lit.js";
import { loadStyles } from "../page/style.js";
import { sayProblem } from "../page/trouble.js";
import { codeOf, isPiece, LANGUAGES, snippetPath, titlesOf, withPieces } from "./fields.js";

await loadStyles("snippets");

/** What the server's word for a check means to who pastes the code. @type {Record<string, string>} */
const CHECKED = {
  run: "Tested: ",
  compiled: "Compiled, not run: ",
  untested: "Untested: ",
};

/**
 * @param {object} options
 * @param {Model[]} options.models
 * @param {Actions} options.actions
 * @param {(text: string) => void} options.say
 * @param {(name: string, blob: Blob) => void} options.save
 */
export function createSnippets({ models, actions, say, save }) {
  const model = createSelect("Model whose code is shown", (code) => actions.set({ code }));
  const choices = createChoices(actions, {
    language: ["Language", Object.fromEntries(LANGUAGES.map(({ id, label }) => [id, label]))],
    channels: [
      "Arguments",
      { 1: "numbers", 3: ["colors", "adds a function that takes and returns RGB"] },
    ],
  });
  const { language, channels } = choices.elements;
  /** @type {{model?: string, id?: string, language: string, code: string, checked: string, checked_by: string} | null} */
  let shown = null;
  let link = "";
  async function copy(/** @type {{currentTarget: HTMLElement}} */ { currentTarget }) {
    const done = await copyText(shown?.code ?? "");
    flash(currentTarget, done);
    say(done ? "The code was copied." : "The browser refused to copy.");
  }
  function keep() {
    if (!shown) return;
    const { model: ofModel, id, language: used, code } = shown;
    const file = LANGUAGES.find((l) => l.id === used)?.file ?? "txt";
    save(`${ofModel ?? id}.${file}`, new Blob([code], { type: "text/plain" }));
  }
  const element = h("section.column.snippets", { "aria-label": "Shader code" });

  return {
    element,
    /**
     * @param {State} now
     * @param {readonly string[]} offered ids of the models to choose among
     * @param {any} answer of /shaders/{model}
     * @param {import('../page/trouble.js').Problem | undefined} problem
     */
    update(now, offered, answer, problem) {
      const all = withPieces(offered);
      const chosen = codeOf(now, all);
      model.update(chosen, titlesOf(models, all));
      choices.update(now);
      channels.hidden = now.language === "python" || isPiece(chosen); // arrays broadcast
      const wrong = problem !== undefined;
      const none = wrong || !answer;
      if (!none) {
        shown = answer;
        link = `api/v1${snippetPath(now, offered)}&format=text`;
      }
      const { code = "", checked = "", checked_by: by } = shown ?? {};
      render(
        html`<div class="heading">
            <h2>Shader code</h2>
            <p class="exports">
              <button type="button" class="quiet" ?disabled=${none} @click=${copy}>Copy code</button>
              <button type="button" class="quiet" ?disabled=${none} @click=${keep}>Save</button>
            </p>
          </div>
          <div class="snippet-controls">${model.element}${language}${channels}</div>
          <p class="row-error" role="status">${sayProblem(problem)}</p>
          <pre class="code" tabindex="0" role="group" aria-label="Code" ?hidden=${wrong}><code>${code}</code></pre>
          <p class="checked" ?hidden=${wrong}>
            ${by && `${CHECKED[checked] ?? ""}${by}.`}
            <a class="quiet" href=${shown ? link : nothing} target=${aside()}>as plain text</a>
          </p>`,
        element,
      );
    },
  };
}
