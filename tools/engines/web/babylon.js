// Babylon.js: PBRMaterial, in both of its ways to enter a metal, and OpenPBRMaterial.

import { ArcRotateCamera } from "@babylonjs/core/Cameras/arcRotateCamera.js";
import { Camera } from "@babylonjs/core/Cameras/camera.js";
import { Constants } from "@babylonjs/core/Engines/constants.js";
import { Engine } from "@babylonjs/core/Engines/engine.js";
import { DirectionalLight } from "@babylonjs/core/Lights/directionalLight.js";
import { OpenPBRMaterial } from "@babylonjs/core/Materials/PBR/openpbrMaterial.js";
import { PBRMaterial } from "@babylonjs/core/Materials/PBR/pbrMaterial.js";
import { RawCubeTexture } from "@babylonjs/core/Materials/Textures/rawCubeTexture.js";
import { RenderTargetTexture } from "@babylonjs/core/Materials/Textures/renderTargetTexture.js";
import { Color3, Color4 } from "@babylonjs/core/Maths/math.color.js";
import { Vector3 } from "@babylonjs/core/Maths/math.vector.js";
import { CreateGround } from "@babylonjs/core/Meshes/Builders/groundBuilder.js";
import { Scene } from "@babylonjs/core/scene.js";
import "@babylonjs/core/Engines/Extensions/engine.readTexture.js";
import "@babylonjs/core/Engines/Extensions/engine.rawTexture.js";
import "@babylonjs/core/Engines/Extensions/engine.renderTarget.js";

const DISTANCE = 10;

export async function open() {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 4;
  const engine = new Engine(canvas, false);
  const scene = new Scene(engine);
  scene.clearColor = new Color4(0, 0, 0, 1);
  scene.imageProcessingConfiguration.applyByPostProcess = true; // materials write linear values
  const face = new Float32Array([1, 1, 1, 1]);
  const even = new RawCubeTexture(
    scene,
    Array(6).fill(face),
    1,
    Constants.TEXTUREFORMAT_RGBA,
    Constants.TEXTURETYPE_FLOAT,
  );
  even.gammaSpace = false;
  const ground = CreateGround("plane", { width: 1000, height: 1000 }, scene);
  const light = new DirectionalLight("light", new Vector3(0, -1, 0), scene);
  const camera = new ArcRotateCamera("camera", 0, 0, DISTANCE, Vector3.Zero(), scene);
  camera.mode = Camera.ORTHOGRAPHIC_CAMERA;
  camera.orthoLeft = camera.orthoBottom = -0.01;
  camera.orthoRight = camera.orthoTop = 0.01;
  camera.lowerBetaLimit = 0;
  const target = new RenderTargetTexture("target", 4, scene, {
    type: Constants.TEXTURETYPE_FLOAT,
    generateMipMaps: false,
  });
  target.clearColor = new Color4(0, 0, 0, 1);
  target.renderList = [ground];
  target.activeCamera = camera;
  scene.customRenderTargets.push(target);

  const made = {
    PBRMaterial(typed) {
      const material = new PBRMaterial("m", scene);
      material.metallic = typed.metallic;
      material.roughness = typed.roughness;
      material.albedoColor = new Color3(...typed.albedoColor);
      if (typed.clearCoat) {
        material.clearCoat.isEnabled = true;
        material.clearCoat.roughness = 0;
        material.clearCoat.indexOfRefraction = typed.clearCoat.indexOfRefraction;
      }
      if (typed.indexOfRefraction) material.indexOfRefraction = typed.indexOfRefraction;
      if (typed.conductorSpecularModel) {
        material.brdf.conductorSpecularModel = typed.conductorSpecularModel;
        material.metallicReflectanceColor = new Color3(...typed.metallicReflectanceColor);
      }
      return material;
    },
    OpenPBRMaterial(typed) {
      const material = new OpenPBRMaterial("m", scene);
      material.baseMetalness = typed.baseMetalness;
      material.baseColor = new Color3(...typed.baseColor);
      material.specularRoughness = typed.specularRoughness;
      if (typed.specularIor) material.specularIor = typed.specularIor;
      if (typed.coatWeight) {
        material.coatWeight = typed.coatWeight;
        material.coatIor = typed.coatIor;
        material.coatRoughness = typed.coatRoughness;
      }
      if ("specularWeight" in typed) material.specularWeight = typed.specularWeight;
      if (typed.specularColor) material.specularColor = new Color3(...typed.specularColor);
      return material;
    },
  };

  return {
    ways({ metal, n, F0, tint }) {
      const black = [0, 0, 0];
      if (!metal) {
        return {
          PBRMaterial: { indexOfRefraction: n[0], albedoColor: black, metallic: 0, roughness: 0 },
          OpenPBRMaterial: {
            specularIor: n[0],
            baseColor: black,
            baseMetalness: 0,
            specularRoughness: 0,
          },
        };
      }
      return {
        PBRMaterial: { albedoColor: F0, metallic: 1, roughness: 0 },
        "PBRMaterial, F82": {
          albedoColor: F0,
          metallic: 1,
          roughness: 0,
          conductorSpecularModel: 1,
          metallicReflectanceColor: tint,
        },
        OpenPBRMaterial: {
          baseColor: F0,
          baseMetalness: 1,
          specularRoughness: 0,
          specularColor: tint,
        },
      };
    },
    async reflect(way, typed, under, theta) {
      const material = made[way.split(",")[0]](typed);
      scene.environmentTexture = under === "light" ? null : even;
      light.setEnabled(under === "light");
      light.intensity = 1e-7; // what is drawn is cut at 30
      light.direction = new Vector3(Math.sin(theta), -Math.cos(theta), 0);
      camera.alpha = 0;
      camera.beta = Math.max(theta, 1e-6);
      ground.material = material;
      await material.forceCompilationAsync(ground);
      await scene.whenReadyAsync();
      scene.render();
      const pixels = await target.readPixels();
      material.dispose();
      return pixels;
    },
  };
}
