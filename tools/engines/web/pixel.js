// One float pixel that a fragment shader computes: for engines whose shaders are all that is run.

export function onePixel() {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 1;
  const gl = canvas.getContext("webgl2");
  gl.getExtension("EXT_color_buffer_float");
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, 1, 1);
  gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);

  function shader(kind, text) {
    const made = gl.createShader(kind);
    gl.shaderSource(made, `#version 300 es\n${text}`);
    gl.compileShader(made);
    if (!gl.getShaderParameter(made, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(made));
    return made;
  }

  return {
    /** A program that writes `seen`, given the text of its fragment shader without the version. */
    program(fragment) {
      const made = gl.createProgram();
      gl.attachShader(
        made,
        shader(
          gl.VERTEX_SHADER,
          "void main() { gl_Position = vec4(0.0, 0.0, 0.0, 1.0); gl_PointSize = 4.0; }",
        ),
      );
      gl.attachShader(made, shader(gl.FRAGMENT_SHADER, fragment));
      gl.linkProgram(made);
      if (!gl.getProgramParameter(made, gl.LINK_STATUS))
        throw new Error(gl.getProgramInfoLog(made));
      return made;
    },

    /** What a program writes, with numbers, flags and triples as its uniforms. */
    drawn(program, uniforms) {
      gl.useProgram(program);
      for (const [name, value] of Object.entries(uniforms)) {
        const at = gl.getUniformLocation(program, name);
        if (Array.isArray(value)) gl.uniform3f(at, ...value);
        else if (typeof value === "boolean") gl.uniform1i(at, value);
        else gl.uniform1f(at, value);
      }
      gl.drawArrays(gl.POINTS, 0, 1);
      const pixels = new Float32Array(4);
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.FLOAT, pixels);
      return pixels;
    },
  };
}
