#!/usr/bin/env bash
# One would guess: a smooth black dielectric of StandardMaterial (metalness 0, gloss 1; index 1.5 by
# refractionIndex = 1/1.5) reflects 0.04 along the normal and far more at grazing incidence, as Fresnel's
# equations (0.39 at 80 degrees, 0.90 at 89) and Schlick's curve (0.41 and 0.92) say, and as glTF asks.
# What happens: it reflects 0.0400 at 0, 60, 80 and 89 degrees, and diamond (2.42) 0.172 at all of them. F90 is
# gloss^2 times the largest channel of F0, so grazing light never exceeds that channel: gray metals are constant
# too, and the rim of copper is no whiter than its red.
# Measured 2026-11-30 with playcanvas 2.23.3 (Chromium, software WebGL, float pixels, a white sky of radiance 1).
# Touches: materials/engines/playcanvas.json and the model constant_f0, which stands for it.
# Needs npm and Chromium on the PATH (or named by CHROMIUM).
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3}" -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet --disable-pip-version-check playwright==1.60.0
npm install --silent --no-save --prefix "$folder" playcanvas@2.23.3
CHROMIUM=${CHROMIUM:-$(command -v chromium || command -v chromium-browser || command -v google-chrome)}
export CHROMIUM
echo >"$folder/index.html"
cat >"$folder/plane.js" <<'JS'
import * as pc from "/node_modules/playcanvas/build/playcanvas.mjs";

export async function measured(cases, angles) {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 4;
  const app = new pc.Application(canvas, { graphicsDeviceOptions: { antialias: false } });
  app.autoRender = false;
  app.start();
  const square = { width: 4, height: 4, format: pc.PIXELFORMAT_RGBA32F, mipmaps: false };
  const white = () => new Float32Array([1, 1, 1, 1]);
  const levels = [Array.from({ length: 6 }, white)];
  const sky = new pc.Texture(app.graphicsDevice, { ...square, cubemap: true, width: 1, height: 1, levels });
  app.scene.envAtlas = pc.EnvLighting.generateAtlas(sky);
  app.scene.ambientLight = new pc.Color(0, 0, 0);
  app.scene.exposure = 1;
  const color = new pc.Texture(app.graphicsDevice, square);
  const target = new pc.RenderTarget({ colorBuffer: color, depth: true });
  const plane = new pc.Entity();
  plane.addComponent("render", { type: "plane" });
  plane.setLocalScale(1000, 1, 1000);
  const camera = new pc.Entity();
  camera.addComponent("camera", {
    projection: pc.PROJECTION_ORTHOGRAPHIC,
    orthoHeight: 0.01,
    nearClip: 0.1,
    farClip: 100,
    renderTarget: target,
    clearColor: new pc.Color(0, 0, 0),
    toneMapping: pc.TONEMAP_LINEAR,
    gammaCorrection: pc.GAMMA_NONE,
  });
  app.root.addChild(plane);
  app.root.addChild(camera);

  async function reflected({ diffuse, ...numbers }, degrees) {
    const material = Object.assign(new pc.StandardMaterial(), { useMetalness: true, gloss: 1 }, numbers);
    material.diffuse = new pc.Color(...diffuse).gamma(); // a color is taken as sRGB
    material.update();
    plane.render.meshInstances[0].material = material;
    const theta = (degrees * Math.PI) / 180;
    camera.setPosition(10 * Math.sin(theta), 10 * Math.cos(theta), 0);
    camera.lookAt(new pc.Vec3(0, 0, 0), new pc.Vec3(0, 0, 1));
    app.render();
    const pixels = await color.read(0, 0, 4, 4, { renderTarget: target, immediate: true });
    return [...pixels.slice(0, 3)];
  }

  await reflected({ diffuse: [1, 1, 1], metalness: 1 }, 0);
  const found = { version: pc.version };
  for (const [name, material] of Object.entries(cases)) {
    found[name] = [];
    for (const degrees of angles) found[name].push(await reflected(material, degrees));
  }
  return found;
}
JS
"$folder/venv/bin/python" - "$folder" <<'PYTHON'
import functools
import http.server
import os
import sys
import threading
from math import cos, radians, sin, sqrt

from playwright.sync_api import sync_playwright


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


def fresnel(n, degrees):
    c, g = cos(radians(degrees)), sqrt(n * n - sin(radians(degrees)) ** 2)
    return (((c - g) / (c + g)) ** 2 + ((n * n * c - g) / (n * n * c + g)) ** 2) / 2


ANGLES = (0, 60, 80, 89)
COPPER = (0.952, 0.62, 0.511)
cases = {
    "index 1.5": {"metalness": 0, "diffuse": (0, 0, 0), "refractionIndex": 1 / 1.5},
    "index 2.42": {"metalness": 0, "diffuse": (0, 0, 0), "refractionIndex": 1 / 2.42},
    "gray metal": {"metalness": 1, "diffuse": (0.5, 0.5, 0.5)},
    "copper": {"metalness": 1, "diffuse": COPPER},
}
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
    found = page.evaluate(
        "async (asked) => (await import('/plane.js')).measured(...asked)", [cases, list(ANGLES)]
    )
    browser.close()
print("playcanvas", found.pop("version"))
same = True
for n, F0 in ((1.5, 0.04), (2.42, 0.1724)):
    curve = [pixel[0] for pixel in found[f"index {n}"]]
    for degrees, value in zip(ANGLES, curve):
        print(f"index {n} at {degrees} degrees: {value:.4f} (Fresnel {fresnel(n, degrees):.4f})")
    same &= all(abs(value - F0) < 1e-3 for value in curve) and fresnel(n, 89) > 0.8
for name, F0 in (("gray metal", (0.5, 0.5, 0.5)), ("copper", COPPER)):
    for degrees, pixel in zip(ANGLES, found[name]):
        print(f"{name} at {degrees} degrees:", *(f"{value:.3f}" for value in pixel))
        same &= max(pixel) < max(F0) + 2e-3
    same &= all(abs(value - wanted) < 2e-3 for value, wanted in zip(found[name][0], F0))
print("unchanged" if same else "CHANGED")
sys.exit(0 if same else 1)
PYTHON
