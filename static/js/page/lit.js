/** Templates: what a panel shows is said once, and what has changed is set when it is rendered again. */

export { html, nothing, render } from "../../vendor/lit-html-3.3.3/lit-html.js";
