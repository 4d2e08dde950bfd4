/** The sheet where a file or a table of n and k becomes a material: what was assumed, and n and k. */

import { NEGLIGIBLE } from "../media/media.js";
import { plain, significant } from "../numbers/format.js";
import { h } from "../page/dom.js";
import { addressOf, follow } from "../page/links.js";
import { html, nothing, render, svg } from "../page/lit.js";
import { loadStyles } from "../page/style.js";
import { Problem } from "../server/api.js";
import { send } from "../server/sending.js";
import { forget, keep, keptRows } from "./kept.js";

/** What may be set by hand, and its values where they are few. @type {[string, string, string[]][]} */
const CONTROLS = [
  ["unit", "Unit", ["nm", "um", "A", "eV", "cm-1", "THz", "m", "mm", "keV", "meV", "GHz", "Hz"]],
  ["columns", "Columns", []],
  ["sign", "Absorption as", ["n+ik", "n-ik"]],
  ["decimal", "Decimal sign", [".", ","]],
  ["zero_k", "k = 0 is", ["known", "unknown"]],
  ["n_from", "n from", ["table", "formula"]],
  ["relative_to", "n relative to", ["vacuum", "air"]],
  ["glass", "Glass", []],
  ["format", "Format", []],
];
/** What a problem offers, as unit=um. */
const OFFERED = /\b([a-z_]+)=([\w+-]+(?:,[\w+-]+)*)/gu;
const PASTED = "pasted.txt";
const WIDTH = 480;
const HEIGHT = 150;

/** Load how the sheet looks, and the page while a file is held over it. */
export const prepare = () => loadStyles("dialog", "own");

/**
 * @param {OwnOptions} options
 * @param {{files?: File[], side?: OwnGiven["side"]}} [given]
 */
