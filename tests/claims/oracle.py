"""The answers that claims are measured by, a second time: textbook formulas on dense grids.

Nothing of `app.optics` is used but the formulas of d'Eon's and Kulla's longest fits. Indices of
materials come from the catalog, which tests/materials holds against another package; everything
computed from them is computed here.
"""

from collections.abc import Callable
from functools import cache, partial
from itertools import pairwise
from typing import Any
from urllib.parse import parse_qsl, urlsplit

import numpy as np
from numpy.typing import NDArray

from app.materials.catalog import load_catalog
from app.optics.albedo import find_fit
from app.optics.interface import Interface

Array = NDArray[np.float64]
Medium = tuple[float, complex]

# Crowded at both ends: errors are largest near grazing incidence.
THETA = np.pi / 4.0 * (1.0 - np.cos(np.linspace(0.0, np.pi, 40_001)))
FORMS = (
    "lagarde_conductor",
    "lagarde_dielectric",
    "lagarde_gc",
    "wloka_gc",
    "deon_gc",
    "deon_pq",
    "shirley_ab",
    "gulbrandsen_rg",
)
# Operations counted by hand, weighted as the route's answer says.
COSTS = {
    "schlick": 2 * 1 + 4 * 1,
    "spherical_gaussian": 3 * 1 + 2 * 1 + 9,
    "lagarde_gc": 8 + 8 + 2 * 5 + 4,
}


def polarized(n_i: float, N: Any, theta: Array) -> tuple[Array, Array]:
    """Rs and Rp by the cosines of both angles."""
    c = np.cos(theta)
    c_t = np.sqrt(1.0 - (n_i * np.sin(theta) / N) ** 2 + 0j)
    s = (n_i * c - N * c_t) / (n_i * c + N * c_t)
    p = (N * c - n_i * c_t) / (N * c + n_i * c_t)
    return np.abs(s) ** 2, np.abs(p) ** 2


def exact(n_i: float, N: Any, theta: Array) -> Array:
    Rs, Rp = polarized(n_i, N, theta)
    return np.asarray((Rs + Rp) / 2.0)


def normal(n_i: float, N: complex) -> float:
    return float(abs((N - n_i) / (N + n_i)) ** 2)


def power_of_five(F0: float, c: Array, F90: float = 1.0) -> Array:
    return np.asarray(F0 + (F90 - F0) * (1.0 - c) ** 5)


def transmitted(n_i: float, N: complex, theta: Array) -> Array:
    """Schlick with the cosine beyond the surface; 1 where there is none."""
    sin_t = n_i / N.real * np.sin(theta)
    c_t = np.sqrt(np.maximum(1.0 - sin_t**2, 0.0))
    return np.where(sin_t > 1.0, 1.0, power_of_five(normal(n_i, N), c_t))


def pharr(n_i: float, N: complex, theta: Array) -> Array:
    c, n, t = np.cos(theta), N.real / n_i, abs(N / n_i) ** 2
    s = (t - 2 * n * c + c * c) / (t + 2 * n * c + c * c)
    p = (t * c * c - 2 * n * c + 1) / (t * c * c + 2 * n * c + 1)
    return np.asarray((s + p) / 2.0)


def misunderstood(n_i: float, N: complex, theta: Array) -> Array:
    c = np.cos(theta)
    g = np.sqrt((N / n_i) ** 2 - 1.0 + c * c)
    r = 0.5 * ((g - c) / (g + c)) ** 2 * (1.0 + ((c * (g + c) - 1.0) / (c * (g - c) + 1.0)) ** 2)
    return np.asarray(np.abs(r))


def tabulated(n_i: float, N: complex, theta: Array, given: dict[str, float]) -> Array:
    nodes = np.linspace(0.0, 1.0, int(given.get("size", 256)))
    texels = exact(n_i, N, np.arccos(nodes))
    if given.get("bits", 32) == 8:
        texels = np.round(255.0 * texels) / 255.0
    return np.interp(np.cos(theta), nodes, texels)


