"""An output: the registers of each version of a device as CSV, for the company's data logger."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.extension import DeviceLayout, Diagnostic, Files, csv_text, finding, stem

TITLE = "Addresses of registers as CSV"
MOST_WORDS = 2


def files(versions: Sequence[DeviceLayout]) -> Files:
    """One file for each version, the oldest first."""
    return {f"{stem(layout.device.id, layout.device.version)}.csv": _table(layout) for layout in versions}


def shared() -> Files:
    """The file that belongs to no device."""
    return {"README.txt": "Import one of these lists for each device.\n"}


def refusals(versions: Sequence[DeviceLayout]) -> list[Diagnostic]:
    """The logger reads no register of more than two words."""
    return [
        finding(
            "address_list_words",
            register.register.place,
            "name",
            f"`address_list` has registers of {MOST_WORDS} words at most; {register.name} has {register.words}",
            "build the other outputs with --to",
        )
        for layout in versions
        for register in layout.registers
        if register.words > MOST_WORDS
    ]


def _table(layout: DeviceLayout) -> str:
    rows = [(f"0x{register.address:04X}", register.name, str(register.words)) for register in layout.registers]
    return csv_text([("address", "name", "words"), *rows])
