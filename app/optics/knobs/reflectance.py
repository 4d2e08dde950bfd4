r"""Knobs of the reflectance at normal incidence.

Those of one number scale F0; those with an index keep it and scale what it reflects. Engines know no
medium in front: their indices are relative to it.

References
----------
.. [1] B. Burley, Physically Based Shading at Disney, SIGGRAPH 2012 course notes.
.. [2] R. Guy and M. Agopian, Physically Based Rendering in Filament.
.. [3] KHR_materials_ior and KHR_materials_specular, extensions of glTF 2.0.
.. [4] OpenPBR Surface specification 1.1.1, dielectric base, and coat.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial

from app.optics.errors import OutOfRange
from app.optics.interface import normal_reflectance
from app.optics.knobs.knob import (
    Input,
    Knob,
    KnobId,
    Read,
    Seen,
    Setting,
    one_of,
    several,
    way_back,
)
from app.optics.parameters import Parameter, share

SPECULAR_F0 = 0.08
REFLECTANCE_F0 = 0.16
LARGEST_ETA = 1e5
"""Beyond it, F0 > 0.99996, there is nothing but a mirror."""

SPECULAR = share("specular", r"\text{specular}", "Specular level, F0 / 0.08.")
FILAMENT = share("reflectance", r"\text{reflectance}", "Filament's reflectance, sqrt(F0 / 0.16).")
REFLECTIVITY = share("reflectivity", r"\text{reflectivity}", "three.js's, sqrt(F0 / 0.16).")
GODOT = share("metallic_specular", r"\text{specular}", "Godot's, sqrt(F0 / 0.16).")


def _number(name: str, symbol: str, description: str, minimum: float = 0.0) -> Parameter:
    return Parameter(name, symbol, None, minimum, 100.0, "", description)


IOR = _number("ior", r"\text{ior}", "An engine's index, relative to the medium in front.")
LEVEL = _number("specular_ior_level", "L", "Blender's Specular IOR Level; twice of it scales F0.")
SPECULAR_IOR = _number("specular_ior", "n_s", "OpenPBR's index, as `ior`.", 1e-3)
WEIGHT = _number("specular_weight", r"\xi_s", "OpenPBR's, which scales F0.")
FACTOR = share("specularFactor", "f", "glTF's, which scales F0 and F90.")
COLOR_FACTOR = replace(
    _number("specularColorFactor", "c", "glTF's, linear, which scales F0."), triple=True
)


def of_index(eta: float) -> float:
    """F0 of a relative index."""
    return float(normal_reflectance(1.0, eta, 0.0))


def index_of(F0: float, side: float = 1.0) -> float:
    """Relative index of an F0: above 1, or below for `side` = -1."""
    root = math.copysign(math.sqrt(F0), side)
    return (1.0 + root) / (1.0 - root) if root < 1.0 else math.inf


def _write_scaled(
    parameter: Parameter, largest: float, power: int, seen: Sequence[Seen]
) -> Setting:
    values = [(one.F0 / largest) ** (1.0 / power) for one in seen]
    value = one_of(values)
    if value is None:
        return Setting({parameter.name: None}, "infeasible", several(parameter.name, values))
    if value > 1.0 + 1e-12:
        why = f"F0 = {seen[0].F0:.4g} is above {largest:g}: it would have to be {value:.3g}"
        return Setting({parameter.name: None}, "infeasible", why)
    return Setting({parameter.name: min(value, 1.0)}, *way_back(seen))


def _scaled(
    id: KnobId,  # noqa: A002
    title: str,
    given: Input,
    largest: float,
    power: int,
    *,
    reference: str,
    read: Callable[[float], Read] | None = None,
    engines: tuple[str, ...] = (),
) -> Knob:
    """Make a knob whose power is a share of the largest F0."""
    raised = "" if power == 1 else f"^{power}"
    return Knob(
        id=id,
        title=title,
        inputs=(given,),
        latex=rf"F_0={largest:g}\,{given.parameter.symbol}{raised}",
        reference=reference,
        read=read or (lambda value: Read(largest * value**power)),
        write=partial(_write_scaled, given.parameter, largest, power),
        engines=engines,
    )


def _read_reflectivity(value: float) -> Read:
    return Read(REFLECTANCE_F0 * value * value, (1.0 + 0.4 * value) / (1.0 - 0.4 * value))


def _read_blender(ior: float, level: float) -> Read:
    eta = max(ior, 1e-5)
    if level == 0.5:
        return Read(of_index(eta), eta)
    F0 = min(2.0 * level * of_index(eta), 1.0)
    eta = index_of(F0, eta - 1.0)
    lost = "which IOR and Specular IOR Level made this F0 is lost"
    return Read(F0, eta if eta <= LARGEST_ETA else None, lost)


def _read_openpbr(specular_ior: float, weight: float) -> Read:
    F0 = min(weight * of_index(specular_ior), 1.0)
    eta = index_of(F0, specular_ior - 1.0)
    lost = "" if weight == 1.0 else "which specular_ior and specular_weight made this F0 is lost"
    return Read(F0, eta if eta <= LARGEST_ETA else None, lost)


def _read_gltf(ior: float, factor: float, color: float) -> Read:
    if 0.0 < ior < 1.0:
        raise OutOfRange(IOR.name, ior, "0, which glTF takes for infinite, or a number from 1 on")
    of_ior = 1.0 if ior == 0.0 else of_index(ior)
    F0 = min(of_ior * color, 1.0) * factor
    if factor != 1.0:
        return Read(F0, None, "specularFactor is F90 as well, which no other knob lowers")
    if color != 1.0:
        return Read(F0, None, "which ior and specularColorFactor made this F0 is lost")
    return Read(F0, ior or None)


def _write_index(index: Parameter, level: Input, seen: Sequence[Seen]) -> Setting:
    """Type the index, and leave what scales it as it is."""
    values = [one.eta for one in seen]
    neutral = {level.parameter.name: level.default}
    eta = one_of(values)
    if eta is None:
        return Setting({index.name: None, **neutral}, "infeasible", several(index.name, values))
    if not eta <= index.maximum:
        why = f"F0 = {seen[0].F0:.6g} would need an index of {eta:.3g}"
        return Setting({index.name: None, **neutral}, "infeasible", why)
    status, why = way_back(seen)
    if all(one.is_index and not one.absorbs and not one.lost for one in seen):
        status, why = "exact", "the relative index itself"
    return Setting({index.name: eta, **neutral}, status, why)


def _write_gltf(seen: Sequence[Seen]) -> Setting:
    """Type the index of the brightest channel, and the others as a color."""
    brightest = max(seen, key=lambda one: one.F0)
    eta = max(brightest.eta, 1.0 / brightest.eta)
    status, why = way_back(seen)
    whole = 1.0 if eta > IOR.maximum else brightest.F0
    if eta > IOR.maximum:
        eta, why = 0.0, f"{why}; an ior of 0 stands for infinite, and the color is F0 then"
    elif one_of([one.F0 for one in seen]) is None:
        why = f"{why}; ior is that of the brightest channel, the color what the others are of it"
    elif all(one.is_index and one.eta >= 1.0 and not one.absorbs and not one.lost for one in seen):
        why = "the relative index itself"
    colors = tuple(one.F0 / whole if whole else 1.0 for one in seen)
    color = colors[0] if len(colors) == 1 else colors
    return Setting({IOR.name: eta, FACTOR.name: 1.0, COLOR_FACTOR.name: color}, status, why)


_SLIDER = "its slider ends there"
_OF_LEVEL = Input(
    "Specular IOR Level",
    LEVEL,
    0.5,
    (0.0, 1.0),
    "only the slider ends: twice of it scales F0, which is cut to 1",
)
_OF_WEIGHT = Input(
    "specular_weight", WEIGHT, 1.0, (0.0, None), "F0 is cut to 1 by its specification"
)

KNOBS: tuple[Knob, ...] = (
    Knob(
        id="blender",
        title="Blender, Principled BSDF",
        inputs=(
            Input(
                "IOR",
                IOR,
                1.5,
                (1.0, 1000.0),
                "only the slider ends: less than 1 is kept, and totally reflects as the thinner medium",
            ),
            _OF_LEVEL,
        ),
        latex=r"F_0=2L\left(\frac{\text{ior}-1}{\text{ior}+1}\right)^2",
        reference="Blender 5.2.3, Cycles",
        read=_read_blender,
        write=partial(_write_index, IOR, _OF_LEVEL),
        engines=("cycles",),
    ),
    Knob(
        id="gltf",
        title="glTF, ior and specular",
        inputs=(
            Input(
                "ior",
                IOR,
                1.5,
                (1.0, None),
                "less than 1, but for 0, is an error to the validator; 0 stands for infinite",
            ),
            Input("specularFactor", FACTOR, 1.0, (0.0, 1.0), "more is an error to the validator"),
            Input(
                "specularColorFactor",
                COLOR_FACTOR,
                1.0,
                (0.0, None),
                "its product with the F0 of ior is cut to 1",
            ),
        ),
        latex=r"F_0=f\min\left(c\left(\frac{\text{ior}-1}{\text{ior}+1}\right)^2,1\right)",
        reference="KHR_materials_ior and KHR_materials_specular, extensions of glTF 2.0",
        read=_read_gltf,
        write=_write_gltf,
        engines=("three", "filament"),
    ),
    Knob(
        id="openpbr",
        title="OpenPBR, specular",
        inputs=(
            Input(
                "specular_ior", SPECULAR_IOR, 1.5, (1.0, 3.0), "only the slider ends: it is above 0"
            ),
            _OF_WEIGHT,
        ),
        latex=r"F_0=\min\left(\xi_s\left(\frac{n_s-1}{n_s+1}\right)^2,1\right)",
        reference="OpenPBR Surface specification 1.1.1, dielectric base",
        read=_read_openpbr,
        write=partial(_write_index, SPECULAR_IOR, _OF_WEIGHT),
        engines=("babylon",),
    ),
    _scaled(
        "three",
        "three.js, reflectivity",
        Input(
            "reflectivity",
            REFLECTIVITY,
            0.5,
            (0.0, 1.0),
            "it sets ior = (1 + 0.4 r) / (1 - 0.4 r), is read back as 1 at most, and is what a file "
            "keeps: no ior above 2.333",
        ),
        REFLECTANCE_F0,
        2,
        reference="three.js 0.187.0, MeshPhysicalMaterial",
        read=_read_reflectivity,
        engines=("three",),
    ),
    _scaled(
        "reflectance",
        "Filament, reflectance",
        Input("reflectance", FILAMENT, 0.5, (0.0, 1.0), _SLIDER),
        REFLECTANCE_F0,
        2,
        reference="R. Guy and M. Agopian, Physically Based Rendering in Filament",
    ),
    _scaled(
        "specular",
        "Disney, specular",
        Input("specular", SPECULAR, 0.5, (0.0, 1.0), _SLIDER),
        SPECULAR_F0,
        1,
        reference="B. Burley, Physically Based Shading at Disney, SIGGRAPH 2012 course notes",
    ),
    _scaled(
        "unreal",
        "Unreal, Specular",
        Input("Specular", SPECULAR, 0.5, (0.0, 1.0), _SLIDER),
        SPECULAR_F0,
        1,
        reference="Unreal Engine, Physically Based Materials; DielectricSpecularToF0 of its shaders",
    ),
    _scaled(
        "godot",
        "Godot, metallic_specular",
        Input("metallic_specular", GODOT, 0.5, (0.0, 1.0), _SLIDER),
        REFLECTANCE_F0,
        2,
        reference="Godot Engine 4, scene_forward_lights_inc.glsl",
    ),
)
"""Every knob of the reflectance; the order is that of the answers."""