def solved_alpha(n_i: float, N: complex) -> float:
    c = np.cos(THETA)
    error = power_of_five(normal(n_i, N), c) - exact(n_i, N, THETA)
    worst = int(np.argmax(np.abs(error)))
    return float(np.log(error[worst] / (2.0 * N.real * c[worst])) / np.log(1.0 - c[worst]))


def tinted(n_i: float, N: complex, theta: Array) -> Array:
    c, mu, F0 = np.cos(theta), 1.0 / 7.0, normal(n_i, N)
    missing = power_of_five(F0, np.array(mu)) - exact(n_i, N, np.arccos([mu]))[0]
    return np.asarray(power_of_five(F0, c) - c * (1.0 - c) ** 6 / (mu * (1.0 - mu) ** 6) * missing)


def curve(model: str, n_i: float, N: complex, theta: Array, given: dict[str, float]) -> Array:
    """R of one model."""
    c, F0 = np.cos(theta), normal(n_i, N)
    simple: dict[str, Callable[[], Array]] = {
        "schlick": lambda: power_of_five(F0, c),
        "schlick_ior": lambda: power_of_five(F0, c),
        "schlick_four_percent": lambda: power_of_five(0.04, c),
        "schlick_f90_50": lambda: power_of_five(F0, c, min(50.0 * F0, 1.0)),
        "schlick_f0_srgb": lambda: power_of_five(1.055 * F0 ** (1 / 2.4) - 0.055, c),
        "schlick_wrong_angle": lambda: power_of_five(F0, c),
        "schlick_tir": lambda: transmitted(n_i, N, theta),
        "one_minus_cos": lambda: 1.0 - c,
        "spherical_gaussian": lambda: F0 + (1.0 - F0) * np.exp2((-5.55473 * c - 6.98316) * c),
        "pharr_humphreys": lambda: pharr(n_i, N, theta),
        "complex_dielectric": lambda: misunderstood(n_i, N, theta),
        "cook_torrance": lambda: exact(1.0, (1 + F0**0.5) / (1 - F0**0.5), theta),
        "f82_tint": lambda: tinted(n_i, N, theta),
        "lut_1d": lambda: tabulated(n_i, N, theta, given),
        "lazanyi2005": lambda: (
            power_of_five(F0, c)
            - 2.0 * N.real * c * (1.0 - c) ** given.get("alpha", solved_alpha(n_i, N))
        ),
    }
    return exact(n_i, N, theta) if model in FORMS else simple[model]()


def figures(
    model: str, medium: Medium, given: dict[str, float], theta: Array = THETA
) -> dict[str, Any]:
    """Metrics of the error of one model."""
    truth = exact(*medium, theta)
    error = curve(model, *medium, theta, given) - truth
    worst = int(np.argmax(np.abs(error)))
    with np.errstate(invalid="ignore", divide="ignore"):
        relative = np.abs(error / truth)
    c = np.cos(theta)
    return {
        "model": model,
        "max_abs": abs(error[worst]),
        "max_abs_at_deg": np.degrees(theta[worst]),
        "max_relative": np.nanmax(relative),
        "rms": np.sqrt(-np.trapezoid(error**2, c)),
        "albedo_error": -2.0 * np.trapezoid(error * c, c),
        "parameters": {"alpha": solved_alpha(*medium)} if model == "lazanyi2005" else {},
    }


@cache
def catalog() -> Any:
    return load_catalog()


