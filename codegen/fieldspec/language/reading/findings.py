"""Findings of reading: their limit, quoting of files, and the names of folders."""

from __future__ import annotations

from collections.abc import Collection

from fieldspec.language.diagnostics import Diagnostic

PROTOCOLS = "protocols"
MAIN = "device.yaml"
VERSIONS = "versions"

LARGEST_FILE = 16 * 1024 * 1024
"""Bytes of a spec file."""
LARGEST_FOLDER = 32 * 1024 * 1024
"""Bytes of all files of a device, or of all protocols."""
MOST_FILES = 1000
"""Files of a device, or of all protocols."""


MOST_FINDINGS = 200
"""The greatest number of reported findings of one kind; more do not help."""

SYNONYMS = {
    "address": ("at", "unit_addresses", "base", "bounds"),
    "allowed": ("range",),
    "baud_rate": ("baud",),
    "baudrate": ("baud",),
    "bits": ("fields",),
    "cmd": ("code",),
    "command": ("code",),
    "comment": ("notes", "doc"),
    "constant": ("const",),
    "crc": ("algorithm",),
    "data_type": ("type",),
    "datatype": ("type",),
    "default_value": ("default",),
    "description": ("doc", "title", "notes"),
    "endian": ("byte_order",),
    "endianness": ("byte_order",),
    "entries": ("rows", "members", "fields", "bits"),
    "factor": ("scale",),
    "fields": ("bits", "rows"),
    "first": ("bounds", "from"),
    "fixed": ("const",),
    "function": ("code",),
    "function_code": ("code",),
    "gain": ("scale",),
    "help": ("doc",),
    "init": ("initial",),
    "initial_value": ("default",),
    "items": ("rows", "members", "fields", "bits"),
    "last": ("bounds", "to"),
    "limits": ("range",),
    "line": ("source",),
    "max": ("range", "unit_range"),
    "maximum": ("range", "unit_range"),
    "min": ("range", "unit_range"),
    "minimum": ("range", "unit_range"),
    "mode": ("access",),
    "multiplier": ("scale",),
    "opcode": ("code",),
    "options": ("enum",),
    "page": ("source",),
    "permission": ("access",),
    "poly": ("polynomial",),
    "read_only": ("access",),
    "readonly": ("access",),
    "refin": ("reflect_in",),
    "refout": ("reflect_out",),
    "register": ("at",),
    "resolution": ("scale",),
    "scaling": ("scale",),
    "size": ("length", "words", "count"),
    "swap": ("word_order",),
    "terminator": ("end",),
    "title": ("doc", "label"),
    "units": ("unit",),
    "values": ("members", "enum"),
    "word_swap": ("word_order",),
    "xorout": ("final_xor",),
}
"""Words of other tools for keys of the language, the likeliest key first."""

FORMER = {
    "access_steps": "accesses",
    "check_code_correct": "checksum_correct",
    "checksum": "algorithm",
    "counts": "measures",
    "encoding": "transmission",
    "error_reply_changed": "exception_response_changed",
    "wrong_check": "wrong_checksum",
}
"""Keys and words of earlier versions of the language, with their names today."""

_CHECKED = ("data_words", "decimal", "frame_length", "size", "span", "wire_number", "word_span", "words")
_MOVED = {
    **{key: ("checked", f"state it under `checked`: `checked: {{{key}: ...}}`") for key in _CHECKED},
    "delimiters": ("start", "state `start` and `end`, each for both directions or as `{request: .., response: ..}`"),
}
"""Keys whose values are elsewhere today: the key of that place, and the help."""

_LONGEST = 60
_MOST_NAMES = 100
_SEARCHED = 2000
_SHORTEST = 2


def bounded(findings: list[Diagnostic]) -> list[Diagnostic]:
    """The first findings, and one that states how many more there are."""
    if len(findings) <= MOST_FINDINGS:
        return findings
    text = f"more than {MOST_FINDINGS} findings; the rest is not listed"
    remark = Diagnostic("too_many_findings", text, findings[MOST_FINDINGS].span, help="correct the first findings")
    return [*findings[:MOST_FINDINGS], remark]


def quoted(text: str) -> str:
    """A text of a file between backticks; a long one is cut."""
    return f"`{text}`" if len(text) <= _LONGEST else f"`{text[:_LONGEST]}...`"


def former(word: str, known: Collection[str]) -> str:
    """The help for a key or a word with a new name; empty for others."""
    if (name := FORMER.get(word)) in known:
        return f"it is called `{name}` now"
    name, help = _MOVED.get(word, ("", ""))
    return help if name in known else ""


def synonym(word: str, known: Collection[str]) -> str:
    """The known key for which other tools use a word; empty for other words."""
    return next((key for key in SYNONYMS.get(word.lower(), ()) if key in known), "")


def near(word: str, known: Collection[str], description: str = "") -> str:
    """The help for an unknown word: the known word that is probably meant, or all known words.

    Where these are too many to be listed, `description` says what they are.
    """
    from difflib import get_close_matches

    if help := former(word, known):
        return help
    letters = sorted(word)
    swapped = [name for name in known if sorted(name) == letters] if len(known) <= _SEARCHED else []
    if swapped:
        return f"did you mean `{swapped[0]}`?"
    if len(word) < _SHORTEST and len(known) <= _LONGEST:
        return "it can be " + ", ".join(f"`{name}`" for name in sorted(known)) if known else "there is none"
    close = get_close_matches(word, known, 1) if len(known) <= _SEARCHED else []
    if close:
        return f"did you mean `{close[0]}`?"
    if description and len(known) > _MOST_NAMES:
        return description
    names = [f"`{name}`" for name in sorted(known)]
    ending = "" if len(names) <= _MOST_NAMES else ", ..."
    return "it can be " + ", ".join(names[:_MOST_NAMES]) + ending if names else "there is none"
