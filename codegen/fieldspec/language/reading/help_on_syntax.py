"""What to do about the errors that YAML parsers report most often, in plain words."""

from __future__ import annotations

import re

_COMMA = "separate the entries with commas, and close each `{` with `}` and each `[` with `]`"
_INDENT = "begin all entries of a list or a mapping in one column: indent this line, or the one above, like the others"
_ENDS = "close what was opened before: a quote, a `{` or a `[`"

_HELP = (
    ("did not find expected ',' or", _COMMA),
    ("expected ',' or", _COMMA),
    ("did not find expected node content", "write a value here, or remove the bracket or the comma before it"),
    ("expected the node content", "write a value here, or remove the bracket or the comma before it"),
    ("did not find expected key", f"{_INDENT}; a text with quotes in it is quoted as a whole"),
    ("did not find expected '-' indicator", _INDENT),
    ("expected <block end>", _INDENT),
    ("could not find expected ':'", "write `: ` after the key; quote a text that continues over several lines"),
    ("unexpected end of stream", _ENDS),
    ("did not find expected <stream", _ENDS),
    ("undefined alias", "define it before as `&NAME`, or quote the text: `*` begins the name of another place"),
    ("escape", "write the backslash twice, or use single quotes"),
)


def syntax_help(problem: str, text: str, offset: int) -> str:
    """The help for a message of the parser about a place of a text; empty for unknown messages."""
    if "cannot start any token" in problem:
        word = re.split(r"[\s,}\]]", text[offset:], maxsplit=1)[0]
        return f'a text cannot begin with `{text[offset : offset + 1]}`: quote it, as in `"{word}"`'
    if "mapping values are not allowed" in problem:
        line = text[text.rfind("\n", 0, offset) + 1 : offset]
        if ": " in line:
            return (
                "a text with `: ` needs quotes around it, as in `doc: 'a: b'`; one line has one key outside of braces"
            )
        return "begin the key in the column of the others: indented further, it continues the text of the line above"
    return next((help for part, help in _HELP if part in problem), "")
