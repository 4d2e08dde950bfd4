"""Fill static/vendor from the npm packages that package-lock.json pins.

Every package gets a folder with its version in the name, so that the server may tell browsers to
keep these files for ever. The files are copied unchanged, but for the page's font, which is cut to
what the page shows and renamed, and a line for the type checker beside lit-html. `manifest.json`
records where each came from, under which licence, and its SHA-256. Run it by `make vendor` after
changing a version.
"""

import hashlib
import json
import shutil
import subprocess
import tarfile
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from fontTools.subset import Options, Subsetter
from fontTools.ttLib import TTFont
from fontTools.varLib.instancer import instantiateVariableFont

ROOT = Path(__file__).resolve().parent.parent
NODE_MODULES = ROOT / "node_modules"
VENDOR = ROOT / "static" / "vendor"


@dataclass(frozen=True)
class Package:
    """What is taken from one npm package: glob patterns inside it, each with its target folder."""

    name: str
    npm: str
    licence_file: str
    files: dict[str, str]

    @property
    def source(self) -> Path:
        """The installed package."""
        return NODE_MODULES / self.npm

    @property
    def metadata(self) -> dict[str, Any]:
        """The installed package's package.json."""
        content: dict[str, Any] = json.loads((self.source / "package.json").read_text("utf-8"))
        return content

    @property
    def folder(self) -> Path:
        """Where its files go."""
        return VENDOR / f"{self.name}-{self.metadata['version']}"


PLOTLY = Package(
    "plotly-cartesian",
    "plotly.js-cartesian-dist-min",
    "LICENSE",
    {"plotly-cartesian.min.js": "."},
)
# IBM Plex Sans, under a name of its own: "Plex" is reserved by its licence for what is not changed.
FONT = Package(
    "fresnel-sans",
    "@fontsource-variable/ibm-plex-sans",
    "LICENSE",
    {},  # cut below
)
# The build that node may load too, where modules are tested that hold templates.
LIT = Package("lit-html", "lit-html", "LICENSE", {"node/lit-html.js": "."})
PACKAGES = (
    PLOTLY,
    LIT,
    Package(
        "katex",
        "katex",
        "LICENSE",
        {
            "dist/katex.min.js": ".",
            "dist/katex.min.css": ".",
            # Browsers take the first format they know: the woff and ttf twins go unused.
            "dist/fonts/*.woff2": "fonts",
        },
    ),
    FONT,
    Package(
        "swagger-ui",
        "swagger-ui-dist",
        "LICENSE",
        {
            "NOTICE": ".",
            "swagger-ui-bundle.js": ".",
            "swagger-ui-bundle.js.LICENSE.txt": ".",  # of what is inside the bundle
            "swagger-ui.css": ".",
        },
    ),
)


def copy(package: Package) -> None:
    """Copy the package's files and its licence text."""
    patterns = {package.licence_file: ".", **package.files}
    for pattern, target in patterns.items():
        sources = sorted(package.source.glob(pattern))
        if not sources:
            raise FileNotFoundError(f"{package.npm} has no {pattern}: run npm ci")
        folder = package.folder / target
        folder.mkdir(parents=True, exist_ok=True)
        for source in sources:
            shutil.copyfile(source, folder / source.name)


def copy_plotly_stylesheet() -> None:
    """Take plotly.css of the same version from the package `plotly.js`.

    The bundle would otherwise inject these rules as an inline style, which the page's
    Content-Security-Policy forbids. The package is unpacked, not installed: it brings hundreds of
    dependencies that nothing here needs.
    """
    with tempfile.TemporaryDirectory() as scratch:
        package = f"plotly.js@{PLOTLY.metadata['version']}"
        subprocess.run(
            ["npm", "pack", "--silent", "--pack-destination", scratch, package],
            check=True,
            stdout=subprocess.DEVNULL,
        )
        (archive,) = Path(scratch).glob("*.tgz")
        with tarfile.open(archive) as tar:
            stylesheet = tar.extractfile("package/dist/plotly.css")
            if stylesheet is None:
                raise FileNotFoundError(f"{package} has no dist/plotly.css")
            (PLOTLY.folder / "plotly.css").write_bytes(stylesheet.read())


def declare_lit() -> None:
    """Tell the type checker that the copy has the types of the installed package."""
    (LIT.folder / "lit-html.d.ts").write_text('export * from "lit-html";\n', "utf-8")


# The weights and characters in use, with the letters of western names. Who changes them changes the
# name of the file too: browsers keep it for ever.
FONT_SOURCE = "files/ibm-plex-sans-latin-wght-normal.woff2"
FONT_CUT = "fresnel-sans-latin-400-700.woff2"
FONT_NAME = "Fresnel Sans"
FONT_WEIGHTS = (400, 700)
FONT_CHARACTERS = (
    *map(chr, range(0x20, 0x7F)),
    *map(chr, range(0xC0, 0x100)),
    *"\u00a0°±²³µ·ıŒœ–—‘’“”…′″↑↓−",
)


def cut_font() -> None:
    """Cut the font of the page, half of whose bytes are thin weights and characters never shown."""
    with TTFont(FONT.source / FONT_SOURCE, recalcTimestamp=False) as font:
        # Variable fonts are mostly sent without hints: today's rasterizers do as well without them.
        # Kerning is a third of the bytes and hardly seen in words of 14 px.
        names = [*range(7), 13, 14]  # what it is called, by whom it is, and its licence
        subsetter = Subsetter(Options(layout_features=[], hinting=False, name_IDs=names))
        subsetter.populate(text="".join(FONT_CHARACTERS))
        subsetter.subset(font)
        instantiateVariableFont(font, {"wght": FONT_WEIGHTS}, inplace=True)
        rename(font)
        font.flavor = "woff2"
        font.save(FONT.folder / FONT_CUT)


def rename(font: TTFont) -> None:
    """Take the reserved name out of everything that the font calls itself."""
    for record in font["name"].names:
        text = record.toUnicode()
        for theirs in ("IBM Plex Sans", "IBMPlexSans"):
            ours = FONT_NAME if " " in theirs else FONT_NAME.replace(" ", "")
            text = text.replace(theirs, ours)
        record.string = text


def describe(package: Package) -> dict[str, Any]:
    """Make the package's entry in the manifest."""
    files = sorted(path for path in package.folder.rglob("*") if path.is_file())
    return {
        "name": package.name,
        "npm": package.npm,
        "version": package.metadata["version"],
        "licence": package.metadata["license"],
        "licence_file": f"{package.folder.name}/{package.licence_file}",
        "files": {
            path.relative_to(VENDOR).as_posix(): {
                "sha256": hashlib.sha256(path.read_bytes()).hexdigest(),
                "bytes": path.stat().st_size,
            }
            for path in files
        },
    }


def main() -> None:
    """Rebuild static/vendor from nothing."""
    shutil.rmtree(VENDOR, ignore_errors=True)
    for package in PACKAGES:
        copy(package)
    copy_plotly_stylesheet()
    declare_lit()
    cut_font()
    manifest = {"packages": [describe(package) for package in PACKAGES]}
    (VENDOR / "manifest.json").write_text(json.dumps(manifest, indent=2) + "\n", "utf-8")
    for entry in manifest["packages"]:
        size = sum(file["bytes"] for file in entry["files"].values())
        print(f"{entry['name']} {entry['version']}: {len(entry['files'])} files, {size:,} bytes")


if __name__ == "__main__":
    main()
