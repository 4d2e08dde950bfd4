/** What is sent to the server, beside the questions of `api.js`. */

import { BASE, Problem } from "./api.js";

/** Send a form and read the answer. @param {string} path @param {FormData} body @returns {Promise<any>} */
export async function send(path, body) {
  let response;
  try {
    response = await fetch(`${BASE}${path}`, { method: "POST", body });
  } catch {
    throw new Problem("The server does not answer", {
      detail: "Is it running, and are you online?",
    });
  }
  const told = await response.json().catch(() => null);
  if (response.ok && told !== null) return told;
  throw new Problem(told?.title ?? `The server answered ${response.status}`, {
    status: response.status,
    detail: told?.detail ?? "",
    errors: Array.isArray(told?.errors) ? told.errors : [],
  });
}
