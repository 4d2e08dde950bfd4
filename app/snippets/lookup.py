"""Reading R from a table over the cosine, as code to take away: what `/lut` is made for."""

from collections.abc import Mapping

from app.optics.lookup import texel_coordinate
from app.optics.parameters import MU
from app.snippets.formula import read
from app.snippets.guards import guarded, told
from app.snippets.languages import Language, Trust
from app.snippets.piece import Piece
from app.snippets.snippet import Argument, untested_words

_BODIES: Mapping[str, str] = {
    "glsl": """float table_lookup(sampler2D table, float texels, float mu) {
    return texture(table, vec2(texel_coordinate(mu, texels), 0.5)).r;
}""",
    "hlsl": """float table_lookup(Texture2D table, SamplerState linear_clamp, float texels, float mu) {
    return table.SampleLevel(linear_clamp, float2(texel_coordinate(mu, texels), 0.5), 0.0).r;
}""",
    "wgsl": """fn table_lookup(
    table: texture_2d<f32>, linear_clamp: sampler, texels: f32, mu: f32
) -> f32 {
    return textureSampleLevel(table, linear_clamp, vec2f(texel_coordinate(mu, texels), 0.5), 0.0).r;
}""",
    "osl": """float table_lookup(string table, float texels, float mu) {
    float at = texel_coordinate(mu, texels);
    return texture(table, at, 0.5, "wrap", "clamp", "interp", "bilinear");
}""",
    "javascript": """function table_lookup(table, mu) {
    const at = texel_coordinate(mu, table.length) * table.length - 0.5;
    const i = Math.min(Math.floor(at), table.length - 2);
    return table[i] + (at - i) * (table[i + 1] - table[i]);
}""",
    "python": """def table_lookup(table, mu):
    at = texel_coordinate(mu, len(table)) * len(table) - 0.5
    return np.interp(at, np.arange(len(table)), table)""",
}
"""The one function that no formula is behind: it asks the language for a texture."""

_COMPILED = "compiled by glslangValidator; its numbers were not run"
_CHECKED: Mapping[str, tuple[Trust, str]] = {
    "glsl": ("compiled", _COMPILED),
    "hlsl": ("compiled", _COMPILED),
    "wgsl": ("compiled", "compiled by Chromium's WebGPU; its numbers were not run"),
    "osl": ("untested", "no compiler of OSL is at hand to the tests"),
    "javascript": ("run", "run by Node.js against NumPy"),
    "python": ("run", "run by Python against NumPy"),
}

REFERENCE = "M. Wloka, Fresnel Reflection, NVIDIA technical report (2002), figures 10 and 11"
VALIDITY = (
    "The table is one of /lut, R over mu from 0 to 1, sampled with linear filtering and clamped at its "
    "ends; its error is told with it."
)


def write_lookup(language: Language) -> str:
    """Write the reading of a table, with its source and meaning as comments."""
    trust, by = _CHECKED[language.id]
    coordinate = guarded(read(texel_coordinate))
    lines = language.commented(
        [
            "R read from a table over the cosine of the angle of incidence",
            f"Source: {REFERENCE}",
            VALIDITY,
            *([untested_words(by)] if trust == "untested" else []),
            *(f"{a.name}: {a.description} {a.minimum:g} to {a.maximum:g}." for a in ARGUMENTS),
            told(coordinate),
        ]
    )
    if language.id == "python":
        lines += ["", "import numpy as np"]
    between = ["", ""] if language.id == "python" else [""]
    lines += [*between, *language.function(coordinate)]
    return "\n".join([*lines, *between, _BODIES[language.id]]) + "\n"


ARGUMENTS = (
    Argument(MU.name, MU.description, per_channel=False, minimum=MU.minimum, maximum=MU.maximum),
    Argument("texels", "Texels of the table.", per_channel=False, minimum=2.0, maximum=4096.0),
)
PIECE = Piece(
    id="lookup",
    title="Reading a table, Wloka's figure 10",
    reference=REFERENCE,
    validity=VALIDITY,
    functions=("texel_coordinate", "table_lookup"),
    arguments=ARGUMENTS,
    write=write_lookup,
    checked=_CHECKED,
)