export async function openSheet({ catalog, set, say }, { files = [], side = "material" } = {}) {
  await prepare();
  /** @type {File[]} */
  let chosen = files;
  /** @type {Record<string, string>} */
  const byHand = {};
  /** @type {any} */
  let answer = null;
  /** @type {Problem | null} */
  let problem = null;
  let asked = 0;
  /** What was set last, on its way to the answer. @type {Promise<void>} */
  let reading;
  const dialog = h("dialog.dialog.own", { "aria-labelledby": "own-title" });
  const close = () => dialog.close();

  async function read() {
    if (!chosen.length) return;
    asked += 1;
    const mine = asked;
    const form = new FormData();
    for (const file of chosen) form.append("file", file, file.name);
    const query = new URLSearchParams(Object.entries(byHand).filter(([, value]) => value !== ""));
    try {
      const told = await send(`/materials/read?${query}`, form);
      if (mine !== asked) return;
      [answer, problem] = [told, null];
      say(`Read ${told.name}: ${told.report.assumed.length} assumptions`);
    } catch (error) {
      if (mine !== asked) return;
      answer = null;
      problem = error instanceof Problem ? error : new Problem(String(error));
    }
    draw();
  }

  /** @param {string} name @param {string} value */
  function choose(name, value) {
    byHand[name] = value.trim();
    reading = read();
  }

  /** @param {OwnGiven["side"] | null} place */
  async function use(place) {
    await reading; // a name that is left by pressing the button is still to be read
    if (!answer) return;
    const { material, name } = answer;
    try {
      await keep(catalog, material);
    } catch (error) {
      problem = error instanceof Problem ? error : new Problem(String(error));
      draw();
      return;
    }
    close();
    if (place === "layer") window.dispatchEvent(new CustomEvent("ownlayer", { detail: material }));
    else if (place) set({ [place]: material });
    else follow(addressOf("materials", { preset: material }));
    say(`${name} is a medium now`);
  }

  /** A value that a click or a key sets. @param {string} what @param {string} value @param {string} words */
  const setter = (what, value, words = `${what} = ${value}`) =>
    html` <button type="button" class="quiet flip" @click=${() => choose(what, value)}>${words}</button>`;

  /** What is wrong or asked, and values that would answer it. @param {Problem} told */
  function refused({ errors, detail, title }) {
    const said = errors.map((e) => e.message).join("; ");
    const offered = [...said.matchAll(OFFERED)].filter(([, what]) =>
      CONTROLS.some(([name]) => name === what),
    );
    return html`<div class="wrong"><p>${said ? `Needed: ${said}` : detail || title}</p>${offered.map(
      ([, what = "", value = ""]) => setter(what, value),
    )}</div>`;
  }

  /** @param {[string, string, string[]]} control */
  function field([name, label, values]) {
    const value = byHand[name] ?? "";
    /** @param {Event} event */
    const onchange = ({ target }) => choose(name, /** @type {HTMLInputElement} */ (target).value);
    const needed = problem?.errors.some((e) => e.parameter === name);
    return html`<label class=${needed ? "needed" : ""}>
      <span>${label}</span>
      ${
        values.length
          ? html`<select @change=${onchange}>
            <option value="" ?selected=${value === ""}>found out</option>
            ${values.map((one) => html`<option value=${one} ?selected=${one === value}>${one}</option>`)}
          </select>`
          : html`<input type="text" placeholder="found out" .value=${value} @change=${onchange} />`
      }
    </label>`;
  }

  function report() {
    const { report: told, spectrum, name } = answer;
    const clear =
      spectrum.k === null ||
      spectrum.k.every((/** @type {number | null} */ k) => (k ?? 0) < NEGLIGIBLE);
    return html`
      <label class="named"><span>Name</span>
        <input type="text" maxlength="60" .value=${name}
          @change=${(/** @type {Event} */ e) => choose("name", /** @type {HTMLInputElement} */ (e.target).value)} /></label>
      ${plot(spectrum)}
      <h3>Assumed</h3>
      <ul class="assumed">
        ${told.assumed.map(
          (/** @type {any} */ one) =>
            html`<li><b>${one.what} = ${one.value}</b>: ${one.why}${one.alternatives.map(
              (/** @type {string} */ other) => setter(one.what, other),
            )}</li>`,
        )}
        ${told.assumed.length ? nothing : html`<li>nothing</li>`}
        ${CONTROLS.filter(([what]) => byHand[what]).map(
          ([what]) =>
            html`<li class="set"><b>${what} = ${byHand[what]}</b>: set by hand${setter(what, "", "found out again")}</li>`,
        )}
      </ul>
      ${
        told.left_out.length || told.warnings.length || told.merged
          ? html`<h3>To know</h3><ul>
          ${told.warnings.map((/** @type {string} */ one) => html`<li>${one}</li>`)}
          ${told.merged ? html`<li>${told.merged} points at the wavelength of another one: their mean</li>` : nothing}
          ${told.left_out.slice(0, 20).map((/** @type {any} */ row) => html`<li>Line ${row.line} is left out: ${row.why}</li>`)}
          ${told.left_out.length > 20 ? html`<li>and ${told.left_out.length - 20} more lines</li>` : nothing}
        </ul>`
          : nothing
      }
      <p class="uses">
        ${
          side === "layer"
            ? html`<button type="button" class="main" @click=${() => use("layer")}>Use as the layer</button>`
            : nothing
        }
        ${
          side === "incident" && clear
            ? html`<button type="button" class="main" @click=${() => use("incident")}>Use as incident medium</button>`
            : html`<button type="button" class=${side === "layer" ? "" : "main"} @click=${() => use("material")}>Use as second medium</button>`
        }
        <button type="button" @click=${() => use(null)}>Open in Materials</button>
      </p>
      <p class="hint">The link carries the data; they are kept in this browser, and not by the server.</p>`;
  }

  function kept() {
    const rows = keptRows();
    if (!rows.length) return nothing;
    return html`<h3>Kept in this browser</h3>
      <ul class="kept">
        ${rows.map(
          (row) => html`<li><span>${row.name}</span>
            <button type="button" class="quiet" aria-label=${`Remove ${row.name}`}
              @click=${() => {
                forget(row.id);
                say(`${row.name} is removed`);
                draw();
              }}>Remove</button></li>`,
        )}
      </ul>`;
  }

  /** @param {FileList | File[]} given */
  function take(given) {
    chosen = [...given];
    for (const name of Object.keys(byHand)) delete byHand[name];
    reading = read();
  }

  function draw() {
    const held = dialog.contains(document.activeElement);
    render(
      html`<header>
          <h2 id="own-title">Your own material</h2>
          <button type="button" class="quiet" @click=${close}>Close</button>
        </header>
        <div class="from">
          <label><span>A file of n and k, or eta and k together</span>
            <input type="file" multiple @change=${(/** @type {Event} */ e) =>
              take(/** @type {HTMLInputElement} */ (e.target).files ?? [])} /></label>
          <label><span>or a table, pasted</span>
            <textarea rows="3" spellcheck="false" placeholder="wavelength_nm, n, k"
              @change=${(/** @type {Event} */ e) => {
                const { value } = /** @type {HTMLTextAreaElement} */ (e.target);
                if (value.trim()) take([new File([value], PASTED, { type: "text/plain" })]);
              }}></textarea></label>
        </div>
        <div role="alert">${problem ? refused(problem) : nothing}</div>
        ${answer ? report() : nothing}
        ${
          chosen.length
            ? html`<details ?open=${problem !== null}><summary>Set by hand</summary>
              <div class="by-hand">${CONTROLS.map(field)}</div></details>`
            : nothing
        }
        ${kept()}`,
      dialog,
    );
    // A button that set something is gone with what it stood beside.
    if (!held || dialog.contains(document.activeElement)) return;
    /** @type {HTMLElement | null} */
    const near = dialog.querySelector(".set:last-child button") ?? dialog.querySelector(".flip");
    (near ?? dialog.querySelector("button"))?.focus();
  }

  dialog.addEventListener("click", (event) => {
    if (event.target === dialog) close();
  });
  dialog.addEventListener("close", () => dialog.remove());
  draw();
  document.body.append(dialog);
  dialog.showModal();
  reading = read();
}

