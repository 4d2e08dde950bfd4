/**
 * What is needed without a server: the page's files, kept by a service worker, and the answers that
 * stood on the screen. A kept answer is given only where the server does not answer, with its date.
 */

const ANSWERS = "fresnel-answers"; // a new version of the page begins it anew
const MOST = 200;

/** Keep the page's files from now on; done when they are kept. */
export async function keepPage() {
  try {
    await navigator.serviceWorker.register(new URL("sw.js", document.baseURI));
    await navigator.serviceWorker.ready;
  } catch {
    // Forbidden here (plain http on another machine, a private window): the page works as before.
  }
}

/** @param {Iterable<string>} urls of answers that stand on the screen */
export async function keepAnswers(urls) {
  if (typeof caches === "undefined") return;
  try {
    const cache = await caches.open(ANSWERS);
    for (const url of urls) {
      // From the browser's own cache, where it was put when it was drawn.
      const response = await fetch(url, { cache: "force-cache" });
      const date = response.headers.get("date") ?? new Date().toUTCString();
      if (response.ok) await cache.put(url, new Response(response.body, { headers: { date } }));
    }
    const all = await cache.keys();
    for (const old of all.slice(0, Math.max(0, all.length - MOST))) await cache.delete(old);
  } catch {
    // No room, or no network: there is nothing to be kept.
  }
}

/** @param {string} url @returns {Promise<{text: string, since: Date} | null>} */
export async function keptAnswer(url) {
  if (typeof caches === "undefined") return null;
  const response = await (await caches.open(ANSWERS)).match(url);
  if (!response) return null;
  return { text: await response.text(), since: new Date(response.headers.get("date") ?? "") };
}
