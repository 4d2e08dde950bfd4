"""Lookup tables as files: PNG, OpenEXR, NPY."""

import io
from collections.abc import Mapping
from typing import Any

import numpy as np
import OpenEXR
import png
from numpy.typing import DTypeLike, NDArray

from app.answers.lookup import LookupTable
from app.optics.lookup import Depth
from app.optics.parameters import Array

ERROR_HEADER = "Interpolation-Error"
"""Name of the largest error, in the header of an answer and inside pictures."""

MEDIA = {"npy": "application/octet-stream", "png": "image/png", "exr": "image/x-exr"}
"""Types of the files, by their endings."""

_WHOLE: dict[Depth, DTypeLike] = {"unorm8": np.uint8, "unorm16": np.uint16}
_FLOAT: dict[Depth, DTypeLike] = {"half": np.float16, "float": np.float32}


def stored(texels: Array, depth: Depth) -> NDArray[Any]:
    """Quantized texels as what a file holds: integers up to 255 or 65535, or floats."""
    if depth in _FLOAT:
        return texels.astype(_FLOAT[depth])
    return np.rint(texels * (255.0 if depth == "unorm8" else 65535.0)).astype(_WHOLE[depth])


def file_bytes(table: LookupTable, kind: str) -> bytes:
    """Write a table as a file of one of the kinds in `MEDIA`."""
    if kind == "npy":
        return npy_bytes(table.texels, table.depth)
    said = {
        "Title": table.title(),
        "Description": table.reading,
        ERROR_HEADER: f"{table.error.max_abs:g}",
    }
    return (png_bytes if kind == "png" else exr_bytes)(table.pixels, table.depth, said)


def npy_bytes(texels: Array, depth: Depth) -> bytes:
    """Write an array of the texels' shape, as `numpy.load` reads it."""
    file = io.BytesIO()
    np.save(file, stored(texels, depth), allow_pickle=False)
    return file.getvalue()


def png_bytes(texels: Array, depth: Depth, said: Mapping[str, str]) -> bytes:
    """Write gray or RGB pixels, marked as linear, with tEXt chunks in Latin-1."""
    rows, columns, channels = texels.shape
    bits = 8 if depth == "unorm8" else 16
    pixels = stored(texels, depth).astype(">u2" if bits == 16 else "u1")
    plain = io.BytesIO()
    writer = png.Writer(columns, rows, greyscale=channels == 1, bitdepth=bits, gamma=1.0)
    writer.write_packed(plain, [row.tobytes() for row in pixels])
    plain.seek(0)
    chunks = list(png.Reader(file=plain).chunks())
    texts = [(b"tEXt", f"{key}\0{text}".encode("latin-1", "replace")) for key, text in said.items()]
    file = io.BytesIO()
    png.write_chunks(file, [chunks[0], *texts, *chunks[1:]])  # texts may stand anywhere after IHDR
    return file.getvalue()


def exr_bytes(texels: Array, depth: Depth, said: Mapping[str, str]) -> bytes:
    """Write a luminance or RGB image of halves or floats, compressed without loss, with attributes."""
    pixels = stored(texels, depth)
    channels = {"Y": pixels[..., 0]} if texels.shape[-1] == 1 else {"RGB": pixels}
    header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage, **said}
    file = io.BytesIO()
    OpenEXR.File(
        header, {name: np.ascontiguousarray(values) for name, values in channels.items()}
    ).write(file)
    return file.getvalue()