class Query(dict[str, str]):
    """A query string, with the numbers it means."""

    def number(self, name: str, default: float) -> float:
        return float(self.get(name, default))

    def medium(self, n_t: float | None = None, k_t: float | None = None) -> Medium:
        n, k = self.number("n_t", 1.5), self.number("k_t", 0.0)
        if "material" in self:
            at = self.number("wavelength_nm", 0.0) or None
            constants = catalog().constants(catalog().get(self["material"]).id, at)
            n, k = constants.n_absolute, constants.k or 0.0
        return self.number("n_i", 1.0), complex(
            n if n_t is None else n_t, k if k_t is None else k_t
        )

    def axis(self, prefix: str, steps: str = "steps") -> Array:
        ends = self.number(f"{prefix}minimum", 0.0), self.number(f"{prefix}maximum", 0.0)
        spread = np.geomspace if self.get("scale") == "log" else np.linspace
        return np.asarray(spread(*ends, int(self[f"{prefix}{steps}"])))

    def given(self, model: str) -> dict[str, float]:
        own = {k: v for k, v in self.items() if k.startswith(f"{model}.")}
        return {name.partition(".")[2]: float(value) for name, value in own.items()}


def described(medium: Medium) -> dict[str, Any]:
    n_i, N = medium
    eta = N.real / n_i
    critical = np.degrees(np.arcsin(eta)) if eta < 1.0 and N.imag == 0.0 else None
    return {"F0": normal(n_i, N), "critical_deg": critical}


def errors(query: Query) -> Any:
    medium = query.medium()
    models = query.get("models", "schlick").split(",")
    return {
        "interface": described(medium),
        "errors": [figures(model, medium, query.given(model)) for model in models],
    }


def errors_sweep(query: Query) -> Any:
    values = query.axis("")
    media = [query.medium(**{query["over"]: float(value)}) for value in values]
    rows = [figures(query["model"], medium, {}, THETA[::4]) for medium in media]
    return {"values": values.tolist()} | {n: [row[n] for row in rows] for n in rows[0]}


def errors_map(query: Query) -> Any:
    x, y = query.axis("x_"), query.axis("y_")
    if query["x"] == "theta_i_deg":
        rows = [
            (
                curve(query["model"], *query.medium(n_t=n), np.radians(x), {})
                - exact(*query.medium(n_t=n), np.radians(x))
            )
            for n in y.tolist()
        ]
        return {"values": [row.tolist() for row in rows]}
    return {
        "values": [
            [
                figures(query["model"], query.medium(n, k), {}, THETA[::8])[query["metric"]]
                for n in x.tolist()
            ]
            for k in y.tolist()
        ]
    }


def curves(query: Query) -> Any:
    medium, theta = (
        query.medium(),
        np.radians(np.linspace(0.0, 90.0, int(query.number("samples", 181)))),
    )
    answer = []
    for model in query.get("models", "exact").split(","):
        if model == "exact":
            Rs, Rp = polarized(*medium, theta)
            R = (Rs + Rp) / 2.0
            named = {"R": R, "Rs": Rs, "Rp": Rp, "T": 1.0 - R}
        else:
            named = {"R": curve(model, *medium, theta, query.given(model))}
        answer += [{"model": model, "quantity": q, "values": v.tolist()} for q, v in named.items()]
    return {"theta_i_deg": np.degrees(theta).tolist(), "curves": answer}


def snell(query: Query) -> Any:
    theta = np.radians([query.number("theta_i_deg", 0.0)])
    Rs, Rp = polarized(*query.medium(), theta)
    return {"R": float(Rs[0] + Rp[0]) / 2.0, "Rs": float(Rs[0]), "Rp": float(Rp[0])}


NODES, WEIGHTS = np.polynomial.legendre.leggauss(240)


def mean(function: Callable[[Array], Array], eta: float = 2.0) -> float:
    """2 * integral of R sin cos over the hemisphere, split at a critical angle.

    theta = low + (high - low) sin^2(t) crowds the nodes at both ends, where R may grow as a root.
    """
    ends = [0.0, float(np.arcsin(eta)), np.pi / 2.0] if eta < 1.0 else [0.0, np.pi / 2.0]
    t = np.pi / 4.0 * (NODES + 1.0)
    total = 0.0
    for low, high in pairwise(ends):
        theta = low + (high - low) * np.sin(t) ** 2
        slope = (high - low) * np.sin(2.0 * t) * np.pi / 4.0
        total += float(np.sum(WEIGHTS * slope * function(theta) * np.sin(2.0 * theta)))
    return total


