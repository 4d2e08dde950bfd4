/** lit-html, at one address. It is loaded where it is used, which is in no first picture. */

export { html, noChange, nothing, render, svg } from "../../vendor/lit-html-3.3.3/lit-html.js";
