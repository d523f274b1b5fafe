"""Enums, and tables of codes with their texts."""

from __future__ import annotations

from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import bounds_of, is_count
from fieldspec.language.model.enums import Enum, Member
from fieldspec.language.model.ranges import merged, uncovered
from fieldspec.language.model.value import Value
from fieldspec.targets.c.declarations import (
    BLANK,
    Comment,
    Declaration,
    Define,
    Enumeration,
    Enumerator,
    Function,
    Typedef,
    describe_fact,
    escape_comment,
)
from fieldspec.targets.c.expressions import (
    INDEX,
    VALUE,
    Call,
    Expression,
    Identifier,
    Initializer,
    SizeOf,
    Type,
    all_of,
)
from fieldspec.targets.c.literals import (
    FALSE,
    INT64,
    NULL,
    TRUE,
    UINT32,
    UINT64,
    ZERO,
    hexadecimal,
    hexadecimal_digits,
    integer,
    string,
)
from fieldspec.targets.c.machine import machine
from fieldspec.targets.c.naming import Naming
from fieldspec.targets.c.statements import CountUp, If, Return, Statement, Table, Variable, discard

# What the constants of an enum may be: an int, which has 16 bits on small machines.
_LEAST, _LARGEST = -(2**15) + 1, 2**15 - 1
_LARGEST_CODE = INT64.bounds[1]

# Enums that are not tables of codes, and have no texts but their members' comments.
_KINDS_WITHOUT_TEXTS = ("enum", "function", "type")


def code_tables(device: Device) -> list[Enum]:
    """The enums that are tables of codes, which have texts: alarms, faults, exceptions, errors."""
    return [enum for enum in device.enums.values() if enum.kind not in _KINDS_WITHOUT_TEXTS]


def available_members(enum: Enum) -> list[Member]:
    """The members of an enum without those that the device does not have."""
    return [member for member in enum.members if not member.unavailable]


def declare_enum(naming: Naming, enum: Enum) -> list[Declaration]:
    """The members' values, and the function that says which values a closed enum has.

    Members that are more than an int can be make all of them macros of one integer type.
    """
    members = available_members(enum)
    declarations: list[Declaration] = [describe_fact(enum, "Other values may occur." if enum.open else "")]
    if _fits_int(members):
        declarations += _enumeration(naming, enum, members)
    else:
        declarations += _macros(naming, enum, members)
    if not enum.open:
        declarations += [BLANK, *_known_function(naming, enum)]
    return declarations


def _enumeration(naming: Naming, enum: Enum, members: list[Member]) -> list[Declaration]:
    if not members:
        return []
    printed_in_hexadecimal = "x}" in enum.printed_as.lower()
    enumerators = tuple(
        Enumerator(
            naming.macro("enum", enum.name, name),
            hexadecimal_digits(member.value) if printed_in_hexadecimal and member.value >= 0 else integer(member.value),
            remark,
        )
        for member in members
        for name, remark in _names(member)
    )
    return [Enumeration(naming.type("enum", enum.name), enumerators, naming.own_macro("enum_16"))]


