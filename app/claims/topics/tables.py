"""Claims about what is read between the points of a table or of a mesh."""

from app.claims import sources
from app.claims.claim import Claim, Figure, Part
from app.claims.readings import value

_WATER = "n_t=1.333333"


def _table(name: str, says: str, size: int, bits: int = 32) -> Figure:
    return Figure(
        name,
        says,
        f"/errors?{_WATER}&models=lut_1d&lut_1d.size={size}&lut_1d.bits={bits}",
        value("errors[model=lut_1d].max_abs"),
    )


CLAIMS = (
    Claim(
        id="texture-most-accurate",
        title="A texture of the curve is the most accurate",
        claimed="Reading R(arccos x) from a texture is the most accurate way; only its resolution "
        "introduces "
        "an error.",
        source=sources.WLOKA,
        where="Per-Pixel, figures 10, 11 and 13",
        domain="from vacuum into water (1.333333), linear filtering, 0 to 90 degrees",
        figures=(
            _table("texels_256", "largest error, 256 texels of 32 bits", 256),
            _table("bits_8", "largest error, 256 texels of 8 bits", 256, 8),
            _table("texels_16", "largest error, 16 texels of 32 bits", 16),
            Figure(
                "schlick",
                "largest error of Schlick",
                f"/errors?{_WATER}&models=schlick",
                value("errors[model=schlick].max_abs"),
            ),
        ),
        parts=(
            Part(
                says="256 texels of 8 bits beat the polynomial", figure="bits_8", at_most="schlick"
            ),
            Part(
                says="256 texels: within half an 8-bit step", figure="texels_256", at_most=0.5 / 255
            ),
            Part(says="8 bits: only the depth is left", figure="bits_8", at_most=1.1 * 0.5 / 255),
        ),
        found="256 texels leave {texels_256:.1e}, with 8 bits each {bits_8:.4f}; 16 texels "
        "{texels_16:.4f}. "
        "Schlick leaves {schlick:.4f}.",
    ),
    Claim(
        id="per-vertex-per-pixel",
        title="Per-vertex and per-pixel can only be told apart side by side",
        claimed="With reasonable tessellation, evaluating per pixel is only insignificantly more "
        "accurate than interpolating between vertices.",
        source=sources.WLOKA,
        where="Rendering with Fresnel's Formula; the text above figure 14",
        domain="from vacuum into water (1.333333); a sphere of flat facets seen along its axis, 16, "
        "32 and 64 latitudes at equal angles from the rim to the middle; the source names no "
        "tessellation",
        figures=tuple(
            Figure(
                f"{way}_{count}",
                f"largest {words}, {count} latitudes",
                f"/errors/mesh?{_WATER}&latitudes={count}",
                value(f"{way}.max_abs"),
            )
            for count in (16, 32, 64)
            for way, words in (
                ("per_vertex", "error per vertex against the sphere"),
                ("per_pixel", "error per pixel on the same facets"),
                ("apart", "difference of the two"),
            )
        ),
        parts=tuple(
            Part(
                says=f"{count} latitudes: within two 8-bit steps of each other",
                figure=f"apart_{count}",
                at_most=2 / 255,
            )
            for count in (16, 32, 64)
        ),
        found="At the rim vertices are {per_vertex_16:.3f} off for 16 latitudes, "
        "{per_vertex_32:.3f} for 32 and {per_vertex_64:.3f} for 64. Most of that is due to the flat "
        "facets, which cost {per_pixel_16:.3f}, {per_pixel_32:.3f} and {per_pixel_64:.3f} per pixel "
        "too; the two ways differ by {apart_16:.4f}, {apart_32:.4f} and {apart_64:.4f}.",
    ),
)
