/** The words of the trade, and what each leads to in the finder. */

/**
 * Words by which things are meant that are not called so: the ids that lead, the first one first. Those of
 * media and models are the catalog's, the others are made below.
 * @type {Record<string, readonly string[]>}
 */
export const TRADE = {
  plastic: ["PMMA", "polycarbonate", "polystyrene", "lesson:coat"],
  acrylic: ["PMMA"],
  chrome: ["Cr"],
  steel: ["stainless", "stainless-ferritic"],
  skin: ["skin", "lesson:coat"],
  glass: ["default-shirley", "soda-lime", "BK7"],
  mirror: ["Ag", "Al"],
  blender: ["use:blender", "engine:cycles"],
  cycles: ["engine:cycles", "use:blender"],
  unreal: ["spherical_gaussian"],
  ue: ["spherical_gaussian"],
  ue5: ["spherical_gaussian"],
  "three.js": ["engine:three"],
  gltf: ["use:gltf"],
  khronos: ["use:gltf"],
  worksheet: ["section:worksheets"],
  exercise: ["section:worksheets"],
  "answer key": ["section:worksheets"],
  "thin film": ["films"],
  coating: ["films"],
  export: ["use:blender", "use:gltf", "use:materialx", "use:usd"],
  theme: ["Light or dark"],
  slide: ["Present"],
  lesson: ["section:path"],
  help: ["Keys", "section:path", "documentation"],
  beginner: ["section:path"],
  tutorial: ["section:path"],
  keyboard: ["Keys"],
  shortcut: ["Keys"],
};

/**
 * What a word of the trade leads to, in the order of the word.
 * @param {readonly Findable[]} entries
 * @param {string} text
 * @returns {Findable[]}
 */
export function led(entries, text) {
  const asked = text.trim().toLowerCase();
  const words = Object.keys(TRADE).filter(
    (word) =>
      word === asked ||
      word === asked.replace(/s$/u, "") ||
      (asked.length > 2 && word.startsWith(asked)),
  );
  const ids = [...new Set(words.flatMap((word) => TRADE[word] ?? []))];
  return ids.flatMap((id) => entries.find((entry) => entry.id === id) ?? []);
}
