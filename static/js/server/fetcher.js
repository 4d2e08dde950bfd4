/**
 * A worker that asks the server beside the page: while something is dragged, the page's own thread
 * draws frame after frame and would read an answer only one or two frames late.
 *
 * It is told `{id, url}` and answers `{id, status, text}`, or `{id, status: 0}` when the server
 * cannot be reached; `{id}` alone gives a question up.
 */

/** @type {Map<number, AbortController>} */
const flights = new Map();

self.addEventListener("message", async ({ data }) => {
  const { id, url } = /** @type {{id: number, url?: string}} */ (data);
  if (url === undefined) {
    flights.get(id)?.abort();
    return;
  }
  const flight = new AbortController();
  flights.set(id, flight);
  try {
    const response = await fetch(url, { signal: flight.signal });
    self.postMessage({ id, status: response.status, text: await response.text() });
  } catch {
    self.postMessage({ id, status: 0, text: "" });
  } finally {
    flights.delete(id);
  }
});

self.postMessage({ id: 0, status: 0, text: "" });

export {};
