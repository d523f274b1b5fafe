"""How the facts of devices are spelled in outputs, kept in the cache from where it was asked first."""

from __future__ import annotations

from contextlib import suppress

from fieldspec.command.files import cache_folder
from fieldspec.targets import OUTPUTS
from fieldspec.targets.usages import Spellings, from_stored, stored_text

KIND = "spellings"


def stored(key: str) -> Spellings:
    """The cached spellings of a device under a key, by output and version; empty for an empty key."""
    spellings: Spellings = {}
    for name in OUTPUTS if key else ():
        content = cache_folder.cached(KIND, f"{key} {name}")
        if content is not None:
            with suppress(ValueError):  # another program has written it
                spellings[name] = from_stored(content)
    return spellings


def store(key: str, spellings: Spellings) -> None:
    """Keeps what outputs have spelled under a key; nothing for an empty key."""
    for name, versions in spellings.items() if key else ():
        cache_folder.store(KIND, f"{key} {name}", stored_text(versions))
