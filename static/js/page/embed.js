/** The HTML that shows a view, as it is now, in another page. */

/** @param {string} text */
const quoted = (text) =>
  text.replaceAll("&", "&amp;").replaceAll('"', "&quot;").replaceAll("<", "&lt;");

/** @param {string} href of the page @param {string} title */
export function embedCode(href, title) {
  const address = new URL(href);
  address.hash = "";
  address.searchParams.set("embed", "1");
  return `<iframe src="${quoted(address.href)}" title="${quoted(title)}" width="100%" height="640" style="border: 0"></iframe>`;
}
