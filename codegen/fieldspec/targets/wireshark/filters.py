"""The fields that a filter can name, each once, with its type in Wireshark."""

from __future__ import annotations

from fieldspec.foundation.classes import dataclass, field
from fieldspec.foundation.names import Name
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.primitives import Kind
from fieldspec.language.model.value import Value
from fieldspec.targets.fact_texts import sentence
from fieldspec.targets.wireshark.text import Data, joined, line_text

_LONGEST = 200
"""The characters of a description, which Wireshark shows in its status line."""

_SHORT = 0x7FFFFFFF
"""The greatest number that a table of names takes on every platform."""


def title_of(fact: Fact) -> str:
    """The title of a fact, with the name that the manual prints."""
    title = Name.of(fact.name).title()
    printed = line_text(fact.printed_name)
    return f"{title} ({printed})" if printed and printed.lower() != title.lower() else title


def description(fact: Fact) -> str:
    """The sentence about a fact in the status line."""
    text = line_text(joined([sentence(fact.label), sentence(fact.doc)]))
    return text if len(text) <= _LONGEST else f"{text[: _LONGEST - 3]}..."


@dataclass(frozen=True, slots=True)
class Filters:
    """The fields of a device by their filter names.

    Several facts share a field if its type and its names of numbers are the same. Otherwise the later ones get another
    of the names that are proposed, or an underscore at the end.
    """

    device: Device
    prefix: str
    rows: dict[str, dict[str, Data]] = field(default_factory=dict)

    def take(self, names: tuple[str, ...], row: dict[str, Data]) -> str:
        """The filter name for a field: the first of `names`, below the device, that is free or has the same field."""
        candidates = [f"{self.prefix}.{name}" for name in names]
        while True:
            for candidate in candidates:
                existing = self.rows.get(candidate)
                if existing is None:
                    self.rows[candidate] = {"filter": candidate, **row}
                    return candidate
                if all(existing.get(key) == row.get(key) for key in ("type", "base", "names")):
                    return candidate
            candidates = [f"{candidates[-1]}_"]

    def of_value(self, names: tuple[str, ...], fact: Fact, value: Value) -> str:
        """The name of the display filter of a value."""
        kind, size = value.type.kind, value.size
        row: dict[str, Data] = {"title": title_of(fact), "text": description(fact)}
        if kind is Kind.TEXT:
            return self.take(names, {**row, "type": "STRING"})
        if kind is Kind.BYTES:
            return self.take(names, {**row, "type": "BYTES"})
        if kind is Kind.FLOAT:
            return self.take(names, {**row, "type": "DOUBLE" if size == 8 else "FLOAT"})
        width = 8 * size if size <= 4 else 64
        signed = kind is Kind.INTEGER and value.type.signed
        base = "HEX" if value.flags else "DEC"
        return self.take(
            names,
            {**row, "type": f"{'INT' if signed else 'UINT'}{width}", "base": base, "names": self._names(value)},
        )

    def of_quantity(self, names: tuple[str, ...], fact: Fact, value: Value) -> str | None:
        """The filter name of the quantity of a value; None where this is the raw value itself."""
        if value.type.kind is not Kind.INTEGER or not value.scaled or value.flags:
            return None
        unit = f" in {line_text(value.unit)}" if value.unit else ""
        row: dict[str, Data] = {"title": f"{title_of(fact)}{unit}", "type": "DOUBLE", "text": description(fact)}
        return self.take(tuple(f"{name}.quantity" for name in names), row)

    def of_bits(self, names: tuple[str, ...], value: Value) -> str | None:
        """The name below which the filter names of a word's bits are; None where a value is no word."""
        if not value.flags:
            return None
        flags = self.device.flags[value.flags]
        for name in (*names, f"{names[-1]}_bits"):
            rows = {}
            for bit in flags.bits:
                row: dict[str, Data] = {"title": title_of(bit), "text": description(bit)}
                if bit.width == 1:
                    row |= {"type": "BOOLEAN"}
                else:
                    width = next(size for size in (8, 16, 32, 64) if bit.width <= size)
                    names_of = self._enum_names(bit.enum) if bit.enum and width < 64 and not bit.signed else None
                    row |= {"type": f"{'INT' if bit.signed else 'UINT'}{width}", "base": "DEC", "names": names_of}
                rows[f"{self.prefix}.{name}.{bit.name}"] = row
            if all(self._fits(place, row) for place, row in rows.items()):
                for place, row in rows.items():
                    self.rows.setdefault(place, {"filter": place, **row})
                return f"{self.prefix}.{name}"
        return self.of_bits((f"{names[-1]}_",), value)

    def _fits(self, place: str, row: dict[str, Data]) -> bool:
        existing = self.rows.get(place)
        return existing is None or all(existing.get(key) == row.get(key) for key in ("type", "base", "names"))

    def _names(self, value: Value) -> Data:
        if value.size > 4:
            return None
        if value.enum:
            return self._enum_names(value.enum)
        return {0: "false", 1: "true"} if value.type.kind is Kind.BOOLEAN else None

    def _enum_names(self, name: str) -> str | None:
        members = self.device.enums[name].members
        return name if members and all(0 <= member.value <= _SHORT for member in members) else None
