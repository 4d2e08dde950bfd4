"""What the C library is told about memory."""

from __future__ import annotations

import ctypes
import sys
from contextlib import suppress

_M_MMAP_THRESHOLD = -3
_LARGE_BYTES = 1_000_000


def return_large_blocks() -> None:
    """Have large blocks given back to the system as soon as they are free.

    glibc does so at first, but with every large block that is freed it keeps larger ones for later,
    one heap a thread, so that a server would hold more after some large calls than any of them needs.
    Other C libraries are left alone.
    """
    if sys.platform == "linux":
        with suppress(AttributeError, OSError):
            ctypes.CDLL(None).mallopt(_M_MMAP_THRESHOLD, _LARGE_BYTES)
