"""`python -m tools.exports` checks all exports with all libraries; with names, those alone.

Each library's line tells how many files it read, how many it found wrong, what it warned of, and, where
it evaluates the material, how far its reflectance is from what the answer says. Packages are installed
below the folder that FRESNEL_LIBRARIES names, else below a temporary one.
"""

from __future__ import annotations

import json
import os
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

from app.export.registry import TARGETS
from tools.exports.checking import checked
from tools.exports.libraries import LIBRARIES, command


def main(names: list[str]) -> int:
    """Check, and print a line a library; 1 if a file is wrong."""
    known = [library.package for library in LIBRARIES]
    if unknown := set(names) - set(known):
        print(f"{', '.join(sorted(unknown))}: known are {', '.join(known)}", file=sys.stderr)
        return 2
    unread = set(TARGETS) - {target for library in LIBRARIES for target in library.targets}
    print(f"{', '.join(sorted(unread))}: no library of Python's index or npm reads these alone")
    wrong = False
    with TemporaryDirectory() as temporary:
        libraries = Path(os.environ.get("FRESNEL_LIBRARIES", temporary))
        for library in LIBRARIES:
            if names and library.package not in names:
                continue
            answer = checked(library, command(library, libraries))
            print(f"{library.package} {library.version}: {json.dumps(answer, ensure_ascii=False)}")
            wrong |= bool(answer["errors"])
    return int(wrong)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
