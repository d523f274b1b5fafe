"""The header of a device that takes, when it is compiled, the header of the version that is asked for."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from fieldspec.backends.c.naming import Naming, stem, version_word
from fieldspec.backends.c.text import plain
from fieldspec.backends.forms import filled
from fieldspec.layout.device import DeviceLayout
from fieldspec.names import Name

_SELECT, _LATEST = "select", "latest"


def claim_selection(naming: Naming, versions: Iterable[str]) -> None:
    """Keeps the names of the header free in those of all versions."""
    for words in ((), (_LATEST,), *((version_word(version),) for version in versions)):
        naming.own_macro(_SELECT, *words)


def selection(versions: Sequence[DeviceLayout]) -> dict[str, str]:
    """The header, by its path; `versions` are those of one device, the oldest first."""
    device = versions[-1].device
    naming = Naming(device.id)
    headers = [(version, layout) for layout in versions for version in (layout.device.version, *layout.equal_versions)]
    macros = {version: naming.own_macro(_SELECT, version_word(version)) for version, _ in headers}
    header = f"{Name.of(device.id).snake()}.h"
    select = naming.own_macro(_SELECT)
    taken = [(macros[version], f"{stem(device.id, layout.device.version)}.h", layout) for version, layout in headers]
    text = filled(
        "backends/c/selection.h.in",
        title=plain(f"{device.name} ({device.vendor}), in any of its versions"),
        identity=versions[-1].identity,
        select=select,
        latest=naming.own_macro(_SELECT, _LATEST),
        newest=macros[device.version],
        listed=[f" * {macro}: {name}, identity {layout.identity}\n" for macro, name, layout in taken],
        defined=[f"#define {macro} {number}\n" for number, (macro, _, _) in enumerate(taken, 1)],
        included=[f'#elif {select} + 0 == {macro}\n#include "{name}"\n' for macro, name, _ in taken],
        choices=", ".join(macros.values()),
    )
    return {header: text}
