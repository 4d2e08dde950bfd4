"""`fresnel-explorer evaluate`: files of rows, on this machine and on a cluster."""

import re
import subprocess
import sys
from pathlib import Path

import distributed
import numpy as np
import pyarrow as pa
import pyarrow.csv
import pyarrow.parquet
import pytest
from typer.testing import CliRunner

from app.cli.main import cli
from app.materials.media import default_catalog
from tests.optics.reference.fresnel import fresnel

ROWS = """\
n_t,k_t,theta_i_deg,model,quantity,pixel
1.5,,0,,,7
0.27,2.9,60,exact,Rp,8
1.5,0,60,schlick,,9
-3,0,60,,,10
"""


def run(*arguments: object) -> tuple[int, str]:
    result = CliRunner().invoke(cli, ["evaluate", *map(str, arguments)], env={"COLUMNS": "200"})
    return result.exit_code, re.sub(r"[│╭╮╰╯─]+|\s+", " ", result.output)


def read(path: Path) -> pa.Table:
    if path.suffix == ".csv":
        options = pa.csv.ConvertOptions(strings_can_be_null=True)
        return pa.csv.read_csv(path, convert_options=options)
    return pa.parquet.read_table(path)


@pytest.fixture
def rows(tmp_path: Path) -> Path:
    path = tmp_path / "rows.csv"
    path.write_text(ROWS)
    return path


@pytest.mark.parametrize("suffix", [".csv", ".parquet"])
def test_values_and_errors_are_added(rows: Path, suffix: str) -> None:
    output = rows.with_name(f"out{suffix}")
    code, printed = run(rows, "--output", output, "--keep", "pixel")
    assert code == 1
    assert "4 rows in" in printed
    assert "1 of them are wrong" in printed
    table = read(output)
    assert table.schema.names[-3:] == ["pixel", "value", "error"]
    values = table["value"].to_pylist()
    assert values[0] == pytest.approx(0.04, rel=1e-12)
    assert values[1] == pytest.approx(float(fresnel(1.0, 0.27, 2.9, 60.0).Rp), rel=1e-12)
    assert values[2] == pytest.approx(0.04 + 0.96 / 32, rel=1e-12)
    assert values[3] is None
    assert table["error"].to_pylist()[:3] == [None] * 3
    assert table["error"].to_pylist()[3].startswith("n_t = -3.0: ")


def test_a_table_of_n_and_k_over_the_wavelength_is_evaluated(tmp_path: Path) -> None:
    path = tmp_path / "gold.csv"
    path.write_text("wavelength_nm,n_t,k_t\n550,0.4,2.4\n600,0.25,3\n")
    assert run(path)[0] == 0
    table = read(path.with_name("gold-evaluated.csv"))
    expected = [float(fresnel(1.0, n, k, 0.0).R) for n, k in ((0.4, 2.4), (0.25, 3.0))]
    assert table["value"].to_pylist() == pytest.approx(expected, rel=1e-12)


def test_an_unknown_column_is_told_every_known_one(tmp_path: Path) -> None:
    path = tmp_path / "rows.csv"
    path.write_text("zzzzzz\n1\n")
    printed = run(path)[1]
    for name in ("n_t", "wavelength_nm", "model", "quantity", "material", "incident"):
        assert re.search(rf"\b{name}\b", printed), name


@pytest.mark.parametrize("suffix", [".csv", ".parquet"])
def test_presets_in_columns(tmp_path: Path, suffix: str) -> None:
    table = pa.table(
        {
            "material": ["Au", "Au", None, "nope", "BK7"],
            "incident": [None, "water", "water", None, "vacuum-shirley"],
            "wavelength_nm": pa.array([500.0, None, 500.0, 500.0, 1.0]),
            "n_t": pa.array([None, None, 2.0, None, None], pa.float64()),
            "theta_i_deg": [0.0, 30.0, 60.0, 10.0, 0.0],
        }
    )
    if suffix == ".parquet":  # as pandas writes categories
        table = table.set_column(0, "material", table["material"].dictionary_encode())
    path = tmp_path / f"rows{suffix}"
    (pa.csv.write_csv if suffix == ".csv" else pa.parquet.write_table)(table, path)
    assert run(path)[0] == 1
    answered = read(tmp_path / f"rows-evaluated{suffix}")
    known = default_catalog().constants
    gold, gold_d = known("Au", 500.0), known("Au")
    water, water_d = known("water", 500.0), known("water")
    assert gold.k is not None
    assert gold_d.k is not None
    expected = [
        fresnel(1.0, gold.n, gold.k, 0.0),
        fresnel(water_d.n, gold_d.n, gold_d.k, 30.0),
        fresnel(water.n, 2.0, 0.0, 60.0),
    ]
    values, errors = answered["value"].to_pylist(), answered["error"].to_pylist()
    assert values[:3] == [pytest.approx(float(ray.R), rel=1e-12) for ray in expected]
    assert values[3:] == [None, None]
    assert errors[3].startswith("material = nope: ")
    assert errors[4].startswith("wavelength_nm = 1.0: 300 to ")


