"""The files of tables: parts that appear whole, both tables of a part or none."""

from __future__ import annotations

import os
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any, BinaryIO

from fieldspec.command.console.usage import UsageError
from fieldspec.command.files.storage import BESIDE, sync_folder

if TYPE_CHECKING:
    from fieldspec.tools.captures.writers import TableWriter

TABLES = ("frames", "values")


class TableParts:
    """Writes parts into the folders `frames` and `values`, in an `exclusive_folder`. `number` is that of the next part.

    A part is written into temporary files, which take their names when it is finished. A part that a killed run has
    left without an entry in its journal is replaced.
    """

    def __init__(self, folder: Path, form: str, number: int) -> None:
        self.folder, self.form, self.number = folder, form, number
        self.frames = 0
        self._open: dict[str, tuple[TableWriter, BinaryIO, Path]] = {}

    def write(self, tables: dict[str, Any]) -> None:
        """Adds batches of both tables to the part. Raises UsageError where the disk is full."""
        try:
            if not self._open:
                self._begin()
            for table, batch in tables.items():
                self._open[table][0].write(batch)
        except OSError as error:
            raise UsageError(f"cannot write into {self.folder}: {error.strerror or error}") from None
        self.frames += tables["frames"].num_rows

    def _begin(self) -> None:
        from fieldspec.tools.captures.writers import WRITERS

        for table in TABLES:
            (self.folder / table).mkdir(exist_ok=True)
            path = self.folder / f"{BESIDE}{os.urandom(8).hex()}"
            file = open(path, "xb")  # noqa: SIM115 - it stays open until the part is finished
            self._open[table] = WRITERS[self.form](file, table), file, path

    def finish(self) -> None:
        """Brings the part to the disk under its names. Raises UsageError."""
        if not self._open:
            return
        try:
            for writer, file, _ in self._open.values():
                writer.close()
                file.flush()
                os.fsync(file.fileno())
                file.close()
            for table, (_, _, path) in self._open.items():
                os.replace(path, self.folder / table / f"{self.number:05}.{self.form}")
                sync_folder(self.folder / table)
        except OSError as error:
            raise UsageError(f"cannot write into {self.folder}: {error.strerror or error}") from None
        self._open = {}
        self.number += 1
        self.frames = 0

    def drop(self) -> None:
        """Removes the temporary files of a part that is not finished."""
        for _, file, path in self._open.values():
            with suppress(OSError):
                file.close()
                os.unlink(path)
        self._open = {}
