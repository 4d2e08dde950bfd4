"""Claims about tables of the exact curve: textures, and vertices a mesh interpolates between."""

from app.claims import sources
from app.claims.claim import Claim, Figure, Part
from app.claims.readings import value

_WATER = "n_t=1.333333"


def _table(name: str, says: str, size: int, bits: int = 32, metric: str = "max_abs") -> Figure:
    return Figure(
        name,
        says,
        f"/errors?{_WATER}&models=lut_1d&lut_1d.size={size}&lut_1d.bits={bits}",
        value(f"errors[model=lut_1d].{metric}"),
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
        claimed="With reasonable tessellation, evaluating per pixel is insignificantly more "
        "accurate than "
        "interpolating between vertices.",
        source=sources.WLOKA,
        where="Rendering with Fresnel's Formula; Results",
        domain="from vacuum into water (1.333333); R interpolated linearly in the cosine between "
        "vertices, "
        "8, 16, 32 and 64 of them from grazing to normal incidence",
        figures=(
            *(
                _table(f"vertices_{count}", f"largest error, {count} vertices", count)
                for count in (8, 16, 32, 64)
            ),
            _table("rms_16", "root mean square error, 16 vertices", 16, metric="rms"),
        ),
        parts=(
            Part(
                says="16 vertices: within an 8-bit step in the mean",
                figure="rms_16",
                at_most=1.5 / 255,
            ),
            Part(
                says="16 vertices: within two 8-bit steps everywhere",
                figure="vertices_16",
                at_most=2 / 255,
            ),
            Part(
                says="32 vertices: within two 8-bit steps everywhere",
                figure="vertices_32",
                at_most=2 / 255,
            ),
        ),
        found="16 vertices across the visible half leave {vertices_16:.4f} near the rim and "
        "{rms_16:.4f} in the "
        "mean, 32 leave {vertices_32:.4f}, 64 leave {vertices_64:.4f}, 8 leave {vertices_8:.3f}.",
    ),
)
