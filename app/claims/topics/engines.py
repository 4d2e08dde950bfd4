"""Claims and conventions of popular renderers, and the traps beside them."""

from app.claims import sources
from app.claims.claim import Claim, Figure, Part
from app.claims.figures import error_of
from app.claims.readings import share_at_most, value


def _converted(name: str, says: str, query: str, form: str, number: str) -> Figure:
    return Figure(name, says, f"/convert?{query}", value(f"results[form={form}].values.{number}"))


CLAIMS = (
    Claim(
        id="four-percent",
        title="4 % for everything",
        claimed="A fixed index of 1.5, F0 = 0.04, is a good compromise for most dielectrics.",
        source=sources.GLTF,
        where="Appendix B, dielectrics; the default of Unreal Engine, Disney's model and others "
        "alike",
        domain="from vacuum into water (1.333), ice (1.31), sapphire (1.77) and diamond (2.417)",
        figures=(
            error_of(
                "ice", "largest error with F0 = 0.04, ice", "n_t=1.31", "schlick_four_percent"
            ),
            error_of(
                "water", "largest error with F0 = 0.04, water", "n_t=1.333", "schlick_four_percent"
            ),
            error_of("water_own", "largest error with water's own F0", "n_t=1.333", "schlick"),
            error_of(
                "sapphire",
                "largest error with F0 = 0.04, sapphire",
                "n_t=1.77",
                "schlick_four_percent",
            ),
            error_of(
                "diamond",
                "largest error with F0 = 0.04, diamond",
                "n_t=2.417",
                "schlick_four_percent",
            ),
            Figure("F0", "F0 of water", "/errors?n_t=1.333", value("interface.F0")),
        ),
        parts=(
            Part(says="good (within 0.07) for ice", figure="ice", at_most=0.07),
            Part(says="good (within 0.07) for water", figure="water", at_most=0.07),
            Part(says="good (within 0.07) for sapphire", figure="sapphire", at_most=0.07),
            Part(says="good (within 0.07) for diamond", figure="diamond", at_most=0.07),
        ),
        found="{ice:.3f} off for ice, {water:.3f} for water ({water_own:.3f} with its own F0, "
        "which is {F0:.3f}), "
        "{sapphire:.3f} for sapphire and {diamond:.3f} for diamond.",
    ),
    Claim(
        id="four-percent-is-1-5",
        title="F0 = 0.04 is n = 1.5",
        claimed="The default of 4 % stands for an index of 1.5.",
        source=sources.GLTF,
        where="Appendix B, dielectrics",
        domain="normal incidence from vacuum",
        figures=(_converted("F0", "F0 of n = 1.5", "from=ior&n_t=1.5", "f0", "F0"),),
        parts=(
            Part(
                says="0.04 but for rounding",
                figure="F0",
                at_least=0.04 - 1e-15,
                at_most=0.04 + 1e-15,
            ),
        ),
        found="{F0:.12g}.",
    ),
    Claim(
        id="specular-008",
        title="0.08 specular is an index of 1.8",
        claimed="The parameter from 0 to 1 is F0 from 0 to 0.08, an index from 1.0 to 1.8, with "
        "1.5 in the middle.",
        source=sources.BURLEY,
        where="section 5.5, Specular F details; Unreal Engine and glTF exporters alike",
        domain="normal incidence from vacuum",
        figures=(
            _converted("top", "index of specular = 1", "from=specular&specular=1", "ior", "n_t"),
            _converted(
                "middle", "index of specular = 0.5", "from=specular&specular=0.5", "ior", "n_t"
            ),
        ),
        parts=(
            Part(says="1.8 at the top", figure="top", at_least=1.75, at_most=1.85),
            Part(
                says="1.5 in the middle", figure="middle", at_least=1.5 - 1e-12, at_most=1.5 + 1e-12
            ),
        ),
        found="{top:.6f} at the top, {middle:.6g} in the middle.",
    ),
    Claim(
        id="specular-008-covers",
        title="0.08 covers the most common materials",
        claimed="F0 up to 0.08 encompasses most common materials.",
        source=sources.BURLEY,
        where="section 5.5, Specular F details",
        domain="the transparent presets of this server, by their index at 587.6 nm",
        figures=tuple(
            Figure(
                category,
                f"share of our presets with n up to 1.788, {words}",
                f"/materials?category={category}&fields=id,n",
                share_at_most("materials[*].n", 1.7887885),
            )
            for category, words in (
                ("liquid", "liquids"),
                ("polymer", "polymers"),
                ("glass", "glasses"),
                ("crystal", "crystals"),
            )
        ),
        parts=(
            Part(says="most (over nine tenths) of the liquids", figure="liquid", at_least=0.9),
            Part(says="most of the polymers", figure="polymer", at_least=0.9),
            Part(says="most of the glasses", figure="glass", at_least=0.9),
            Part(says="most of the crystals", figure="crystal", at_least=0.9),
        ),
        found="{liquid:.0%} of the liquids, {polymer:.0%} of the polymers, {glass:.0%} of the "
        "glasses and "
        "{crystal:.0%} of the crystals, among which are the gems.",
    ),
    Claim(
        id="filament-reflectance",
        title="Filament's reflectance spans dielectrics and gems",
        claimed="F0 = 0.16 reflectance^2 gives 4 % in the middle and reaches the gemstones, 8 to "
        "16 %.",
        source=sources.FILAMENT,
        where="section 4.8.3, Remapping, dielectrics",
        domain="normal incidence from vacuum; sapphire 1.77, diamond 2.417",
        figures=(
            _converted(
                "middle", "F0 of reflectance = 0.5", "from=reflectance&reflectance=0.5", "f0", "F0"
            ),
            _converted(
                "top", "F0 of reflectance = 1", "from=reflectance&reflectance=1", "f0", "F0"
            ),
            _converted("sapphire", "F0 of sapphire", "from=ior&n_t=1.77", "f0", "F0"),
            _converted("diamond", "F0 of diamond", "from=ior&n_t=2.417", "f0", "F0"),
        ),
        parts=(
            Part(
                says="4 % in the middle",
                figure="middle",
                at_least=0.04 - 1e-12,
                at_most=0.04 + 1e-12,
            ),
            Part(says="16 % at the top", figure="top", at_least=0.16 - 1e-12, at_most=0.16 + 1e-12),
            Part(says="reaches sapphire", figure="sapphire", at_most="top"),
            Part(says="reaches diamond", figure="diamond", at_most="top"),
        ),
        found="{middle:.3g} in the middle and {top:.3g} at the top: sapphire has {sapphire:.3f}, "
        "but diamond "
        "{diamond:.3f}.",
    ),
    Claim(
        id="nothing-below-two-percent",
        title="Nothing reflects less than 2 %",
        claimed="Anything below 2 % is physically impossible and counts as shadowing: F90 = min(50 "
        "F0, 1).",
        source=sources.UNREAL,
        where="comment at F_Schlick; Frostbite 2014 alike",
        domain="F0 from vacuum; n = 1.31 for ice, 1.1 for an aerogel or a boundary of two liquids",
        figures=(
            Figure("water", "F0 of water, 1.333", "/errors?n_t=1.333", value("interface.F0")),
            Figure("ice", "F0 of ice, 1.31", "/errors?n_t=1.31", value("interface.F0")),
            Figure(
                "immersed",
                "F0 of glass seen in water",
                "/errors?n_i=1.333&n_t=1.52",
                value("interface.F0"),
            ),
            error_of("ice_error", "largest error of that F90, ice", "n_t=1.31", "schlick_f90_50"),
            error_of(
                "thin_error", "largest error of that F90, n = 1.1", "n_t=1.1", "schlick_f90_50"
            ),
        ),
        parts=(
            Part(says="water has 2 % at least", figure="water", at_least=0.02),
            Part(says="ice has 2 % at least", figure="ice", at_least=0.02),
            Part(says="glass under water has 2 % at least", figure="immersed", at_least=0.02),
        ),
        found="Water has {water:.4f}, but ice {ice:.4f}, and glass under water {immersed:.4f}. The "
        "rule takes "
        "{ice_error:.2f} of the reflection from ice at grazing incidence, and at n = 1.1 "
        "{thin_error:.2f}.",
    ),
    Claim(
        id="f0-is-linear",
        title="F0 taken from a picture needs its gamma undone",
        claimed="R0 can be read off a picture, but be careful about gamma.",
        source=sources.SHIRLEY,
        where="two Schlick equations, for metals",
        domain="F0 of n = 1.5 and of n = 0.27, k = 2.9, put in without decoding, 0 to 90 degrees",
        figures=(
            error_of(
                "glass", "largest error with F0 taken as sRGB, glass", "n_t=1.5", "schlick_f0_srgb"
            ),
            error_of(
                "metal",
                "largest error with F0 taken as sRGB, metal",
                "n_t=0.27&k_t=2.9",
                "schlick_f0_srgb",
            ),
            error_of("glass_right", "largest error of Schlick, glass", "n_t=1.5", "schlick"),
        ),
        parts=(
            Part(says="the wrong one is worse for glass", figure="glass", at_least="glass_right"),
            Part(says="and more than 0.05 for the metal", figure="metal", at_least=0.05),
        ),
        found="Glass becomes {glass:.2f} too bright, the metal {metal:.2f}; done right, Schlick is "
        "{glass_right:.3f} off.",
    ),
    Claim(
        id="wrong-angle-in-glass",
        title="Inside glass Schlick needs the other angle",
        claimed="From the denser side take the cosine of the transmitted angle.",
        source=sources.LAGARDE,
        where="FresnelSchlickTIR",
        domain="from n = 1.5 into vacuum, 0 to 90 degrees",
        figures=(
            error_of(
                "wrong",
                "largest error with the angle inside",
                "n_i=1.5&n_t=1",
                "schlick_wrong_angle",
            ),
            error_of(
                "right", "largest error with the transmitted angle", "n_i=1.5&n_t=1", "schlick_tir"
            ),
        ),
        parts=(
            Part(says="the wrong angle misses most of the light", figure="wrong", at_least=0.5),
            Part(says="the right one is within 0.05", figure="right", at_most=0.05),
        ),
        found="{wrong:.3f} off with the angle inside, {right:.4f} with the transmitted one.",
    ),
    Claim(
        id="when-in-doubt",
        title="When in doubt, 1.5",
        claimed="Take n = 1.5 for glass and coats whose index is not known.",
        source=sources.SHIRLEY,
        where="the table of indices; glossy paint",
        domain="normal incidence from vacuum; our presets of glasses, polymers and liquids",
        figures=tuple(
            Figure(
                name,
                f"F0 of {words}",
                f"/errors?material={material}",
                value("interface.F0"),
            )
            for name, words, material in (
                ("silica", "fused silica", "fused-silica"),
                ("bk7", "BK7", "BK7"),
                ("acrylic", "acrylic", "PMMA"),
                ("polycarbonate", "polycarbonate", "polycarbonate"),
                ("flint", "dense flint SF11", "SF11"),
            )
        ),
        parts=(
            *(
                Part(says=f"{words} within 0.01 of 4 %", figure=name, at_least=0.03, at_most=0.05)
                for name, words in (
                    ("silica", "fused silica"),
                    ("bk7", "BK7"),
                    ("acrylic", "acrylic"),
                )
            ),
            Part(
                says="polycarbonate within 0.015 of 4 %",
                figure="polycarbonate",
                at_least=0.025,
                at_most=0.055,
            ),
            Part(
                says="dense flint within 0.015 of 4 %",
                figure="flint",
                at_least=0.025,
                at_most=0.055,
            ),
        ),
        found="Fused silica has {silica:.4f}, BK7 {bk7:.4f}, acrylic {acrylic:.4f}, polycarbonate "
        "{polycarbonate:.4f}; dense flint {flint:.4f}.",
    ),
)
