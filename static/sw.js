/**
 * Keeps the page's files for when the server is out of reach. Online it changes nothing: each file
 * is asked for as ever, and only what is not answered comes from here. Answers of the API are no
 * business of this worker, so none can be mistaken for a fresh one.
 *
 * The server puts FILES and VERSION, a digest of them all, in front.
 */

/* global FILES, VERSION */
const HOME = new URL("./", self.location.href).href;
const KEPT = `fresnel-page-${VERSION}`;
/** The page without a picture: what is kept stands for every address. */
const PAGE = new URL("index.html", HOME).href;
const KNOWN = new Set([HOME, ...FILES.map((path) => new URL(path, HOME).href)]);

self.addEventListener("install", (event) => {
  // Where browsers can be told so, the API's answers do not even pass by here.
  const api = { urlPattern: { pathname: `${new URL("api/", HOME).pathname}*` } };
  event.addRoutes?.({ condition: api, source: "network" });
  event.waitUntil(
    (async () => {
      const cache = await caches.open(KEPT);
      // Asked after, not fetched again: the browser has most of them already.
      await cache.addAll(FILES.map((path) => new Request(path, { cache: "no-cache" })));
      await self.skipWaiting();
    })(),
  );
});

self.addEventListener("activate", (event) => {
  event.waitUntil(
    (async () => {
      const all = (await caches.keys()).filter((name) => name.startsWith("fresnel-"));
      // Answers kept by another version of the page go with it; those of a first visit stay.
      if (all.some((name) => name.startsWith("fresnel-page-") && name !== KEPT))
        await Promise.all(all.filter((name) => name !== KEPT).map((name) => caches.delete(name)));
      await self.clients.claim();
    })(),
  );
});

self.addEventListener("fetch", (event) => {
  const { request } = event;
  const address = new URL(request.url);
  address.hash = "";
  address.search = ""; // the state is the page's to read
  if (request.method !== "GET" || !KNOWN.has(address.href)) return;
  event.respondWith(
    (async () => {
      try {
        return await fetch(request);
      } catch (error) {
        const file = address.href === HOME ? PAGE : address.href;
        const kept = await caches.match(file, { cacheName: KEPT });
        if (kept) return kept;
        throw error;
      }
    })(),
  );
});
