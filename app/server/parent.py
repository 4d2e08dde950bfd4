"""A process that was started by another one does not outlive it."""

import threading
from collections.abc import Callable
from multiprocessing import parent_process


def when_parent_is_gone(do: Callable[[], None]) -> None:
    """Call a function, in a thread of its own, once the process that started this one has ended.

    However it ended: the system closes its end of a pipe. In a process that `multiprocessing` did
    not start, nothing is done.
    """
    parent = parent_process()
    if parent is None:
        return

    def wait() -> None:
        parent.join()
        do()

    threading.Thread(target=wait, name="parent", daemon=True).start()
