"""The fields that a filter can name, each once, with its type in Wireshark."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from fieldspec.foundation.classes import dataclass, field
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.foundation.names import Name
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import (
    MACHINE_BITS,
    Digits,
    Encoding,
    Octets,
    OfPrecision,
    Real,
    Text,
    Truth,
    Whole,
    is_count,
    is_exact,
)
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.value import Value
from fieldspec.targets.fact_texts import sentence
from fieldspec.targets.wireshark.text import Data, joined, line_text
from fieldspec.targets.wireshark.value_code import ValueFunctions

_LONGEST = 200
"""The characters of a description, which Wireshark shows in its status line."""

_WIDEST_SINGLE = 32
"""The bits of the widest number that has fields of its own width; wider ones have fields of 64 bits."""

_LONGEST_NAMED = 4
"""The bytes of the widest number whose field has a table of names."""

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
    of the names that are proposed, or an underscore at the end. `digits` are the patterns of the values that are shown
    as bytes, by the paths of their facts.
    """

    device: Device
    prefix: str
    functions: ValueFunctions
    digits: Mapping[str, Sequence[bytes]]
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
        encoding = value.encoding
        row: dict[str, Data] = {"title": title_of(fact), "text": description(fact), "type": _type(encoding)}
        if is_exact(encoding):
            row |= {"base": "HEX" if value.flags else "DEC", "names": self._names(value)}
        return self.take(names, row)

    def of_quantity(self, names: tuple[str, ...], fact: Fact, value: Value) -> str | None:
        """The filter name of the quantity of a value; None where this is the raw value itself."""
        if not is_count(value.encoding) or not value.scaled or value.flags:
            return None
        unit = f" in {line_text(value.unit)}" if value.unit else ""
        row: dict[str, Data] = {"title": f"{title_of(fact)}{unit}", "type": "DOUBLE", "text": description(fact)}
        return self.take(tuple(f"{name}.quantity" for name in names), row)

    def of_bits(self, names: tuple[str, ...], value: Value) -> str | None:
        """The name below which the filter names of a word's bits are; None where a value is not a word."""
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
                    width = next(size for size in MACHINE_BITS if bit.width <= size)
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
        encoding = value.encoding
        match encoding:
            case Whole() | Digits():
                return self._enum_names(value.enum) if value.enum and value.size <= _LONGEST_NAMED else None
            case Truth():
                return self._enum_names(value.enum) if value.enum else {0: "false", 1: "true"}
            case Real() | Text() | Octets():
                return None
            case _:
                assert_never(encoding)

    def _enum_names(self, name: str) -> str | None:
        members = self.device.enums[name].members
        return name if members and all(0 <= member.value <= _SHORT for member in members) else None


def _type(encoding: Encoding) -> str:
    """The type of the field of a value."""
    match encoding:
        case Text():
            return "STRING"
        case Octets():
            return "BYTES"
        case Real():
            return _real_type(encoding.precision)
        case Truth():
            return f"UINT{encoding.bits}"
        case Whole():
            return _whole_type(encoding)
        case Digits():
            return _whole_type(Whole(8 * encoding.size, encoding.number.sign))
        case _:
            assert_never(encoding)


_real_type = OfPrecision(half="FLOAT", single="FLOAT", double="DOUBLE")


def _whole_type(whole: Whole) -> str:
    width = whole.bits if whole.bits <= _WIDEST_SINGLE else MACHINE_BITS[-1]
    return f"{'INT' if whole.sign.is_signed else 'UINT'}{width}"
