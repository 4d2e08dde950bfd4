"""Claims about approximations for conductors."""

from app.claims import sources
from app.claims.claim import Claim, Figure, Part
from app.claims.figures import error_of
from app.claims.readings import (
    cosine,
    difference,
    largest,
    modulus,
    most,
    offset,
    share_of_cosines,
    value,
)

_AUTHORS = "n_t=1.5&k_t=5"
_AT_K = "/errors/sweep?model=pharr_humphreys&over=k_t&n_t=1.5"
_AT_BREWSTER = "/snell?n_t=1.5&theta_i_deg=56.309932474020215"
_METALS = "x=n_t&x_minimum=0.1&x_maximum=4&x_steps=40&y=k_t&y_minimum=1.7&y_maximum=8&y_steps=64"


def _of(model: str, metric: str) -> str:
    return f"errors[model={model}].{metric}"


def _errors(interface: str, model: str, *rest: str) -> str:
    return "&".join((f"/errors?{interface}&models={model}", *rest))


CLAIMS = (
    Claim(
        id="conductor-form-k0",
        title="The cheap conductor form is not good at k = 0",
        claimed="Without absorption the air-conductor approximation is not good and should not be "
        "used.",
        source=sources.LAGARDE,
        where="Dielectric-Conductor interface, approximation after Pharr and Humphreys",
        domain="from vacuum into n = 1.5, k = 0, 0 to 90 degrees",
        figures=(
            error_of("largest", "largest error", "n_t=1.5", "pharr_humphreys"),
            error_of(
                "relative",
                "largest error relative to R",
                "n_t=1.5",
                "pharr_humphreys",
                "max_relative",
            ),
            error_of("schlick", "largest error of Schlick there", "n_t=1.5", "schlick"),
        ),
        parts=(
            Part(says="not good: more than 0.05 off", figure="largest", at_least=0.05),
            Part(
                says="not to be used: Schlick is cheaper and closer",
                figure="largest",
                at_least="schlick",
            ),
        ),
        found="{largest:.4f} off, {relative:.0%} of R, where Schlick is {schlick:.4f} off.",
        example="lagarde-conductor-k0",
    ),
    Claim(
        id="conductor-form-great",
        title="The cheap conductor form is great for every other k",
        claimed="For k other than 0 the air-conductor approximation is great.",
        source=sources.LAGARDE,
        where="Dielectric-Conductor interface, approximation after Pharr and Humphreys",
        domain="from vacuum into n = 1.5 with k from 0.1 to 5, 0 to 90 degrees",
        figures=(
            Figure(
                "weak",
                "largest error, k from 0.1 to 1",
                f"{_AT_K}&minimum=0.1&maximum=1&steps=19",
                largest("max_abs", "values"),
            ),
            Figure(
                "strong",
                "largest error, k from 2 to 5",
                f"{_AT_K}&minimum=2&maximum=5&steps=31",
                largest("max_abs", "values"),
            ),
            error_of("half", "largest error at k = 0.5", "n_t=1.5&k_t=0.5", "pharr_humphreys"),
            error_of("one", "largest error at k = 1", "n_t=1.5&k_t=1", "pharr_humphreys"),
        ),
        parts=(
            Part(says="great (within 0.02) from k = 2 on", figure="strong", at_most=0.02),
            Part(says="great (within 0.02) for weaker absorption", figure="weak", at_most=0.02),
        ),
        found="From k = 2 on it is never more than {strong:.4f} off, but {one:.3f} at k = 1, "
        "{half:.3f} at "
        "k = 0.5 and {weak:.3f} at k = 0.1.",
        example="lagarde-conductor-k",
    ),
    Claim(
        id="conductor-form-larger-k",
        title="Pharr's form is more accurate for larger k",
        claimed="The approximate form gets more accurate as k grows.",
        source=sources.DEON,
        where="Additional approximate form",
        domain="from vacuum into n = 1.5, 0 to 90 degrees",
        figures=(
            error_of("k05", "largest error at k = 0.5", "n_t=1.5&k_t=0.5", "pharr_humphreys"),
            error_of("k2", "largest error at k = 2", "n_t=1.5&k_t=2", "pharr_humphreys"),
            error_of("k3", "largest error at k = 3", "n_t=1.5&k_t=3", "pharr_humphreys"),
            error_of("k5", "largest error at k = 5", "n_t=1.5&k_t=5", "pharr_humphreys"),
        ),
        parts=(
            Part(says="better at 2 than at 0.5", figure="k2", at_most="k05"),
            Part(says="better at 3 than at 2", figure="k3", at_most="k2"),
            Part(says="better at 5 than at 3", figure="k5", at_most="k3"),
        ),
        found="{k05:.4f} at k = 0.5, {k2:.4f} at 2, {k3:.4f} at 3, {k5:.4f} at 5: better on the "
        "whole, "
        "though not at every step.",
        example="deon-conductor",
    ),
    Claim(
        id="complex-dielectric",
        title="A complex index in the dielectric formula is a misunderstanding",
        claimed="Putting n + ik into the dielectric formula and taking the modulus is wrong.",
        source=sources.DEON,
        where="Misunderstood form",
        domain="from vacuum into n = 1.5, k = 2, 0 to 90 degrees",
        figures=(
            error_of(
                "wrong",
                "largest error of the misunderstanding",
                "n_t=1.5&k_t=2",
                "complex_dielectric",
            ),
            error_of("schlick", "largest error of Schlick there", "n_t=1.5&k_t=2", "schlick"),
        ),
        parts=(
            Part(says="worse than the cheapest approximation", figure="wrong", at_least="schlick"),
        ),
        found="{wrong:.3f} off, where Schlick's polynomial is {schlick:.3f} off.",
        example="deon-conductor",
    ),
    Claim(
        id="deon-n-i",
        title="Four curves of a conductor, for n_i from 1 to 2",
        claimed="The exact curve, Schlick's, Pharr's and the misunderstood one are drawn over each "
        "other for n_i from 1 to 2.",
        source=sources.DEON,
        where="Conductor Fresnel Reflectance Comparison, the code of the plot",
        domain="from n_i = 1.5 into n = 1.5, k = 2, straight on",
        figures=(
            Figure(
                "own",
                "R of Pharr's form straight on, n_i = 1.5",
                "/curves?n_i=1.5&n_t=1.5&k_t=2&models=pharr_humphreys&samples=2",
                value("curves[model=pharr_humphreys].values.0"),
            ),
            Figure(
                "left_out",
                "R of Pharr's form straight on, n_i left out",
                "/curves?n_i=1&n_t=1.5&k_t=2&models=pharr_humphreys&samples=2",
                value("curves[model=pharr_humphreys].values.0"),
            ),
        ),
        parts=(
            Part(
                says="n_i is in all four: straight on they agree",
                figure="left_out",
                at_least="own",
                at_most="own",
            ),
        ),
        found="Pharr's curve and the misunderstood one are drawn without n_i, as from 1: straight on "
        "{left_out:.4f} where {own:.4f} is right. The four belong together for n_i = 1 alone; here "
        "all curves have it.",
        example="deon-conductor",
    ),
    Claim(
        id="lazanyi-alpha",
        title="alpha = 7.7 for n = 1.5, k = 5",
        claimed="Solving for the angle where Schlick errs most gives the exponent 7.7.",
        source=sources.LAGARDE,
        where="Fresnel Schlick's approximation, metals",
        domain="from vacuum into n = 1.5, k = 5",
        figures=(
            Figure(
                "alpha",
                "exponent that meets the largest error",
                _errors(_AUTHORS, "lazanyi2005"),
                value("errors[model=lazanyi2005].parameters.alpha"),
            ),
            error_of(
                "angle",
                "angle where Schlick errs most",
                _AUTHORS,
                "schlick",
                "max_abs_at_deg",
                unit="deg",
            ),
        ),
        parts=(Part(says="7.7 to the digit printed", figure="alpha", at_least=7.65, at_most=7.75),),
        found="{alpha:.4f}, at {angle:.2f} degrees.",
        example="lagarde-lazanyi",
    ),
    Claim(
        id="lazanyi-dip",
        title="The compensated polynomial follows the dip of metals",
        claimed="For n = 1.5, k = 5 and alpha = 7.7 the compensated form is good.",
        source=sources.LAGARDE,
        where="Fresnel Schlick's approximation, metals, the last plot before total reflection",
        domain="from vacuum into n = 1.5, k = 5, 0 to 90 degrees",
        figures=(
            error_of("schlick", "largest error of Schlick", _AUTHORS, "schlick"),
            error_of(
                "lazanyi",
                "largest error with the compensation",
                _AUTHORS,
                "lazanyi2005",
                given="lazanyi2005.alpha=7.7",
            ),
            error_of(
                "schlick_rms", "root mean square error of Schlick", _AUTHORS, "schlick", "rms"
            ),
            error_of(
                "lazanyi_rms",
                "root mean square error with the compensation",
                _AUTHORS,
                "lazanyi2005",
                "rms",
                given="lazanyi2005.alpha=7.7",
            ),
        ),
        parts=(
            Part(says="good: within 0.05", figure="lazanyi", at_most=0.05),
            Part(says="closer than Schlick", figure="lazanyi", at_most="schlick"),
            Part(
                says="closer than Schlick in the mean", figure="lazanyi_rms", at_most="schlick_rms"
            ),
        ),
        found="The largest error falls from {schlick:.3f} to {lazanyi:.3f}, the root mean square "
        "from "
        "{schlick_rms:.4f} to {lazanyi_rms:.4f}.",
        example="lagarde-lazanyi",
    ),
    Claim(
        id="lazanyi-term",
        title="A rational term follows the error of Schlick",
        claimed="With a = 3 and alpha = 7 the term is a rational approximation of the error between "
        "Fresnel's equation and Schlick's, for n = 1.5 and k = 5.",
        source=sources.LAGARDE,
        where="Fresnel Schlick's approximation, metals, the plot of the error term",
        domain="from vacuum into n = 1.5, k = 5, 0 to 90 degrees",
        figures=(
            error_of("schlick", "largest error that is to be taken away", _AUTHORS, "schlick"),
            error_of(
                "left",
                "largest error that the term leaves",
                _AUTHORS,
                "lazanyi2005",
                given="lazanyi2005.a=3&lazanyi2005.alpha=7",
            ),
        ),
        parts=(
            Part(
                says="an approximation of it: less than 0.02 is left", figure="left", at_most=0.02
            ),
        ),
        found="Of {schlick:.4f} the term leaves {left:.4f}.",
        example="lagarde-error-term",
    ),
    Claim(
        id="dip-perpendicular",
        title="The perpendicular curve has the dip",
        claimed="The dip comes from the perpendicular curve, which of a dielectric crosses the 0 line "
        "at Brewster's angle.",
        source=sources.LAGARDE,
        where="Fresnel Schlick's approximation, metals, the pair of plots of p and s, left",
        domain="n = 1.5 at arctan(1.5)",
        figures=(
            Figure("Rs", "Rs, perpendicular", _AT_BREWSTER, value("Rs")),
            Figure("Rp", "Rp, parallel", _AT_BREWSTER, value("Rp")),
        ),
        parts=(Part(says="the perpendicular one is 0 there", figure="Rs", at_most=1e-12),),
        found="There Rs is {Rs:.3f} and Rp {Rp:.0e}: it is the parallel curve that crosses, as the memo "
        "says of metals two sentences later.",
        example="lagarde-sp-dielectric",
    ),
    Claim(
        id="metal-rp-above-zero",
        title="Of a conductor Rp does not reach zero",
        claimed="The reflectance Rp of a conductor does not reach zero; the angle of its minimum is "
        "called the pseudo-Brewster angle.",
        source=sources.LAGARDE,
        where="Fresnel Schlick's approximation, metals, the pair of plots of p and s, right",
        domain="from vacuum into n = 1.5, k = 5",
        figures=(
            Figure(
                "least",
                "Rp at its least, at 78.82 degrees",
                f"/snell?{_AUTHORS}&theta_i_deg=78.81728966778029",
                value("Rp"),
            ),
        ),
        parts=(Part(says="above zero", figure="least", at_least=0.1),),
        found="At 78.82 degrees {least:.3f} of the p-polarized light are still reflected.",
        example="lagarde-sp-metal",
    ),
    Claim(
        id="lazanyi-minimum",
        title="Metals have the dip between 0.1 and 0.15",
        claimed="For most metals the local minimum of the error term is somewhere between 0.1 and 0.15; "
        "of what, the memo does not say.",
        source=sources.LAGARDE,
        where="Fresnel Schlick's approximation, metals, quoting Lazanyi and Szirmay-Kalos 2005",
        domain="read as a cosine; from vacuum into n from 0.1 to 4 and k from 1.7 to 8, d'Eon's box of "
        "metals",
        figures=(
            Figure(
                "share",
                "share of the box where the cosine is between 0.1 and 0.15",
                f"/errors/map?model=schlick&{_METALS}&metric=max_abs_at_deg",
                share_of_cosines("values[*]", 0.1, 0.15),
            ),
            Figure(
                "example",
                "cosine for n = 1.5, k = 5",
                _errors(_AUTHORS, "schlick"),
                cosine(_of("schlick", "max_abs_at_deg")),
            ),
            Figure(
                "aluminium",
                "cosine for aluminium at 587.6 nm",
                _errors("material=Al", "schlick"),
                cosine(_of("schlick", "max_abs_at_deg")),
            ),
            Figure(
                "gold",
                "cosine for gold at 587.6 nm",
                _errors("material=Au", "schlick"),
                cosine(_of("schlick", "max_abs_at_deg")),
            ),
        ),
        parts=(
            Part(says="most: more than half of the box", figure="share", at_least=0.5),
            Part(says="so for the authors' example", figure="example", at_least=0.1, at_most=0.15),
        ),
        found="So in {share:.0%} of the box. The authors' example has {example:.3f}, aluminium "
        "{aluminium:.3f}, gold {gold:.3f}.",
    ),
    Claim(
        id="dip-negligible",
        title="The dip of metals can be ignored",
        claimed="The visual impact of the dip is negligible, and the compensation not worth its "
        "while.",
        source=sources.LAGARDE,
        where="Fresnel Schlick's approximation, metals, after Lazanyi and Szirmay-Kalos 2005",
        domain="silver, gold, copper, aluminium, chromium and iron at 587.6 nm",
        figures=(
            *(
                error_of(
                    name,
                    f"error of Schlick's albedo, {name}",
                    f"material={symbol}",
                    "schlick",
                    "albedo_error",
                )
                for name, symbol in (
                    ("silver", "Ag"),
                    ("gold", "Au"),
                    ("copper", "Cu"),
                    ("aluminium", "Al"),
                    ("chromium", "Cr"),
                    ("iron", "Fe"),
                )
            ),
            error_of("chromium_largest", "largest error, chromium", "material=Cr", "schlick"),
        ),
        parts=tuple(
            Part(
                says=f"negligible: the albedo of {name} within 0.01",
                figure=name,
                at_least=-0.01,
                at_most=0.01,
            )
            for name in ("silver", "gold", "copper", "aluminium", "chromium", "iron")
        ),
        found="The albedo of silver is {silver:.4f} off, of gold {gold:.4f}, copper {copper:.4f}, "
        "aluminium "
        "{aluminium:.4f}; of chromium {chromium:.3f} and iron {iron:.3f}. Near grazing incidence "
        "chromium is {chromium_largest:.2f} off.",
    ),
    Claim(
        id="f0-not-enough",
        title="F0 does not determine n and k",
        claimed="From F0 alone there is no way back to the right n and k of a metal.",
        source=sources.LAGARDE,
        where="Fresnel Schlick's approximation, specular color",
        domain="from vacuum into n = 1.5, k = 5, against a dielectric of the same F0",
        figures=(
            error_of(
                "apart", "how far a dielectric of the same F0 is off", _AUTHORS, "cook_torrance"
            ),
        ),
        parts=(
            Part(says="indices of one F0 differ at other angles", figure="apart", at_least=0.01),
        ),
        found="A dielectric of the same F0 is {apart:.2f} off at its worst angle.",
    ),
    Claim(
        id="copper-schlick",
        title="Schlick with another F0 per channel does for copper",
        claimed="Copper's curves at 400 to 800 nm look like Schlick's with another F0 for R, G and "
        "B; they "
        "rise with the wavelength.",
        source=sources.SHIRLEY,
        where="figure 2.8, copper at 4000 to 8000 angstroms",
        domain="from vacuum into copper at 400, 500, 600, 700 and 800 nm, 0 to 90 degrees",
        figures=tuple(
            figure
            for nm in (400, 500, 600, 700, 800)
            for figure in (
                error_of(
                    f"error_{nm}",
                    f"largest error of Schlick at {nm} nm",
                    f"material=Cu&wavelength_nm={nm}",
                    "schlick",
                ),
                Figure(
                    f"F0_{nm}",
                    f"F0 at {nm} nm",
                    _errors(f"material=Cu&wavelength_nm={nm}", "schlick"),
                    value("interface.F0"),
                ),
            )
        ),
        parts=(
            *(
                Part(says=f"alike (within 0.05) at {nm} nm", figure=f"error_{nm}", at_most=0.05)
                for nm in (400, 500, 600, 700, 800)
            ),
            *(
                Part(
                    says=f"more at {high} than at {low} nm",
                    figure=f"F0_{high}",
                    at_least=f"F0_{low}",
                )
                for low, high in ((400, 500), (500, 600), (600, 700), (700, 800))
            ),
        ),
        found="F0 rises from {F0_400:.2f} over {F0_600:.2f} to {F0_800:.2f}. Schlick is "
        "{error_400:.3f}, "
        "{error_500:.3f}, {error_600:.3f}, {error_700:.3f} and {error_800:.3f} off.",
    ),
    Claim(
        id="metals-vary",
        title="The index of metals varies a lot with wavelength",
        claimed="That is why some metals, such as gold, are colored, and why one float will not "
        "do.",
        source=sources.SHIRLEY,
        where="two Schlick equations, for dielectrics and for metals",
        domain="F0 of gold and of BK7 glass from 400 to 700 nm",
        figures=(
            Figure(
                "gold_blue",
                "F0 of gold at 400 nm",
                "/errors?material=Au&wavelength_nm=400",
                value("interface.F0"),
            ),
            Figure(
                "gold_red",
                "F0 of gold at 700 nm",
                "/errors?material=Au&wavelength_nm=700",
                value("interface.F0"),
            ),
        ),
        parts=(Part(says="a lot: twice as much", figure="gold_red", at_least=0.6),),
        found="Gold reflects {gold_blue:.0%} at 400 nm and {gold_red:.0%} at 700 nm.",
    ),
    Claim(
        id="f82-meets-exact",
        title="F82-tint meets the exact curve near 82 degrees",
        claimed="The model takes F0 and the reflectance at a cosine of 1/7 and passes through "
        "both.",
        source=sources.KUTZ,
        where="metallic Fresnel",
        domain="k = 3 and n from 0.2 to 4 there; n = 2.9, a grey metal such as chromium, elsewhere",
        figures=(
            Figure(
                "there",
                "largest of 39 errors at arccos(1/7), n from 0.2 to 4",
                "/errors/map?model=f82_tint&x=theta_i_deg&x_minimum=81.786789298261&x_maximum=81.786789298262"
                "&x_steps=2&y=n_t&y_minimum=0.2&y_maximum=4&y_steps=39&k_t=3",
                most("values"),
            ),
            error_of("largest", "largest error between", "n_t=2.9&k_t=3", "f82_tint"),
            error_of("schlick", "largest error of Schlick", "n_t=2.9&k_t=3", "schlick"),
        ),
        parts=(
            Part(says="through the exact value there", figure="there", at_most=1e-12),
            Part(says="close everywhere: within 0.02", figure="largest", at_most=0.02),
        ),
        found="Between them it is at most {largest:.4f} off, where Schlick is {schlick:.3f} off.",
    ),
    Claim(
        id="gulbrandsen-invertible",
        title="Reflectance and edge tint are another way to write n and k",
        claimed="Every n and k with n^2 + k^2 of at least 1 has an r and a g from 0 to 1, and back "
        "again.",
        source=sources.GULBRANDSEN,
        where="equations 3 to 6",
        domain="n = 0.27, k = 2.9, near silver",
        figures=(
            Figure(
                "g",
                "edge tint of n = 0.27, k = 2.9",
                "/convert?from=nk&n_t=0.27&k_t=2.9",
                value("results[form=rg].values.g"),
            ),
            error_of(
                "again",
                "error of the curve after there and back",
                "n_t=0.27&k_t=2.9",
                "gulbrandsen_rg",
            ),
        ),
        parts=(
            Part(says="the tint lies between 0 and 1", figure="g", at_least=0.0, at_most=1.0),
            Part(says="nothing is lost but rounding", figure="again", at_most=1e-12),
        ),
        found="g = {g:.4f}, and the curve comes back within {again:.1e}.",
    ),
    Claim(
        id="deon-benchmark",
        title="d'Eon's benchmark table",
        claimed="Reflectances printed to eight digits, for n and k given and the angle in radians.",
        source=sources.DEON,
        where="Benchmark data, three of 108 cells",
        domain="one radian of incidence; n = 1.4, n = 1.4 + 0.5i and n = 10 + 5i",
        figures=tuple(
            Figure(
                name,
                f"difference from the cell of {words}",
                f"/snell?{media}&theta_i_deg=57.29577951308232",
                offset("R", printed),
            )
            for name, words, media, printed in (
                ("dielectric", "1.4", "n_t=1.4", 0.06118057),
                ("weak", "1.4 + 0.5i", "n_t=1.4&k_t=0.5", 0.12163143),
                ("strong", "10 + 5i", "n_t=10&k_t=5", 0.69690083),
            )
        ),
        parts=tuple(
            Part(says="equal to the eight digits printed", figure=name, at_most=5.001e-9)
            for name in ("dielectric", "weak", "strong")
        ),
        found="All three cells are right to the last digit; a test of ours checks the other 105.",
    ),
    Claim(
        id="dunkle-exact-for-pharr",
        title="Dunkle's albedo is exact for Pharr's form",
        claimed="The closed expressions are approximate for a conductor and exact for the "
        "approximate form.",
        source=sources.DEON,
        where="Hemispherical Albedo, Smooth Conductor, approximation 1",
        domain="n = 1.5, k = 5",
        figures=(
            Figure(
                "apart",
                "difference of the expression and the form's own mean",
                "/albedo?n_t=1.5&k_t=5&models=pharr_humphreys",
                difference(
                    "approximations[id=dunkle_1963].value", "models[model=pharr_humphreys].value"
                ),
            ),
            Figure(
                "error",
                "error against the exact albedo",
                "/albedo?n_t=1.5&k_t=5",
                value("approximations[id=dunkle_1963].error"),
            ),
        ),
        parts=(Part(says="equal but for rounding and quadrature", figure="apart", at_most=1e-10),),
        found="They agree within {apart:.0e}; against the exact albedo {error:.4f} remain.",
    ),
    Claim(
        id="schlick-albedo-exact",
        title="1 - 80 n / (21 (k^2 + (1 + n)^2)) is the albedo of Schlick's curve",
        claimed="The expression is the hemispherical albedo by Schlick's approximation.",
        source=sources.DEON,
        where="Hemispherical Albedo, Smooth Conductor, Schlick approximation",
        domain="n = 1.5, k = 5",
        figures=(
            Figure(
                "apart",
                "difference of the expression and Schlick's mean",
                "/albedo?n_t=1.5&k_t=5&models=schlick",
                difference("approximations[id=schlick_nk].value", "models[model=schlick].value"),
            ),
            Figure(
                "error",
                "largest error against the exact albedo over metals",
                "/albedo/map?fit=schlick_nk&n_minimum=0.1&n_maximum=4&n_steps=2&k_minimum=1.7&k_maximum=8&k_steps=2",
                modulus("largest_in_domain.value"),
            ),
        ),
        parts=(Part(says="equal but for rounding and quadrature", figure="apart", at_most=1e-12),),
        found="They agree within {apart:.0e}; as an albedo of metals it is up to {error:.3f} off.",
    ),
)
