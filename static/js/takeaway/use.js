/** The preset as a file of a render engine: what is typed there, what is lost, and how far it will be off. */

import { createChoice } from "../controls/panel.js";
import { plain } from "../numbers/format.js";
import { copying, h } from "../page/dom.js";
import { html, nothing, render } from "../page/lit.js";
import { sayProblem } from "../page/trouble.js";
import { choice, optional, path } from "../state/state.js";

/** Where a material can be taken. @type {Record<string, string>} */
export const TARGETS = {
  blender: "Blender",
  materialx: "MaterialX",
  openpbr: "OpenPBR",
  gltf: "glTF",
  usd: "USD",
  mitsuba: "Mitsuba",
  pbrt: "pbrt",
  luxcore: "LuxCore",
};
/** @type {Record<string, string>} */
export const MODES = {
  nk: "n and k",
  f82: "F82 tint",
  principled: "Principled",
  spectral: "spectra",
  schlick: "F₀",
  ior: "index",
};
/** Which engine, and which of its ways. @returns {Record<string, Field>} */
export const useFields = () => ({
  use_in: choice("blender", Object.keys(TARGETS)),
  use_mode: optional(Object.keys(MODES)),
});

/** @param {string} route @param {State} state @param {(string | false)[]} query what is exported, and how */
export const usePath = (route, { use_in, use_mode }, query) =>
  path(route, [`to=${use_in}`, use_mode !== null && `mode=${use_mode}`, ...query, "format=json"]);

/** More numbers than a color and its opacity are not shown one by one. */
const SHOWN = 4;

/**
 * A parameter in words: each number, or what a long list or text begins with.
 * @param {string | number | number[]} value
 */
export function typed(value) {
  if (typeof value === "number") return plain(value);
  if (typeof value === "string") return value.length > 40 ? `${value.slice(0, 32)}…` : value;
  const first = value
    .slice(0, SHOWN)
    .map((x) => plain(x))
    .join(", ");
  return value.length > SHOWN ? `${first}, … (${value.length} numbers)` : first;
}

/** How far an engine will be off, in a sentence. @param {any} error */
export function off({ max_abs, at_deg, channel, delta_e, delta_e_at_deg, measured_with }) {
  const { model, engine, version, way, note } = measured_with;
  const where = engine ? `as measured in ${engine} ${version}, ${way}` : note;
  const by = [model && `by the model ${model}`, where].filter(Boolean).join(", ");
  return `Largest error ${plain(max_abs, 3)} at ${plain(at_deg)}° in ${channel}, ΔE ${plain(delta_e, 3)} at ${plain(delta_e_at_deg)}°: ${by}.`;
}

/** @param {Pick<ViewContext, 'actions' | 'say' | 'save'> & {parent: HTMLElement}} context */
export function createUse({ parent, actions, say, save }) {
  const target = createChoice({
    legend: "Engine or format",
    items: Object.entries(TARGETS).map(([value, label]) => ({ value, label })),
    onChange: ([use_in]) => actions.set({ use_in, use_mode: null }),
  });
  const problem = h("p.row-error", { role: "alert" });
  const body = h("div.take-body");
  const element = h(
    "section.column.sheet.take",
    { "aria-label": "Use it in" },
    h("div.heading", h("h2", "Use it in")),
    h("div.sheet-controls", target.element),
    problem,
    body,
  );
  parent.append(element);

  /** @param {any} answer */
  function modes({ mode, modes }) {
    if (modes.length < 2) return nothing;
    const option = (/** @type {string} */ one) => html`<label><input type="radio" name="use-mode"
      .checked=${one === mode} @change=${() => actions.set({ use_mode: one })}><span>${MODES[one]}</span></label>`;
    return html`<fieldset class="choice"><legend>What is kept</legend>
      <div class="options">${modes.map(option)}</div></fieldset>`;
  }

  /** @param {string} title @param {[string, string | number | number[]]} parameter */
  const row = (title, [name, value]) => html`<tr><th scope="row">${name}</th>
    <td><button type="button" class="number" aria-label="${name} in ${title}: ${typed(value)}, copy"
      @click=${copying(() => String(value).replaceAll(",", ", "), say, `${name} copied`)}>${typed(value)}</button></td></tr>`;

  /** @param {any} answer */
  function draw(answer) {
    const { title, mode_title, files, parameters, lost, error } = answer;
    const [file] = files;
    const blob = () => new Blob([file.text], { type: "text/plain" });
    render(
      html`<div class="sheet-controls">${modes(answer)}</div>
        <p>${title}, ${mode_title}. ${off(error)}</p>
        <table class="parameters">
          <caption class="hidden">What to type in ${title}</caption>
          <tbody>${Object.entries(parameters).map((one) => row(title, /** @type {any} */ (one)))}</tbody>
        </table>
        <ul class="lost">${lost.map((/** @type {string} */ one) => html`<li>${one}</li>`)}</ul>
        <div class="take-file">
          <button type="button" class="quiet" @click=${() => save(file.name, blob())}>save ${file.name}</button>
          <button type="button" class="quiet" @click=${copying(() => file.text, say, `${file.name} copied`)}>copy it</button>
        </div>
        <details class="definitions"><summary>What is in the file</summary>
          <pre tabindex="0" role="region" aria-label=${file.name}>${file.text}</pre></details>`,
      body,
    );
  }

  return {
    /** @param {State} state @param {any} answer */
    update(state, answer) {
      target.update([state.use_in]);
      if (answer) draw(answer);
    },
    /** @param {{title: string, lines: string[]} | undefined} what */
    problem(what) {
      problem.textContent = sayProblem(what);
      body.hidden = Boolean(what);
    },
  };
}
