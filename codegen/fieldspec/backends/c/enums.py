"""Enums and tables of codes."""

from __future__ import annotations

from fieldspec.backends.c.comments import told
from fieldspec.backends.c.naming import Naming
from fieldspec.backends.c.text import hexadecimal, indented, integer, plain, string
from fieldspec.model.device import Device
from fieldspec.model.enums import Enum, Member
from fieldspec.model.value import Value

# What the constants of an enum may be: an int, which has 16 bits on small machines.
_LEAST, _LARGEST = -(2**15) + 1, 2**15 - 1
_LARGEST_CODE = 2**63 - 1

# Enums that are no tables of codes, and have no texts but their members' comments.
_PLAIN_KINDS = ("enum", "function", "type")


def coded(device: Device) -> list[Enum]:
    """The tables of codes, which have texts: alarms, faults, exceptions, errors."""
    return [enum for enum in device.enums.values() if enum.kind not in _PLAIN_KINDS]


def available(enum: Enum) -> list[Member]:
    """The members that a value may be."""
    return [member for member in enum.members if not member.unavailable]


def enum_lines(naming: Naming, enum: Enum) -> list[str]:
    """The members' values, and the function that says which values a closed enum has.

    Members that are more than an int holds make all of them macros of one integer type.
    """
    members = available(enum)
    lines = told(enum, "Other values may occur." if enum.open else "")
    if all(_LEAST <= member.value <= _LARGEST for member in members):
        lines += _enumerators(naming, enum, members)
    else:
        lines += _macros(naming, enum, members)
    if not enum.open:
        lines += ["", *_known(naming, enum)]
    return lines


def _enumerators(naming: Naming, enum: Enum, members: list[Member]) -> list[str]:
    if not members:
        return []
    name = naming.type("enum", enum.name)
    hexadecimal_in_print = "x}" in enum.printed_as.lower()
    lines = [f"typedef enum {name} {{"]
    for at, member in enumerate(members):
        comma = "," if at + 1 < len(members) else ""
        constant = naming.macro("enum", enum.name, member.name)
        number = f"0x{member.value:X}" if hexadecimal_in_print and member.value >= 0 else integer(member.value)
        lines.append(f"    {constant} = {number}{comma}{_beside(member)}")
    return [*lines, f"}} {name};"]


def _macros(naming: Naming, enum: Enum, members: list[Member]) -> list[str]:
    signed = any(member.value < 0 for member in members)
    size = 4 if not signed and all(member.value < 2**32 for member in members) else 8
    lines = [f"typedef {'' if signed else 'u'}int{8 * size}_t {naming.type('enum', enum.name)};"]
    for member in members:
        number = integer(member.value, size) if signed else hexadecimal(member.value, size)
        lines.append(f"#define {naming.macro('enum', enum.name, member.name)} {number}{_beside(member)}")
    return lines


def _beside(member: Member) -> str:
    number = f"Number {member.number}." if member.number is not None else ""
    text = plain(" ".join(part for part in (member.printed_name, member.label, number, member.doc) if part))
    return f" /**< {text} */" if text else ""


def _wide(enum: Enum) -> bool:
    return any(member.value > _LARGEST_CODE for member in available(enum))


def _known(naming: Naming, enum: Enum) -> list[str]:
    kind = "uint64_t" if _wide(enum) else "int64_t"
    lines = [
        f"/** Whether a value is one of {plain(naming.type('enum', enum.name))}. */",
        f"static inline bool {naming.function('enum', enum.name, 'known')}({kind} value)",
        "{",
    ]
    runs = _runs(sorted({member.value for member in available(enum)}))
    tests = []
    for low, high in runs:
        first, last = (integer(bound, 8, not _wide(enum)) for bound in (low, high))
        test = f"value == {first}" if low == high else f"value >= {first} && value <= {last}"
        tests.append(f"value <= {last}" if low == 0 and high > 0 and _wide(enum) else test)
    for test in tests[:-1]:
        lines += [f"    if ({test}) {{", "        return true;", "    }"]
    if tests:
        return [*lines, f"    return {naming.own_macro('likely')}({tests[-1]});", "}"]
    return [*lines, "    (void)value;", "    return false;", "}"]


def _runs(values: list[int]) -> list[tuple[int, int]]:
    runs: list[tuple[int, int]] = []
    for value in values:
        if runs and runs[-1][1] == value - 1:
            runs[-1] = (runs[-1][0], value)
        else:
            runs.append((value, value))
    return runs


def closed_test(naming: Naming, device: Device, value: Value, name: str) -> str:
    """The condition under which the value's closed enum refuses it, or an empty one."""
    if not value.enum or device.enums[value.enum].open:
        return ""
    kind = "uint64_t" if _wide(device.enums[value.enum]) else "int64_t"
    known = f"!{naming.function('enum', value.enum, 'known')}(({kind}){name})"
    others = [f" && {name} != {integer(s.value, value.size, value.type.signed)}" for s in value.sentinels]
    return known + "".join(others)


def text_lines(naming: Naming, enum: Enum) -> list[str]:
    """A function from a code to its texts, for tables of alarms, faults, exceptions and errors."""
    kind = naming.own("code_text")
    lines = [
        f"/** The texts of a code of {naming.type('enum', enum.name)}, or NULL where it is not listed. */",
        f"static inline const {kind} *{naming.function('enum', enum.name, 'text')}(int64_t code)",
        "{",
    ]
    members = [member for member in enum.members if member.value <= _LARGEST_CODE]
    if not members:
        return [*lines, "    (void)code;", "    return NULL;", "}"]
    lines.append(f"    static const {kind} texts[] = {{")
    for member in members:
        causes = "\n".join(cause.cause for cause in member.causes)
        remedies = "\n".join([*(r for cause in member.causes for r in cause.remedies), *member.remedies])
        texts = (member.printed_name, member.name, member.label, member.problem or member.doc, causes, remedies)
        cells = ", ".join(string(text) for text in texts)
        number = integer(-1 if member.number is None else member.number, 8)
        lines.append(f"        {{{integer(member.value, 8)}, {number}, {cells}}},")
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
