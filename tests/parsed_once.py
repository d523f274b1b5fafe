"""Reads large files of specs once in a process: tests read the same specs again and again, most of them by verbs."""

from __future__ import annotations

from functools import lru_cache

from fieldspec.foundation.source import Refused
from fieldspec.language.reading import project, yaml_reader
from fieldspec.language.reading.memory import FileRead, file_read

LARGE = 4000
"""Bytes of a file that takes longer to parse than to find again."""


def _file_read(path: str, data: bytes, earlier: FileRead | None) -> FileRead:
    if earlier is not None or len(data) < LARGE or isinstance(data, Refused):
        return file_read(path, data, earlier)
    return _parsed_once(path, bytes(data), yaml_reader._Parser)


@lru_cache(maxsize=200)
def _parsed_once(path: str, data: bytes, parser: object) -> FileRead:
    return file_read(path, data, None)


project.file_read = _file_read
