"""Running a snippet on Chromium's software GPU, in WebGL2 and in WebGPU."""

import numpy as np
from numpy.typing import NDArray
from playwright.sync_api import Page

Array = NDArray[np.float64]

_GLSL = """#version 300 es
precision highp float;
precision highp sampler2D;
uniform sampler2D given;
out vec4 result;
{code}
float argument(int i) {{ return texelFetch(given, ivec2(int(gl_FragCoord.x), i), 0).r; }}
void main() {{
    result = vec4({call}, {color});
}}
"""

_WGSL = """
@group(0) @binding(0) var<storage, read> given: array<f32>;
@group(0) @binding(1) var<storage, read_write> result: array<vec4f>;
{code}
@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {{
    let at = id.x;
    if (at < {count}u) {{
        result[at] = vec4f({call}, {color});
    }}
}}
"""

_WEBGL = """([source, rows, width]) => {
    const gl = document.createElement('canvas').getContext('webgl2');
    if (!gl?.getExtension('EXT_color_buffer_float')) return 'no WebGL2 with float targets';
    const shader = (type, text) => {
        const made = gl.createShader(type);
        gl.shaderSource(made, text);
        gl.compileShader(made);
        if (!gl.getShaderParameter(made, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(made));
        return made;
    };
    const program = gl.createProgram();
    gl.attachShader(program, shader(gl.VERTEX_SHADER, `#version 300 es
        void main() {
            gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0);
        }`));
    gl.attachShader(program, shader(gl.FRAGMENT_SHADER, source));
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    gl.useProgram(program);
    const texture = (format, w, h, kind, values) => {
        gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
        gl.texImage2D(gl.TEXTURE_2D, 0, format, w, h, 0, kind, gl.FLOAT, values);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
        return gl.getParameter(gl.TEXTURE_BINDING_2D);
    };
    const target = texture(gl.RGBA32F, width, 1, gl.RGBA, null);
    gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, target, 0);
    texture(gl.R32F, width, rows.length / width, gl.RED, new Float32Array(rows));
    gl.viewport(0, 0, width, 1);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    const values = new Float32Array(4 * width);
    gl.readPixels(0, 0, width, 1, gl.RGBA, gl.FLOAT, values);
    if (gl.getError()) throw new Error('WebGL error');
    return [...values];
}"""

_WEBGPU = """async ([source, rows, width]) => {
    const adapter = await navigator.gpu?.requestAdapter();
    if (!adapter) return 'no WebGPU';
    const device = await adapter.requestDevice();
    const module = device.createShaderModule({ code: source });
    const wrong = (await module.getCompilationInfo()).messages.map((m) => m.message);
    if (wrong.length) throw new Error(wrong.join('; '));
    const usage = GPUBufferUsage;
    const given = device.createBuffer({
        size: 4 * rows.length, usage: usage.STORAGE | usage.COPY_DST,
    });
    device.queue.writeBuffer(given, 0, new Float32Array(rows));
    const size = 16 * width;
    const result = device.createBuffer({ size, usage: usage.STORAGE | usage.COPY_SRC });
    const read = device.createBuffer({ size, usage: usage.MAP_READ | usage.COPY_DST });
    const pipeline = device.createComputePipeline({ layout: 'auto', compute: { module } });
    const group = device.createBindGroup({
        layout: pipeline.getBindGroupLayout(0),
        entries: [given, result].map((buffer, binding) => ({ binding, resource: { buffer } })),
    });
    const encoder = device.createCommandEncoder();
    const pass = encoder.beginComputePass();
    pass.setPipeline(pipeline);
    pass.setBindGroup(0, group);
    pass.dispatchWorkgroups(Math.ceil(width / 64));
    pass.end();
    encoder.copyBufferToBuffer(result, 0, read, 0, size);
    device.queue.submit([encoder.finish()]);
    await read.mapAsync(GPUMapMode.READ);
    const values = [...new Float32Array(read.getMappedRange())];
    device.destroy();
    return values;
}"""


def draw(page: Page, source: str, rows: Array) -> Array | str:
    """Run a fragment shader that reads `given`, a column a pixel, or say why that cannot be done here.

    Returns
    -------
    Array
        Of shape (pixels, 4).
    """
    found = page.evaluate(_WEBGL, [source, rows.ravel().tolist(), rows.shape[1]])
    return found if isinstance(found, str) else np.array(found).reshape(-1, 4)


def run(
    page: Page, language: str, code: str, name: str, per_channel: list[bool], given: Array
) -> Array | str:
    """Run a snippet with its function of colors, or say why that cannot be done here.

    Returns
    -------
    Array
        Of shape (angles, 4): the function of reals, then R, G and B of that of colors.
    """
    count = given.shape[1]
    read = "argument({})" if language == "glsl" else f"given[{{}}u * {count}u + at]"
    color = "vec3" if language == "glsl" else "vec3f"
    reals = [read.format(i) for i in range(len(given))]
    colors = [f"{color}({r})" if c else r for r, c in zip(reals, per_channel, strict=True)]
    call = f"{name}({', '.join(reals)})"
    rgb = f"{name}_rgb({', '.join(colors)})" if any(per_channel) else f"{color}({call})"
    frame, script = (_GLSL, _WEBGL) if language == "glsl" else (_WGSL, _WEBGPU)
    source = frame.format(code=code, call=call, color=rgb, count=count)
    values = page.evaluate(script, [source, given.ravel().tolist(), count])
    return values if isinstance(values, str) else np.array(values).reshape(-1, 4)
