// MaterialX: the GLSL that its generator includes, as it is shipped, compiled with a main of ours.
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
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 1;
  const gl = canvas.getContext("webgl2");
  gl.getExtension("EXT_color_buffer_float");
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, 1, 1);
  gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);

  const shader = (kind, text) => {
    const made = gl.createShader(kind);
    gl.shaderSource(made, text);
    gl.compileShader(made);
    if (!gl.getShaderParameter(made, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(made));
    return made;
  };
  const programs = {};
  for (const [node, init] of Object.entries(SURFACES)) {
    const program = gl.createProgram();
    gl.attachShader(
      program,
      shader(
        gl.VERTEX_SHADER,
        `#version 300 es
      void main() { gl_Position = vec4(0.0, 0.0, 0.0, 1.0); gl_PointSize = 4.0; }`,
      ),
    );
    gl.attachShader(
      program,
      shader(
        gl.FRAGMENT_SHADER,
        `#version 300 es
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
      }`,
      ),
    );
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS))
      throw new Error(gl.getProgramInfoLog(program));
    programs[node] = program;
  }

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
      const program = programs[way];
      gl.useProgram(program);
      gl.uniform1f(gl.getUniformLocation(program, "mu"), Math.cos(theta));
      gl.uniform1i(gl.getUniformLocation(program, "prefiltered"), under === "environment");
      for (const [name, value] of Object.entries(typed)) {
        const three = Array.isArray(value) ? value : [value, value, value];
        gl.uniform3f(gl.getUniformLocation(program, name), ...three);
      }
      gl.drawArrays(gl.POINTS, 0, 1);
      const pixels = new Float32Array(4);
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.FLOAT, pixels);
      return pixels;
    },
  };
}
