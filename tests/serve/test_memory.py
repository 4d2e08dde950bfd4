"""Memory that large calls needed is given back."""

from __future__ import annotations

import platform
import subprocess
import sys

import pytest

HELD_MB = """
import sys
from pathlib import Path
import numpy as np
from app.memory import return_large_blocks

if sys.argv[1] == "return":
    return_large_blocks()
np.ones(2_000_000)  # freed at once, as the first large call would
blocks = [(np.ones(1_000_000), np.ones(10_000)) for _ in range(10)]
kept = [small for _, small in blocks]
del blocks
print(next(s for s in Path("/proc/self/status").read_text().splitlines() if "VmRSS" in s).split()[1])
"""


@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="another C library")
def test_large_blocks_are_given_back_though_small_ones_lie_between() -> None:
    held = {}
    for how in ("keep", "return"):
        command = [sys.executable, "-c", HELD_MB, how]
        ended = subprocess.run(command, capture_output=True, text=True, check=True)
        held[how] = int(ended.stdout) / 1000.0
    assert held["return"] < held["keep"] - 8.0  # of the first block's 16 MB
