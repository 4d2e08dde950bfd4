/** Pictures as files: with the page's typeface inside, so that they look the same anywhere. */

/** @param {Blob} blob @returns {Promise<string>} */
function dataUrl(blob) {
  return new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.addEventListener("load", () => resolve(String(reader.result)));
    reader.addEventListener("error", () => reject(reader.error));
    reader.readAsDataURL(blob);
  });
}

/** The page's rules for its typefaces. */
function faceRules() {
  return [...document.styleSheets].flatMap((sheet) =>
    [...sheet.cssRules].flatMap((rule) =>
      rule instanceof CSSFontFaceRule ? [{ rule, base: sheet.href ?? location.href }] : [],
    ),
  );
}

/**
 * `@font-face` rules with the font itself in place of its address, for the first of the families
 * that the page declares; empty when there is none or it cannot be had.
 * @param {string} families a CSS font-family
 * @returns {Promise<string>}
 */
export async function fontFaces(families) {
  const bare = (/** @type {string} */ name) => name.trim().replace(/^["']|["']$/gu, "");
  const wanted = families.split(",").map(bare);
  const written = await Promise.all(
    faceRules()
      .filter(({ rule }) => wanted[0] === bare(rule.style.getPropertyValue("font-family")))
      .map(async ({ rule, base }) => {
        const source = rule.style.getPropertyValue("src");
        const address = source.match(/url\(["']?([^"')]+)["']?\)/u)?.[1];
        if (!address) return "";
        const answer = await fetch(new URL(address, base));
        if (!answer.ok) return "";
        return rule.cssText.replace(
          /url\([^)]*\)/u,
          `url("${await dataUrl(await answer.blob())}")`,
        );
      }),
  ).catch(() => []); // a picture in another typeface is better than none
  return written.join("");
}

/**
 * @param {string} svg source
 * @param {string} css
 */
export function withStyle(svg, css) {
  if (!css) return svg;
  return svg.replace(/(<svg[^>]*>)/u, (start) => `${start}<style>${css}</style>`);
}

/**
 * @param {Blob} svg
 * @param {number} width px
 * @param {number} height px
 * @returns {Promise<Blob>}
 */
export async function rasterized(svg, width, height) {
  const address = URL.createObjectURL(svg);
  try {
    const image = new Image(width, height);
    image.src = address;
    await image.decode();
    const canvas = document.createElement("canvas");
    canvas.width = width;
    canvas.height = height;
    canvas.getContext("2d")?.drawImage(image, 0, 0, width, height);
    return await new Promise((resolve, reject) => {
      canvas.toBlob(
        (blob) => (blob ? resolve(blob) : reject(new Error("the picture could not be made"))),
        "image/png",
      );
    });
  } finally {
    URL.revokeObjectURL(address);
  }
}
