#!/usr/bin/env bash
# One would guess: a perfect mirror (white metal) below a clear, smooth OpenPBR coat of index 1.5 stays a
# mirror: what the coat sends back, the mirror reflects again. So says OpenPBR: coat_darkening is
# (1 - K) / (1 - E K), which is 1 where the base's albedo E is 1. glTF's coat in the same package does so.
# What happens: OpenPBRMaterial multiplies all below the coat by (1 - a)^2, a the mean of the coat's
# Fresnel term and (1 + F0) / 2, whatever the base's color. In an even white environment of radiance 1 the
# mirror reflects 0.538, and 1.000 without the coat, or with coatDarkening = 0.
# Measured 2026-11-30 with @babylonjs/core 9.35.0 (Chromium, software WebGL, float pixels).
# Touches: what we say of OpenPBR coats in Babylon, in /engines and /materials/{material}/covered.
# Needs npm and Chromium on the PATH (or named by CHROMIUM).
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3}" -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet --disable-pip-version-check playwright==1.60.0
npm install --silent --no-save --prefix "$folder" @babylonjs/core@9.35.0
CHROMIUM=${CHROMIUM:-$(command -v chromium || command -v chromium-browser || command -v google-chrome)}
export CHROMIUM
cat >"$folder/index.html" <<'HTML'
<script type="importmap">{"imports": {"@babylonjs/core/": "/node_modules/@babylonjs/core/"}}</script>
HTML
cat >"$folder/mirror.js" <<'JS'
import { ArcRotateCamera } from "@babylonjs/core/Cameras/arcRotateCamera.js";
import { Camera } from "@babylonjs/core/Cameras/camera.js";
import { Constants } from "@babylonjs/core/Engines/constants.js";
import { Engine } from "@babylonjs/core/Engines/engine.js";
import { OpenPBRMaterial } from "@babylonjs/core/Materials/PBR/openpbrMaterial.js";
import { PBRMaterial } from "@babylonjs/core/Materials/PBR/pbrMaterial.js";
import { RawCubeTexture } from "@babylonjs/core/Materials/Textures/rawCubeTexture.js";
import { RenderTargetTexture } from "@babylonjs/core/Materials/Textures/renderTargetTexture.js";
import { Color3 } from "@babylonjs/core/Maths/math.color.js";
import { Vector3 } from "@babylonjs/core/Maths/math.vector.js";
import { CreateGround } from "@babylonjs/core/Meshes/Builders/groundBuilder.js";
import { Scene } from "@babylonjs/core/scene.js";
import "@babylonjs/core/Engines/Extensions/engine.readTexture.js";
import "@babylonjs/core/Engines/Extensions/engine.rawTexture.js";
import "@babylonjs/core/Engines/Extensions/engine.renderTarget.js";

const engine = new Engine(document.createElement("canvas"), false);
const scene = new Scene(engine);
scene.imageProcessingConfiguration.applyByPostProcess = true; // materials write linear values
const white = Array(6).fill(new Float32Array([1, 1, 1, 1]));
const { TEXTUREFORMAT_RGBA, TEXTURETYPE_FLOAT } = Constants;
scene.environmentTexture = new RawCubeTexture(scene, white, 1, TEXTUREFORMAT_RGBA, TEXTURETYPE_FLOAT);
scene.environmentTexture.gammaSpace = false;
const plane = CreateGround("plane", { width: 1000, height: 1000 }, scene);
const camera = new ArcRotateCamera("camera", 0, 1e-6, 10, Vector3.Zero(), scene);
camera.mode = Camera.ORTHOGRAPHIC_CAMERA;
camera.lowerBetaLimit = 0;
camera.orthoLeft = camera.orthoBottom = -0.01;
camera.orthoRight = camera.orthoTop = 0.01;
const target = new RenderTargetTexture("target", 4, scene, { type: TEXTURETYPE_FLOAT, generateMipMaps: false });
target.renderList = [plane];
target.activeCamera = camera;
scene.customRenderTargets.push(target);

async function seen(material) {
  plane.material = material;
  await material.forceCompilationAsync(plane);
  await scene.whenReadyAsync();
  scene.render();
  return (await target.readPixels())[0];
}

function openpbr(coat) {
  const material = new OpenPBRMaterial("m", scene);
  material.baseColor = new Color3(1, 1, 1);
  material.baseMetalness = 1;
  material.specularRoughness = 0;
  return Object.assign(material, coat);
}

function gltf() {
  const material = new PBRMaterial("m", scene);
  material.albedoColor = new Color3(1, 1, 1);
  material.metallic = 1;
  material.roughness = 0;
  material.clearCoat.isEnabled = true;
  material.clearCoat.roughness = 0;
  return material;
}

export async function measured() {
  const coat = { coatWeight: 1, coatIor: 1.5, coatRoughness: 0 };
  await seen(openpbr({})); // the first frame is drawn before all is loaded
  return {
    version: Engine.Version,
    "OpenPBRMaterial, no coat": await seen(openpbr({})),
    "OpenPBRMaterial, coat": await seen(openpbr(coat)),
    "OpenPBRMaterial, coat, coatDarkening 0": await seen(openpbr({ ...coat, coatDarkening: 0 })),
    "PBRMaterial, clearCoat": await seen(gltf()),
  };
}
JS
"$folder/venv/bin/python" - "$folder" <<'PYTHON'
import base64
import functools
import http.server
import os
import sys
import threading

from playwright.sync_api import sync_playwright

# One gray pixel in place of the noise picture that the material fetches from its makers' server.
GRAY = base64.b64decode(
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR42mNoaGgAAAMEAYF1LgG8AAAAAElFTkSuQmCC"
)


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


handler = functools.partial(Quiet, directory=sys.argv[1])
server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
threading.Thread(target=server.serve_forever, daemon=True).start()
here = f"http://127.0.0.1:{server.server_port}"
with sync_playwright() as playwright:
    browser = playwright.chromium.launch(
        executable_path=os.environ["CHROMIUM"],
        args=["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--no-sandbox"],
    )
    page = browser.new_page()
    page.route(
        lambda url: not url.startswith(here),
        lambda route: route.fulfill(
            body=GRAY, content_type="image/png", headers={"Access-Control-Allow-Origin": "*"}
        ),
    )
    page.goto(here)
    found = page.evaluate("async () => (await import('/mirror.js')).measured()")
    browser.close()
print("@babylonjs/core", found.pop("version"))
expected = {
    "OpenPBRMaterial, no coat": 1.0,
    "OpenPBRMaterial, coat": 0.04 + 0.96 * (1 - (0.04 + 0.52) / 2) ** 2,
    "OpenPBRMaterial, coat, coatDarkening 0": 1.0,
    "PBRMaterial, clearCoat": 1.0,
}
same = True
for name, wanted in expected.items():
    print(f"white mirror, {name}: {found[name]:.4f}")
    same &= abs(found[name] - wanted) < 5e-3
print("unchanged" if same else "CHANGED")
sys.exit(0 if same else 1)
PYTHON