def _macros(naming: Naming, enum: Enum, members: list[Member]) -> list[Declaration]:
    signed = any(member.value < 0 for member in members)
    whole = INT64 if signed else UINT32 if all(member.value < 2**32 for member in members) else UINT64
    return [
        Typedef(Type(machine(whole).type), naming.type("enum", enum.name)),
        *(
            Define(
                naming.macro("enum", enum.name, name),
                integer(member.value, whole) if signed else hexadecimal(member.value, whole.bits // 8),
                remark,
            )
            for member in members
            for name, remark in _names(member)
        ),
    ]


def _names(member: Member) -> list[tuple[str, str]]:
    """The names of a member, the one to write first, each with its remark."""
    return [(member.name, _remark(member)), *((alias, f"An alias of {member.name}.") for alias in member.aliases)]


def _remark(member: Member) -> str:
    number = f"Number {member.number}." if member.number is not None else ""
    return escape_comment(" ".join(part for part in (member.printed_name, member.label, number, member.doc) if part))


def _fits_int(members: list[Member]) -> bool:
    return all(_LEAST <= member.value <= _LARGEST for member in members)


def enum_type(device: Device, value: Value) -> Enum | None:
    """The closed enum whose type a value has as a parameter or a result of C; None where that is an integer."""
    enum = _closed_enum(device, value)
    return None if enum is None or integer_reason(device, value) else enum


def integer_reason(device: Device, value: Value) -> str:
    """Why a value of a closed enum has an integer type in C; empty where it has the type of its enum, or has none."""
    enum = _closed_enum(device, value)
    if enum is None:
        return ""
    members = available_members(enum)
    if not members:
        return f"An integer, as {enum.name} has no members."
    if not _fits_int(members):
        return f"An integer, as 16 bits do not hold all members of {enum.name}."
    low, high = bounds_of(value.encoding)
    if not all(low <= member.value <= high for member in members):
        return f"An integer, as {value.type.name} does not hold all members of {enum.name}."
    known = merged((member.value, member.value) for member in members) if value.sentinels else []
    missing = [sentinel.name for sentinel in value.sentinels if uncovered(*sentinel.interval, known)]
    return f"An integer, as {enum.name} does not have {', '.join(missing)}." if missing else ""


def _closed_enum(device: Device, value: Value) -> Enum | None:
    """The closed enum of an integer that is not a constant."""
    if not value.enum or value.const is not None or not is_count(value.encoding):
        return None
    enum = device.enums[value.enum]
    return None if enum.open else enum


def _known_function(naming: Naming, enum: Enum) -> list[Declaration]:
    """`bool stop_mode_known(int64_t value)`"""
    wide = any(member.value > _LARGEST_CODE for member in available_members(enum))
    whole = UINT64 if wide else INT64
    tests: list[Expression] = []
    for low, high in _runs(sorted({member.value for member in available_members(enum)})):
        minimum, maximum = integer(low, whole), integer(high, whole)
        if low == 0 and high > 0 and wide:
            tests.append(VALUE.at_most(maximum))
        else:
            tests.append(
                VALUE.equals(minimum) if low == high else all_of([VALUE.at_least(minimum), VALUE.at_most(maximum)])
            )
    body: list[Statement] = [If(test, (Return(TRUE),)) for test in tests[:-1]]
    if tests:
        body.append(Return(Call(naming.own_macro("likely"), (tests[-1],))))
    else:
        body += [discard("value"), Return(FALSE)]
    parameter = Variable(Type(machine(whole).type), "value")
    # The name of the type is claimed before that of the function.
    description = f"Whether a value is one of {escape_comment(naming.type('enum', enum.name))}."
    function = Function(Type("bool"), naming.function("enum", enum.name, "known"), (parameter,), tuple(body))
    return [Comment((description,)), function]


def _runs(values: list[int]) -> list[tuple[int, int]]:
    """The intervals of consecutive numbers."""
    runs: list[tuple[int, int]] = []
    for value in values:
        if runs and runs[-1][1] == value - 1:
            runs[-1] = (runs[-1][0], value)
        else:
            runs.append((value, value))
    return runs


def declare_code_texts(naming: Naming, enum: Enum) -> list[Declaration]:
    """A function from a code to its texts, for tables of alarms, faults, exceptions and errors."""
    struct = naming.own("code_text")
    description = f"The texts of a code of {naming.type('enum', enum.name)}, or NULL if the code is unknown."
    members = [member for member in enum.members if member.value <= _LARGEST_CODE]
    texts, code = Identifier("texts"), Identifier("code")
    row = texts.element(INDEX)
    body: tuple[Statement, ...] = (discard("code"), Return(NULL))
    if members:
        body = (
            Table(Type(struct), "texts", tuple([_code_text(member) for member in members])),
            Variable(INDEX.type, INDEX.name),
            CountUp(
                INDEX,
                SizeOf(texts) / SizeOf(texts.element(ZERO)),
                (If(row.member("code").equals(code), (Return(row.address()),)),),
            ),
            Return(NULL),
        )
    function = Function(
        Type(struct, const=True, pointer=True),
        naming.function("enum", enum.name, "text"),
        (Variable(Type("int64_t"), "code"),),
        body,
    )
    return [Comment((description,)), function]


def _code_text(member: Member) -> Initializer:
    causes = "\n".join(cause.cause for cause in member.causes)
    remedies = "\n".join([*(r for cause in member.causes for r in cause.remedies), *member.remedies])
    texts = (member.printed_name, member.name, member.label, member.problem or member.doc, causes, remedies)
    number = integer(-1 if member.number is None else member.number, INT64)
    return Initializer((integer(member.value, INT64), number, *[string(text) for text in texts]))
