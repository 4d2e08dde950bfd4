// @ts-check
/** The API's documentation: Swagger UI on this server's own schema, loading nothing from elsewhere. */

/**
 * @typedef {{name: string, in: string, schema?: {default?: unknown}}} Declared
 * @typedef {{parameters?: Declared[]}} Operation
 * @typedef {{paths: Record<string, Record<string, Operation>>}} Schema
 * @typedef {{url: string, method?: string, loadSpec?: boolean}} Call
 * @typedef {(options: Record<string, unknown>) => unknown} SwaggerUI
 */

const SCHEMA = new URL("../openapi.json", document.baseURI).href;
const root = document.documentElement;

/** @type {Schema} */
let schema = { paths: {} };

/**
 * Leave out what says no more than the default does. Swagger UI fills every field with its default and
 * sends them all, and the API refuses the parameters of a model that the call does not ask for.
 * @param {Call} call
 * @returns {Call}
 */
function withoutDefaults(call) {
  const url = new URL(call.url);
  const parameters = operation(url.pathname, call.method ?? "GET")?.parameters ?? [];
  for (const { name, schema: declared } of parameters) {
    const isDefault = url.searchParams.get(name) === String(declared?.default);
    if (declared?.default !== undefined && isDefault) url.searchParams.delete(name);
  }
  call.url = url.href;
  return call;
}

/**
 * @param {string} path
 * @param {string} method
 * @returns {Operation | undefined}
 */
function operation(path, method) {
  const template = Object.keys(schema.paths).find((candidate) => {
    const parts = candidate.split("/");
    const given = path.split("/").slice(-parts.length);
    return (
      parts.length === given.length &&
      parts.every((part, i) => part === given[i] || part.startsWith("{"))
    );
  });
  return template === undefined ? undefined : schema.paths[template]?.[method.toLowerCase()];
}

/**
 * @param {string} a
 * @param {string} b
 * @returns {number} order of two groups of routes: as declared, what is about the server itself last
 */
function serverLast(a, b) {
  return Number(a === "server") - Number(b === "server");
}

/** Swagger UI knows its own dark colours by this class. */
function followTheme() {
  root.classList.toggle("dark-mode", root.dataset["theme"] === "dark");
}

/**
 * Give what Swagger UI draws the names and stops that keyboards and screen readers need.
 * @param {Element} drawing
 */
function makeReachable(drawing) {
  for (const text of drawing.querySelectorAll("pre.microlight")) {
    text.setAttribute("tabindex", "0"); // it scrolls
  }
  for (const row of drawing.querySelectorAll("tr[data-param-name]")) {
    const name = row.getAttribute("data-param-name") ?? "";
    row.querySelector("input, select, textarea")?.setAttribute("aria-label", name);
  }
  const about = drawing.querySelector(".information-container");
  about?.setAttribute("role", "region"); // all else is in a landmark of its own
  about?.setAttribute("aria-label", "Conventions");
  for (const table of drawing.querySelectorAll("table[role=region]")) {
    table.removeAttribute("role"); // several landmarks without a name of their own
  }
}

/**
 * The names of routes and their groups as text: Swagger UI makes links of them that lead nowhere,
 * inside of the buttons that open them.
 * @param {{React: {createElement: (tag: string, props: null, text: string) => unknown}}} system
 */
function plainNames({ React }) {
  /** @param {{text: string}} name */
  const DeepLink = ({ text }) => React.createElement("span", null, text);
  return { components: { DeepLink } };
}

/** @param {string} text */
function say(text) {
  const line = document.querySelector("#swagger .starting");
  if (line) line.textContent = text;
}

root.addEventListener("themechange", followTheme);
followTheme();

const drawing = document.querySelector("#swagger");
if (drawing) {
  new MutationObserver(() => makeReachable(drawing)).observe(drawing, {
    childList: true,
    subtree: true,
  });
}

async function start() {
  try {
    const answer = await fetch(SCHEMA);
    if (!answer.ok) throw new Error(`it answered ${answer.status}`);
    schema = await answer.json();
    const { SwaggerUIBundle } = /** @type {{SwaggerUIBundle: SwaggerUI}} */ (
      /** @type {unknown} */ (window)
    );
    SwaggerUIBundle({
      dom_id: "#swagger",
      spec: schema,
      validatorUrl: null, // the badge would send the schema's address to another host
      docExpansion: "list",
      tagsSorter: serverLast,
      defaultModelsExpandDepth: 0,
      displayRequestDuration: true,
      syntaxHighlight: false, // slow on long answers, and dark in the light theme
      tryItOutEnabled: true,
      requestInterceptor: withoutDefaults,
      plugins: [plainNames],
    });
  } catch (error) {
    say(
      `The schema of the API could not be read: ${error instanceof Error ? error.message : error}.`,
    );
  }
}

start();
