"""`/errors/map` of 40,000 cells beside a fresh `/curves` of 181 samples with two curves."""

from __future__ import annotations

import itertools
import statistics

from benchmarks.albedo import mean_ms
from benchmarks.load import served, under_uvicorn

ROUNDS = 7
REQUESTS = 40
BAR = 40.0
CURVES = "/api/v1/curves?models=exact,schlick&samples=181&n_t={x:.9f}"
CELLS = "/api/v1/errors/map?x_steps=200&y_steps=200"
HEMISPHERES = CELLS + "&x=n_t&y=k_t&y_maximum={x:.9f}"
MAPS = {
    "angle by index, signed error": CELLS + "&y_maximum={x:.9f}",
    "angle by index, relative error": CELLS + "&metric=relative&y_maximum={x:.9f}",
    "index by extinction, max_abs": HEMISPHERES,
    "index by extinction, rms": HEMISPHERES + "&metric=rms",
    "the same of f82_tint": HEMISPHERES + "&metric=rms&model=f82_tint",
    "index by extinction, albedo_error": HEMISPHERES + "&metric=albedo_error",
    "index by extinction, max_relative": HEMISPHERES + "&metric=max_relative",
}
HERE = "/api/v1/errors?models=schlick,spherical_gaussian,hoffman_f82&k_t=3&n_t={x:.9f}"
SWEEP = "/api/v1/errors/sweep?model=schlick&steps=201&maximum={x:.9f}"
RECOMMEND = "/api/v1/recommend?k_t=3&n_t={x:.9f}"


def main(application: str = "app.main:create_app") -> None:
    """Print the times and their ratios to `/curves`, medians of the rounds."""
    numbers = (2.0 + 1e-6 * i for i in itertools.count())
    others = {
        "/errors of three models": HERE,
        "/errors/sweep, 201 steps": SWEEP,
        "/recommend, every model": RECOMMEND,
    }
    with served(*under_uvicorn(application, "--factory")) as server:
        rounds = [
            {
                "curves": mean_ms(server.port, CURVES, numbers, REQUESTS),
                **{name: mean_ms(server.port, path, numbers, 3) for name, path in MAPS.items()},
                **{name: mean_ms(server.port, path, numbers, 5) for name, path in others.items()},
            }
            for _ in range(ROUNDS)
        ]
    curves = statistics.median(times["curves"] for times in rounds)
    print(f"fresh /curves, 181 samples, two curves: {curves:.2f} ms")
    for name in (*MAPS, *others):
        time = statistics.median(times[name] for times in rounds)
        ratio = statistics.median(times[name] / times["curves"] for times in rounds)
        bar = f" (bar: {BAR:g}x)" if name in MAPS else ""
        print(f"{name + ':':40}{time:7.1f} ms, {ratio:5.1f}x{bar}")


if __name__ == "__main__":
    main()
