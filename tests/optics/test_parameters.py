"""Declared parameters: what they let pass, and what the error says of the rest."""

import contextlib

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import ArrayLike

from app.optics.errors import NotAllowed, OpticsError, OutOfRange, UnknownModel, UnknownName
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import K_T, MU, N_I, N_T, THETA_I, THETA_I_DEG, Parameter
from app.optics.specular import F82

DECLARED = (N_I, N_T, K_T, THETA_I_DEG, THETA_I, MU)
WHOLE = Parameter("size", "N", 64.0, 2.0, 4096.0, "", "Texels.", integer=True)
CHOICE = Parameter(
    "bits", "b", 8.0, 8.0, 32.0, "", "Texel.", choices=(("unorm8", 8.0), ("half", 16.0))
)


@pytest.mark.parametrize("parameter", DECLARED, ids=lambda parameter: parameter.name)
def test_bounds_are_inclusive_and_the_default_is_legal(parameter: Parameter) -> None:
    ends = parameter.check([parameter.minimum, parameter.maximum])
    assert ends.tolist() == [parameter.minimum, parameter.maximum]
    assert parameter.default is not None
    assert float(parameter.check(parameter.default)) == parameter.default
    for outside in (
        np.nextafter(parameter.minimum, -np.inf),
        np.nextafter(parameter.maximum, np.inf),
    ):
        with pytest.raises(OutOfRange):
            parameter.check(outside)


def test_bounds_are_those_of_the_contract() -> None:
    assert (N_I.minimum, N_I.maximum, N_I.default) == (1e-3, 100.0, 1.0)
    assert (N_T.minimum, N_T.maximum, N_T.default) == (1e-3, 100.0, 1.5)
    assert (K_T.minimum, K_T.maximum, K_T.default) == (0.0, 100.0, 0.0)
    assert (THETA_I_DEG.minimum, THETA_I_DEG.maximum) == (0.0, 90.0)


REFUSED: list[ArrayLike] = [
    np.nan,
    np.inf,
    -np.inf,
    -1.0,
    [1.0, np.nan],
    [[1.0], [1e400]],
    "glass",
    "",
    [1.5 + 0.0j],
    [[1.0, 2.0], [3.0]],
    None,  # type: ignore[list-item]
]


@pytest.mark.parametrize("value", REFUSED, ids=repr)
def test_what_is_no_number_in_bounds_is_refused(value: ArrayLike) -> None:
    with pytest.raises(OutOfRange) as caught:
        N_T.check(value)
    assert caught.value.parameter == "n_t"
    assert caught.value.allowed == "a finite number from 0.001 to 100"
    assert "n_t" in str(caught.value)


def test_a_complex_index_is_told_apart_into_its_parts() -> None:
    with pytest.raises(OutOfRange) as caught:
        N_T.check(1.5 + 0.1j)
    assert caught.value.parameter == "n_t"
    assert "n_t = 1.5 and k_t = 0.1" in caught.value.allowed


def test_the_error_shows_the_first_offending_element() -> None:
    with pytest.raises(OutOfRange) as caught:
        THETA_I_DEG.check([10.0, 91.0, -5.0])
    assert (
        str(caught.value) == "theta_i_deg = 91.0 is not allowed: a finite number from 0 to 90 deg"
    )


@given(st.floats() | st.complex_numbers() | st.text() | st.none() | st.integers() | st.binary())
def test_nothing_but_an_error_of_ours_comes_out(value: object) -> None:
    with contextlib.suppress(OutOfRange):
        checked = N_T.check(value)  # type: ignore[arg-type]
        assert 1e-3 <= float(checked) <= 100.0


def test_whole_numbers() -> None:
    assert WHOLE.check([2, 64.0]).tolist() == [2.0, 64.0]
    with pytest.raises(OutOfRange, match=r"size = 2\.5 is not allowed: a whole number from 2"):
        WHOLE.check(2.5)


def test_choices_by_name_and_by_number() -> None:
    assert float(CHOICE.check("half")) == 16.0
    assert CHOICE.check([8, 16]).tolist() == [8.0, 16.0]
    for value in (32.0, "float", "", 9):
        with pytest.raises(OutOfRange, match="one of unorm8, half"):
            CHOICE.check(value)


@pytest.mark.parametrize("error", [OutOfRange, NotAllowed])
def test_errors_are_optics_errors_and_value_errors(error: type[OpticsError]) -> None:
    raised = error("n_t", -1.0, "positive numbers")
    assert isinstance(raised, OpticsError)
    assert isinstance(raised, ValueError)
    assert (raised.parameter, raised.value, raised.allowed) == ("n_t", -1.0, "positive numbers")


def test_unknown_names_list_the_nearest() -> None:
    known = ["exact", "schlick", "schlick_ior"]
    error = UnknownModel("models", "Shlick", known)
    assert isinstance(error, UnknownName)
    assert error.nearest == ["schlick", "schlick_ior"]
    assert "nearest: schlick" in str(error)
    far = UnknownModel("models", "zzz", known)
    assert far.nearest == []
    assert all(name in str(far) for name in known)


class TestInterface:
    def test_defaults_are_air_to_glass(self) -> None:
        interface = Interface()
        assert (float(interface.n_i), float(interface.n_t), float(interface.k_t)) == (1.0, 1.5, 0.0)
        assert interface.kind == "dielectric"

    @pytest.mark.parametrize("name", ["n_i", "n_t", "k_t"])
    @pytest.mark.parametrize("value", [np.nan, -1.0, 100.1, np.inf])
    def test_every_index_is_checked(self, name: str, value: float) -> None:
        with pytest.raises(OutOfRange) as caught:
            Interface(**{name: value})
        assert caught.value.parameter == name

    def test_relative_indices(self) -> None:
        interface = Interface(2.0, [3.0, 1.0], [[1.0], [0.0]])
        assert interface.eta.tolist() == [1.5, 0.5]
        assert interface.kappa.tolist() == [[0.5], [0.0]]
        assert interface.F0.shape == F82(interface).shape == (2, 2)

    def test_one_absorbing_element_makes_a_conductor(self) -> None:
        assert Interface(k_t=[0.0, 1.0]).kind == "conductor"
        assert Interface(k_t=[0.0, 0.0]).kind == "dielectric"

    def test_eta_minus_1_keeps_its_digits(self) -> None:
        n_t = 1.0 + 2.0**-40
        assert float(Interface(1.0, n_t).eta_minus_1) == 2.0**-40
        assert float(Interface(1.37, 1.37).eta_minus_1) == 0.0

    def test_an_extinction_without_a_square_is_none(self) -> None:
        assert Interface(k_t=[1e-300, 1e-140]).kappa.tolist() == [0.0, 1e-140]

    def test_is_immutable(self) -> None:
        with pytest.raises(AttributeError):
            Interface().n_t = np.asarray(2.0)  # type: ignore[misc]

    def test_incidence_of_another_unit_is_another_parameter(self) -> None:
        for make, name in (
            (Incidence.from_degrees, "theta_i_deg"),
            (Incidence.from_radians, "theta_i"),
            (Incidence.from_cosine, "mu"),
        ):
            with pytest.raises(OutOfRange) as caught:
                make(-0.5)
            assert caught.value.parameter == name
