#!/usr/bin/env bash
# One would guess: a glTF material with KHR_materials_ior 2.42 reflects ((n - 1)/(n + 1))^2 = 0.172 at normal
# incidence, and 1.5, glTF's default written out, changes nothing; KHR_materials_specular with factor 1 (its
# default) changes nothing either; a factor of 0.5 halves F0; and on a metal the factor has no effect.
# What happens, through gltfio of the npm package: with KHR_materials_ior alone no light is reflected at all, at
# any angle and for any index. Beside KHR_materials_specular the index is right. The factor enters F0 squared:
# 0.5 leaves 0.010 of 0.040, not 0.020. A white metal is black with factor 0 and reflects 0.5 with 0.5.
# Measured 2026-11-30 with filament 1.53.4 (Chromium, software WebGL, half-float pixels; a white environment of
# radiance 1; a black base, so that only the reflection is seen), against the text of the two extensions.
# Touches: our glTF files carry KHR_materials_specular for it (app/export/targets/gltf.py, materials/engines).
# Needs npm and Chromium on the PATH (or named by CHROMIUM).
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3}" -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet --disable-pip-version-check playwright==1.60.0
npm install --silent --no-save --prefix "$folder" filament@1.53.4
CHROMIUM=${CHROMIUM:-$(command -v chromium || command -v chromium-browser || command -v google-chrome)}
export CHROMIUM
cat >"$folder/index.html" <<'HTML'
<script src="/node_modules/filament/filament.js"></script>
<script src="/node_modules/gl-matrix/gl-matrix-min.js"></script>
HTML
cat >"$folder/plane.js" <<'JS'
const corners = new Float32Array([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0].map((x) => 500 * x));
const normals = new Float32Array([0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1]);
const bytes = new Uint8Array(108);
bytes.set(new Uint8Array(corners.buffer), 0);
bytes.set(new Uint8Array(normals.buffer), 48);
bytes.set(new Uint8Array(new Uint16Array([0, 1, 2, 0, 2, 3]).buffer), 96);
const uri = `data:application/octet-stream;base64,${btoa(String.fromCharCode(...bytes))}`;

function gltf({ metal = false, extensions = {} }) {
  const pbrMetallicRoughness = {
    baseColorFactor: metal ? [1, 1, 1, 1] : [0, 0, 0, 1],
    metallicFactor: Number(metal),
    roughnessFactor: 0,
  };
  return {
    asset: { version: "2.0" },
    extensionsUsed: Object.keys(extensions),
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0, NORMAL: 1 }, indices: 2, material: 0 }] }],
    materials: [{ pbrMetallicRoughness, extensions }],
    buffers: [{ byteLength: 108, uri }],
    bufferViews: [
      { buffer: 0, byteOffset: 0, byteLength: 48 },
      { buffer: 0, byteOffset: 48, byteLength: 48 },
      { buffer: 0, byteOffset: 96, byteLength: 12 },
    ],
    accessors: [
      { bufferView: 0, componentType: 5126, count: 4, type: "VEC3", min: [-500, -500, 0], max: [500, 500, 0] },
      { bufferView: 1, componentType: 5126, count: 4, type: "VEC3" },
      { bufferView: 2, componentType: 5123, count: 6, type: "SCALAR" },
    ],
  };
}

