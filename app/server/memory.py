"""What the C library is told about memory."""

import ctypes
import sys
from contextlib import suppress

_M_ARENA_MAX = -8


def share_one_heap() -> None:
    """Have all threads take memory from one heap.

    glibc gives each thread a heap of its own and keeps in each what was freed there, so that after
    some large calls, computed in this thread and that, a server would hold more than any of them
    needs: a fifth more at the peak. Other C libraries are left alone.
    """
    if sys.platform == "linux":
        with suppress(AttributeError, OSError):
            ctypes.CDLL(None).mallopt(_M_ARENA_MAX, 1)
