"""Claims about Fresnel's equations themselves: energy, polarization, total reflection, forms."""

from app.claims import sources
from app.claims.claim import Claim, Figure, Part
from app.claims.figures import error_of
from app.claims.readings import apart, spread, unity, value

_FORMS = {
    "lagarde_conductor": "Lagarde's conductor shader",
    "lagarde_dielectric": "Lagarde's dielectric shader",
    "lagarde_gc": "Lagarde's g, c shader",
    "wloka_gc": "Wloka's equation 9",
    "deon_gc": "d'Eon's evalF",
    "deon_pq": "d'Eon's p, q",
    "shirley_ab": "Shirley's a, b at k = 0",
}


CLAIMS = (
    Claim(
        id="adds-to-one",
        title="What is reflected and what is transmitted add to one",
        claimed="The fractions reflected and transmitted add to one, tracing the light in either "
        "direction.",
        source=sources.SHIRLEY,
        where="the picture of 23 % and 77 %",
        domain="between vacuum and n = 1.333, both ways, 0 to 90 degrees",
        figures=tuple(
            Figure(
                name,
                f"largest |R + T - 1| of 1801 angles, {words}",
                f"/curves?n_i={n_i}&n_t={n_t}&models=exact&samples=1801",
                unity("curves[quantity=R].values", "curves[quantity=T].values"),
            )
            for name, words, n_i, n_t in (
                ("into", "into water", 1, 1.333),
                ("out", "out of it", 1.333, 1),
            )
        ),
        parts=(
            Part(says="one but for rounding, into water", figure="into", at_most=1e-15),
            Part(says="one but for rounding, out of it", figure="out", at_most=1e-15),
        ),
        found="They do, to the last digits of double precision.",
    ),
    Claim(
        id="same-both-ways",
        title="Light takes the same share both ways",
        claimed="As the expressions are squared, the two media can be swapped.",
        source=sources.LAGARDE,
        where="Fresnel equation basis",
        domain="60 degrees from vacuum into n = 1.5, and the refracted ray's way back",
        figures=(
            Figure(
                "outside",
                "R from outside, to 12 digits",
                "/snell?n_t=1.5&theta_i_deg=60&digits=12",
                value("R"),
            ),
            Figure(
                "inside",
                "R from inside, to 12 digits",
                "/snell?n_i=1.5&n_t=1&theta_i_deg=35.26438968275465&digits=12",
                value("R"),
            ),
            Figure(
                "same_angle",
                "R from inside at 60 degrees",
                "/snell?n_i=1.5&n_t=1&theta_i_deg=60",
                value("R"),
            ),
        ),
        parts=(
            Part(
                says="the same to 12 digits", figure="inside", at_least="outside", at_most="outside"
            ),
        ),
        found="Along one ray R is {inside:.12g} both ways. At one and the same angle it is not: "
        "from inside "
        "60 degrees is beyond the critical angle, R = {same_angle:.0f}.",
    ),
    Claim(
        id="brewster-zero",
        title="Rp goes to zero at Brewster's angle",
        claimed="For one angle, p-polarized light is not reflected at all.",
        source=sources.SHIRLEY,
        where="Brewster's angle",
        domain="n = 1.5 at arctan(1.5), and n = 1.5 + 5i where Rp is least",
        figures=(
            Figure(
                "Rp",
                "Rp at arctan(1.5), n = 1.5",
                "/snell?n_t=1.5&theta_i_deg=56.309932474020215",
                value("Rp"),
            ),
            Figure(
                "metal",
                "Rp at its least for n = 1.5, k = 5",
                "/snell?n_t=1.5&k_t=5&theta_i_deg=78.81728966778029",
                value("Rp"),
            ),
        ),
        parts=(Part(says="zero but for rounding of the angle", figure="Rp", at_most=1e-30),),
        found="Rp = {Rp:.0e} for glass; of a conductor {metal:.2f} remain at the angle of least "
        "Rp.",
    ),
    Claim(
        id="schlick-knows-no-tir",
        title="Schlick does not handle total internal reflection",
        claimed="From the denser side the polynomial misses total reflection.",
        source=sources.LAGARDE,
        where="FresnelSchlickTIR",
        domain="from n = 1.33 into vacuum, 0 to 90 degrees",
        figures=(
            error_of("largest", "largest error of Schlick", "n_i=1.33&n_t=1", "schlick"),
            Figure(
                "critical",
                "critical angle",
                "/errors?n_i=1.33&n_t=1",
                value("interface.critical_deg"),
                "deg",
            ),
        ),
        parts=(
            Part(says="misses it: more than half of the light", figure="largest", at_least=0.5),
        ),
        found="At the critical angle, {critical:.2f} degrees, it is {largest:.3f} off.",
        example="lagarde-water-air",
    ),
    Claim(
        id="schlick-tir-fixes-it",
        title="The transmitted angle repairs Schlick in water",
        claimed="That Schlick misses total reflection can be fixed by the cosine of the transmitted "
        "angle.",
        source=sources.LAGARDE,
        where="FresnelSchlickTIR; the words beside its plot say of the exact curve and of plain Schlick "
        "that they almost merge, which is true of the repaired one",
        domain="from n = 1.33 into vacuum, 0 to 90 degrees",
        figures=(
            error_of("largest", "largest error", "n_i=1.33&n_t=1", "schlick_tir"),
            error_of("rms", "root mean square error", "n_i=1.33&n_t=1", "schlick_tir", "rms"),
            error_of("outside", "largest error of Schlick from outside", "n_t=1.33", "schlick"),
        ),
        parts=(
            Part(says="fixed in the mean: within 0.01", figure="rms", at_most=0.01),
            Part(
                says="fixed everywhere: within 0.06, as from outside",
                figure="largest",
                at_most=0.06,
            ),
        ),
        found="{rms:.4f} in the mean; just below the critical angle {largest:.3f} off, exactly "
        "what "
        "Schlick is off from outside ({outside:.3f}).",
        example="lagarde-water-air",
    ),
    Claim(
        id="polarization-small",
        title="Leaving out polarization has a small effect",
        claimed="Light is polarized in general, but the effect on Fresnel's formula is small.",
        source=sources.WLOKA,
        where="Rendering with Fresnel's Formula",
        domain="from vacuum into water (1.333333), glass (1.52) and diamond (2.417), 0 to 90 "
        "degrees",
        figures=tuple(
            Figure(
                name,
                f"largest |Rs - R|, {name}",
                f"/curves?n_t={n}&models=exact&samples=1801",
                apart("curves[quantity=Rs].values", "curves[quantity=R].values"),
            )
            for name, n in (("water", 1.333333), ("glass", 1.52), ("diamond", 2.417))
        ),
        parts=tuple(
            Part(says=f"small for {name}: within 0.05", figure=name, at_most=0.05)
            for name in ("water", "glass", "diamond")
        ),
        found="Polarized light differs by up to {water:.2f} for water, {glass:.2f} for glass and "
        "{diamond:.2f} for diamond: more than most approximations cost.",
    ),
    Claim(
        id="one-wavelength",
        title="One wavelength is enough",
        claimed="Reflected light has many wavelengths, but the effect on Fresnel's formula is "
        "small.",
        source=sources.WLOKA,
        where="Rendering with Fresnel's Formula",
        domain="F0 of water, BK7 glass, diamond and gold from 400 to 700 nm",
        figures=tuple(
            Figure(
                name,
                f"how much F0 varies, {name}",
                f"/materials/{material}/spectrum?minimum_nm=400&maximum_nm=700&step_nm=5",
                spread("F0"),
            )
            for name, material in (
                ("water", "water"),
                ("glass", "BK7"),
                ("diamond", "diamond"),
                ("gold", "Au"),
            )
        ),
        parts=tuple(
            Part(says=f"small for {name}: within 0.01", figure=name, at_most=0.01)
            for name in ("water", "glass", "diamond")
        ),
        found="F0 varies by {water:.4f} for water, {glass:.4f} for glass and {diamond:.4f} for "
        "diamond; for "
        "gold, of which the source does not speak, by {gold:.2f}.",
    ),
    Claim(
        id="air-is-vacuum",
        title="Air can count as vacuum",
        claimed="The index of air is 1.000293 and is taken as 1, which simplifies much.",
        source=sources.LAGARDE,
        where="Fresnel equation basis",
        domain="F0 of n = 1.5 from air and from vacuum",
        figures=(
            Figure("air", "F0 from air", "/errors?n_i=1.000293&n_t=1.5", value("interface.F0")),
            Figure("vacuum", "F0 from vacuum", "/errors?n_t=1.5", value("interface.F0")),
        ),
        parts=(Part(says="the same within 1e-4", figure="air", at_least=0.0399, at_most=0.0401),),
        found="{air:.6f} from air, {vacuum:.6f} from vacuum.",
    ),
    Claim(
        id="index-from-F0",
        title="The index of a dielectric follows from F0",
        claimed="n = (1 + sqrt F0) / (1 - sqrt F0).",
        source=sources.LAGARDE,
        where="Fresnel Schlick's approximation, specular color",
        domain="F0 = 0.04",
        figures=(
            Figure(
                "n",
                "index of F0 = 0.04",
                "/convert?from=f0&F0=0.04",
                value("results[form=ior].values.n_t"),
            ),
        ),
        parts=(
            Part(
                says="1.5 but for rounding", figure="n", at_least=1.5 - 1e-12, at_most=1.5 + 1e-12
            ),
        ),
        found="{n:.12g}.",
    ),
    Claim(
        id="forms-agree",
        title="All the ways to write Fresnel's equations are equal",
        claimed="The form by g and c is equivalent to the one by a and b without absorption, which is "
        "derived from Fresnel's equations.",
        source=sources.LAGARDE,
        where="Fresnel Equation in practice; those of Wloka, Shirley and d'Eon are measured beside it",
        domain="from vacuum into n = 1.5, 0 to 90 degrees, in double precision",
        figures=(
            *(
                error_of(model, f"largest difference of {words}", "n_t=1.5", model)
                for model, words in _FORMS.items()
            ),
        ),
        parts=tuple(
            Part(says=f"{words}: equal but for rounding", figure=model, at_most=1e-13)
            for model, words in _FORMS.items()
        ),
        found="All agree within rounding, the largest difference being {shirley_ab:.0e} for Shirley's.",
    ),
    Claim(
        id="denser-reflects-more",
        title="A family of curves over the index",
        claimed="A family of curves for various indices of refraction, which the text does not name.",
        source=sources.WLOKA,
        where="figure 3",
        domain="from vacuum into ice, crown glass, diamond and gallium phosphide of the table in his "
        "appendix (1.31, 1.52, 2.417 and 3.5), which are our choice, at 0 and at 85 degrees",
        figures=tuple(
            Figure(
                f"{name}_{deg}",
                f"R of {name} at {deg} degrees",
                f"/snell?n_t={n}&theta_i_deg={deg}",
                value("R"),
            )
            for deg in (0, 85)
            for name, n in (("ice", 1.31), ("glass", 1.52), ("diamond", 2.417), ("phosphide", 3.5))
        ),
        parts=(),
        found="{ice_0:.3f}, {glass_0:.3f}, {diamond_0:.3f} and {phosphide_0:.3f} at normal "
        "incidence; at 85 "
        "degrees the curves have crossed: {diamond_85:.3f} for diamond, {phosphide_85:.3f} for "
        "gallium phosphide.",
        example="wloka-family",
    ),
    Claim(
        id="water-23-percent",
        title="Water reflects 23 % at some angle",
        claimed="At the angle drawn, 23 % are reflected and 77 % come from below.",
        source=sources.SHIRLEY,
        where="the picture of 23 % and 77 %",
        domain="from vacuum into n = 1.333; the picture names no angle",
        figures=(
            Figure("at_75", "R at 75 degrees", "/snell?n_t=1.333&theta_i_deg=75", value("R")),
            Figure("at_76", "R at 76 degrees", "/snell?n_t=1.333&theta_i_deg=76", value("R")),
        ),
        parts=(
            Part(says="not yet 23 % at 75 degrees", figure="at_75", at_most=0.23),
            Part(says="23 % at 76 degrees", figure="at_76", at_least=0.23),
        ),
        found="{at_75:.1%} at 75 degrees and {at_76:.1%} at 76: the ray drawn is 14 degrees above "
        "the water.",
    ),
)
