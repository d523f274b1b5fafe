"""The heading of a frame says as many bytes as its table has rows for."""

from __future__ import annotations

import re

import pytest

from docs_output.documented import documentation, with_ending

FRAME = re.compile(
    r"\*\w+ on [^\n]*: (\d+) bytes?(,[^\n]*| of data)?\*\n\n\| (Byte|Character) [^\n]*\n[^\n]*\n((?:\|[^\n]*\n)+)"
)
PLACE = re.compile(r"^\| `(?:\d+\.\.)?(\d+)` ")


@pytest.mark.parametrize("path", with_ending(".md"))
def test_the_length_in_the_heading_is_that_of_the_table(path: str) -> None:
    for match in FRAME.finditer(documentation()[path]):
        length, more, _, rows = match.groups()
        last = PLACE.match(rows.splitlines()[-1])
        if last is None:  # a list, or an identifier without data
            continue
        delimiters = re.search(r"and (\d+) characters? as delimiters", more or "")
        sent = int(length)
        if "two characters each" in (more or ""):
            sent = 2 * sent + (int(delimiters[1]) if delimiters else 0)
        assert int(last[1]) + 1 == sent, match[0]


def test_there_are_frames_with_delimiters_in_bytes_and_in_characters() -> None:
    texts = "".join(documentation()[path] for path in with_ending(".md"))
    assert {match[3] for match in FRAME.finditer(texts) if "delimiter" in match[4]} == {"Byte", "Character"}
