"""Both benchmark tables of E. d'Eon's notebook "Fresnel Boundaries" (2019), cell by cell.

The notebook prints eight decimals of R for unpolarized light at six angles in radians, from vacuum.
Text recognition dropped cells of the rows with n < 1: beyond the critical angle arcsin(n) the
notebook's function returns 1, and those rows end in as many ones as the angles beyond it demand.
"""

import numpy as np
import pytest

from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.printed import deon_2019
from app.optics.registry import Model, default_registry

THETA_I = (0.0, 0.2, 0.5, 1.0, 1.2, 1.5)

# Half a unit of the last decimal printed, and the rounding of that half itself.
PRINTED = 0.5e-8 + 1e-15

CELLS = np.stack(deon_2019(), axis=-1).reshape(-1, len(THETA_I), 4)
DIELECTRIC = {row[0, 0]: row[:, 3] for row in CELLS if row[0, 1] == 0.0}
CONDUCTOR = {(row[0, 0], row[0, 1]): row[:, 3] for row in CELLS if row[0, 1] > 0.0}

EXACT_FORMS = [model for model in default_registry().values() if model.kind == "exact"]
OF_CONDUCTORS = [model for model in EXACT_FORMS if "conductor" in model.applies_to]


def identify(model: Model) -> str:
    return model.id


def test_the_tables_are_complete() -> None:
    assert sum(map(len, DIELECTRIC.values())) == 48
    assert sum(map(len, CONDUCTOR.values())) == 60
    assert np.all(CELLS[..., 2] == THETA_I)


@pytest.mark.parametrize("model", EXACT_FORMS, ids=identify)
@pytest.mark.parametrize("n", DIELECTRIC)
def test_dielectrics(model: Model, n: float) -> None:
    theta_i, printed = np.array(THETA_I), np.array(DIELECTRIC[n])
    R = model(Interface(n_t=n), Incidence.from_radians(theta_i))
    inside = np.full(theta_i.shape, True)
    if "undefined beyond" in model.validity:
        inside = np.sin(theta_i) < n
        assert np.isnan(R[~inside]).all()
    assert np.all(np.abs(R - printed)[inside] <= PRINTED)


@pytest.mark.parametrize("model", OF_CONDUCTORS, ids=identify)
@pytest.mark.parametrize(("n", "k"), CONDUCTOR)
def test_conductors(model: Model, n: float, k: float) -> None:
    R = model(Interface(n_t=n, k_t=k), Incidence.from_radians(THETA_I))
    assert np.all(np.abs(R - CONDUCTOR[n, k]) <= PRINTED)
