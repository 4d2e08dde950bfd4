"""An export as it is asked for: the file, or what is said of it."""

from typing import Any

from starlette.responses import Response

from app.answers.materials.export import Export, export, exported_file
from app.api.materials.queries import ExportQuery
from app.export.registry import TARGETS
from app.http.writing import shown_as
from app.materials.schema import Preset

FILES: dict[int | str, dict[str, Any]] = {
    200: {"content": {target.media_type: {} for target in TARGETS.values()}}
}
"""What OpenAPI says of the files."""


def exported(preset: Preset, query: ExportQuery) -> Export | Response:
    """Write a material.

    Raises
    ------
    NotAllowed
        As `export` does.
    """
    asked = (preset, query.to, query.mode, query.policy, query.space, query.film())
    if query.format == "json":
        return export(*asked)
    file = exported_file(*asked)
    media_type = TARGETS[query.to].media_type
    return Response(file.text, headers=shown_as(file.name), media_type=media_type)
