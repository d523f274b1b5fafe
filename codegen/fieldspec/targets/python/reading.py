"""The code that reads a field from the raw values of its slots, and the choices between field types."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.codec.layout.record import CaseLayout, RecordLayout
from fieldspec.foundation.classes import dataclass, replace
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.encoding import (
    Digits,
    Octets,
    OfSign,
    Real,
    Sign,
    Text,
    Truth,
    Whole,
    is_text,
    is_truth,
    struct_letter,
)
from fieldspec.targets.python.registers import value_expression
from fieldspec.targets.python.slots import Slots
from fieldspec.targets.python.text import filled, literal
from fieldspec.targets.python.writing import digits_form, real_letters, sent_order, text_form, tuple_of


def local(field: Slots) -> str:
    """The variable of a raw value. The variables of its words have two underscores, which no name of a spec has."""
    return f"raw_{field.title}"


def targets(field: Slots, owner: str, bound: bool = False) -> list[str]:
    """The targets that the slots of a field are unpacked into: an attribute or locals; locals where it is `bound`."""
    if field.skipped:
        return []
    star = "*" if field.is_list or field.splits else ""
    if field.field.field.reserved and not field.field.field.measures:
        return ["_"] * field.parted or [f"{star}_"]
    if (field.is_raw or field.deferred) and field.stored and not bound:
        return [f"{star}{owner}.{field.slot}"]
    if field.parted:
        return [f"{local(field)}__{part}" for part in range(field.parted)]
    return [f"{star}{local(field)}"]


@dataclass(frozen=True, slots=True)
class ListPlace:
    """A place in a tuple `raws`, after a number of slots and of lists whose sizes are in `counts`."""

    slots: int
    lists: int
    total: int

    def behind(self, field: Slots) -> ListPlace:
        """The place after a field."""
        if field.in_room and not field.splits:
            return replace(self, lists=self.lists + 1)
        return replace(self, slots=self.slots + (0 if field.skipped else field.parted or field.count))

    def text(self, lists: int = 0) -> str:
        """The place, or the one after more lists, as an expression: `5 + counts[0]`."""
        return " + ".join([str(self.slots), *(f"counts[{number}]" for number in range(self.lists + lists))])

    @property
    def rest(self) -> str:
        """The slice of the list that begins here."""
        if self.lists + 1 < self.total:
            return f"{self.text()} : {self.text(1)}"
        return f"{self.text()} :" if self.lists else f"{self.slots}:"


def sources(field: Slots, place: ListPlace) -> str:
    """The raw value of a field in a tuple `raws`, from a place on."""
    if field.in_room and not field.is_list:
        return f"raws[{place.text()}]"
    if field.in_room or field.splits:
        return f"raws[{place.rest}]"
    if field.is_list:
        return f"raws[{place.slots}:{place.slots + field.count}]"
    return f"raws[{place.slots}]"


def indexed(field: Slots, owner: str, place: ListPlace) -> list[str]:
    """Lines that take the raw values of a field from a tuple `raws`."""
    if field.skipped or (field.field.field.reserved and not field.field.field.measures):
        return []
    if field.parted:
        return [f"{local(field)}__{part} = raws[{place.slots + part}]" for part in range(field.parted)]
    if (field.is_raw or field.deferred) and field.stored:
        source = sources(field, place)
        return [f"{owner}.{field.slot} = {f'list({source})' if field.is_list else source}"]
    source = sources(field, place)
    return [f"{local(field)} = {f'list({source})' if field.is_list else source}"]


def reading(field: Slots, owner: str, offset: int, bound: bool) -> list[str]:
    """Lines that convert the raw value of a field, and refuse an invalid one.

    `offset` is that of the field from the start of the bytes; `bound` says that the raw value is in a local in any
    case. Measures are tested when all fields are read.
    """
    reserved = field.field.field.reserved and not field.field.field.measures
    if reserved:
        return []
    if (field.is_raw or field.deferred) and field.stored:
        return [f"{owner}.{field.slot} = {local(field)}"] if bound else []
    lines, raw = _field_number(field, offset)
    title = literal(field.title)
    size = field.field.size
    if field.field.field.measures and field.constant is None:
        return lines
    if field.field.record is not None:
        record = field.element_type
        call = "_decoded_each" if field.is_list else "_decoded_at"
        sized = f", {size}" if field.is_list else ""
        return [f"{owner}.{field.name} = {call}({record}, {raw}, {offset}{sized})"]
    if field.constant is not None:
        if field.is_list:
            return [*lines, f"_constants({title}, {raw}, {field.constant}, {offset}, {size})"]
        return [
            *lines,
            f"if {raw} != {field.constant}:",
            f"    raise _wrong_const({title}, {raw}, {field.constant}, {offset})",
        ]
    if is_truth(field.value.encoding):
        if field.is_list:
            return [*lines, f"{owner}.{field.name} = _booleans({title}, {raw}, {offset}, {size})"]
        return [
            *lines,
            f"if {raw} > 1:",
            f"    raise _no_boolean({title}, {raw}, {offset})",
            f"{owner}.{field.name} = {raw} == 1",
        ]
    if field.value.text_form is not None:
        function = "texts" if field.is_list else "text"
        form = text_form(field.value, field.field.order)
        return [f"{owner}.{field.name} = {form}.{function}({title}, {raw}, {offset})"]
    if is_text(field.value.encoding):
        call = f"_texts({title}, {raw}, {offset}, {size})" if field.is_list else f"_text({title}, {raw}, {offset})"
        return [f"{owner}.{field.name} = {call}"]
    if field.value.flags:
        flags = field.element_type
        construction = f"[{flags}(raw) for raw in {raw}]" if field.is_list else f"{flags}({raw})"
        return [*lines, f"{owner}.{field.name} = {construction}"]
    if field.enum is not None:
        return [*lines, *_member(field, owner, raw, offset)]
    if field.is_list:
        return [*lines, f"{owner}.{field.name} = {raw}"]
    return [*lines[:-1], f"{owner}.{field.name} = {lines[-1].partition(' = ')[2]}"]


def deferred_value_lines(field: Slots) -> list[str]:
    """The lines of the getter of a deferred field; it stores the object of a word of bits on first access."""
    if not field.deferred:
        return []
    slot = f"self.{field.slot}"
    if field.enum is not None:
        member = f"{field.enum.table}.get(word, word)"
        return [f"word = {slot}", f"return {member} if isinstance(word, int) else word"]
    return [
        f"word = {slot}",
        "if isinstance(word, int):",
        f"    word = {slot} = {field.type}(word)",
        "return word",
    ]


def _field_number(field: Slots, offset: int) -> tuple[list[str], str]:
    """Lines that assemble the number of a field from its slots, and the expression of the number."""
    raw = local(field)
    if field.field.value is not None and field.value.digits:
        form = digits_form(field.value, field.field.order, field.field.swapped)
        arguments = f"{literal(field.title)}, {raw}, {offset}, {field.field.swapped}"
        if not field.is_list:
            return [f"{raw} = {form}.number({arguments})"], raw
        return [f"{raw} = {form}.numbers({arguments}{_accepted(field)})"], raw
    if field.parted:
        parts = [f"{raw}__{part}" for part in range(field.parted)]
        if not field.big:
            parts.reverse()
        joined = " | ".join(f"{part} << {16 * number}" if number else part for number, part in enumerate(parts))
        return [f"{raw} = {joined}"], raw
    if not field.foreign:
        return [], raw
    converted = _from_bytes(field, "item" if field.is_list else raw)
    return [f"{raw} = [{converted} for item in {raw}]" if field.is_list else f"{raw} = {converted}"], raw


def _accepted(field: Slots) -> str:
    """The argument with the numbers that a list of digits may have; empty where it may have all."""
    if field.constant is not None:
        return f", ({field.constant},)"
    if field.enum is None or field.enum.open:
        return ""
    return f", {_member_table(field)}"


def _from_bytes(field: Slots, raw: str) -> str:
    encoding = field.value.encoding
    match encoding:
        case Real():
            return f"_float_of({raw}, {real_letters(field, encoding)}, {field.field.swapped})"
        case Whole():
            return _whole_of_bytes(field, raw, encoding.sign)
        case Truth():
            return _whole_of_bytes(field, raw, Sign.NONE)
        case Digits() | Text() | Octets():
            raise AssertionError("characters and bytes are not a number in another order")
        case _:
            assert_never(encoding)


_READ_WHOLE = OfSign(none="_int_of({})", complement="_int_of({}, signed=True)", magnitude="_magnitude_of({})")


def _whole_of_bytes(field: Slots, raw: str, sign: Sign) -> str:
    arguments = f'{f"_turned({raw})" if field.field.swapped else raw}, "{sent_order(field)}"'
    return _READ_WHOLE(sign).format(arguments)


def _member(field: Slots, owner: str, raw: str, offset: int) -> list[str]:
    enum = field.enum
    assert enum is not None
    title, name, attribute = literal(field.title), literal(enum.title), f"{owner}.{field.name}"
    if enum.open:
        construction = (
            f"[{enum.table}.get(raw, raw) for raw in {raw}]" if field.is_list else f"{enum.table}.get({raw}, {raw})"
        )
        return [f"{attribute} = {construction}"]
    if field.is_list:
        return [f"{attribute} = _members({title}, {raw}, {_member_table(field)}, {name}, {offset}, {field.field.size})"]
    wrong = f"raise _unknown_member({title}, {raw}, {name}, {offset}) from None"
    lines = ["try:", f"    {attribute} = {enum.table}[{raw}]", "except KeyError:"]
    if not field.sentinels:
        return [*lines, f"    {wrong}"]
    known = ", ".join(str(low) for low, high in field.sentinels if low == high)
    tests = [f"{raw} not in ({known},)"] if known else []
    tests += [f"not {low} <= {raw} <= {high}" for low, high in field.sentinels if low != high]
    return [*lines, f"    if {' and '.join(tests)}:", f"        {wrong}", f"    {attribute} = {raw}"]


def _member_table(field: Slots) -> str:
    """The expression of the members of a closed enum by their numbers, and of sentinels."""
    assert field.enum is not None
    if not field.sentinels:
        return field.enum.table
    entries = [f"{low}: {low}" for low, high in field.sentinels if low == high]
    entries += [f"**{{n: n for n in range({low}, {high + 1})}}" for low, high in field.sentinels if low != high]
    return f"{{**{field.enum.table}, {', '.join(entries)}}}"


CASE = "case"
"""The variable that holds the case of the selector."""


def choice_lines(variable: str, record: RecordLayout, fields: Sequence[Slots], letters: str, order: str) -> list[str]:
    """The statement that defines the `Choice` of a record; `letters` are the letters of the fields before the decided
    field.
    """
    selector, decided = record.selector, fields[-1]
    assert selector is not None
    repeat = decided.field.field.repeat
    minimum, maximum = (repeat.low, repeat.high) if repeat else (decided.count, decided.count)
    arguments = [
        literal(record.name),
        literal(letters),
        literal(selector.name),
        str(selector.offset),
        str(selector.size),
    ]
    cases = [_case(case, order, decided) for case in decided.field.cases]
    bounds = [f"minimum={minimum}", f"maximum={maximum}"] + (['order="little"'] if selector.order == "little" else [])
    return [
        f"{variable} = _Choice(",
        f"    {', '.join(arguments)},",
        *(f"    {case}," for case in cases),
        f"    {', '.join(bounds)},",
        ")",
    ]


def _case(case: CaseLayout, order: str, decided: Slots) -> str:
    native = case.value.size == 1 or (case.order == order and not case.swapped)
    letters = struct_letter(case.value.encoding).strip("s") if native else ""
    letters = letters or f"{case.value.size}s"
    value = value_expression(case.value, case.order, case.swapped, decided.words)
    return f"({tuple_of(sorted(case.numbers))}, {literal(letters)}, {value})"


def cases_lines(variable: str, field: Slots) -> list[str]:
    """The statement that defines the types of a field, whichever another one decides."""
    cases = [
        f"({tuple_of(sorted(case.numbers))}, {value_expression(case.value, case.order, case.swapped, field.words)})"
        for case in field.field.cases
    ]
    selector = field.field.selector
    assert selector is not None
    mask = [f"mask={field.field.deciding_bits}"] if field.field.deciding_bits is not None else []
    return filled(f"{variable} = _Cases(", [literal(selector.name), *cases, *mask], ")", 0)


def decided_read(decided: Slots, owner: str, offset: int) -> list[str]:
    """Lines that read the decided field."""
    first = "" if decided.is_list else "[0]"
    values = f"{CASE}.values({literal(decided.title)}, {local(decided)}, {offset}){first}"
    return [f"{owner}.{decided.name} = {values}"]


def decided_values(decided: Slots, expression: str) -> str:
    """The expression of the slots of the decided field."""
    values = expression if decided.is_list else f"({expression},)"
    return f"*{CASE}.raws({literal(decided.title)}, {values})"
