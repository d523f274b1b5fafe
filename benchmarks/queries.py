"""Telegram 111 from a column of payloads to its columns, by the generated queries: one thread, against scans and C."""

from __future__ import annotations

import ctypes
import os
import sys
from collections.abc import Iterator

os.environ["POLARS_MAX_THREADS"] = "1"

import duckdb
import numpy
import polars
from python_many import by_hand, pointer
from rows import ROOT, Row, printed, timed

GROUP = "Queries"
NUMBER = 200_000
COLUMNS = {
    "status_word_1": numpy.uint16,
    "positioning_status_word_1": numpy.uint16,
    "positioning_status_word_2": numpy.uint16,
    "status_word_2": numpy.uint16,
    "message_word": numpy.uint16,
    "position_actual_a": numpy.int32,
    "speed_actual_b_raw": numpy.int32,
    "fault_code_raw": numpy.uint16,
    "warning_code_raw": numpy.uint16,
}
FOLDER = ROOT / "generated" / "queries"
PER_SECOND = 3_000_000
"""The goal: telegrams per second of a core."""


def rows() -> Iterator[Row]:
    """The rows."""
    sys.path.insert(0, str(FOLDER))
    import hiwin_e_v2_14_4 as hiwin

    data = numpy.random.default_rng(111).bytes(24 * NUMBER)
    frame = polars.DataFrame({"payload": [data[at : at + 24] for at in range(0, len(data), 24)]})
    connection = duckdb.connect()
    connection.execute("SET threads = 1")
    connection.execute((FOLDER / "hiwin_e_v2_14_4.sql").read_text("utf-8"))
    connection.register("frames", frame.to_arrow())
    connection.execute("CREATE TABLE telegrams AS FROM frames")
    own = f"SELECT {', '.join(COLUMNS)} FROM hiwin_e_v2_14_4.telegram_111_response(telegrams, payload)"
    every = "SELECT * EXCLUDE (payload) FROM hiwin_e_v2_14_4.telegram_111_response(telegrams, payload)"
    lazy = frame.lazy().select(hiwin.telegram_111_response("payload"))
    library = by_hand()

    def stored(query: str) -> object:
        return connection.execute(f"CREATE OR REPLACE TABLE decoded AS {query}")

    def in_c() -> object:
        arrays = [numpy.empty(NUMBER, kind) for kind in COLUMNS.values()]
        library.columns(data, ctypes.c_size_t(NUMBER), *map(pointer, arrays))
        return arrays

    def scan() -> object:
        return stored("SELECT payload FROM telegrams")

    for name, call in (
        ("DuckDB", lambda: stored(own)),
        ("Polars", lambda: lazy.select(list(COLUMNS)).collect()),
        ("DuckDB, every bit as a column", lambda: stored(every)),
        ("Polars, every bit as a column", lambda: lazy.collect()),
    ):
        yield timed(GROUP, f"{NUMBER} telegrams to columns, {name}", call, "DuckDB's scan of the same bytes", scan)
        yield timed(GROUP, f"{NUMBER} telegrams to columns, {name}", call, "a loop in C", in_c)
    for name, call in (("DuckDB", lambda: stored(own)), ("Polars", lambda: lazy.select(list(COLUMNS)).collect())):
        row = timed(GROUP, "telegrams", call, "", scan)
        rate = NUMBER / (row.ours / 1e9)
        title = f"telegrams a second and core, {name}"
        yield Row(GROUP, title, "the goal", round(rate), PER_SECOND, "", round(rate / PER_SECOND, 3), at_least=1.0)


if __name__ == "__main__":
    printed(rows())
