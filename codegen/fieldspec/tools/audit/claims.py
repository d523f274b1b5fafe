"""What facts claim of the lines that they cite: addresses, codes, names, frames, and the numbers of their values."""

from __future__ import annotations

import re
from collections.abc import Iterator
from decimal import Decimal
from posixpath import dirname

from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.source import Span
from fieldspec.language.checks.facts import facts
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_count, is_signed
from fieldspec.language.model.enums import Bit, Flags, Member
from fieldspec.language.model.fact import Citation, Fact
from fieldspec.language.model.record import Field
from fieldspec.language.model.registers import Parameter, Register, Table
from fieldspec.language.model.value import Value

NUMBERS = (
    "at",
    "decimal",
    "base",
    "value",
    "code",
    "refusal_code",
    "number",
    "wire_number",
    "bit",
    "bits",
    "word_span",
)
"""The keys of numbers that identify a fact: the manual prints them on the lines of the fact."""

VALUES = (
    "range",
    "unit_range",
    "write_range",
    "count",
    "length",
    "scale",
    "full_scale",
    "default",
)
"""The keys of the numbers of a value. The lines of the fact print them, or the spec says why they do not."""

SIGN = "type"
"""The key of the claim that a number has a sign."""

_LIMITS = ("range", "unit_range", "write_range")
_NUMBER = re.compile(r"(?<![0-9^.])(?:0[xX][0-9A-Fa-f]+|-?[0-9]+(?:\.[0-9]+)?)(?![0-9.^])")


@dataclass(frozen=True, slots=True)
class Claim:
    """A key of a fact, or of another place that states it, with its text and the lines that should print it.

    `means` are the numbers of which the manual may print any.
    """

    path: str
    key: str
    text: str
    span: Span
    sources: tuple[Citation, ...]
    means: tuple[int | Decimal, ...] = ()

    @property
    def is_of_value(self) -> bool:
        """Whether it is about a value, not about what identifies the fact."""
        return self.key in VALUES or self.key == SIGN


def claims_of(device: Device, visited: set[int]) -> Iterator[Claim]:
    """The claims of the facts of a device, without those that were `visited`, as versions share facts."""
    bases = {
        parameter.place.path: parameter_set.base
        for parameter_set in device.parameters.values()
        for parameter in parameter_set.parameters
    }
    for fact in facts(device):
        if id(fact) in visited:
            continue
        visited.add(id(fact))
        path, place = fact.place.path, fact.place
        if fact.sources:
            for key in NUMBERS:
                if key in place and not (key == "bits" and isinstance(fact, Flags)):
                    yield Claim(
                        path,
                        key,
                        _span_text(place[key]),
                        place[key],
                        fact.sources,
                        _means(fact, key, bases.get(path, 0)),
                    )
            if "printed_name" in place:
                yield Claim(path, "printed_name", fact.printed_name, place["printed_name"], fact.sources)
            yield from _value_claims(fact, device)
        for claim in fact.restated:
            for key in (*NUMBERS, "printed_name"):
                value = claim.values.get(key)
                if value is not None and claim.sources:
                    yield Claim(claim.place.path, key, str(value), claim.place[key], claim.sources)
        if isinstance(fact, Register):
            for number, source in enumerate(fact.element_sources):
                address = fact.address + number * fact.stride
                element_path = f"{path}/{fact.index_from + number}"
                yield Claim(element_path, "at", str(address), place["at"], (source,), (address,))
    for table in device.tables.values():
        for element in table.elements:
            address = table.address(element.index)
            place = element.place
            yield Claim(place.path, "at", str(address), place["at"], element.sources, (address,))
    for example in device.examples.values():
        if example.origin == "printed":
            key = "elided" if example.elided else "frame"
            span = example.place["frame"]
            yield Claim(example.place.path, key, example.frame.hex(" "), span, example.sources)
    for erratum in device.errata:
        if erratum.literal:
            yield Claim(erratum.place.path, "literal", erratum.literal, erratum.place["literal"], erratum.sources)