def test_parquet_in_many_batches_keeps_the_order(tmp_path: Path) -> None:
    theta = np.linspace(0.0, 90.0, 200_001)
    path = tmp_path / "rows.parquet"
    pa.parquet.write_table(pa.table({"theta_i_deg": theta, "n_t": np.full(theta.size, 2.0)}), path)
    assert run(path)[0] == 0
    table = read(tmp_path / "rows-evaluated.parquet")
    assert table["theta_i_deg"].to_pylist() == theta.tolist()
    for at in (0, 65_536, 131_073, 200_000):
        expected = float(fresnel(1.0, 2.0, 0.0, float(theta[at])).R)
        assert table["value"][at].as_py() == pytest.approx(expected, rel=1e-12)


def test_what_cannot_be_read_is_told(rows: Path, tmp_path: Path) -> None:
    code, printed = run(rows)
    assert (code, "pixel" in printed, "--keep" in printed or "unknown" in printed) == (
        2,
        True,
        True,
    )
    assert run(rows, "--keep", "other")[0] == 2
    assert run(tmp_path / "none.csv")[0] == 2
    assert run(rows, "--output", tmp_path / "x.txt", "--keep", "pixel")[0] == 2
    words = tmp_path / "words.csv"
    words.write_text("n_t\n1.5\nglass\n")
    code, printed = run(words)
    assert (code, "glass" in printed) == (1, True)
    nothing = tmp_path / "nothing.parquet"
    nothing.write_bytes(b"nothing")
    assert run(nothing)[0] == 1
    assert not list(tmp_path.glob("*evaluated*"))
    assert "Traceback" not in printed


def test_nothing_is_overwritten_unasked(rows: Path) -> None:
    output = rows.with_name("out.csv")
    output.write_text("mine")
    code, printed = run(rows, "--output", output, "--keep", "pixel")
    assert (code, "--force" in printed, output.read_text()) == (2, True, "mine")
    assert run(rows, "--output", output, "--keep", "pixel", "--force")[0] == 1
    assert output.read_text() != "mine"


def test_on_a_cluster(rows: Path) -> None:
    with distributed.LocalCluster(
        n_workers=1, threads_per_worker=2, processes=False, dashboard_address=None
    ) as cluster:
        address = cluster.scheduler_address
        remote = rows.with_name("remote.parquet")
        assert run(rows, "--output", remote, "--keep", "pixel", "--scheduler", address)[0] == 1
    here = rows.with_name("here.parquet")
    assert run(rows, "--output", here, "--keep", "pixel")[0] == 1
    assert read(remote).equals(read(here))


def test_a_scheduler_that_is_not_there(rows: Path) -> None:
    code, printed = run(rows, "--keep", "pixel", "--scheduler", "tcp://127.0.0.1:9")
    assert code == 1
    assert "127.0.0.1:9" in printed


def test_memory_does_not_grow_with_the_file(tmp_path: Path) -> None:
    """Ten times the rows, a third more memory at most."""
    peaks = []
    for count in (200_000, 2_000_000):
        path = tmp_path / f"{count}.parquet"
        table = pa.table({"theta_i_deg": np.linspace(0.0, 90.0, count)})
        pa.parquet.write_table(table, path, row_group_size=100_000)
        code = (
            "import sys, resource; from app.cli.main import cli\n"
            "try: cli(sys.argv[1:])\n"
            "except SystemExit: print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)"
        )
        command = [sys.executable, "-c", code, "evaluate", str(path)]
        ended = subprocess.run(command, capture_output=True, text=True, check=True)
        peaks.append(int(ended.stdout.splitlines()[-1]))
    assert peaks[1] < 1.33 * peaks[0]
