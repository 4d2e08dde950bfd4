/**
 * Pack the page: the modules of static/js into a few files with source maps, and its first style
 * sheets into one. `node tools/pack.mjs [FOLDER]` fills static/packed, or that folder's own `packed`.
 *
 * What the first view needs is one file, all else is fetched when it is asked for. The names carry a
 * digest, so that browsers may keep the files for ever; manifest.json says which are needed first, and
 * a digest of the sources, by which the server knows whether they have changed since.
 */

import { createHash } from "node:crypto";
import { mkdir, readdir, readFile, rm, writeFile } from "node:fs/promises";
import { join, resolve } from "node:path";
import { rolldown } from "rolldown";

const root = resolve(process.argv[2] ?? join(import.meta.dirname, "..", "static"));
const target = join(root, "packed");
const FIRST = ["js/main.js", "js/views/explore.js"].map((path) => join(root, path));
const STYLES = ["css/base.css", "css/explore.css", "vendor/plotly-cartesian-4.1.1/plotly.css"];

/** The order that the server reads them in too. */
async function sources() {
  const found = (await readdir(join(root, "js"), { recursive: true })).filter((path) =>
    path.endsWith(".js"),
  );
  return [...found.map((path) => `js/${path.replaceAll("\\", "/")}`), ...STYLES].sort();
}

const digest = createHash("sha256");
for (const path of await sources()) digest.update(path).update(await readFile(join(root, path)));

/** What the first view cannot be drawn without: all that it imports, and all that that imports. */
const needed = new Set();
function need(id, moduleOf) {
  if (needed.has(id)) return;
  needed.add(id);
  for (const next of moduleOf(id)?.importedIds ?? []) need(next, moduleOf);
}

await rm(target, { recursive: true, force: true });
await mkdir(target, { recursive: true });
/** The first view is on its way with the rest: it need not be asked for in a file of its own. */
const atOnce = {
  name: "first view at once",
  transform(code, id) {
    if (id !== FIRST[0]) return null;
    const asked = 'import("./views/explore.js")';
    if (!code.includes(asked)) throw new Error(`main.js has no ${asked}`);
    // Lines stay lines, so the map of the sources holds.
    const now = code.replace(asked, "Promise.resolve(first)");
    return { code: `import * as first from "./views/explore.js"; ${now}`, map: null };
  },
};
const bundle = await rolldown({ input: { main: FIRST[0] }, plugins: [atOnce] });
const { output } = await bundle.write({
  dir: target,
  format: "es",
  minify: true,
  sourcemap: true,
  entryFileNames: "[name]-[hash].js",
  chunkFileNames: "[name]-[hash].js",
  codeSplitting: {
    groups: [
      {
        debugName: "first",
        name(id, context) {
          for (const first of FIRST) need(first, (one) => context.getModuleInfo(one));
          return needed.has(id) && id !== FIRST[0] ? "first" : null;
        },
      },
    ],
  },
});

const chunks = output.filter((one) => one.type === "chunk");
const entry = chunks.find((chunk) => chunk.isEntry);
const css = (await Promise.all(STYLES.map((path) => readFile(join(root, path), "utf8")))).join(
  "\n",
);
const style = `first-${createHash("sha256").update(css).digest("hex").slice(0, 8)}.css`;
await writeFile(join(target, style), css);
const manifest = {
  sources: digest.digest("hex"),
  main: entry.fileName,
  first: entry.imports,
  style,
};
await writeFile(join(target, "manifest.json"), `${JSON.stringify(manifest, null, 2)}\n`);
console.log(`packed ${needed.size} modules for the first view, ${chunks.length} files in all`);
