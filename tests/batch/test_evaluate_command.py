"""`fresnel-explorer evaluate`: files of rows, on this machine and on a cluster."""

import re
import signal
import subprocess
import sys
import time
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


@pytest.mark.parametrize("suffix", [".csv", ".parquet"])
def test_angles_of_a_file_may_be_in_radians(tmp_path: Path, suffix: str) -> None:
    path = tmp_path / f"angles{suffix}"
    table = pa.table({"n_t": [1.5, 2.0], "theta_i_rad": [1.0, 0.25]})
    (pa.csv.write_csv if suffix == ".csv" else pa.parquet.write_table)(table, path)
    assert run(path)[0] == 0
    values = read(path.with_name(f"angles-evaluated{suffix}"))["value"].to_pylist()
    degrees = np.degrees([1.0, 0.25])
    expected = [float(fresnel(1.0, n, 0.0, a).R) for n, a in zip((1.5, 2.0), degrees, strict=True)]
    assert values == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize("suffix", [".csv", ".parquet"])
def test_values_have_the_digits_asked_for(rows: Path, suffix: str) -> None:
    output = rows.with_name(f"out{suffix}")
    run(rows, "--output", output, "--keep", "pixel", "--digits", 5)
    exact = float(fresnel(1.0, 0.27, 2.9, 60.0).Rp)
    assert read(output)["value"].to_pylist() == [0.04, float(f"{exact:.5g}"), 0.07, None]


@pytest.mark.parametrize("digits", ["2", "18", "five", "5.5"])
def test_digits_that_cannot_be_are_told(rows: Path, digits: str) -> None:
    code, printed = run(rows, "--digits", digits)
    assert code == 2
    assert f"'--digits': {digits}: " in printed
    assert printed.rstrip().endswith("allowed: 3 to 17")
    assert not rows.with_name("rows-evaluated.csv").exists()


def test_an_unknown_column_is_told_every_known_one(tmp_path: Path) -> None:
    path = tmp_path / "rows.csv"
    path.write_text("n_tt\n1\n")
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
    empty = tmp_path / "empty.csv"
    empty.touch()
    assert run(empty)[0] == 1
    nothing = tmp_path / "nothing.parquet"
    nothing.write_bytes(b"nothing")
    assert run(nothing)[0] == 1
    assert not list(tmp_path.glob("*evaluated*"))
    assert "Traceback" not in printed


def test_a_column_that_is_there_twice_is_told(tmp_path: Path) -> None:
    path = tmp_path / "rows.csv"
    path.write_text("n_t,pixel,pixel\n1.5,1,2\n")
    for arguments in ((), ("--keep", "pixel")):
        code, printed = run(path, *arguments)
        assert (code, "pixel: there twice" in printed) == (2, True)
    pq = tmp_path / "rows.parquet"
    pa.parquet.write_table(pa.table([[1.5], [1], [2]], ["n_t", "pixel", "pixel"]), pq)
    code, printed = run(pq, "--keep", "pixel")
    assert (code, "pixel: there twice" in printed) == (2, True)


BAD_CELLS = """\
n_t,k_t,model,pixel
1.5,0,,"two
lines"

glass,0,,b
1.5,,schlick,c
1.5,0
1.5,1_0,,e
1.5,0,,"f
2.0,0,,g
-1,0,,h
"""