def _means(fact: Fact, key: str, base: int) -> tuple[int, ...]:
    """The numbers of which the manual may print any, if they differ from the number of the key itself.

    A parameter has a number in its set, and one on the wire, which is greater by `base`.
    """
    if isinstance(fact, Parameter) and key == "number":
        return fact.number, base + fact.number
    if isinstance(fact, Bit):
        return tuple(range(fact.first, fact.last + 1))
    return (fact.value,) if isinstance(fact, Member) and key == "value" else ()


def _span_text(span: Span) -> str:
    return span.file.text[span.start : span.end].strip("\"'")


def _value_claims(fact: Fact, device: Device) -> Iterator[Claim]:
    """The claims of the numbers of a value that the spec of the device itself states, and of the sign of its type.

    Copied values are stated at the original, and values that are `inferred` or from a standard are not printed. Neither
    are values that the file of a version changes, with its reason.
    """
    if (isinstance(fact, Field) and fact.signal) or (isinstance(fact, Register) and fact.copy_of):
        return
    home = dirname(device.place["id"].file.path)
    value = getattr(fact, "value", None)
    for key in (*VALUES, SIGN):
        own = key in fact.place and key not in fact.inferred and key not in fact.standard
        if not own or not f"{dirname(fact.place[key].file.path)}/".startswith(f"{home}/"):
            continue
        if dirname(fact.place[key].file.path) == f"{home}/versions" and fact.place[key].file != fact.place["name"].file:
            continue
        text, span = _span_text(fact.place[key]), fact.place[key]
        restated_sources = (source for claim in fact.restated if key in claim.values for source in claim.sources)
        sources = (*fact.sources, *restated_sources)
        if key != SIGN:
            yield from (
                Claim(fact.place.path, key, number, span, sources, means)
                for number, means in _numbers(fact, key, text, value)
            )
        elif isinstance(value, Value) and _needs_sign(value, device):
            yield Claim(fact.place.path, SIGN, text, span, sources)


def _numbers(fact: Fact, key: str, text: str, value: object) -> Iterator[tuple[str, tuple[int | Decimal, ...]]]:
    """The numbers in the text of a key, each with its permitted printed forms.

    A limit may be printed as a raw value, in its unit, or below zero as its bytes are; the limit of a type is not
    printed at all. A count may be printed as the number or the address of the last element.
    """
    for match in _NUMBER.finditer(text.replace("..", " ")):
        number = Decimal(int(match[0], 16) if match[0][:2] in ("0x", "0X") else match[0])
        means = {number}
        if key in _LIMITS and isinstance(value, Value):
            if key != "unit_range" and number in (value.type.low, value.type.high):
                continue
            if isinstance(value.scale, Decimal):
                means |= {number * value.scale}
            means |= {below + (1 << 8 * value.type.size) for below in means if below < 0}
        elif key == "default" and isinstance(value, Value) and isinstance(value.scale, Decimal):
            means |= {number * value.scale}
        elif key == "count":
            means |= set(_last_elements(fact, int(number)))
        yield match[0], tuple(means)


def _last_elements(fact: Fact, count: int) -> Iterator[Decimal]:
    """The number and the address of the last of that number of elements. Those of a field are numbered from 0."""
    if isinstance(fact, Register | Table):
        first = fact.address if isinstance(fact, Register) else fact.base
        yield Decimal(fact.index_from + count - 1)
        yield Decimal(first + (count - 1) * fact.stride)
    elif isinstance(fact, Parameter):
        yield Decimal(fact.number + count - 1)
    else:
        yield Decimal(count - 1)


def _needs_sign(value: Value, device: Device) -> bool:
    """Whether the lines must print that a whole number has a sign: nothing that the spec states is below zero."""
    if not is_signed(value.encoding) or not is_count(value.encoding):
        return False
    enum = device.enums.get(value.enum)
    low = value.ranges.low if value.ranges is not None else 0
    members = enum.members if enum is not None else ()
    sentinels = [sentinel.value for sentinel in value.sentinels if not sentinel.is_nan]
    return low >= 0 and all(member.value >= 0 for member in members) and all(number >= 0 for number in sentinels)
