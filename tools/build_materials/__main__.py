"""Write the generated files, or compare them with what is there."""

import argparse
import sys
from pathlib import Path

from tools.build_materials.files import generated_files

ROOT = Path(__file__).resolve().parents[2]


def differences(root: Path, files: dict[str, str]) -> list[str]:
    """Return the paths that are missing, differ or are left over."""
    there = {
        path.relative_to(root).as_posix() for path in (root / "materials" / "spectra").glob("*")
    }
    changed = [
        name
        for name, text in files.items()
        if not (root / name).is_file() or (root / name).read_bytes() != text.encode()
    ]
    return sorted({*changed, *(there - files.keys())})


def main() -> int:
    """Run the command line; 1 if --check finds a difference."""
    parser = argparse.ArgumentParser(prog="python -m tools.build_materials", description=__doc__)
    parser.add_argument("--check", action="store_true", help="compare instead of writing")
    check = parser.parse_args().check
    files = generated_files(ROOT)
    changed = differences(ROOT, files)
    for name in changed:
        print(name)
        if check:
            continue
        path = ROOT / name
        if name in files:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(files[name].encode())
        else:
            path.unlink()
    return 1 if check and changed else 0


if __name__ == "__main__":
    sys.exit(main())
