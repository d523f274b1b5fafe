"""Enums, tables of codes, and words of flags."""

from __future__ import annotations

from fieldspec.backends.c.naming import Naming
from fieldspec.backends.c.text import comment, hexadecimal, indented, integer, plain, string
from fieldspec.model.device import Device
from fieldspec.model.enum import Enum, Member
from fieldspec.model.fact import Fact
from fieldspec.model.flags import Flags
from fieldspec.model.value import Value

_LARGEST_ENUM = 2**31 - 1


def told(fact: Fact, *more: str) -> list[str]:
    """The comment of a fact: what it is, what the manual calls it, and where it stands."""
    printed = " ".join(text for text in (fact.printed_name, fact.label) if text)
    sources = "; ".join(citation.text() for citation in fact.sources)
    return comment(
        fact.doc,
        f"Printed as {printed}." if printed else "",
        *more,
        *(f"Note: {note}" for note in fact.notes),
        f"Source: {sources}" if sources else "",
    )


def enum_lines(naming: Naming, enum: Enum) -> list[str]:
    """The members' values, and the function that says which values a closed enum has."""
    members = [member for member in enum.members if not member.unavailable]
    lines = told(enum, "Other values may occur." if enum.open else "")
    small = [member for member in members if abs(member.value) <= _LARGEST_ENUM]
    if small:
        name = naming.type(enum.name)
        lines += [f"typedef enum {name} {{"]
        for at, member in enumerate(small):
            comma = "," if at + 1 < len(small) else ""
            lines.append(
                f"    {naming.macro(enum.name, member.name)} = {integer(member.value)}{comma}{_beside(member)}"
            )
        lines.append(f"}} {name};")
    for member in members:
        if member not in small:
            lines.append(f"#define {naming.macro(enum.name, member.name)} {integer(member.value, 8, member.value < 0)}")
    if not enum.open:
        lines += ["", *_known(naming, enum.name, members)]
    return lines


def _known(naming: Naming, name: str, members: list[Member]) -> list[str]:
    lines = [
        f"/** Whether a value is one of {plain(naming.type(name))}. */",
        f"static inline bool {naming.function(name, 'known')}(int64_t value)",
        "{",
    ]
    for low, high in _runs(sorted({member.value for member in members})):
        test = (
            f"value == {integer(low, 8)}"
            if low == high
            else f"value >= {integer(low, 8)} && value <= {integer(high, 8)}"
        )
        lines += [f"    if ({test}) {{", "        return true;", "    }"]
    return [*lines, "    return false;", "}"]


def _runs(values: list[int]) -> list[tuple[int, int]]:
    runs: list[tuple[int, int]] = []
    for value in values:
        if runs and runs[-1][1] == value - 1:
            runs[-1] = (runs[-1][0], value)
        else:
            runs.append((value, value))
    return runs


def _beside(member: Member) -> str:
    text = plain(" ".join(part for part in (member.label, member.doc) if part))
    return f" /**< {text} */" if text else ""


def closed_test(naming: Naming, device: Device, value: Value, name: str) -> str:
    """The condition under which the value's closed enum refuses it, or an empty one."""
    if not value.enum or device.enums[value.enum].open:
        return ""
    known = f"!{naming.function(value.enum, 'known')}((int64_t){name})"
    others = [f" && {name} != {integer(s.value, value.size, value.type.signed)}" for s in value.sentinels]
    return known + "".join(others)


def flags_lines(naming: Naming, word: Flags) -> list[str]:
    """Masks, shifts, and a function for each bit or field of bits."""
    size = word.type.size
    number = f"uint{8 * size}_t"
    lines = told(word, f"A word of {8 * size} bits.")
    lines.append(f"typedef {number} {naming.type(word.name)};")
    for bit in word.bits:
        if bit.reserved:
            continue
        states = [f"{n}: {text}." for n, text in ((0, bit.zero), (1, bit.one)) if text]
        edge = f"Its {bit.edge} edge counts." if bit.edge else ""
        mask, shift = naming.macro(word.name, bit.name, "mask"), naming.macro(word.name, bit.name, "shift")
        lines += ["", *told(bit, " ".join(states), edge, f"When {bit.when}." if bit.when else "")]
        lines += [f"#define {mask} {hexadecimal(bit.mask, size)}", f"#define {shift} {bit.first}u"]
        get = naming.function(word.name, bit.name)
        if bit.width == 1:
            lines += [
                f"static inline bool {get}({number} word)",
                "{",
                f"    return (word & {mask}) != 0;",
                "}",
            ]
            continue
        lines += [
            f"static inline {number} {get}({number} word)",
            "{",
            f"    return ({number})((word & {mask}) >> {shift});",
            "}",
            f"static inline {number} {naming.function(word.name, 'with', bit.name)}({number} word, {number} value)",
            "{",
            f"    return ({number})((word & ({number})~{mask}) | (({number})(value << {shift}) & {mask}));",
            "}",
        ]
    return lines


def text_lines(naming: Naming, enum: Enum) -> list[str]:
    """A function from a code to its texts, for tables of alarms, faults, exceptions and errors."""
    kind = naming.type("code_text")
    lines = [
        f"/** The texts of a code of {naming.type(enum.name)}, or NULL where it is not listed. */",
        f"static inline const {kind} *{naming.function(enum.name, 'text')}(int64_t code)",
        "{",
        f"    static const {kind} texts[] = {{",
    ]
    for member in enum.members:
        causes = "\n".join(cause.cause for cause in member.causes)
        remedies = "\n".join([*(r for cause in member.causes for r in cause.remedies), *member.remedies])
        texts = (member.name, member.label, member.problem or member.doc, causes, remedies)
        cells = ", ".join(string(text) for text in texts)
        lines.append(f"        {{{integer(member.value, 8)}, {cells}}},")
    lines += [
        "    };",
        "    size_t at;",
        "    for (at = 0; at < sizeof texts / sizeof texts[0]; at++) {",
        *indented(["if (texts[at].code == code) {", "    return &texts[at];", "}"], 2),
        "    }",
        "    return NULL;",
        "}",
    ]
    return lines
