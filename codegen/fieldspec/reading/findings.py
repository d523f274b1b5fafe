"""Findings of reading: their limit, quoting of files, and the names of folders."""

from __future__ import annotations

from collections.abc import Collection

from fieldspec.diagnostics import Diagnostic

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
"""How many findings of one kind are reported; more of them help nobody."""

_LONGEST = 60
_SEARCHED = 2000


def bounded(findings: list[Diagnostic]) -> list[Diagnostic]:
    """The first findings, and one that states how many more there are."""
    if len(findings) <= MOST_FINDINGS:
        return findings
    text = f"more than {MOST_FINDINGS} findings; the rest is not listed"
    more = Diagnostic("too_many_findings", text, findings[MOST_FINDINGS].span, help="correct the first findings")
    return [*findings[:MOST_FINDINGS], more]


def quoted(text: str) -> str:
    """A text of a file between backticks; a long one is cut."""
    return f"`{text}`" if len(text) <= _LONGEST else f"`{text[:_LONGEST]}...`"


def near(word: str, known: Collection[str]) -> str:
    """The help for an unknown word: the known word that is probably meant, or all known words."""
    from difflib import get_close_matches

    close = get_close_matches(word, known, 1) if len(known) <= _SEARCHED else []
    if close:
        return f"did you mean `{close[0]}`?"
    names = [f"`{name}`" for name in sorted(known)]
    more = "" if len(names) <= _LONGEST else ", ..."
    return "it can be " + ", ".join(names[:_LONGEST]) + more if names else "there is none"