def test_a_row_that_cannot_be_read_is_told_with_its_line_and_the_others_are_answered(
    tmp_path: Path,
) -> None:
    path = tmp_path / "rows.csv"
    path.write_bytes(BAD_CELLS.encode() + b"1.5,0,,\xff\n")
    code, printed = run(path, "--keep", "pixel")
    assert code == 1
    table = read(tmp_path / "rows-evaluated.csv")
    glass = pytest.approx(0.04, rel=1e-12)
    two = pytest.approx(1.0 / 9.0, rel=1e-12)
    assert table["value"].to_pylist() == [glass, None, glass, None, None, None, two, None, None]
    assert table["pixel"].to_pylist() == ["two\nlines", "b", "c", None, "e", None, "g", "h", None]
    wrong = [
        (5, "n_t = glass: no number"),
        (7, "row = 1.5,0: 2 cells where the header has 4"),
        (8, "k_t = 1_0: no number"),
        (9, 'row = 1.5,0,,"f: '),
        (11, "n_t = -1.0: "),
        (12, "row = 1.5,0,,\N{REPLACEMENT CHARACTER}: no UTF-8"),
    ]
    told = [error for error in table["error"].to_pylist() if error is not None]
    for error, (line, start) in zip(told, wrong, strict=True):
        assert error.startswith(start)
        assert f"rows.csv, line {line}: {start}" in printed
    assert "9 rows in" in printed
    assert "6 of them are wrong" in printed


def test_a_wrong_cell_far_down_costs_one_row(tmp_path: Path) -> None:
    """Beyond the first block, whose size no row's end fits."""
    count, at = 700_000, 654_321
    cells = ["1.500000"] * count
    cells[at] = "glass"
    path = tmp_path / "rows.csv"
    path.write_text("\n".join(["n_t", *cells]))
    code, printed = run(path, "--output", tmp_path / "out.parquet")
    assert (code, f"line {at + 2}: n_t = glass: no number" in printed) == (1, True)
    table = read(tmp_path / "out.parquet")
    assert table.num_rows == count
    assert [table[name].null_count for name in ("value", "error")] == [1, count - 1]
    assert table["value"][at].as_py() is None


@pytest.mark.parametrize("encoding", ["latin-1", "utf-16"])
def test_a_header_that_is_no_utf_8_is_told(tmp_path: Path, encoding: str) -> None:
    path = tmp_path / "rows.csv"
    path.write_text("n_t;Wellenlänge\n1,5;550\n", encoding)
    code, printed = run(path)
    assert (code, "save the file as CSV in UTF-8" in printed) == (1, True)


def test_rows_of_parquet_are_told_by_number(tmp_path: Path) -> None:
    path = tmp_path / "rows.parquet"
    n_t = np.full(70_000, 1.5)
    n_t[[66_000, 69_999]] = -1.0
    pa.parquet.write_table(pa.table({"n_t": n_t}), path)
    code, printed = run(path)
    assert code == 1
    assert "row 66001: n_t = -1.0" in printed
    assert "row 70000: n_t = -1.0" in printed


def test_many_wrong_rows_are_counted(tmp_path: Path) -> None:
    path = tmp_path / "rows.csv"
    path.write_text("n_t\n" + "x\n" * 5000)
    printed = run(path)[1]
    assert printed.count("n_t = x: no number") == 10
    assert "and 4990 more" in printed


def test_strict_refuses_a_file_with_a_wrong_row(rows: Path) -> None:
    output = rows.with_name("out.csv")
    code, printed = run(rows, "--keep", "pixel", "--output", output, "--strict")
    assert (code, list(rows.parent.glob("out*"))) == (1, [])
    assert "line 5: n_t = -3.0" in printed
    assert "was not written" in printed
    rows.write_text("n_t\n1.5\n")
    assert run(rows, "--output", output, "--strict")[0] == 0
    assert output.exists()


def test_a_full_disk_is_blamed_on_the_output(rows: Path) -> None:
    output = rows.with_name("out.csv")
    output.with_name("out.csv.part").symlink_to("/dev/full")
    code, printed = run(rows, "--keep", "pixel", "--output", output)
    assert code == 1
    assert f"{output}: " in printed
    assert "No space left on device" in printed
    assert f"{rows}: " not in printed
    assert not list(rows.parent.glob("out*"))


