"""Where the data files are: in the checkout or inside the installed wheel."""

from pathlib import Path


def data_directory() -> Path:
    """Return the directory that holds `tables/`, `spectra/` and `index.json`.

    An installed wheel carries the data as `app/materials/data`; a checkout keeps it as
    `materials/` beside `app/`.
    """
    here = Path(__file__).resolve().parent
    bundled = here / "data"
    return bundled if bundled.is_dir() else here.parents[1] / "materials"
