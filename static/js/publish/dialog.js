/** The sheet where a figure is fitted to a paper or a slide: ground, size, letters, caption, and a preview. */

import { h, setText } from "../dom.js";
import { tooSmall } from "../plot/publication.js";
import { loadStyle } from "../style.js";
import { captionOf } from "./caption.js";

/**
 * @typedef {import("../exports.js").Published} Published
 * @typedef {import("../plot/publication.js").Publication} Publication
 * @typedef {{figures: Published[], call: string, name: string, save: (name: string, blob: Blob) => void}} Task
 */

const GROUNDS = /** @type {const} */ ([
  ["white", "white"],
  ["clear", "transparent"],
  ["clear-dark", "transparent, for dark slides"],
]);
const SIZES = /** @type {const} */ ([
  ["width_mm", "Width, mm", 85, 30, 400],
  ["height_mm", "Height, mm", 60, 25, 400],
  ["font_pt", "Letters, pt", 7, 4, 24],
]);
const REST = 250; // ms without a change before the preview is drawn

function createDialog() {
  /** @type {Task} */
  let task = { figures: [], call: "", name: "", save: () => {} };
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
  const words = h("textarea", { name: "caption", rows: 7, "aria-label": "Text of the caption" });
  const trouble = h("p", { class: "row-error", role: "alert" });
  const preview = h("div", { class: "publish-preview" });
  const close = h("button", { type: "button", onclick: () => dialog.close() }, "Close");
  const form = h(
    "form",
    { method: "dialog" },
    h(
      "div",
      { class: "publish-fields" },
      h("label", {}, h("span", {}, "Ground"), ground),
      ...boxes.map(({ label, input }) => h("label", {}, h("span", {}, label), input)),
    ),
    h("label", { class: "publish-caption" }, withCaption, "Caption below the figure"),
    words,
    trouble,
    preview,
    h(
      "div",
      { class: "publish-actions" },
      ...["svg", "png"].map((format) =>
        h(
          "button",
          { type: "button", onclick: () => take(/** @type {"svg" | "png"} */ (format)) },
          format === "svg" ? "Save as SVG" : "Save as PNG, 600 dpi",
        ),
      ),
      close,
    ),
  );
  const dialog = h(
    "dialog",
    { class: "publish", "aria-labelledby": "publish-title" },
    h("h2", { id: "publish-title" }, "Figure for print"),
    form,
  );
  document.body.append(dialog);

  /** @returns {Publication | null} what is asked for, or null where it cannot be */
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
      caption: withCaption.checked ? words.value.split("\n") : [],
    };
    const problem = wrong
      ? `${wrong.label}: ${wrong.input.min} to ${wrong.input.max}`
      : tooSmall(publication);
    for (const { input } of boxes)
      input.setAttribute("aria-invalid", String(!input.validity.valid));
    setText(trouble, problem);
    return problem ? null : publication;
  }

  /** @param {"svg" | "png"} format @param {Publication} publication */
  const made = (format, publication) =>
    Promise.all(task.figures.map((figure) => figure.exportAs(format, publication)));

  /** @param {"svg" | "png"} format */
  async function take(format) {
    const publication = asked();
    if (!publication) return;
    const blobs = await made(format, publication);
    blobs.forEach((blob, i) => {
      task.save(`${task.name}${blobs.length > 1 ? `-${i + 1}` : ""}-print.${format}`, blob);
    });
  }

  let turn = 0;
  async function show() {
    turn += 1;
    const own = turn;
    const publication = asked();
    words.hidden = !withCaption.checked;
    if (!publication) return;
    const blobs = await made("svg", publication);
    if (own !== turn) return;
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
    clearTimeout(waiting);
    waiting = window.setTimeout(() => void show(), REST);
  });
  form.addEventListener("submit", (event) => {
    event.preventDefault(); // Enter in a box draws, it does not close
    void show();
  });

  return {
    /** @param {Task} next */
    async open(next) {
      task = next;
      preview.replaceChildren();
      dialog.showModal();
      const calls = [...document.querySelectorAll("#calls code")].map((code) =>
        (code.textContent ?? "").replace(/^GET \/api\/v1/u, ""),
      );
      const page = {
        call: calls.find((call) => call.includes(task.call)) ?? "",
        href: location.href,
        version: (document.querySelector("#version")?.textContent ?? "").replace(/^v/u, ""),
      };
      try {
        words.value = await captionOf(
          task.figures.map((figure) => figure.about()),
          page,
        );
      } catch {
        words.value = "";
        withCaption.checked = false;
      }
      await show();
      if (!words.value) setText(trouble, "The sources cannot be had: is the server running?");
    },
  };
}

/** @type {Promise<ReturnType<typeof createDialog>> | null} */
let dialog = null;

/** @param {Task} task */
export async function publish(task) {
  dialog ??= loadStyle("css/publish.css").then(createDialog);
  await (await dialog).open(task);
}
