#!/usr/bin/env bash
# One would guess: a material saved by toJSON and loaded again by three's own loader has the index of refraction
# that it had; clone() keeps it.
# What happens: MeshPhysicalMaterial keeps ior as any number, but toJSON writes `reflectivity` instead, which is
# clamp(2.5 (n - 1)/(n + 1), 0, 1), and the loader sets the index from it. So every index above 7/3 = 2.3333
# comes back as that (diamond 2.42, F0 0.172 -> 0.160; silicon 4, F0 0.360 -> 0.160), and every index below 1 as 1
# (0.75, a bubble of air seen from water, F0 0.020 -> 0). 1.5 comes back as 1.5.
# Measured 2026-11-30 with three 0.187.0 (Node).
# Touches: what we export for three.js is glTF, whose loader keeps the index (app/export/targets/gltf.py).
# Needs npm.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
npm install --silent --no-save --prefix "$folder" three@0.187.0
cat >"$folder/index.mjs" <<'JS'
import { MaterialLoader, MeshPhysicalMaterial, REVISION } from "three";

const F0 = (n) => ((n - 1) / (n + 1)) ** 2;
console.log("three", REVISION);
let same = REVISION === "187";
for (const [n, wanted] of [[1.5, 1.5], [2.3, 2.3], [2.42, 7 / 3], [4, 7 / 3], [0.75, 1]]) {
  const material = new MeshPhysicalMaterial({ ior: n });
  const json = material.toJSON();
  const back = new MaterialLoader().parse(JSON.parse(JSON.stringify(json))).ior;
  const clone = material.clone().ior;
  console.log(
    `ior ${n}: the file has ior ${json.ior}, reflectivity ${json.reflectivity?.toFixed(4)}; loaded ${back.toFixed(4)},`,
    `cloned ${clone}; F0 ${F0(n).toFixed(3)} -> ${F0(back).toFixed(3)}`,
  );
  same &&= Math.abs(back - wanted) < 1e-9 && clone === n && json.ior === undefined;
}
console.log(same ? "unchanged" : "CHANGED");
process.exit(same ? 0 : 1);
JS
node "$folder/index.mjs"
