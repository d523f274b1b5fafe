"""What lists of texts can express."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.plc.capabilities import CONSTRUCTS, EXACT, Capability, refused

_EXACT = ("code_texts", "remedies", "labels")


def capabilities() -> Mapping[str, Capability]:
    """How far each construct is expressed: codes alone, since a list of texts has nothing else."""
    return {name: Capability(EXACT) if name in _EXACT else refused("is no text of a code") for name in CONSTRUCTS}
