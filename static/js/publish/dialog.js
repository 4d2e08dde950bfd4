/** The sheet where a figure is fitted to a paper or a slide: background, size, font size, caption, and a preview. */

import { h, saveEach, setText } from "../page/dom.js";
import { loadStyles } from "../page/style.js";
import { tooSmall } from "../plot/publication.js";
import { load } from "../server/api.js";
import { captionOf, mediaBehind } from "./caption.js";

const GROUNDS = /** @type {const} */ ([
  ["white", "white"],
  ["clear", "transparent"],
  ["clear-dark", "transparent, for dark slides"],
]);
const SIZES = /** @type {const} */ ([
  ["width_mm", "Width, mm", 85, 30, 400],
  ["height_mm", "Height, mm", 60, 25, 400],
  ["font_pt", "Font size, pt", 7, 4, 24],
]);
/** Of two columns, mm. */
const WIDE = 170;
const REST = 250; // ms without a change before the preview is drawn

function createDialog() {
  /** @type {PublishTask} */
  let task = { figures: [], call: "", behind: {}, name: "", save: () => {} };
  /** A figure's own words and what was made of them. @type {Map<string, string>} */
  const edited = new Map();
  /** What went wrong, until something is changed. */
  let failure = "";
  const ground = h(
    "select",
    { name: "ground" },
    ...GROUNDS.map(([value, label]) => h("option", { value }, label)),
  );
  const boxes = SIZES.map(([name, label, value, min, max]) => ({
    name,
    label,
    input: h("input", { type: "number", name, value, min, max, step: "any", required: true }),
  }));
  const withCaption = h("input", { type: "checkbox", name: "captioned", checked: true });
  /** A text for each figure. @type {HTMLTextAreaElement[]} */
  let words = [];
  const captions = h("div.publish-captions");
  const trouble = h("p.row-error", { role: "alert" });
  const preview = h("div.publish-preview");
  const saves = /** @type {const} */ (["svg", "png"]).map((format) =>
    h(
      "button",
      { type: "button", onclick: () => void take(format) },
      format === "svg" ? "Save as SVG" : "Save as PNG, 600 dpi",
    ),
  );
  const close = h("button", { type: "button", onclick: () => dialog.close() }, "Close");
  const form = h(
    "form",
    { method: "dialog" },
    h(
      "div.publish-fields",
      h("label", h("span", "Background"), ground),
      ...boxes.map(({ label, input }) => h("label", h("span", label), input)),
    ),
    h("label.publish-caption", withCaption, "Caption below the figure"),
    captions,
    trouble,
    preview,
    h("div.publish-actions", ...saves, close),
  );
  const dialog = h(
    "dialog.dialog.publish",
    { "aria-labelledby": "publish-title" },
    h("h2", { id: "publish-title" }, "Figure for print"),
    form,
  );
  document.body.append(dialog);

  /** @returns {Omit<Publication, "caption"> | null} what is asked for, or null where it cannot be */
  function asked() {
    const [width_mm = 0, height_mm = 0, font_pt = 0] = boxes.map(
      ({ input }) => input.valueAsNumber,
    );
    const wrong = boxes.find(({ input }) => !input.validity.valid);
    const publication = {
      ground: /** @type {Publication["ground"]} */ (ground.value),
      width_mm,
      height_mm,
      font_pt,
    };
    const beside = Math.max(0, ...task.figures.map((figure) => figure.beside ?? 0));
    const problem = wrong
      ? `${wrong.label}: ${wrong.input.min} to ${wrong.input.max}`
      : tooSmall(publication, beside);
    for (const { input } of boxes)
      input.setAttribute("aria-invalid", String(!input.validity.valid));
    setText(trouble, problem || failure);
    return problem ? null : publication;
  }

  /**
   * @param {"svg" | "png"} format
   * @param {Omit<Publication, "caption">} publication
   * @returns {Promise<Blob[] | null>} null, with the reason in the sheet, where it cannot be made
   */
  async function made(format, publication) {
    const { width_mm, height_mm } = publication;
    const texts = words.map(({ value }) => (withCaption.checked ? value.split("\n") : []));
    try {
      return await Promise.all(
        task.figures.map((figure, i) =>
          figure.exportAs(format, { ...publication, caption: texts[i] ?? [] }),
        ),
      );
    } catch {
      failure =
        format === "png"
          ? `This browser cannot make a PNG of ${width_mm} × ${height_mm} mm at 600 dpi: make it smaller, or save it as SVG.`
          : "The figure cannot be drawn.";
      setText(trouble, failure);
      return null;
    }
  }

  /** @param {"svg" | "png"} format */
  async function take(format) {
    const publication = asked();
    if (!publication) return;
    const { name, save } = task;
    const blobs = (await made(format, publication)) ?? [];
    saveEach(save, blobs, (part) => `${name}${part}-print.${format}`);
  }

  let turn = 0;
  async function show() {
    turn += 1;
    const own = turn;
    const publication = asked();
    captions.hidden = !withCaption.checked;
    if (!publication) return;
    const blobs = await made("svg", publication);
    if (own !== turn || !blobs) return;
    const pictures = blobs.map((blob) => {
      const src = URL.createObjectURL(blob);
      const forget = () => URL.revokeObjectURL(src);
      return h("img", { src, alt: "Preview of the figure", onload: forget, onerror: forget });
    });
    preview.dataset.ground = publication.ground;
    preview.replaceChildren(...pictures);
  }

  let waiting = 0;
  form.addEventListener("input", () => {
    failure = "";
    clearTimeout(waiting);
    waiting = window.setTimeout(() => void show(), REST);
  });
  form.addEventListener("submit", (event) => {
    event.preventDefault(); // Enter in a box draws, it does not close
    void show();
  });

  /** @param {boolean} loading the captions cannot be edited or saved before they are there */
  function wait(loading) {
    for (const one of [...words, ...saves]) one.disabled = loading;
    for (const one of words) one.placeholder = loading ? "Looking up the sources…" : "";
  }

  /** @param {PublishTask} next */
  function prepare(next) {
    task = next;
    turn += 1; // a preview that is still being drawn is of another figure
    failure = "";
    clearTimeout(waiting);
    preview.replaceChildren();
    const [width] = boxes;
    if (width && next.wide && width.input.valueAsNumber < WIDE) width.input.value = String(WIDE);
    words = next.figures.map((_, i) =>
      h("textarea", {
        name: "caption",
        rows: 7,
        "aria-label": `Text of the caption${next.figures.length > 1 ? ` ${i + 1}` : ""}`,
      }),
    );
    captions.replaceChildren(...words);
    wait(true);
    asked();
  }

  /** @param {PublishTask} next @returns {Promise<string[]>} */
  async function captionsOf({ figures, call: part, behind }) {
    const calls = [...document.querySelectorAll("#calls code")].map((code) =>
      (code.textContent ?? "").replace(/^GET \/api\/v1/u, ""),
    );
    const page = {
      call: calls.find((call) => call.includes(part)) ?? "",
      href: location.href,
      version: (await load("/health")).version,
    };
    return Promise.all(
      figures.map((figure) => captionOf(figure.about(), mediaBehind(behind), page)),
    );
  }

  return {
    /** @param {PublishTask} next */
    async open(next) {
      prepare(next);
      dialog.showModal();
      const texts = await captionsOf(next).catch(() => null);
      if (task !== next) return; // another figure's sheet is open by now
      words.forEach((one, i) => {
        const text = texts?.[i] ?? "";
        one.value = edited.get(text) ?? text;
        one.addEventListener("input", () => {
          if (text) edited.set(text, one.value);
        });
      });
      if (!texts) failure = "The sources cannot be had: is the server running?";
      wait(false);
      await show();
    },
  };
}

/** @type {Promise<ReturnType<typeof createDialog>> | null} */
let dialog = null;

/** @param {PublishTask} task */
export async function publish(task) {
  dialog ??= loadStyles("dialog", "publish").then(createDialog);
  await (await dialog).open(task);
}