export async function measured() {
  Object.assign(globalThis, globalThis.glMatrix ?? {}); // the package looks for these names there
  await new Promise((resolve) => Filament.init([], resolve));
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 4;
  document.body.append(canvas);
  const engine = Filament.Engine.create(canvas, { preserveDrawingBuffer: true, alpha: true });
  const gl = canvas.getContext("webgl2");
  gl.getExtension("EXT_color_buffer_half_float");
  gl.getExtension("EXT_color_buffer_float");
  gl.drawingBufferStorage(gl.RGBA16F, 4, 4);
  const scene = engine.createScene();
  const view = engine.createView();
  const camera = engine.createCamera(Filament.EntityManager.get().create());
  view.setCamera(camera);
  view.setScene(scene);
  view.setViewport([0, 0, 4, 4]);
  view.setPostProcessingEnabled(false);
  const swapChain = engine.createSwapChain();
  const renderer = engine.createRenderer();
  renderer.setClearOptions({ clearColor: [0, 0, 0, 1], clear: true });
  camera.setProjection(Filament.Camera$Projection.ORTHO, -0.01, 0.01, -0.01, 0.01, 0.1, 100);
  camera.setExposureDirect(1);
  const sky = Filament.Texture.Builder()
    .width(1)
    .height(1)
    .levels(1)
    .sampler(Filament.Texture$Sampler.SAMPLER_CUBEMAP)
    .format(Filament.Texture$InternalFormat.RGBA16F)
    .build(engine);
  const { RGBA } = Filament.PixelDataFormat;
  sky.setImageCube(engine, 0, Filament.PixelBuffer(new Float32Array(24).fill(1), RGBA, Filament.PixelDataType.FLOAT));
  scene.setIndirectLight(
    Filament.IndirectLight.Builder().reflections(sky).irradianceSh(1, [1, 1, 1]).intensity(1).build(engine),
  );
  const loader = engine.createAssetLoader();

  async function reflected(material, degrees) {
    const theta = (degrees * Math.PI) / 180;
    const asset = loader.createAsset(new TextEncoder().encode(JSON.stringify(gltf(material))));
    await new Promise((resolve) => asset.loadResources(resolve, null, "", null));
    scene.addEntities(asset.getRenderableEntities());
    camera.lookAt([10 * Math.sin(theta), 0, 10 * Math.cos(theta)], [0, 0, 0], [0, 1, 0]);
    for (let i = 0; i < 3; i++) renderer.render(swapChain, view);
    engine.execute();
    const pixels = new Float32Array(64);
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, null);
    gl.readPixels(0, 0, 4, 4, gl.RGBA, gl.FLOAT, pixels);
    scene.removeEntities(asset.getRenderableEntities());
    loader.destroyAsset(asset);
    return pixels[0];
  }

  const ior = (n) => ({ KHR_materials_ior: { ior: n } });
  const specular = (factor) => ({ KHR_materials_specular: { specularFactor: factor } });
  const cases = {
    "glass, no extension": {},
    "ior 1.5": { extensions: ior(1.5) },
    "ior 2.42": { extensions: ior(2.42) },
    "ior 2.42, specular 1": { extensions: { ...ior(2.42), ...specular(1) } },
    "specular 0.5": { extensions: specular(0.5) },
    "white metal": { metal: true },
    "white metal, specular 0": { metal: true, extensions: specular(0) },
    "white metal, specular 0.5": { metal: true, extensions: specular(0.5) },
  };
  await reflected({}, 0);
  const found = {};
  for (const [name, material] of Object.entries(cases)) {
    found[name] = [await reflected(material, 0), await reflected(material, 80)];
  }
  return found;
}
JS
"$folder/venv/bin/python" - "$folder" <<'PYTHON'
import functools
import http.server
import json
import os
import sys
import threading
from pathlib import Path

from playwright.sync_api import sync_playwright


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


handler = functools.partial(Quiet, directory=sys.argv[1])
server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
threading.Thread(target=server.serve_forever, daemon=True).start()
with sync_playwright() as playwright:
    browser = playwright.chromium.launch(
        executable_path=os.environ["CHROMIUM"],
        args=["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--no-sandbox"],
    )
    page = browser.new_page()
    page.goto(f"http://127.0.0.1:{server.server_port}")
    found = page.evaluate("async () => (await import('/plane.js')).measured()")
    browser.close()
package = json.loads((Path(sys.argv[1]) / "node_modules/filament/package.json").read_text())
print("filament", package["version"])
expected = {  # at normal incidence; by glTF
    "glass, no extension": (0.04, 0.04),
    "ior 1.5": (0.0, 0.04),
    "ior 2.42": (0.0, 0.1724),
    "ior 2.42, specular 1": (0.1724, 0.1724),
    "specular 0.5": (0.01, 0.02),
    "white metal": (1.0, 1.0),
    "white metal, specular 0": (0.0, 1.0),
    "white metal, specular 0.5": (0.5, 1.0),
}
same = True
for name, (wanted, gltf) in expected.items():
    normal, oblique = found[name]
    print(f"{name}: {normal:.4f} at 0 degrees, {oblique:.4f} at 80; by glTF {gltf} at 0")
    same &= abs(normal - wanted) < 2e-3
    same &= (oblique < 1e-3) == (wanted == 0)
print("unchanged" if same else "CHANGED")
sys.exit(0 if same else 1)
PYTHON
