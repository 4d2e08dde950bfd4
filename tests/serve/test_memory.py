"""Where the server's memory comes from."""

import platform
import subprocess
import sys
from pathlib import Path

import pytest

THREADS = """
import ctypes, sys, threading
import numpy as np
from app.server.memory import share_one_heap

if sys.argv[1] == "shared":
    share_one_heap()
meet = threading.Barrier(4)
def allocate():
    kept = [np.ones(1000) for _ in range(10)]
    meet.wait()
threads = [threading.Thread(target=allocate) for _ in range(4)]
for thread in threads:
    thread.start()
for thread in threads:
    thread.join()
library = ctypes.CDLL(None)
library.fopen.restype = ctypes.c_void_p
file = ctypes.c_void_p(library.fopen(sys.argv[2].encode(), b"w"))
library.malloc_info(0, file)
library.fclose(file)
"""


@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="another C library")
def test_threads_share_one_heap(tmp_path: Path) -> None:
    heaps = {}
    for how in ("own", "shared"):
        told = tmp_path / how
        subprocess.run([sys.executable, "-c", THREADS, how, str(told)], check=True)
        heaps[how] = told.read_text("utf-8").count("<heap nr=")
    assert heaps["shared"] == 1 < heaps["own"]


@pytest.mark.skipif(sys.platform != "linux", reason="another C library")
def test_arrow_takes_from_the_same_heap() -> None:
    pytest.importorskip("pyarrow")
    script = """
from app.server.memory import share_one_heap
share_one_heap()
import pyarrow
print(pyarrow.default_memory_pool().backend_name)
"""
    told = subprocess.run(
        [sys.executable, "-c", script], check=True, capture_output=True, text=True
    )
    assert told.stdout.strip() == "system"
