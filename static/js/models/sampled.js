/** The key beside a name as a template, for rows that are drawn again and again. */

import { html } from "../page/lit.js";
import { SAMPLE_DASHES } from "./look.js";

/** @param {{color: string, dash: string}} style */
export const sampled = ({ color, dash }) =>
  html`<svg class="sample" viewBox="0 0 26 8" aria-hidden="true"><path
    d="M0 4H26"
    style="stroke: var(${color}); stroke-dasharray: ${SAMPLE_DASHES[dash] ?? dash}"
  ></path></svg>`;
