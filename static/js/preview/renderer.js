/** Draws the scene by WebGL2: each side into a linear picture, and both onto the canvas. */

import { boundsOf, distanceTo, inWater, rowsBelow } from "./camera.js";
import { BALLS, EVEN, INTERVALS, presenter, ROWS, surface, VERTEX } from "./shader.js";

/**
 * @typedef {import('./shader.js').Variant} Variant
 * @typedef {import('./camera.js').Camera} Camera
 * @typedef {'left' | 'right' | 'split' | 'difference'} Show
 * @typedef {object} Picture
 * @property {Camera} camera
 * @property {{left: Variant, right: Variant}} sides
 * @property {number} eta n_i / n_t
 * @property {readonly number[]} escape
 * @property {number} external
 * @property {Show} show
 * @property {number} split from 0 to 1
 * @property {number} gain of the difference
 * @typedef {{program: WebGLProgram, at: (name: string) => WebGLUniformLocation | null}} Program
 */

const SIDES = /** @type {const} */ (["left", "right"]);
const TEXELS = INTERVALS + 1;

/** Each value beside its successor. @param {Float32Array} texels the same in every channel */
function paired(texels) {
  return texels.map((x, i) => (i % 4 === 1 ? (texels[i + 4] ?? x) : x));
}

/** @param {HTMLCanvasElement} canvas @returns {ReturnType<typeof createWith> | null} null without WebGL2 and float targets */
export function createRenderer(canvas) {
  const gl = canvas.getContext("webgl2", {
    alpha: false,
    antialias: false,
    depth: false,
    preserveDrawingBuffer: true, // what is drawn once can be printed later
  });
  return gl?.getExtension("EXT_color_buffer_float") ? createWith(gl) : null;
}

