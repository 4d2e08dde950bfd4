"""MaterialX's own Fresnel functions, compiled as they are shipped and run with what our exports type."""

import os
import re
from pathlib import Path

import MaterialX
import numpy as np
import pytest
from playwright.sync_api import Page

from app.answers.materials.export import Export, export
from app.export.target import ModeId, TargetId
from app.materials.media import default_catalog
from tests.browser.gpu import Array, draw

SHIPPED = Path(MaterialX.__file__).parent / "libraries"
FILES = (
    "stdlib/genglsl/lib/mx_math.glsl",
    "pbrlib/genglsl/lib/mx_microfacet.glsl",
    "pbrlib/genglsl/lib/mx_microfacet_specular.glsl",
)
AT_MOST = 2e-3

INITS = {
    "nk": "mx_init_fresnel_conductor(three(1), three(4), 0.0, 1.5)",
    "f82": "mx_init_fresnel_schlick(three(1), three(4), vec3(1.0), 5.0, 0.0, 1.5)",
    "ior": "mx_init_fresnel_dielectric(argument(1), 0.0, 1.5)",
}
"""By mode, what the generator calls for its node."""


def shader(mode: str) -> str:
    """The library with a main of ours; its generator fills in textures, of which none is read."""
    texts = [(SHIPPED / name).read_text(encoding="utf-8") for name in FILES]
    lines = [line for line in "\n".join(texts).splitlines() if not line.startswith("#include")]
    library = "\n".join(lines).replace("$texSamplerSignature", "sampler2D tex_sampler")
    library = library.replace("$texSamplerSampler2D", "tex_sampler")
    library = re.sub(r"\$\w+", "vec3(0.0)", library)
    return f"""#version 300 es
precision highp float;
precision highp sampler2D;
#define AIRY_FRESNEL_ITERATIONS 2
#define DIRECTIONAL_ALBEDO_METHOD 0
uniform sampler2D given;
out vec4 seen;
{library}
float argument(int i) {{ return texelFetch(given, ivec2(int(gl_FragCoord.x), i), 0).r; }}
vec3 three(int i) {{ return vec3(argument(i), argument(i + 1), argument(i + 2)); }}
void main() {{
    FresnelData fd = {INITS[mode]};
    seen = vec4(mx_compute_fresnel(argument(0), fd), 1.0);
}}"""


def typed(answer: Export, to: TargetId) -> list[float]:
    """What the node is given, by the names of the target."""
    names = {
        ("materialx", "nk"): ("ior", "extinction"),
        ("materialx", "f82"): ("color0", "color82"),
        ("materialx", "ior"): ("ior",),
        ("openpbr", "f82"): ("base_color", "specular_color"),
        ("openpbr", "ior"): ("specular_ior",),
    }[to, answer.mode]
    values = [answer.parameters[name] for name in names]
    return [
        number
        for value in values
        for number in (value if isinstance(value, list) else [value])
        if isinstance(number, float)
    ]


@pytest.mark.parametrize(
    ("to", "mode"),
    [
        ("materialx", "nk"),
        ("materialx", "f82"),
        ("materialx", "ior"),
        ("openpbr", "f82"),
        ("openpbr", "ior"),
    ],
)
def test_reflects_what_the_export_says(page: Page, to: TargetId, mode: ModeId) -> None:
    """Of every material that has the mode, at 0, 30, 60, 80 and 85 degrees."""
    answers = [export(preset, to) for preset in default_catalog().presets]
    answers = [
        one if one.mode == mode else export(default_catalog().get(one.material.id), to, mode)
        for one in answers
        if mode in one.modes
    ]
    columns = [
        [float(mu), *typed(one, to)]
        for one in answers
        for mu in np.cos(np.radians(one.theta_i_deg))
    ]
    rows: Array = np.array(columns).T
    said = np.concatenate([one.reflectance for one in answers])
    page.goto("/docs")
    found = draw(page, shader(mode), rows)
    if isinstance(found, str):
        (pytest.fail if os.environ.get("CI") else pytest.skip)(found)
    off = np.abs(found[:, :3] - said)
    assert len(answers) > 50
    assert 0.0 < off.max() < AT_MOST