# The fits as their sources print them, corrected where a source text is damaged.
FITS: dict[str, Callable[[Array, Array], Array]] = {
    "deon_2019_log": lambda n, _: np.log((10893 * n - 1438.2) / (1 + 10212 * n - 774.4 * n**2)),
    "deon_irving_2011": lambda n, _: (
        0.919317 - 3.4793 / n + 6.75335 / n**2 - 7.80989 / n**3 + 4.98554 / n**4 - 1.36881 / n**5
    ),
    "kulla_conty_2017": lambda n, _: (n - 1) / (4.08567 + 1.00071 * n),
    "egan_hilgeman_1973": lambda n, _: 0.0636 / n + 0.6681 + 0.7099 * n - 1.4399 * n**2,
    "kulla_conty_2017_internal": lambda n, _: (
        0.997118 + 0.1014 * n - 0.965241 * n**2 - 0.130607 * n**3
    ),
    "schlick_nk": lambda n, k: 1 - 80 * n / (21 * (k**2 + (1 + n) ** 2)),
}


def convert(query: Query) -> Any:
    match query["from"]:
        case "ior":
            F0 = ((query.number("n_t", 1.5) - 1) / (query.number("n_t", 1.5) + 1)) ** 2
        case "f0":
            F0 = query.number("F0", 0.0)
        case "specular":
            F0 = 0.08 * query.number("specular", 0.0)
        case "reflectance":
            F0 = 0.16 * query.number("reflectance", 0.0) ** 2
        case _:
            F0 = normal(*query.medium())
    n = query.medium()[1].real
    low, high = (1 - F0) / (1 + F0), (1 + F0**0.5) / (1 - F0**0.5)
    return {
        "results": [
            {"form": "ior", "values": {"n_t": (1 + F0**0.5) / (1 - F0**0.5)}},
            {"form": "f0", "values": {"F0": F0}},
            {"form": "rg", "values": {"g": (high - n) / (high - low)}},
        ]
    }


def recommend(_: Query) -> Any:
    return {"models": [{"model": m, "weighted_cost": cost} for m, cost in COSTS.items()]}


def materials(query: Query) -> Any:
    presets = [p for p in catalog().presets if p.category == query["category"]]
    return {"materials": [{"n": preset.n} for preset in presets]}


def spectrum(material: str, query: Query) -> Any:
    nm = np.arange(
        query.number("minimum_nm", 0), query.number("maximum_nm", 0) + 1, query.number("step_nm", 1)
    )
    found = catalog().spectrum(catalog().get(material).id)
    k = found.k(nm) if found.k_range_nm else np.zeros_like(nm)
    N = found.n_absolute(nm) + 1j * (0.0 if k is None else k)
    return {"F0": (np.abs((N - 1) / (N + 1)) ** 2).tolist()}


def modelled(model: str, medium: Medium, theta: Array) -> Array:
    return curve(model, *medium, theta, {})


def albedo(query: Query) -> Any:
    medium = query.medium()
    n, k = np.array(medium[1].real), np.array(medium[1].imag)
    truth = mean(lambda theta: exact(*medium, theta))
    fit = {name: float(function(n, k)) for name, function in FITS.items()} | {
        # Dunkle's is the mean of Pharr's form, whose closed expression tests/optics checks.
        "dunkle_1963": mean(lambda theta: pharr(*medium, theta))
    }
    models = [m for m in query.get("models", "").split(",") if m]
    return {
        "approximations": [{"id": name, "value": v, "error": v - truth} for name, v in fit.items()],
        "models": [{"model": m, "value": mean(partial(modelled, m, medium))} for m in models],
    }


