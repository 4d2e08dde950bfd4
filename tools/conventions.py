"""Which signs other programs have: each is run where it is installed, and its row printed.

Run it in an environment of its own (`pip install tmm pyElli pypolar mitsuba packaging`, then
`python tools/conventions.py`); it needs nothing of this project. Delta is that of bare silicon,
3.8827 + 0.0196i at 632.8 nm and 70 degrees, whose psi is 10.57788: in exp(-iwt) with r_p = -r_s at
normal incidence it is -179.20608.
"""

from __future__ import annotations

import cmath
import importlib
import importlib.util
import math
from collections.abc import Callable, Iterator
from importlib.metadata import version
from typing import Any

SILICON, AT_DEG, WAVELENGTH_NM = 3.8827 + 0.0196j, 70.0, 632.8

Row = dict[str, str]


def delta_deg(ratio: complex) -> str:
    """Phase of a ratio, as the table has it."""
    return f"{math.degrees(cmath.phase(ratio)):.5f}"


def of_tmm() -> Row:
    """S. J. Byrnes' tmm."""
    tmm: Any = importlib.import_module("tmm")
    absorbing = tmm.coh_tmm("s", [1, 1.5 + 0.1j, 1], [math.inf, 100, math.inf], 0, 550)
    sign = "n + ik" if absorbing["R"] + absorbing["T"] < 1 else "n - ik"
    r = {p: complex(tmm.coh_tmm(p, [1, 1.5], [math.inf] * 2, 0, 550)["r"]) for p in "sp"}
    stack = [1, SILICON], [math.inf] * 2, math.radians(AT_DEG), WAVELENGTH_NM
    ours = {p: complex(tmm.coh_tmm(p, *stack)["r"]) for p in "sp"}
    return {
        "program": f"tmm {version('tmm')}",
        "absorbs": sign,
        "r_s": f"{r['s'].real:+.1f}",
        "r_p": f"{r['p'].real:+.1f}",
        "arg(r_p/r_s)": delta_deg(ours["p"] / ours["s"]),
        "Delta it prints": f"{math.degrees(float(tmm.ellips(*stack)['Delta'])):.5f}",
    }


def of_pyelli() -> Row:
    """pyElli."""
    elli: Any = importlib.import_module("elli")
    numpy: Any = importlib.import_module("numpy")
    air = elli.IsotropicMaterial(elli.ConstantRefractiveIndex(1.0))

    def result(index: complex, degrees: float, *films: Any) -> Any:
        medium = elli.IsotropicMaterial(elli.ConstantRefractiveIndex(index))
        structure = elli.Structure(air, list(films), medium)
        return structure.evaluate(numpy.array([WAVELENGTH_NM]), degrees)

    film = elli.Layer(elli.IsotropicMaterial(elli.ConstantRefractiveIndex(1.5 + 0.1j)), 100.0)
    through = result(1.0, 0.0, film)
    absorbed = 1.0 - float(numpy.ravel(through.R)[0] + numpy.ravel(through.T)[0])
    glass, silicon = result(1.5, 0.0), result(SILICON, AT_DEG)
    r_s, r_p = (complex(numpy.ravel(getattr(glass, name))[0]) for name in ("r_ss", "r_pp"))
    at_70 = [complex(numpy.ravel(getattr(silicon, name))[0]) for name in ("r_ss", "r_pp")]
    return {
        "program": f"pyElli {version('pyElli')}",
        "absorbs": "n + ik" if absorbed > 0 else "n - ik",
        "r_s": f"{r_s.real:+.1f}",
        "r_p": f"{r_p.real:+.1f}",
        "arg(r_p/r_s)": delta_deg(at_70[1] / at_70[0]),
        "Delta it prints": f"{float(numpy.ravel(silicon.delta)[0]):.5f}",
    }


def of_pypolar() -> Row:
    """pypolar, which conjugates an index of the other sign; its Delta is 180 degrees off its rho."""
    pypolar: Any = importlib.import_module("pypolar")
    fresnel, ellipsometry = pypolar.fresnel, pypolar.ellipsometry
    r_s, r_p = (complex(of(1.5, 0.0)) for of in (fresnel.r_per_amplitude, fresnel.r_par_amplitude))
    rho = complex(ellipsometry.rho_from_m(SILICON, math.radians(AT_DEG)))
    read = complex(ellipsometry.m_from_rho(rho, math.radians(AT_DEG)))
    delta = float(ellipsometry.tanpsi_Delta_from_rho(rho, deg=True)[1])
    return {
        "program": f"pypolar {version('pypolar')}",
        "absorbs": "n + ik" if read.imag > 0 else "n - ik",
        "r_s": f"{r_s.real:+.1f}",
        "r_p": f"{r_p.real:+.1f}",
        "arg(r_p/r_s)": delta_deg(rho),
        "Delta it prints": f"{delta:.5f}",
    }


def of_mitsuba() -> Row:
    """Mitsuba's `fresnel_polarized`."""
    mitsuba: Any = importlib.import_module("mitsuba")
    mitsuba.set_variant("scalar_rgb")

    def pair(cosine: float, index: complex) -> tuple[complex, complex, complex]:
        eta = mitsuba.Complex2f(index.real, index.imag)
        found = mitsuba.fresnel_polarized(cosine, eta)
        r_s, r_p, eta_it = (complex(found[i].real, found[i].imag) for i in (0, 1, 3))
        return r_s, r_p, eta_it

    r_s, r_p, _ = pair(1.0, 1.5 + 0j)
    at_70 = pair(math.cos(math.radians(AT_DEG)), SILICON)
    return {
        "program": f"mitsuba {version('mitsuba')}",
        "absorbs": "n + ik" if at_70[2].imag > 0 else "n - ik",
        "r_s": f"{r_s.real:+.1f}",
        "r_p": f"{r_p.real:+.1f}",
        "arg(r_p/r_s)": delta_deg(at_70[1] / at_70[0]),
        "Delta it prints": "none",
    }


PROGRAMS: dict[str, Callable[[], Row]] = {
    "tmm": of_tmm,
    "elli": of_pyelli,
    "pypolar": of_pypolar,
    "mitsuba": of_mitsuba,
}


def rows() -> Iterator[Row]:
    """A row of each program that is installed."""
    for module, run in PROGRAMS.items():
        if importlib.util.find_spec(module):
            yield run()


def main() -> None:
    """Print the rows as a table."""
    for row in rows():
        print("| " + " | ".join(row.values()) + " |")


if __name__ == "__main__":
    main()