/** n and k over the wavelength, each to its own scale. @param {any} spectrum */
function plot({ wavelength_nm: x, n, k }) {
  const [low, high] = [x[0], x[x.length - 1]];
  /** @param {(number | null)[]} values */
  const line = (values) => {
    const known = values.filter((value) => value !== null);
    const [least, most] = [Math.min(...known), Math.max(...known)];
    const points = values
      .map((value, i) => {
        if (value === null) return "";
        const right = high > low ? (x[i] - low) / (high - low) : 0.5;
        const up = most > least ? (value - least) / (most - least) : 0.5;
        return `${(6 + right * (WIDTH - 12)).toFixed(1)},${(HEIGHT - 6 - up * (HEIGHT - 12)).toFixed(1)}`;
      })
      .join(" ");
    return { points, said: `${significant(least, 4)} to ${significant(most, 4)}` };
  };
  const index = line(n);
  const absorption = k === null ? null : line(k);
  return html`<figure>
    <svg viewBox="0 0 ${WIDTH} ${HEIGHT}" role="img"
      aria-label="n and k over the wavelength, each from its least to its largest value">
      <polyline class="n" points=${index.points} />
      ${absorption ? svg`<polyline class="k" points=${absorption.points} />` : nothing}
    </svg>
    <figcaption>
      <span>n ${index.said}, solid</span>
      <span>${absorption ? `k ${absorption.said}, dashed` : "k is not known"}</span>
      <span>${plain(low)} to ${plain(high)} nm</span>
    </figcaption>
  </figure>`;
}
