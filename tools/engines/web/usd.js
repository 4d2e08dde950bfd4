// UsdPreviewSurface: the lighting of the preview shader that usd-core ships, under one light.
// At roughness 0 its highlight is infinite in single precision; F is the same at any roughness.

import { onePixel } from "./pixel.js";

const FILE = "/node_modules/pxr/pluginfo/usdShaders/resources/shaders/previewSurface.glslfx";

async function lighting() {
  const text = await (await fetch(FILE)).text();
  const section = text.split("-- glsl Preview.Lighting\n")[1].split("\n-- ")[0];
  return section.replaceAll("const float R", "float R"); // ESSL has constants of constants alone
}

export async function open() {
  const { program, drawn } = onePixel();
  const shading = program(`
    precision highp float;
    #define PI 3.14159265358979
    struct LightingContributions { vec3 diffuse; vec3 specular; };
    uniform float mu, ior, metallic, useSpecularWorkflow;
    uniform vec3 diffuseColor, specularColor;
    out vec4 seen;
    ${await lighting()}
    void main() {
      LightingContributions light = evaluateLight(
        diffuseColor, useSpecularWorkflow > 0.5, ior, metallic, 1.0, specularColor, 0.5,
        0.0, vec3(0.0), 0.0, 1.0, mu, mu, 1.0, mu, vec3(0.0), vec3(1.0));
      seen = vec4(light.specular, 1.0);
    }`);

  return {
    lights: ["light"],
    ways({ metal, n, F0 }) {
      if (!metal) return { ior: { ior: n[0], diffuseColor: [0, 0, 0], metallic: 0 } };
      return {
        metallic: { diffuseColor: F0, metallic: 1 },
        "specular workflow": { useSpecularWorkflow: 1, specularColor: F0, diffuseColor: [0, 0, 0] },
      };
    },
    reflect(_way, typed, _under, theta) {
      const all = {
        ior: 1.5,
        metallic: 0,
        useSpecularWorkflow: 0,
        specularColor: [0, 0, 0],
        ...typed,
      };
      return drawn(shading, { mu: Math.cos(theta), ...all });
    },
  };
}
