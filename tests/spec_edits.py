"""Random edits of spec files, as people and slips make them: sound and broken ones, of all kinds of files."""

from __future__ import annotations

import random
import re
from collections.abc import Callable, Mapping

Files = dict[str, str]
Edit = Callable[[str, random.Random], str]

_STRAY = (*"x1 \n#:\"'{}|>\t\ré", "- ", ", ", "...", "---\n", "&a", "*a")
_NUMBER = re.compile(r"(?<![\w.])\d+")
_NAME = re.compile(r"(?<=name: )\w+")
_DOC = re.compile(r"(?<=(?:doc|tle): )[^\n{},]+")
_ROW = re.compile(r"^ *- .*\n", re.MULTILINE)


def stray(text: str, choose: random.Random) -> str:
    """A character or two somewhere."""
    place = choose.randrange(len(text) + 1)
    return text[:place] + choose.choice(_STRAY) + text[place:]


def cut(text: str, choose: random.Random) -> str:
    """Some characters less."""
    place = choose.randrange(len(text) + 1)
    return text[:place] + text[place + choose.choice((1, 1, 2, 5, 40)) :]


def _lines(change: Callable[[list[str], int, random.Random], None]) -> Edit:
    def edit(text: str, choose: random.Random) -> str:
        lines = text.splitlines(keepends=True) or ["\n"]
        change(lines, choose.randrange(len(lines)), choose)
        return "".join(lines)

    return edit


def _double(lines: list[str], number: int, choose: random.Random) -> None:
    lines.insert(number, lines[number])


def _remove(lines: list[str], number: int, choose: random.Random) -> None:
    del lines[number : number + choose.choice((1, 1, 1, 3, 12))]


def _move(lines: list[str], number: int, choose: random.Random) -> None:
    lines.insert(choose.randrange(len(lines)), lines.pop(number))


def _comment(lines: list[str], number: int, choose: random.Random) -> None:
    lines.insert(number, choose.choice(("\n", "# a remark\n", "            # far away\n", "   \n")))


def _append(lines: list[str], number: int, choose: random.Random) -> None:
    lines.append(lines[number])


def _pattern_edit(pattern: re.Pattern[str], new: Callable[[str, list[str], random.Random], str]) -> Edit:
    """Replaces one match of a pattern; `new` also gets all others."""

    def edit(text: str, choose: random.Random) -> str:
        matches = [*pattern.finditer(text)]
        if not matches:
            return text
        match = choose.choice(matches)
        others = [other[0] for other in matches]
        return text[: match.start()] + new(match[0], others, choose) + text[match.end() :]

    return edit


def row_at_an_end(text: str, choose: random.Random) -> str:
    """The first or the last row of a list once more, or no more."""
    rows = [*_ROW.finditer(text)]
    ends = [
        row
        for row, following in zip(rows, [*rows[1:], None], strict=True)
        if following is None or row.end() != following.start()
    ]
    if not ends:
        return text
    row = choose.choice((*ends, rows[0]))
    return text[: row.start()] + choose.choice(("", row[0] * 2)) + text[row.end() :]


EDITS: tuple[Edit, ...] = (
    stray,
    cut,
    row_at_an_end,
    *map(_lines, (_double, _remove, _move, _comment, _append)),
    _pattern_edit(_NUMBER, lambda old, others, choose: str(int(old) + 1)),
    _pattern_edit(_NUMBER, lambda old, others, choose: choose.choice(others)),
    _pattern_edit(_NAME, lambda old, others, choose: f"{old}_other"),
    _pattern_edit(_NAME, lambda old, others, choose: choose.choice(others)),
    _pattern_edit(_NAME, lambda old, others, choose: old.replace("_", "", 1)),
    _pattern_edit(_DOC, lambda old, others, choose: f"{old} once more"),
)
"""The edits of one file."""


def edited(files: Files, sound: Mapping[str, str], choose: random.Random) -> Files:
    """The files after one edit. Half of the time a broken file is made `sound` again, or a lost one brought back."""
    files = dict(files)
    different = [path for path, text in sound.items() if files.get(path) != text]
    if len(different) > 2 or (different and choose.random() < 0.4):
        added = [path for path in files if path not in sound]
        for path in added:
            del files[path]
        path = choose.choice(different)
        return {**files, path: sound[path]}
    path = choose.choice([*files])
    deed = choose.random()
    if deed < 0.03:
        del files[path]
    elif deed < 0.06:
        files[path.replace(".yaml", "_moved.yaml")] = files.pop(path)
    else:
        files[path] = choose.choice(EDITS)(files[path], choose)
    return files
