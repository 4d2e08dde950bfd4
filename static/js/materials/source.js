/** Where the numbers come from, and how far other measurements lie from them. */

import { plain, stretch } from "../numbers/format.js";
import { h, setText } from "../page/dom.js";
import { copyText, flash } from "../page/exports.js";
import { narrow } from "./columns.js";

/** Units that end the names of conditions. @type {Record<string, string>} */
const UNITS = { k: "K", pa: "Pa", nm: "nm" };

/** A condition in words: `temperature_k` 293 is "temperature 293 K". @param {string} key @param {string | number} value */
export function condition(key, value) {
  const parts = key.split("_");
  const unit = typeof value === "number" ? UNITS[parts.at(-1) ?? ""] : undefined;
  const name = (unit ? parts.slice(0, -1) : parts).join(" ");
  return `${name} ${typeof value === "number" ? plain(value) : value}${unit ? `\u00a0${unit}` : ""}`;
}

/** What a reader would cite. @param {any} detail */
export function citation(detail) {
  const doi = detail.doi.map((/** @type {string} */ d) => `https://doi.org/${d}`);
  const database = detail.provenance
    ? `${detail.provenance.database} ${detail.provenance.tag}, ${detail.provenance.page}`
    : "";
  return [detail.source, ...doi, database].filter(Boolean).join(". ");
}

/** @param {(text: string) => void} say */
export function createSource(say) {
  const list = h("dl", { class: "source-list" });
  const copy = h("button", { type: "button", class: "quiet" }, "copy citation");
  /** @type {any} */
  let shown = null;
  copy.addEventListener("click", async () => {
    if (!shown) return;
    const done = await copyText(citation(shown));
    flash(copy, done);
    say(done ? "Citation copied" : "Copying is not allowed here");
  });
  const element = h(
    "section",
    { class: "column sheet origin", "aria-label": "Source" },
    h("div", { class: "heading" }, h("h2", {}, "Source"), copy),
    list,
  );
  /** @param {string} term @param {...(Node | string)} words */
  const entry = (term, ...words) => h("div", {}, h("dt", {}, term), h("dd", {}, ...words));
  return {
    element,
    /** @param {any} detail */
    update(detail) {
      if (shown === detail) return;
      shown = detail;
      const { provenance, conditions, warnings, note, doi, licence } = detail;
      const links = [
        ...doi.map((/** @type {string} */ d) => ({
          text: `doi:${d}`,
          href: `https://doi.org/${d}`,
        })),
        ...(doi.length ? [] : (provenance?.links ?? [])).map((/** @type {string} */ url) => ({
          text: url,
          href: url,
        })),
      ];
      const said = Object.entries(conditions).map(([key, value]) => condition(key, value));
      list.replaceChildren(
        entry("Reference", detail.source),
        ...links.map((l) => entry("Link", h("a", { href: l.href, rel: "noreferrer" }, l.text))),
        entry("Sample", `${detail.sample}; confidence ${detail.confidence}`),
        ...(said.length ? [entry("Conditions", said.join(", "))] : []),
        ...(note ? [entry("Note", note)] : []),
        ...(provenance?.comments ? [entry("Comment", provenance.comments)] : []),
        ...(detail.n_range_nm
          ? [
              entry(
                "Known",
                `n ${stretch(detail.n_range_nm)}; k ${detail.k_range_nm ? stretch(detail.k_range_nm) : "not given"}`,
              ),
            ]
          : []),
        entry("Licence", licence),
        ...(provenance
          ? [
              entry(
                "Data",
                `${provenance.database} ${provenance.tag}, ${provenance.file}, `,
                h(
                  "span",
                  { class: "sum", title: provenance.sha256 },
                  `sha256 ${provenance.sha256.slice(0, 12)}…`,
                ),
              ),
            ]
          : []),
        ...warnings.map((/** @type {string} */ w) => {
          const one = entry("Warning", w);
          one.className = "warning";
          return one;
        }),
      );
    },
  };
}

/**
 * Measurements of the same material, this one among them, by their reflectance.
 * @param {(id: string) => void} onPick
 */
export function createRivals(onPick) {
  const body = h("tbody", {});
  const summary = h("p", { class: "hint" });
  const element = h(
    "section",
    { class: "column sheet rival-list", "aria-label": "Other measurements" },
    h("div", { class: "heading" }, h("h2", {}, "Other measurements")),
    summary,
    h(
      "div",
      {
        class: "rival-scroll",
        tabindex: "0",
        role: "region",
        "aria-label": "Measurements of the same material",
      },
      h(
        "table",
        { class: "rivals" },
        h("caption", { class: "hidden" }, "Measurements of the same material"),
        h(
          "thead",
          {},
          h(
            "tr",
            {},
            ...["measurement", "Y", "difference", "n", "k", "sample, confidence"].map((t) =>
              h("th", { scope: "col" }, t),
            ),
          ),
        ),
        body,
      ),
    ),
  );
  /** @type {any} */
  let shown = null;
  return {
    element,
    /** @param {any} detail */
    update(detail) {
      if (shown === detail) return;
      shown = detail;
      element.hidden = detail.rivals.length === 0;
      // What dielectrics differ by is seen in the fourth digit.
      const fixed = (/** @type {number} */ Y) => Y.toFixed(detail.color.luminance < 0.2 ? 5 : 3);
      const own = { ...detail, luminance: detail.color.luminance };
      const all = [own, ...detail.rivals].sort((a, b) => a.luminance - b.luminance);
      const { minimum, maximum } = detail.spread;
      setText(
        summary,
        `Luminous reflectance at normal incidence lies between ${fixed(minimum)} and ${fixed(maximum)} in ${all.length} measurements: which one is taken changes it by ${fixed(maximum - minimum)}.`,
      );
      body.replaceChildren(
        ...all.map((one) => {
          const here = one === own;
          const by = one.luminance - own.luminance;
          return h(
            "tr",
            here ? { "data-chosen": true } : {},
            h(
              "th",
              { scope: "row" },
              here
                ? h("b", {}, one.name)
                : h(
                    "button",
                    {
                      type: "button",
                      class: "rival",
                      title: one.source,
                      onclick: () => onPick(one.id),
                    },
                    one.name,
                  ),
            ),
            h("td", {}, fixed(one.luminance)),
            h("td", {}, here ? "shown" : `${by < 0 ? "−" : "+"}${fixed(Math.abs(by))}`),
            h("td", {}, plain(one.n, 4)),
            h("td", {}, narrow(one.k)),
            h("td", {}, `${one.sample}, ${one.confidence}`),
          );
        }),
      );
    },
  };
}
