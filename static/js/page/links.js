/** Links from one view into another: addresses as any other, followed without loading the page anew. */

import { h } from "./dom.js";

/** Whether this page stands in another one, as theme.js found it. */
const embedded = () => globalThis.document?.documentElement.hasAttribute("data-embed") ?? false;

/**
 * Within an embedded page a link leads to an embedded one: nothing else may be shown in a frame.
 * @param {string} href of this page
 */
function kept(href) {
  if (!embedded() || /[?&]embed=/u.test(href)) return href;
  return `${href}${href.includes("?") ? "&" : "?"}embed=1`;
}

/** Where a link to what is no view of this page opens: not in the frame of an embedded one. */
export const aside = () => (embedded() ? "_blank" : "_self");

/**
 * @param {string} view
 * @param {Record<string, string | number | null | undefined>} [state] what differs from the defaults
 * @returns {string} the address, relative to the page
 */
export function addressOf(view, state = {}) {
  const query = Object.entries({ view: view === "explore" ? null : view, ...state })
    .filter(([, value]) => value !== null && value !== undefined)
    .map(
      ([key, value]) =>
        `${encodeURIComponent(key)}=${encodeURIComponent(String(value)).replace(/%2C/g, ",")}`,
    )
    .join("&");
  return kept(query ? `?${query}` : "./");
}

/** Become what an address says, as soon as its view is there: main.js listens. @param {string} href */
export function follow(href) {
  window.dispatchEvent(new CustomEvent("followlink", { detail: href }));
}

/** What a plain click on a link does in place of loading it. @param {() => void} go */
export function clicked(go) {
  return (/** @type {MouseEvent} */ event) => {
    if (event.ctrlKey || event.metaKey || event.shiftKey || event.altKey) return;
    event.preventDefault();
    go();
  };
}

/**
 * @param {string} text
 * @param {string} href of this page
 * @param {(href: string) => void} [go] what a plain click does; by default the state becomes the link's
 */
export function followed(text, href, go = follow) {
  const to = kept(href);
  return h("a", { href: to, onclick: clicked(() => go(to)) }, text);
}

/**
 * @param {string} text
 * @param {string} view
 * @param {Record<string, string | number | null | undefined>} [state]
 * @param {(href: string) => void} [go]
 */
export function pageLink(text, view, state, go) {
  return followed(text, addressOf(view, state), go);
}