def albedo_sweep(query: Query) -> Any:
    eta = query.axis("")
    truth = np.array([mean(partial(exact, 1.0, complex(n)), n) for n in eta.tolist()])
    fit = query["fits"]
    return {
        "values": eta.tolist(),
        "curves": [
            {"kind": "exact", "quantity": "unpolarized", "values": truth.tolist()},
            {
                "kind": "fit",
                "id": fit,
                "error": (FITS[fit](eta, np.zeros_like(eta)) - truth).tolist(),
            },
        ],
    }


def albedo_map(query: Query) -> Any:
    """The largest error of a fit, on a grid of its own."""
    ends = [[query.number(f"{x}_{end}imum", 0.0) for end in ("min", "max")] for x in "nk"]
    fit = find_fit(query["fit"])
    if all(domain.kind == "dielectric" for domain in fit.domains):
        ends[1] = [0.0, 0.0]
    (n_low, n_high), (k_low, k_high) = ends
    n, k = np.geomspace(n_low, n_high, 201), np.linspace(k_low, k_high, 201 if k_high else 1)
    theta = np.pi / 4.0 * (NODES + 1.0)
    media = (n[np.newaxis, :] + 1j * k[:, np.newaxis])[..., np.newaxis]
    with np.errstate(under="ignore"):
        truth = exact(1.0, media, theta) @ (WEIGHTS * np.sin(2.0 * theta) * np.pi / 4.0)
    # The longest formulas are not typed a second time; their albedo is, see tests/optics.
    error = fit(Interface(1.0, n[np.newaxis, :], k[:, np.newaxis])) - truth
    found = {"value": float(np.abs(error).max())}
    return {"largest": found, "largest_in_domain": found}


def errors_mesh(query: Query) -> Any:
    """Triangles of a sphere, seen along its axis, at points of their own."""
    (n_i, N), count = query.medium(), int(query["latitudes"])
    ring = np.linspace(0.0, np.pi / 2.0, count)
    t = 1.0 - np.linspace(0.0, 1.0, 4001)[:, np.newaxis] ** 2
    found = {"per_vertex": 0.0, "per_pixel": 0.0, "apart": 0.0}
    for a, b in pairwise(ring.tolist()):
        corner = np.array([[np.sin(a), np.cos(a)], [np.sin(b), np.cos(b)]])
        x, z = ((1.0 - t) * corner[0] + t * corner[1]).T
        vertex = (1.0 - t[:, 0]) * exact(n_i, N, np.array(a)) + t[:, 0] * exact(n_i, N, np.array(b))
        sphere, pixel = (
            exact(n_i, N, at) for at in (np.arcsin(np.minimum(x, 1.0)), np.arctan2(x, z))
        )
        for way, error in (
            ("per_vertex", vertex - sphere),
            ("per_pixel", pixel - sphere),
            ("apart", vertex - pixel),
        ):
            found[way] = max(found[way], float(np.abs(error).max()))
    return {way: {"max_abs": error} for way, error in found.items()}


ROUTES: dict[str, Callable[[Query], Any]] = {
    "/errors": errors,
    "/errors/sweep": errors_sweep,
    "/errors/map": errors_map,
    "/errors/mesh": errors_mesh,
    "/curves": curves,
    "/snell": snell,
    "/albedo": albedo,
    "/albedo/sweep": albedo_sweep,
    "/albedo/map": albedo_map,
    "/convert": convert,
    "/recommend": recommend,
    "/materials": materials,
}


@cache
def answer(request: str) -> Any:
    """What the numbers of an answer should be, in the places where the server sends them."""
    parts = urlsplit(request)
    query = Query(parse_qsl(parts.query))
    if parts.path.endswith("/spectrum"):
        return spectrum(parts.path.split("/")[2], query)
    return ROUTES[parts.path](query)
