// UsdPreviewSurface: the lighting of the preview shader that usd-core ships, under one light.
// At roughness 0 its highlight is infinite in single precision; F is the same at any roughness.
const FILE = "/node_modules/pxr/pluginfo/usdShaders/resources/shaders/previewSurface.glslfx";

async function lighting() {
  const text = await (await fetch(FILE)).text();
  const section = text.split("-- glsl Preview.Lighting\n")[1].split("\n-- ")[0];
  return section.replaceAll("const float R", "float R"); // ESSL has constants of constants alone
}

export async function open() {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 1;
  const gl = canvas.getContext("webgl2");
  gl.getExtension("EXT_color_buffer_float");
  gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, 1, 1);
  gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
  const texture = gl.getParameter(gl.TEXTURE_BINDING_2D);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
  const shader = (kind, text) => {
    const made = gl.createShader(kind);
    gl.shaderSource(made, text);
    gl.compileShader(made);
    if (!gl.getShaderParameter(made, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(made));
    return made;
  };
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
    }`,
    ),
  );
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS))
    throw new Error(gl.getProgramInfoLog(program));
  gl.useProgram(program);

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
      for (const [name, value] of Object.entries({ mu: Math.cos(theta), ...all })) {
        const at = gl.getUniformLocation(program, name);
        if (Array.isArray(value)) gl.uniform3f(at, ...value);
        else gl.uniform1f(at, value);
      }
      gl.drawArrays(gl.POINTS, 0, 1);
      const pixels = new Float32Array(4);
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.FLOAT, pixels);
      return pixels;
    },
  };
}
