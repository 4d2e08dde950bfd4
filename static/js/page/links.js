/** Links from one view into another: addresses as any other, followed without loading the page anew. */

import { h } from "./dom.js";

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
  return query ? `?${query}` : "./";
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
  return h("a", { href, onclick: clicked(() => go(href)) }, text);
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
