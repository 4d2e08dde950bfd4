"""What each route refuses, and that it names the parameter at fault and no other."""

import re

import pytest
from fastapi import FastAPI

from tests.api.raw import send
from tests.api.test_problems import API, expect_problem

# Queries of a path, between which are spaces; what each names last is at fault.
REFUSED = {
    "/snell": (
        # what is no number
        "n_t=nan n_t=NaN n_t=inf n_t=-Infinity n_t=1e400 n_t= n_t n_t=glass n_t=1,5 n_t=0x10 "
        "n_t=1_5 n_t=1.5%00 n_t=%ff n_t=%D9%A1 n_t=true n_t=1.5;k_t=2 n_t=[1.5] "
        # out of bounds
        "n_i=0 n_i=-1 n_i=100.0001 n_t=0.00099 k_t=-1e-300 k_t=101 theta_i_deg=-0.001 "
        "theta_i_deg=90.00001 "
        # names
        "N_t=1.5 n=1.5 samples=5 theta_i_deg=5&=1 n_t=1.5&n_t=1.5"
    ),
    "/models": "page=1",
    "/parameters": "n_t=1",
    "/curves": (
        "samples=1000000000 samples=99999999999999999999999999 samples=1 samples=0 samples=-1 "
        "samples=181.5 samples=1e3 samples=1_000 digits=2 digits=18 format=xml format=JSON "
        "landmarks=maybe phase=2 models=exact&models=schlick "
        # models and their parameters
        "models= models=, models=exact, models=exakt models=exact,exact models=EXACT "
        "models=../exact lazanyi2005.alpha=7.7 models=schlick&lazanyi2005.alpha=7.7 "
        "models=lazanyi2005&lazanyi2005.alpha=nan models=lazanyi2005&lazanyi2005.alpha=-1 "
        "models=lazanyi2005&lazanyi2005.beta=1 models=lazanyi2005&lazanyi2005__alpha=7 "
        "models=exact&exact.F0=0.04 models=lut_1d&lut_1d.size=2.5 models=lut_1d&lut_1d.bits=12 "
        "models=hoffman_f82&hoffman_f82.F0= models=hoffman_f82&hoffman_f82.F0=1.5 "
        "models=hoffman_f82&hoffman_f82.F0=0.1,0.2 models=hoffman_f82&hoffman_f82.F0=0.1,nan,0.2 "
        "models=hoffman_f82&hoffman_f82.F0=0_1,0,0"
    ),
    "/convert": (
        "from=fzero from=f0&F0=1.5 from=f0&F0=nan from=f0&F0=0.1,0.2 from=f0&F0=0.5&n_t=1.5 "
        "from=ior&n_t=1.5&k_t=2.0 from=ior&n_t=1.5&F0=0.04 from=ior&material=Au "
        "from=f0&F0=0.5&material=Au from=f0_srgb&hex=%2312 "
        "from=f0_srgb&F0_srgb=0.5&hex=%23123456 from=specular&specular=1.01 seen_from=0 to=f0"
    ),
    "/formulas/angle.brewster/curve": "n_t=3",
    "/formulas/albedo.deon_2019_log/curve": "k_t=1",
    "/formulas/model.schlick/curve": "samples=1 samples=2002 n_t=0 n_t=nan theta=3",
    "/formulas": "kind=theorem",
    "/shaders/schlick": "language=metal channels=2 lang=glsl format=png",
    "/shaders": "language=glsl",
    "/errors": (
        "models=shlick models=schlick,schlick n_t=nan model=schlick "
        "models=schlick&lazanyi2005.alpha=7.7 models=lazanyi2005&lazanyi2005.alpha=-1 "
        "models=lut_1d&lut_1d.bits=10"
    ),
    "/errors/sweep": (
        "over=n_i over=n_t&n_t=1.5 over=eta&n_t=1.5 over=k_t&k_t=1 material=Au "
        "maximum=1&minimum=2 minimum=0 maximum=101 over=eta&n_i=50&maximum=3 steps=1 steps=20002 "
        "model=shlick model=hoffman_f82&k_t=3&hoffman_f82.F0=1,1,1"
    ),
    "/errors/map": (
        "y_steps=500&x_steps=501 metric=rms x=n_t&y=k_t&metric=error metric=worst n_t=2 "
        "x_maximum=91 y_maximum=3&y_minimum=3 material=Au"
    ),
    "/recommend": "max_error=0 max_error=2 metric=max_abs_at_deg models=schlick n_t=inf",
    "/albedo": "n_t=0 k_t=-1 n_t=nan foo=1 models=shlick models=, lut_1d.size=8",
    "/albedo/sweep": (
        "over=n_i n_t=2 over=eta&n_t=2 over=k_t&k_t=2 material=gold over=k_t&material=gold "
        "maximum=3&minimum=3 minimum=0 maximum=101 over=eta&n_i=2&maximum=51 "
        "over=k_t&scale=log&minimum=0 steps=1000000000 steps=1 maximum=inf "
        "fits=schlick,schlick fits=deon_2019"
    ),
    "/albedo/map": (
        "k_steps=1000&n_steps=1000 n_minimum=4 k_minimum=9 fit=nothing show=error "
        "fit=dunkle_1963_s&quantity=p"
    ),
    "/albedo/coat": "k_t=1 body_albedo=1.1 theta_i_deg=91",
    "/lut": (
        "size=1 size=4097 size=many bits=12 format=png&bits=32 format=exr&bits=8 format=hdr "
        "over=theta rows=4 minimum=1 over=n_t&rows=4 over=n_t&n_t=1.5 "
        "over=n_t&maximum=2&minimum=3 over=n_t&maximum=200 over=n_t&model=schlick "
        "over=mu,n_t&size=4096&rows=4096 over=mu,k_t&material=Au model=schlik "
        "n_i=1.5&n_t=1&model=cos_form model=schlick&hoffman_f82.F0=0.5 "
        "model=generalized_schlick&generalized_schlick.a=20&bits=8 channels=3 "
        "material=Au&model=schlick&channels=3 channels=3&material=Au&wavelength_nm=600 "
        "channels=3&material=Au&incident=water "
        "channels=2 digits=4"
    ),
    "/materials": "limit=0 limit=1e3 offset=-1 category=gold kind=both page=2 q=" + "x" * 101,
    "/materials/gold": "gamut=bright illuminant=A wavelength_nm=inf wavelength_nm=5e-324",
    "/materials/water-shirley": "wavelength_nm=500",
    "/materials/Au/spectrum": (
        "minimum_nm=299 maximum_nm=24931 maximum_nm=500&minimum_nm=600 minimum_nm=nan step_nm=0 "
        "step_nm=-1 step_nm=5e-324 step_nm=0.1 "
    ),
    "/materials/Au/map": (
        "samples=20001&steps=20001 samples=500&steps=501 incident=Cu "
        "incident=water-shirley incident=water&n_i=1.5 incident=glycerol&minimum_nm=380 quantity=T"
    ),
    "/materials/Au/curves": (
        "incident=glycerol&wavelengths_nm=390 wavelengths_nm= wavelengths_nm=400,,500 "
        "wavelengths_nm=400,400.0 wavelengths_nm=nan wavelengths_nm=1e999 wavelengths_nm=4_00 "
        "wavelengths_nm=red wavelengths_nm=299 wavelengths_nm=24930 samples=20002 samples=1 n_i=0 "
        "models=deon_rg models=nothing models=schlick,schlick rgb=false&gamut=clamped "
        "incident=gold incident=nothing wavelengths_nm="
        + ",".join(map(str, range(300, 400)))
        + "&samples=20001"
    ),
}


