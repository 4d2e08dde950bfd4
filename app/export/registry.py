"""All targets of export."""

from collections.abc import Mapping

from app.export.target import Target, TargetId
from app.export.targets.blender import BLENDER
from app.export.targets.gltf import GLTF
from app.export.targets.luxcore import LUXCORE
from app.export.targets.materialx import MATERIALX, OPENPBR
from app.export.targets.mitsuba import MITSUBA
from app.export.targets.pbrt import PBRT
from app.export.targets.usd import USD

TARGETS: Mapping[TargetId, Target] = {
    target.id: target for target in (MATERIALX, OPENPBR, GLTF, USD, BLENDER, MITSUBA, PBRT, LUXCORE)
}
