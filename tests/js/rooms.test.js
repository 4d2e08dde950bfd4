import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import test from "node:test";

const JS = new URL("../../static/js/", import.meta.url);
const VIEWS = readdirSync(new URL("views/", JS)).map((name) => name.replace(/\.js$/, ""));

/** Every import between files of the page, also a dynamic one or of a type. */
const IMPORTS = readdirSync(JS, { recursive: true })
  .filter((name) => name.endsWith(".js"))
  .flatMap((from) => {
    const source = readFileSync(new URL(from, JS), "utf8");
    return [...source.matchAll(/(?:from |import\()["'](\.[^"']+)["']/g)].map(([, path = ""]) => ({
      from,
      to: new URL(path, new URL(from, JS)).href.slice(JS.href.length),
    }));
  });

/** The view that a file belongs to, if it is not for all of them. @param {string} path */
function viewOf(path) {
  const [room = "", file = ""] = path.split("/");
  const view = room === "views" ? file.replace(/\.js$/, "") : room;
  return VIEWS.includes(view) ? view : null;
}

test("views borrow nothing from one another: what several need has a room of its own", () => {
  assert.ok(IMPORTS.length > 300);
  const borrowed = IMPORTS.filter(({ from, to }) => {
    const view = viewOf(to);
    return view !== null && from !== "main.js" && viewOf(from) !== view;
  });
  assert.deepEqual(borrowed, []);
});

test("nobody writes a formula of R here: formulas come from the server, as kernels.js", () => {
  const formula =
    /1 - (mu|F0|cos)|F0 [+*]|\*\* ?5\b|\b(eta|kappa) [*+-] |[*+-] (eta|kappa)\b|n_t [*+-] n_i/;
  const told = readdirSync(JS, { recursive: true })
    .filter((name) => name.endsWith(".js"))
    .filter((name) => {
      const source = readFileSync(new URL(name, JS), "utf8");
      // The code of a trap and what comments say are words.
      const code = source.replace(/\/\*[\s\S]*?\*\/|\/\/.*|"(?:[^"\\\n]|\\.)*"/g, "");
      return formula.test(code);
    });
  assert.deepEqual(told, []);
  assert.match("const R = F0 + (1 - F0) * (1 - mu) ** 5", formula);
});
