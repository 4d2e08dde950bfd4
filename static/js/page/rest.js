/** What the page does once it stands still for the first time, and can do without. */

import { BASE, CATALOG_PATHS, load } from "../server/api.js";

/** @param {Promise<void>} work that may fail: the page may be left, or its server be gone */
const quietly = (work) => void work.catch(() => {});

/**
 * From now on the page can be printed, says its version, and works without its server.
 * @param {SettleDownOptions} options
 * @returns {() => void} keeps what is on the screen for when the server does not answer
 */
export function settleDown({ guest, paths, showVersion }) {
  if (guest) return () => {};
  quietly(load("/health").then((health) => showVersion(health.version)));
  /** @type {typeof import('../server/offline.js') | null} */
  let keeper = null;
  const urls = () => paths().map((path) => `${BASE}${path}`);
  async function keep() {
    const offline = await import("../server/offline.js");
    await offline.keepPage();
    keeper = offline;
    const start = CATALOG_PATHS.map((path) => `${BASE}${path}`);
    await keeper.keepAnswers([...start, ...urls()]);
  }
  quietly(keep());
  return () => void keeper?.keepAnswers(urls());
}