# And what was not given may be at fault.
NOT_GIVEN = {
    "/convert?from=f0": "F0",
    "/convert?from=rg&r=0.5": "g",
    "/errors/sweep?over=k_t&scale=log": "minimum",
    "/errors/map?x=n_t": "y",
    "/errors/map?x=eta": "y",
    "/errors/map?x=n_t&y=k_t&model=lut_1d&lut_1d.size=4096": "steps",
    "/lut?channels=3&material=Au&format=png": "bits",  # red above 1, which no integer holds
    "/materials/water-shirley/spectrum": "material",
    "/materials/water-shirley/map": "material",
    "/materials/water-shirley/curves": "material",
    "/materials/Au/map?maximum_nm=24930": "wavelength_nm",
    "/materials/Au/spectrum?minimum_nm=500.01&maximum_nm=500.02": "step_nm",
}


def last_name(target: str) -> str:
    return re.split("[?&]", target)[-1].partition("=")[0]


TARGETS = [f"{path}?{query}" for path, told in REFUSED.items() for query in told.split()]


@pytest.mark.parametrize(
    ("target", "name"), [*((t, last_name(t)) for t in TARGETS), *NOT_GIVEN.items()]
)
def test_a_bad_parameter_is_named(app: FastAPI, target: str, name: str) -> None:
    told = expect_problem(send(app, API + target.encode()), 422)
    assert told["title"].startswith("Unprocessable")  # Entity until Python 3.12, then Content
    assert told["instance"] == API.decode() + target.partition("?")[0]
    assert [error["parameter"] for error in told["errors"]] == [name]
