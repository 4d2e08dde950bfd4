/**
 * The page on paper: in light colors, its figures as they stand on the screen and scaled to the
 * sheet, and the address that shows it again. What else differs is css/print.css.
 */

import { h } from "./dom.js";

/** What a figure takes of a sheet of A4 or letter at most, px. */
const SHEET = { width: 680, height: 460 };
const FIGURES = ".plot-area, .diagram, .coat-frame, .film-drawing, .scene-frame";
const address = h("p.printed");

/** @param {string} theme that everything is drawn with */
function draw(theme) {
  document.documentElement.dataset.theme = theme;
  document.documentElement.dispatchEvent(new Event("themechange"));
}

let screen = "";

function toPaper() {
  screen = document.documentElement.dataset.theme ?? "light";
  if (screen !== "light") draw("light");
  for (const figure of /** @type {NodeListOf<HTMLElement>} */ (
    document.querySelectorAll(FIGURES)
  )) {
    const { offsetWidth: width, offsetHeight: height } = figure;
    if (width === 0 || height === 0) continue;
    const fit = Math.min(SHEET.width / width, SHEET.height / height, 1);
    figure.style.setProperty("--print-width", `${width}px`);
    figure.style.setProperty("--print-height", `${height}px`);
    figure.style.setProperty("--print-fit", String(fit));
    figure.dataset.printed = "";
  }
  const day = new Date().toISOString().slice(0, 10);
  address.textContent = `${document.title}, ${location.href}, ${day}`;
  document.body.append(address);
}

function toScreen() {
  address.remove();
  for (const figure of /** @type {NodeListOf<HTMLElement>} */ (
    document.querySelectorAll("[data-printed]")
  )) {
    delete figure.dataset.printed;
    for (const part of ["width", "height", "fit"]) figure.style.removeProperty(`--print-${part}`);
  }
  if (screen !== "light") draw(screen);
}

/** From now on the page can be printed. */
export async function preparePrint() {
  const style = await fetch("css/print.css");
  if (!style.ok) return;
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(await style.text());
  document.adoptedStyleSheets = [sheet]; // behind the sheets of views, which come when they are opened
  window.addEventListener("beforeprint", toPaper);
  window.addEventListener("afterprint", toScreen);
}
