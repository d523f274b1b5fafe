"""The code of the page about queries runs, on the processes of a Dask cluster too."""

from __future__ import annotations

import os
import random
import re
import subprocess
import sys
from pathlib import Path

import polars
import pytest

from bounded import HANGING
from fieldspec.cli import main
from fieldspec.codec.reference.records import decoded
from layouts import SPECS, newest
from queries_output.engines import engine_of
from queries_output.expected import is_equal, record_columns

ROOT = Path(__file__).resolve().parents[2]
BLOCKS = re.findall(r"```python\n(.*?)```", (ROOT / "docs" / "queries.md").read_text("utf-8"), re.DOTALL)
MAIN = """

if __name__ == "__main__":
    import sys

    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
        print(decode_folder(client, Path(sys.argv[1]), Path(sys.argv[2])))
"""
PARTS, TELEGRAMS = 3, 40


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder where the queries are built, which are not committed."""
    folder = tmp_path_factory.mktemp("queries_page")
    assert main(["build", "--specs", str(SPECS), "--to", "queries", "--out", str(folder / "generated")]) == 0
    return folder


def test_the_code_decodes_a_telegram_and_finds_a_value_out_of_range(
    built: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(built)
    monkeypatch.setattr(sys, "path", list(sys.path))
    names: dict[str, object] = {}
    exec("\n".join(BLOCKS[:-2]), names)
    assert names["rows"].rows() == [(1, True, 65535, None)]
    exec(BLOCKS[-2], names)
    assert names["findings"] == [("motion_command", "out_of_range", "99", 1)]


def test_processes_of_dask_decode_the_files_of_a_folder_as_the_reference_does(built: Path, tmp_path: Path) -> None:
    layout, dice = newest(SPECS, "hiwin-e"), random.Random(111)
    record = layout.messages["telegram_111"].response
    source, target = tmp_path / "source", tmp_path / "target"
    source.mkdir()
    target.mkdir()
    payloads = [[dice.randbytes(24) for _ in range(TELEGRAMS)] for _ in range(PARTS)]
    for place, data in enumerate(payloads):
        polars.DataFrame({"data": data}).write_parquet(source / f"{place}.parquet")
    script = tmp_path / "decode.py"
    script.write_text(BLOCKS[-1] + MAIN, "utf-8")
    environment = {**os.environ, "PYTHONPATH": str(built / "generated" / "queries"), "POLARS_MAX_THREADS": "1"}
    command = [sys.executable, str(script), str(source), str(target)]
    run = subprocess.run(
        command, env=environment, cwd=tmp_path, capture_output=True, text=True, check=False, timeout=HANGING
    )
    assert run.stdout.strip() == str(PARTS * TELEGRAMS), run.stderr
    for place, data in enumerate(payloads):
        rows = polars.read_parquet(target / f"{place}.parquet").to_dicts()
        for payload, row in zip(data, rows, strict=True):
            wanted = record_columns(layout.device, record, decoded(record, payload, layout.device))
            assert all(is_equal(value, row[column]) for column, value in wanted.items())


@pytest.mark.parametrize("engine", ["duckdb", "polars"])
def test_words_become_the_payload_that_has_them(engine: str) -> None:
    layout = newest(SPECS, "tc100")
    runner = engine_of(engine, layout)
    if engine == "duckdb":
        result = runner.connection.execute("SELECT tc100_v2_0.payload_of([1, 65535, 258])").fetchall()[0][0]
    else:
        frame = polars.DataFrame({"words": [[1, 65535, 258]]})
        result = frame.select(payload=runner.module.payload_of("words"))["payload"][0]
    assert result == bytes.fromhex("0001FFFF0102")
