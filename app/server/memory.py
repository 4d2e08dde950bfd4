"""What the C library is told about memory."""

import ctypes
import os
import sys
from contextlib import suppress

_M_ARENA_MAX = -8
_M_MMAP_THRESHOLD, _LARGE = -3, 8_000_000
_M_TRIM_THRESHOLD, _KEPT = -1, 32_000_000


def give_back() -> None:
    """Give the system what the heap keeps of freed memory, holes between what is used among it.

    It takes some milliseconds, and is for when a large call has ended. Other C libraries than glibc
    are left alone.
    """
    if sys.platform == "linux":
        with suppress(AttributeError, OSError):
            ctypes.CDLL(None).malloc_trim(0)


def share_one_heap() -> None:
    """Have all threads take memory from one heap.

    glibc gives each thread a heap of its own and keeps in each what was freed there, so that after
    some large calls, computed in this thread and that, a server would hold more than any of them
    needs: a fifth more at the peak. What is large is taken from the system and given back; else a body
    that grows would leave holes of all the sizes that it had. Arrow has a heap of its own as well,
    which keeps what was freed in it, 85 MB after one answer; it is told to take from this one, before
    it is imported. Other C libraries are left alone.
    """
    if sys.platform == "linux":
        os.environ.setdefault("ARROW_DEFAULT_MEMORY_POOL", "system")
        with suppress(AttributeError, OSError):
            library = ctypes.CDLL(None)
            library.mallopt(_M_ARENA_MAX, 1)
            library.mallopt(_M_MMAP_THRESHOLD, _LARGE)
            library.mallopt(_M_TRIM_THRESHOLD, _KEPT)