def test_a_folder_that_is_not_there_is_blamed_on_the_output(rows: Path) -> None:
    output = rows.with_name("nowhere") / "out.parquet"
    code, printed = run(rows, "--keep", "pixel", "--output", output)
    assert (code, f"{output}: " in printed, f"{rows}: " in printed) == (1, True, False)


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP])
def test_nothing_half_done_stays_after_a_signal(tmp_path: Path, number: signal.Signals) -> None:
    path, part = tmp_path / "rows.csv", tmp_path / "rows-evaluated.csv.part"
    path.write_text("n_t,theta_i_deg\n" + "1.5,30\n" * 5_000_000)
    with subprocess.Popen(
        [sys.executable, "-c", "from app.cli.main import main; main()", "evaluate", str(path)],
        stderr=subprocess.DEVNULL,
    ) as process:
        while not part.exists():
            assert process.poll() is None
            time.sleep(0.01)
        process.send_signal(number)
        assert process.wait() == 128 + number
    assert list(tmp_path.iterdir()) == [path]


def test_nothing_is_overwritten_unasked(rows: Path) -> None:
    output = rows.with_name("out.csv")
    output.write_text("mine")
    code, printed = run(rows, "--output", output, "--keep", "pixel")
    assert (code, "--force" in printed, output.read_text()) == (2, True, "mine")
    assert run(rows, "--output", output, "--keep", "pixel", "--force")[0] == 1
    assert output.read_text() != "mine"


def test_on_a_cluster(rows: Path) -> None:
    with distributed.LocalCluster(
        n_workers=1, threads_per_worker=2, processes=False, dashboard_address="127.0.0.1:0"
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
    assert f"{rows}: " not in printed


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


INDICES = ((400.0, 1.66, 1.956), (500.0, 0.85, 1.895))


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("wavelength_um;n;k\n0,4;1,66;1,956\n0,5;0,85;1,895\n", "the decimal sign is a comma"),
        ("Energy (eV)\tn\tk\n3.1\t1.66\t1.956\n2.48\t0.85\t1.895\n", "energy in eV"),
        ("wavelength_nm,n,k\n400,1.66,1.956\n500,0.85,1.895\n", "n is read as n_t"),
        ("energy_ev,n_t,k_t\n3.1,1.66,1.956\n2.48,0.85,1.895\n", "energy_ev is read as"),
    ],
)
def test_tables_as_people_have_them_are_read_and_what_is_assumed_is_told(
    tmp_path: Path, text: str, said: str
) -> None:
    path = tmp_path / "gold.csv"
    path.write_text(text)
    code, printed = run(path)
    assert code == 0, printed
    assert said in printed
    table = read(path.with_name("gold-evaluated.csv"))
    expected = [float(fresnel(1.0, n, k, 0.0).R) for _, n, k in INDICES]
    assert table["value"].to_pylist() == pytest.approx(expected, rel=1e-12)


def test_a_preset_is_asked_at_energies(tmp_path: Path) -> None:
    path = tmp_path / "gold.csv"
    path.write_text("material;energy_ev\nAu;2,0\n")
    assert run(path)[0] == 0
    known = default_catalog().constants("Au", 1239.8419843320026 / 2.0)
    assert known.k is not None
    value = read(tmp_path / "gold-evaluated.csv")["value"].to_pylist()
    assert value == pytest.approx([float(fresnel(1.0, known.n, known.k, 0.0).R)], rel=1e-9)


def test_an_unknown_column_is_told_all_that_are_read(tmp_path: Path) -> None:
    path = tmp_path / "rows.csv"
    path.write_text("n,wavelength_um,foo\n1.5,0.55,1\n")
    code, printed = run(path)
    assert code == 2
    assert "foo: unknown column" in printed
    for name in ("n_t", "material", "layers", "in a file also", "wavelength_um", "energy_ev"):
        assert name in printed


def test_two_names_of_one_column_are_not_guessed_between(tmp_path: Path) -> None:
    path = tmp_path / "rows.csv"
    path.write_text("n_t,n\n1.5,1.6\n")
    code, printed = run(path)
    assert code == 2
    assert "n: unknown column" in printed
