"""`/vectors`: directions in space, against the ray in its plane."""

import numpy as np
import pytest

from app.optics.parameters import Array
from tests.api.shape import Ask, error_of, json_of


def written(vector: Array) -> str:
    return ",".join(map(repr, vector.tolist()))


@pytest.mark.parametrize(
    "media", [{"n_t": 1.5}, {"n_i": 1.5, "n_t": 1.0}, {"n_t": 0.27, "k_t": 2.9}], ids=str
)
@pytest.mark.parametrize("theta_i_deg", [0.0, 20.0, 41.0, 60.0, 89.0])
def test_a_ray_in_space_is_the_ray_in_its_plane_turned(
    ask: Ask, media: dict[str, float], theta_i_deg: float
) -> None:
    rng = np.random.default_rng(int(theta_i_deg))
    turn, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    flat = json_of(ask("/snell", theta_i_deg=theta_i_deg, **media))
    theta = np.radians(theta_i_deg)
    incident = turn @ [np.sin(theta), -np.cos(theta), 0.0]
    normal = turn @ [0.0, 1.0, 0.0]
    told = json_of(
        ask("/vectors", incident_direction=written(incident), normal=written(normal), **media)
    )
    assert told["theta_i_deg"] == pytest.approx(theta_i_deg, abs=1e-9)
    np.testing.assert_allclose(told["reflected"], turn @ [*flat["reflected"], 0.0], atol=1e-12)
    if flat["refracted"] is None:
        assert told["refracted"] is None
    else:
        np.testing.assert_allclose(told["refracted"], turn @ [*flat["refracted"], 0.0], atol=1e-12)
    assert told["Rp"] == pytest.approx(flat["Rp"], rel=1e-9)


def test_what_is_no_direction_is_refused(ask: Ask) -> None:
    for vector, message in (
        ("1,1", "3 numbers x,y,z"),
        ("0,-2,0", "unit vectors"),
        ("0,1,0", "toward the surface"),
    ):
        error = error_of(ask("/vectors", incident_direction=vector))
        assert error["parameter"] == "incident_direction"
        assert message in error["message"]
    error = error_of(ask("/vectors", incident_direction="0,-1,0", normal="0,0.5,0"))
    assert error["parameter"] == "normal"
