// MaterialX: the GLSL that its generator includes, as it is shipped, compiled with a main of ours.

import { onePixel } from "./pixel.js";

const LIBRARIES = "/node_modules/MaterialX/libraries/";
const FILES = [
  "stdlib/genglsl/lib/mx_math.glsl",
  "pbrlib/genglsl/lib/mx_microfacet.glsl",
  "pbrlib/genglsl/lib/mx_microfacet_specular.glsl",
];
const ALPHA = 1e-6; // the generator's own least roughness, M_FLOAT_EPS

const SURFACES = {
  dielectric_bsdf: "mx_init_fresnel_dielectric(ior.x, 0.0, 1.5)",
  conductor_bsdf: "mx_init_fresnel_conductor(ior, extinction, 0.0, 1.5)",
  generalized_schlick_bsdf: "mx_init_fresnel_schlick(color0, color82, vec3(1.0), 5.0, 0.0, 1.5)",
};

async function source() {
  const texts = await Promise.all(
    FILES.map(async (file) => (await fetch(LIBRARIES + file)).text()),
  );
  return (
    texts
      .join("\n")
      // What the generator fills in: textures, of which none is read here.
      .replaceAll(/^#include.*$/gm, "")
      .replaceAll("$texSamplerSignature", "sampler2D tex_sampler")
      .replaceAll("$texSamplerSampler2D", "tex_sampler")
      .replaceAll(/\$\w+/g, "vec3(0.0)")
  );
}

export async function open() {
  const library = await source();
  const { program, drawn } = onePixel();
  const programs = Object.fromEntries(
    Object.entries(SURFACES).map(([node, init]) => [
      node,
      program(`
        precision highp float;
        #define AIRY_FRESNEL_ITERATIONS 2
        precision highp sampler2D;
        #define DIRECTIONAL_ALBEDO_METHOD 0
        uniform float mu; uniform bool prefiltered;
        uniform vec3 ior, extinction, color0, color82;
        out vec4 seen;
        ${library}
        void main() {
          FresnelData fd = ${init};
          vec3 F = mx_compute_fresnel(mu, fd);
          vec3 compensation = mx_ggx_energy_compensation(mu, ${ALPHA}, F);
          seen = vec4((prefiltered ? mx_ggx_dir_albedo(mu, ${ALPHA}, fd) : F) * compensation, 1.0);
        }`),
    ]),
  );

  return {
    absolute: true,
    ways({ metal, n, k, F0, tint }) {
      if (!metal) return { dielectric_bsdf: { ior: n[0] } };
      return {
        conductor_bsdf: { ior: n, extinction: k },
        generalized_schlick_bsdf: { color0: F0, color82: tint },
      };
    },
    reflect(way, typed, under, theta) {
      const triples = Object.entries(typed).map(([name, value]) => [
        name,
        Array.isArray(value) ? value : Array(3).fill(value),
      ]);
      const prefiltered = under === "environment";
      return drawn(programs[way], {
        mu: Math.cos(theta),
        prefiltered,
        ...Object.fromEntries(triples),
      });
    },
  };
}
