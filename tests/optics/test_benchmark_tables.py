"""Both benchmark tables of E. d'Eon's notebook "Fresnel Boundaries" (2019), cell by cell.

The notebook prints eight decimals of R for unpolarized light at six angles in radians, from vacuum.
Text recognition dropped cells of the rows with n < 1: beyond the critical angle arcsin(n) the
notebook's function returns 1, and those rows end in as many ones as the angles beyond it demand.
"""

import numpy as np
import pytest

from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.registry import Model, default_registry

THETA_I = (0.0, 0.2, 0.5, 1.0, 1.2, 1.5)

# Half a unit of the last decimal printed, and the rounding of that half itself.
PRINTED = 0.5e-8 + 1e-15

DIELECTRIC = {
    0.5: (0.11111111, 0.11175198, 0.28326783, 1.0, 1.0, 1.0),
    0.7: (0.03114187, 0.03124674, 0.03870036, 1.0, 1.0, 1.0),
    0.9: (0.00277008, 0.00277588, 0.00309559, 0.04529667, 1.0, 1.0),
    0.99: (0.00002525, 0.00002530, 0.00002756, 0.00018462, 0.00132454, 1.0),
    1.01: (0.00002475, 0.00002479, 0.00002690, 0.00016095, 0.00096253, 0.14322539),
    1.1: (0.00226757, 0.00227070, 0.00242550, 0.00987357, 0.03762339, 0.50722589),
    1.4: (0.02777778, 0.02779989, 0.02881388, 0.06118057, 0.13573578, 0.65791346),
    2.0: (0.11111111, 0.11114523, 0.11262121, 0.15018951, 0.22278595, 0.68340009),
}

CONDUCTOR = {
    (1.01, 0.5): (0.05829701, 0.05837392, 0.06178289, 0.14339752, 0.27067729, 0.77121604),
    (1.1, 0.5): (0.05579399, 0.05585623, 0.05861520, 0.12773108, 0.24394224, 0.75157831),
    (1.4, 0.5): (0.06821963, 0.06826528, 0.07026499, 0.12163143, 0.21644127, 0.71680339),
    (2.0, 0.5): (0.13513514, 0.13517164, 0.13673298, 0.17490309, 0.24661001, 0.69400413),
    (10.0, 0.5): (0.67010309, 0.67006997, 0.66870975, 0.64017903, 0.59473323, 0.50049776),
    (1.01, 5.0): (0.86088202, 0.86086219, 0.86006999, 0.84542467, 0.82700656, 0.88043233),
    (1.1, 5.0): (0.85039102, 0.85037015, 0.84953608, 0.83411201, 0.81472471, 0.87118142),
    (1.4, 5.0): (0.81794538, 0.81792166, 0.81697257, 0.79937929, 0.77724082, 0.84183787),
    (2.0, 5.0): (0.76470588, 0.76467863, 0.76358448, 0.74310011, 0.71697927, 0.78954494),
    (10.0, 5.0): (0.72602740, 0.72599530, 0.72467855, 0.69690083, 0.65143060, 0.52292443),
}

EXACT_FORMS = [model for model in default_registry().values() if model.kind == "exact"]
OF_CONDUCTORS = [model for model in EXACT_FORMS if "conductor" in model.applies_to]


def identify(model: Model) -> str:
    return model.id


def test_the_tables_are_complete() -> None:
    assert sum(map(len, DIELECTRIC.values())) == 48
    assert sum(map(len, CONDUCTOR.values())) == 60


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
