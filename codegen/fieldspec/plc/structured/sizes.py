"""A function that says whether the structs have the sizes that they are said to have."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.plc.routines.written import comment
from fieldspec.plc.structured.item import Item


def sizes_item(name: str, sizes: Mapping[str, int]) -> Item:
    """The function: call it once at the start, and stop where it gives FALSE."""
    head = [
        *comment("Whether all structs are as large as their layout says. FALSE means that the compiler fills up gaps:"),
        *comment("then do not copy them as blocks of memory. The functions for words and bytes do not depend on it."),
        f"FUNCTION {name} : BOOL",
        "VAR",
        *(f"    st{number} : {struct};" for number, struct in enumerate(sizes, 1)),
        "END_VAR",
    ]
    body = [f"{name} := TRUE;"]
    for number, (struct, size) in enumerate(sizes.items(), 1):
        body.append(f"IF SIZEOF(st{number}) <> {size} THEN {name} := FALSE; END_IF; // {struct}")
    return Item(name, "function", "layout", tuple(head), tuple(body))
