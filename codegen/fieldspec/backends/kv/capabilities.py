"""What word maps and comments can express."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.plc.capabilities import CONSTRUCTS, EXACT, Capability, lossy, refused

_TABLE = "are in the table, for people; KV STUDIO imports comments alone"
_NOT_EXACT = {
    "wide_numbers": lossy("are words; no instruction of the KV takes them"),
    "wide_lists": lossy("are words; no instruction of the KV takes them"),
    "choices": lossy("stand once for each type, with the values that decide it"),
    "frames": lossy("are words to fill in and to compare; nothing sums and compares them"),
    "orders": lossy("are said for each value; the ladder turns words and bytes"),
    "scales": lossy(_TABLE),
    "conversions": refused("are formulas, which a map of words has not"),
    "ranges": lossy(_TABLE),
    "constants": lossy(_TABLE),
    "code_texts": refused("are no words: see the output for operator panels"),
    "remedies": refused("are no words: see the output for operator panels"),
    "labels": lossy("are in the table; comments are ASCII"),
}


def capabilities() -> Mapping[str, Capability]:
    """How far each construct is expressed."""
    return {name: _NOT_EXACT.get(name, Capability(EXACT)) for name in CONSTRUCTS}