/** @param {WebGL2RenderingContext} gl */
function createWith(gl) {
  const vertex = compile(gl.VERTEX_SHADER, VERTEX);
  /** @type {Map<string, Program>} */
  const programs = new Map();
  const curves = texture(gl.NEAREST);
  const rows = Object.keys(ROWS).length;
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, TEXELS, rows, 0, gl.RGBA, gl.FLOAT, null);
  const tables = { left: texture(gl.LINEAR), right: texture(gl.LINEAR) };
  const sizes = { left: 2, right: 2 };
  const frames = { left: target(), right: target() };
  const measured = target();

  /** @param {number} kind @param {string} source */
  function compile(kind, source) {
    const shader = /** @type {WebGLShader} */ (gl.createShader(kind));
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS) && !gl.isContextLost())
      throw new Error(gl.getShaderInfoLog(shader) ?? "a shader does not compile");
    return shader;
  }

  /** @param {string} source of its fragment shader @returns {Program} */
  function programOf(source) {
    let found = programs.get(source);
    if (!found) {
      const program = gl.createProgram();
      const shader = compile(gl.FRAGMENT_SHADER, source);
      gl.attachShader(program, vertex);
      gl.attachShader(program, shader);
      gl.linkProgram(program);
      gl.deleteShader(shader);
      if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost())
        throw new Error(gl.getProgramInfoLog(program) ?? "a program does not link");
      /** @type {Map<string, WebGLUniformLocation | null>} */
      const places = new Map();
      const at = (/** @type {string} */ name) => {
        if (!places.has(name)) places.set(name, gl.getUniformLocation(program, name));
        return places.get(name) ?? null;
      };
      found = { program, at };
      programs.set(source, found);
    }
    gl.useProgram(found.program);
    return found;
  }

  /** @param {number} filter */
  function texture(filter) {
    const made = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, made);
    for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER])
      gl.texParameteri(gl.TEXTURE_2D, name, filter);
    for (const name of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T])
      gl.texParameteri(gl.TEXTURE_2D, name, gl.CLAMP_TO_EDGE);
    return made;
  }

  function target() {
    const picture = texture(gl.LINEAR);
    const frame = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, picture, 0);
    return { picture, frame, size: [0, 0] };
  }

  /**
   * @param {ReturnType<typeof target>} one
   * @param {readonly [number, number]} size
   * @param {number} format
   */
  function resize(one, size, format) {
    if (one.size[0] === size[0] && one.size[1] === size[1]) return;
    gl.bindTexture(gl.TEXTURE_2D, one.picture);
    const [width, height] = size;
    const type = format === gl.RGBA8 ? gl.UNSIGNED_BYTE : gl.HALF_FLOAT;
    gl.texImage2D(gl.TEXTURE_2D, 0, format, width, height, 0, gl.RGBA, type, null);
    one.size = [width, height];
  }

  /** @param {number} unit @param {WebGLTexture | null} one */
  function bind(unit, one) {
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(gl.TEXTURE_2D, one);
    gl.activeTexture(gl.TEXTURE0);
  }

  /**
   * One side of the scene.
   * @param {'left' | 'right'} side
   * @param {Picture} picture
   * @param {readonly [number, number]} size
   * @param {readonly [number, number]} columns from, to
   * @param {boolean} encode whether onto the canvas itself, else as linear light into the side's picture
   */
  function drawSide(side, picture, size, columns, encode) {
    const { camera } = picture;
    const variant = picture.sides[side];
    const [left, right] = columns;
    if (right <= left) return;
    gl.bindFramebuffer(gl.FRAMEBUFFER, encode ? null : frames[side].frame);
    gl.viewport(0, 0, ...size);
    bind(0, curves);
    bind(1, tables[side]);

    /**
     * @param {string} pass
     * @param {readonly [number, number, number, number]} box
     * @param {{plain?: boolean, thing?: number}} [what]
     */
    const draw = (pass, [x, y, width, height], { plain = false, thing = 0 } = {}) => {
      const from = Math.max(left, x);
      const to = Math.min(right, x + width);
      if (to <= from || height <= 0) return;
      gl.scissor(from, y, to - from, height);
      const { at } = programOf(surface(pass, variant, { plain, encode }));
      gl.uniform2f(at("u_size"), ...size);
      gl.uniformMatrix3fv(at("u_camera"), false, camera.axes);
      gl.uniform3f(at("u_eye"), ...camera.eye);
      gl.uniform1f(at("u_lens"), camera.lens);
      gl.uniform1i(at("u_row"), ROWS[side]);
      gl.uniform1i(at("u_curves"), 0);
      gl.uniform1i(at("u_table"), 1);
      gl.uniform1f(at("u_texels"), sizes[side]);
      gl.uniform1f(at("u_eta"), picture.eta);
      gl.uniform3fv(at("u_escape"), picture.escape);
      gl.uniform1f(at("u_external"), picture.external);
      gl.uniform1i(at("u_thing"), thing);
      gl.drawArrays(gl.TRIANGLES, 0, 3);
    };

    gl.enable(gl.SCISSOR_TEST);
    gl.disable(gl.BLEND);
    if (variant.even) {
      gl.scissor(left, 0, right - left, size[1]);
      gl.clearColor(EVEN, EVEN, EVEN, 0);
      gl.clear(gl.COLOR_BUFFER_BIT);
    } else {
      const rows = rowsBelow(camera, size);
      draw("sky", [0, rows, size[0], size[1] - rows]);
      draw("water", [0, 0, size[0], rows], { plain: true });
      for (const one of Object.values(BALLS)) {
        const box = inWater(camera, one, size);
        if (box) draw("water", [box[0], box[1], box[2], Math.min(box[3], rows - box[1])]);
      }
    }
    gl.enable(gl.BLEND);
    const names = /** @type {(keyof typeof BALLS)[]} */ (
      variant.even ? ["ball"] : Object.keys(BALLS)
    );
    names.sort((a, b) => distanceTo(camera, BALLS[b]) - distanceTo(camera, BALLS[a]));
    for (const name of names) {
      const box = boundsOf(camera, BALLS[name], size);
      if (!box) continue;
      const ball = name === "ball";
      // The fourth channel stays 1 where the chosen surface is seen.
      const own = ball && !variant.water;
      const { ONE, ZERO, ONE_MINUS_SRC_ALPHA: rest } = gl;
      gl.blendFuncSeparate(ONE, rest, own ? ONE : ZERO, rest);
      draw(ball ? "ball" : "thing", box, { thing: name === "buoy" ? 0 : 1 });
    }
    gl.disable(gl.BLEND);
    gl.disable(gl.SCISSOR_TEST);
  }

  /**
   * Linear pictures onto the canvas or into another frame: one, or the difference of both.
   * @param {'left' | 'right' | 'difference'} show
   * @param {WebGLFramebuffer | null} onto
   * @param {readonly [number, number]} size
   * @param {readonly [number, number]} columns
   * @param {number} gain
   */
  function present(show, onto, size, [from, to], gain) {
    gl.bindFramebuffer(gl.FRAMEBUFFER, onto);
    gl.viewport(0, 0, ...size);
    gl.enable(gl.SCISSOR_TEST);
    gl.scissor(from, 0, Math.max(0, to - from), size[1]);
    const { at } = programOf(presenter(show === "difference"));
    bind(0, frames[show === "right" ? "right" : "left"].picture);
    bind(1, frames.right.picture);
    gl.uniform1i(at("u_left"), 0);
    gl.uniform1i(at("u_right"), 1);
    gl.uniform2f(at("u_size"), ...size);
    gl.uniform1f(at("u_gain"), gain);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.disable(gl.SCISSOR_TEST);
  }

  /** @param {readonly [number, number]} size @param {number} scale @returns {[number, number]} */
  const scaled = ([width, height], scale) => [
    Math.max(1, Math.round(width * scale)),
    Math.max(1, Math.round(height * scale)),
  ];

  /** Until all that was asked for is done; waiting for it here would hold up the page. @returns {Promise<void>} */
  function drawn() {
    const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    return new Promise((resolve) => {
      const look = () => {
        const status = fence ? gl.clientWaitSync(fence, 0, 0) : gl.CONDITION_SATISFIED;
        if (status === gl.TIMEOUT_EXPIRED) {
          setTimeout(look, 10);
          return;
        }
        gl.deleteSync(fence);
        resolve();
      };
      setTimeout(look);
    });
  }

  return {
    /** @param {keyof typeof ROWS} name @param {Float32Array} texels four numbers each */
    setCurve(name, texels) {
      if (name === "water") texels = paired(texels);
      gl.bindTexture(gl.TEXTURE_2D, curves);
      const row = ROWS[name];
      gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, row, TEXELS, 1, gl.RGBA, gl.FLOAT, texels);
    },

    /** @param {'left' | 'right'} side @param {Uint8Array} texels four bytes each */
    setTable(side, texels) {
      const { TEXTURE_2D, RGBA, RGBA8, UNSIGNED_BYTE } = gl;
      gl.bindTexture(TEXTURE_2D, tables[side]);
      sizes[side] = texels.length / 4;
      gl.texImage2D(TEXTURE_2D, 0, RGBA8, sizes[side], 1, 0, RGBA, UNSIGNED_BYTE, texels);
    },

    /**
     * @param {Picture} picture
     * @param {number} points of the scene to a pixel of the canvas, along each side; with more than one
     *   the light is added up before it is encoded, and the picture is smooth
     */
    draw(picture, points) {
      const { width, height } = gl.canvas;
      const size = /** @type {const} */ ([width, height]);
      const inner = scaled(size, points);
      const { show, gain } = picture;
      const cut = Math.round(picture.split * width);
      /** @type {Record<string, readonly [number, number]>} */
      const columns = {
        left: [0, show === "split" ? cut : show === "right" ? 0 : width],
        right: [show === "split" ? cut : show === "left" ? width : 0, width],
      };
      const direct = points === 1 && show !== "difference";
      for (const side of SIDES) {
        const [from, to] = /** @type {[number, number]} */ (columns[side]);
        if (direct) {
          drawSide(side, picture, size, [from, to], true);
          continue;
        }
        resize(frames[side], inner, gl.RGBA16F);
        drawSide(side, picture, inner, [points * from, points * to], false);
        if (show !== "difference") present(side, null, size, [from, to], gain);
      }
      if (show === "difference") present(show, null, size, [0, width], gain);
    },

    /**
     * Both sides as 8-bit sRGB; the fourth byte tells where the chosen surface is seen.
     * @param {Picture} picture
     * @param {readonly [number, number]} size
     * @returns {Promise<{left: Uint8Array, right: Uint8Array}>}
     */
    async read(picture, size) {
      resize(measured, size, gl.RGBA8);
      const bytes = 4 * size[0] * size[1];
      const buffers = SIDES.map((side) => {
        resize(frames[side], size, gl.RGBA16F);
        drawSide(side, picture, size, [0, size[0]], false);
        present(side, measured.frame, size, [0, size[0]], 1);
        const buffer = gl.createBuffer();
        gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
        gl.bufferData(gl.PIXEL_PACK_BUFFER, bytes, gl.STREAM_READ);
        gl.readPixels(0, 0, ...size, gl.RGBA, gl.UNSIGNED_BYTE, 0);
        return buffer;
      });
      gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
      await drawn();
      const [left, right] = buffers.map((buffer) => {
        const copy = new Uint8Array(bytes);
        gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
        gl.getBufferSubData(gl.PIXEL_PACK_BUFFER, 0, copy);
        gl.deleteBuffer(buffer);
        return copy;
      });
      gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
      return { left: /** @type {Uint8Array} */ (left), right: /** @type {Uint8Array} */ (right) };
    },

    destroy() {
      gl.getExtension("WEBGL_lose_context")?.loseContext();
    },
  };
}

/** @typedef {ReturnType<typeof createWith>} Renderer */
