"""Claims about Schlick's polynomial on dielectrics, seen from the thinner side."""

from app.claims import sources
from app.claims.claim import Claim, Figure, Part
from app.claims.readings import apart, largest, quotient, smallest, value

_GLASS = "/errors?n_t=1.5&models=schlick"


def _sweep(low: float, high: float, steps: int) -> str:
    return f"/errors/sweep?model=schlick&over=n_t&minimum={low}&maximum={high}&steps={steps}"


def _of(metric: str) -> str:
    return f"errors[model=schlick].{metric}"


CLAIMS = (
    Claim(
        id="schlick-glass",
        title="Schlick lies close to Fresnel for glass",
        claimed="For n = 1.5 the polynomial and Fresnel's equations look alike on one plot.",
        source=sources.SHIRLEY,
        where="the plot of both at n = 1.5",
        domain="from vacuum into n = 1.5, 0 to 90 degrees",
        figures=(
            Figure("largest", "largest error of R", _GLASS, value(_of("max_abs"))),
            Figure(
                "angle", "angle of the largest error", _GLASS, value(_of("max_abs_at_deg")), "deg"
            ),
            Figure("rms", "root mean square error over the hemisphere", _GLASS, value(_of("rms"))),
            Figure("relative", "largest error relative to R", _GLASS, value(_of("max_relative"))),
        ),
        parts=(
            Part(says="close: within 0.05 of R", figure="largest", at_most=0.05),
            Part(says="close in the mean: within 0.02 rms", figure="rms", at_most=0.02),
        ),
        found="At most {largest:.4f} off, at {angle:.1f} degrees, and {rms:.4f} in the mean "
        "square; "
        "relative to R it is up to {relative:.0%}, where R is small.",
        example="shirley-glass",
    ),
    Claim(
        id="schlick-cheaper",
        title="Schlick is a lot cheaper than Fresnel",
        claimed="The polynomial is a lot easier and cheaper than the exact equations.",
        source=sources.SHIRLEY,
        where="below the plot of both at n = 1.5",
        domain="operations of one evaluation, counted and weighted as the answer says",
        figures=(
            Figure(
                "ratio",
                "weighted operations of the exact form by g and c, over those of Schlick",
                "/recommend?n_t=1.5&max_error=1",
                quotient(
                    "models[model=lagarde_gc].weighted_cost", "models[model=schlick].weighted_cost"
                ),
            ),
        ),
        parts=(Part(says="a lot: at least three times", figure="ratio", at_least=3.0),),
        found="The cheapest way to write the exact equation takes {ratio:.1f} times the "
        "operations.",
    ),
    Claim(
        id="schlick-range",
        title="Schlick is accurate for 1.4 < n < 2.2 alone",
        claimed="Seen from air it is only accurate for 1.4 < n < 2.2; outside, its relative error "
        "grows.",
        source=sources.LAGARDE,
        where="Fresnel Schlick's approximation, after Lazanyi and Szirmay-Kalos 2005",
        domain="from vacuum into n from 1.1 to 4, 0 to 90 degrees",
        figures=(
            Figure(
                "inside",
                "largest relative error, n from 1.4 to 2.2",
                _sweep(1.4, 2.2, 81),
                largest("max_relative", "values"),
            ),
            Figure(
                "inside_abs",
                "largest error, n from 1.4 to 2.2",
                _sweep(1.4, 2.2, 81),
                largest("max_abs", "values"),
            ),
            Figure(
                "below",
                "largest relative error, n from 1.1 to 1.3",
                _sweep(1.1, 1.3, 21),
                largest("max_relative", "values"),
            ),
            Figure(
                "above",
                "largest relative error, n from 3 to 4",
                _sweep(3, 4, 51),
                largest("max_relative", "values"),
            ),
            Figure(
                "best",
                "least relative error over n, n from 1.1 to 4",
                _sweep(1.1, 4, 291),
                smallest("max_relative"),
            ),
        ),
        parts=(
            Part(
                says="accurate: within a tenth of R inside the range", figure="inside", at_most=0.1
            ),
            Part(
                says="the relative error grows below the range", figure="below", at_least="inside"
            ),
            Part(
                says="the relative error grows above the range", figure="above", at_least="inside"
            ),
        ),
        found="Inside the range R is still up to {inside:.0%} off ({inside_abs:.3f} absolute). It "
        "is "
        "worse outside: {below:.0%} below and {above:.0%} above; at best {best:.0%} remain.",
        example="lagarde-range",
    ),
    Claim(
        id="schlick-water-ok",
        title="Water at 1.33 is still fine for Schlick",
        claimed="Though outside the accurate range, water at n = 1.33 is still ok.",
        source=sources.LAGARDE,
        where="Fresnel Schlick's approximation",
        domain="from vacuum into n = 1.33, against n from 1.4 to 2.2",
        figures=(
            Figure(
                "water",
                "largest relative error for water",
                "/errors?n_t=1.33&models=schlick",
                value(_of("max_relative")),
            ),
            Figure(
                "water_abs",
                "largest error for water",
                "/errors?n_t=1.33&models=schlick",
                value(_of("max_abs")),
            ),
            Figure(
                "inside",
                "largest relative error, n from 1.4 to 2.2",
                _sweep(1.4, 2.2, 81),
                largest("max_relative", "values"),
            ),
        ),
        parts=(Part(says="no worse than inside the range", figure="water", at_most="inside"),),
        found="{water:.1%} relative and {water_abs:.3f} absolute: relative to R no worse than the "
        "{inside:.1%} inside the range.",
        example="lagarde-range",
    ),
    Claim(
        id="schlick-below-polarization",
        title="Schlick costs less than leaving out polarization",
        claimed="The polynomial introduces less error than treating all light as unpolarized does.",
        source=sources.WLOKA,
        where="equation 10 and figure 4, water and diamond",
        domain="from vacuum into water (1.333333) and diamond (2.417), 0 to 90 degrees",
        figures=tuple(
            figure
            for name, n in (("water", 1.333333), ("diamond", 2.417))
            for figure in (
                Figure(
                    name,
                    f"largest error of Schlick, {name}",
                    f"/errors?n_t={n}&models=schlick",
                    value(_of("max_abs")),
                ),
                Figure(
                    f"{name}_split",
                    f"largest |Rs - R|, {name}",
                    f"/curves?n_t={n}&models=exact&samples=1801",
                    apart("curves[quantity=Rs].values", "curves[quantity=R].values"),
                ),
            )
        ),
        parts=(
            Part(says="less for water", figure="water", at_most="water_split"),
            Part(says="less for diamond", figure="diamond", at_most="diamond_split"),
        ),
        found="Schlick is {water:.3f} off for water and {diamond:.3f} for diamond; s-polarized "
        "light "
        "differs from the mean by {water_split:.3f} and {diamond_split:.3f}.",
        example="wloka-water-diamond",
    ),
    Claim(
        id="one-minus-cos",
        title="1 - cos is visually unacceptable",
        claimed="Approximating reflection by 1 - cos(theta) is visually unacceptable.",
        source=sources.WLOKA,
        where="Results, figures 4 and 15",
        domain="from vacuum into water (1.333333) and diamond (2.417), 0 to 90 degrees",
        figures=(
            *(
                Figure(
                    name,
                    f"largest error of 1 - cos, {name}",
                    f"/errors?n_t={n}&models=one_minus_cos",
                    value("errors[model=one_minus_cos].max_abs"),
                )
                for name, n in (("water", 1.333333), ("diamond", 2.417))
            ),
            Figure(
                "bright",
                "error of the albedo, water",
                "/errors?n_t=1.333333&models=one_minus_cos",
                value("errors[model=one_minus_cos].albedo_error"),
            ),
        ),
        parts=(
            Part(
                says="unacceptable for water: more than a tenth of white",
                figure="water",
                at_least=0.1,
            ),
            Part(
                says="unacceptable for diamond: more than a tenth of white",
                figure="diamond",
                at_least=0.1,
            ),
        ),
        found="{water:.2f} off for water, {diamond:.2f} for diamond; a lake under an even sky "
        "becomes "
        "{bright:.2f} too bright.",
        example="wloka-water-diamond",
    ),
    Claim(
        id="polynomial-like-texture",
        title="Polynomial and texture look alike",
        claimed="Comparing the shader that evaluates the polynomial with the one that reads a "
        "texture of "
        "the exact curve shows little difference.",
        source=sources.WLOKA,
        where="Per-Pixel",
        domain="from vacuum into water (1.333333), 0 to 90 degrees",
        figures=(
            Figure(
                "apart",
                "largest difference of the two",
                "/curves?n_t=1.333333&models=schlick,lut_1d&samples=1801",
                apart("curves[model=schlick].values", "curves[model=lut_1d].values"),
            ),
            Figure(
                "rms",
                "root mean square error of the polynomial",
                "/errors?n_t=1.333333&models=schlick",
                value(_of("rms")),
            ),
        ),
        parts=(
            Part(says="little in the mean: within 0.03", figure="rms", at_most=0.03),
            Part(says="little everywhere: within two 8-bit steps", figure="apart", at_most=2 / 255),
        ),
        found="{rms:.3f} in the mean, but {apart:.3f} near grazing incidence, many steps of an "
        "8-bit "
        "picture of a bright sky.",
    ),
    Claim(
        id="spherical-gaussian-imperceptible",
        title="The spherical Gaussian cannot be told from Schlick",
        claimed="A spherical Gaussian in place of the fifth power is cheaper and the difference is "
        "imperceptible.",
        source=sources.KARIS,
        where="Specular F, with the constants -5.55473 and -6.98316",
        domain="from vacuum into n = 1.5, where 1 - F0 is the scale of the difference; 0 to 90 "
        "degrees",
        figures=(
            Figure(
                "apart",
                "largest difference of the two",
                "/curves?n_t=1.5&models=schlick,spherical_gaussian&samples=1801",
                apart("curves[model=schlick].values", "curves[model=spherical_gaussian].values"),
            ),
            Figure(
                "cost",
                "weighted operations of the Gaussian over those of the power by multiplications",
                "/recommend?n_t=1.5&max_error=1",
                quotient(
                    "models[model=spherical_gaussian].weighted_cost",
                    "models[model=schlick].weighted_cost",
                ),
            ),
        ),
        parts=(
            Part(says="imperceptible: within an 8-bit step", figure="apart", at_most=1 / 255),
            Part(says="cheaper than four multiplications", figure="cost", at_most=1.0),
        ),
        found="They differ by up to {apart:.4f}, {cost:.1f} times the operations of a power that "
        "is "
        "written as multiplications.",
    ),
    Claim(
        id="schlick-forms-agree",
        title="Both forms of Schlick are the same",
        claimed="The form by F0 and the one by the indices are exactly the same.",
        source=sources.LAGARDE,
        where="the other form of the Schlick approximation; equation of Lazanyi and Szirmay-Kalos",
        domain="n = 1.5 with k = 0 and k = 5, 0 to 90 degrees",
        figures=tuple(
            Figure(
                name,
                f"largest difference at 1801 angles, {name}",
                f"/curves?n_t=1.5&k_t={k}&models=schlick,schlick_ior&samples=1801",
                apart("curves[model=schlick].values", "curves[model=schlick_ior].values"),
            )
            for name, k in (("dielectric", 0), ("conductor", 5))
        ),
        parts=(
            Part(says="the same but for rounding", figure="dielectric", at_most=1e-15),
            Part(says="the same but for rounding, with k", figure="conductor", at_most=1e-15),
        ),
        found="They agree to the last digits of double precision.",
    ),
    Claim(
        id="schlick-error-of-n",
        title="Where Schlick is best",
        claimed="The accurate range still covers most materials that are used in games.",
        source=sources.LAGARDE,
        where="Fresnel Schlick's approximation",
        domain="from vacuum into n from 1.3 to 2.2, 0 to 90 degrees",
        figures=(
            Figure(
                "worst",
                "largest error over the range",
                _sweep(1.3, 2.2, 181),
                largest("max_abs", "values"),
            ),
            Figure(
                "best", "least of the largest errors", _sweep(1.3, 2.2, 181), smallest("max_abs")
            ),
            Figure(
                "albedo",
                "largest error of the albedo",
                _sweep(1.3, 2.2, 181),
                largest("albedo_error", "values"),
            ),
        ),
        parts=(
            Part(says="within 0.07 of R", figure="worst", at_most=0.07),
            Part(says="the albedo within 0.02", figure="albedo", at_most=0.02),
        ),
        found="At most {worst:.3f} off anywhere from ice to zircon, {best:.3f} at the best index; "
        "the "
        "albedo by {albedo:.3f}.",
    ),
)
