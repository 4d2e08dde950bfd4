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
