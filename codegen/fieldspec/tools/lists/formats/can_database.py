"""Databases of CAN messages (DBC) as rows: a message or a signal for each.

The library cantools reads them. It says neither where a message is nor which one breaks a rule: the lines of the file
do, and each message is judged alone.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Sequence
from decimal import Decimal
from fractions import Fraction
from functools import partial
from typing import Any

from fieldspec.tools.lists.assumption import Assumption
from fieldspec.tools.lists.formats.format_rows import FormatRows, decimal
from fieldspec.tools.lists.listing import Listing
from fieldspec.tools.lists.row_reading import MESSAGE, SIGNAL, ListRow, SignalPlace
from fieldspec.tools.lists.sheet import CellError, ListError, Sheet
from fieldspec.tools.lists.type_words import Typed
from fieldspec.tools.lists.value_texts import Meanings

SIGNS = re.compile(r"\A\s*VERSION\s+\"|^[ \t]*BO_\s+[0-9]+\s+\w+\s*:", re.MULTILINE)
"""What such a file has."""

MESSAGES = "messages"
"""The space of the identifiers of messages."""

_NOBODY = "Vector__XXX"
_INDEPENDENT = "VECTOR__INDEPENDENT_SIG_MSG"
_LINE = re.compile(r"\s*(?:BO_\s+(?P<identifier>[0-9]+)\s|SG_\s+(?P<signal>\w+)[\s:])")
_EXTENDED = 1 << 31
_LAST_STANDARD, _LAST_WIDE = (1 << 11) - 1, 1 << 29
_MESSAGE = re.compile(r"^[ \t]*BO_[ \t]+([0-9]{1,9})\b", re.MULTILINE)
_OF_MESSAGE = re.compile(
    r"^([ \t]*(?:BO_|(?:CM_|BA_[ \t]+\"[^\"\n]*\")[ \t]+(?:BO_|SG_)|VAL_|SIG_VALTYPE_|SIG_GROUP_|BO_TX_BU_|SG_MUL_VAL_)"
    r"[ \t]+)([0-9]{1,9})\b",
    re.MULTILINE,
)
"""The identifier of a message, wherever a file names it."""

_FAULT, _SIGNAL, _MOST_FAULTS = re.compile(r"at line ([0-9]+)"), re.compile(r"\s*SG_\s+(\S+)"), 20
_LONGEST = 8 << 20
_REALS = {16: "f16", 32: "f32", 64: "f64"}

_ROLES = {
    "Identifier": "address",
    "Name": "name",
    "Length": "length",
    "Senders": "direction",
    "Receivers": "receivers",
    "Start": "bit",
    "Size": "bits",
    "Byte order": "word_order",
    "Type": "type",
    "Factor": "scale",
    "Offset": "value_offset",
    "Minimum": "min",
    "Maximum": "max",
    "Unit": "unit",
    "Values": "values",
    "Multiplexer": "condition",
}
_NOTES = ("Comment", "Cycle time", "Initial value")


def can_database(text: str, node: str = "") -> tuple[Sheet, Listing]:
    """The list of a database, as a node has it. Raises ListError."""
    try:
        import cantools
    except ImportError:
        raise ListError(
            "is a database of CAN messages (DBC), which needs more packages: pip install 'fieldspec[lists]'"
        ) from None
    if len(text) > _LONGEST:
        raise ListError(f"has more than {_LONGEST >> 20} MiB; a database of CAN messages is smaller")
    rows = FormatRows("a database of CAN messages (DBC)", _ROLES, _NOTES)
    text = _with_wide_identifiers(text, rows.assumptions)
    database = _loaded(text, rows, partial(cantools.database.load_string, database_format="dbc", strict=False))
    lines = _lines(text)
    own_node = _node(database.messages, node, rows)
    for message in database.messages:
        if message.name != _INDEPENDENT:
            _add(rows, message, own_node, lines)
    rows.items.sort(key=lambda item: item.line)
    return rows.listing(text.count("\n") + 1)


def _with_wide_identifiers(text: str, assumptions: list[Assumption]) -> str:
    """A text whose identifiers of more than 11 bits have the mark of extended ones, which some files lack."""
    numbers = {digits for digits in _MESSAGE.findall(text) if _LAST_STANDARD < int(digits) < _LAST_WIDE}
    if not numbers:
        return text
    first = min(numbers, key=int)
    evidence = f"identifiers such as 0x{int(first):X} do not fit into 11 bits"
    assumptions.append(Assumption("identifiers", "29 bits, without the mark of extended ones", evidence))
    return _OF_MESSAGE.sub(
        lambda match: f"{match[1]}{int(match[2]) | _EXTENDED}" if match[2] in numbers else match[0], text
    )


def _loaded(text: str, rows: FormatRows, load: Callable[[str], Any]) -> Any:
    """The database of a text, without the signals that break the syntax. Raises ListError."""
    try:
        return load(text)
    except Exception as error:  # the library raises what it stumbles over: ParseError, KeyError, ValueError
        return _loaded(_without_line(text, " ".join(str(error).split())[:300], rows), rows, load)


def _without_line(text: str, fault: str, rows: FormatRows) -> str:
    """A text with an empty line in the place of the signal that breaks the syntax, which is refused. Raises ListError
    for a fault elsewhere, and after many of them."""
    place = _FAULT.search(fault)
    lines = text.split("\n")
    number = int(place[1]) if place else 0
    signal = _SIGNAL.match(lines[number - 1]) if 0 < number <= len(lines) else None
    if signal is None or len(rows.items) >= _MOST_FAULTS:
        raise ListError(f"is not a database of CAN messages: {fault}")
    rows.refuse(number, {"Name": signal[1]}, "breaks the syntax of DBC", "Name")
    return "\n".join([*lines[: number - 1], "", *lines[number:]])


def _lines(text: str) -> dict[tuple[int, str], int]:
    """The lines of messages by their identifiers, and of signals by their names too."""
    lines: dict[tuple[int, str], int] = {}
    identifier = -1
    for number, line in enumerate(text.splitlines(), 1):
        if match := _LINE.match(line):
            identifier = int(match["identifier"]) if match["identifier"] else identifier
            lines.setdefault((identifier, match["signal"] or ""), number)
    return lines


def _node(messages: list[Any], node: str, rows: FormatRows) -> str:
    """The node that the device is: the one that is named, or that sends most messages. Raises ListError."""
    senders = Counter(sender for message in messages for sender in message.senders if sender != _NOBODY)
    receivers = {receiver for message in messages for receiver in message.receivers}
    nodes = sorted({*senders, *receivers} - {_NOBODY})
    if node and node not in nodes:
        raise ListError(f"has no node {node}; choose from {', '.join(nodes) or 'none'}")
    if node or not senders:
        return node
    own_node: str
    (own_node, count), *further = sorted(senders.items(), key=lambda pair: (-pair[1], pair[0]))
    if further and further[0][1] == count:
        raise ListError(f"has nodes that send the same number of messages ({', '.join(nodes)}); choose one with --node")
    if len(nodes) > 1:
        evidence = f"it sends {count} messages, more than any other node"
        rows.assumptions.append(Assumption("node", own_node, evidence, "--node"))
    return own_node


def _add(rows: FormatRows, message: Any, node: str, lines: dict[tuple[int, str], int]) -> None:
    """Adds a message and its signals."""
    identifier = message.frame_id | (_EXTENDED if message.is_extended_frame else 0)
    line = lines.get((identifier, ""), 1)
    cells = _message_cells(message)
    try:
        direction = _direction(message, node)
        size = message.length * 8
        if message.signals and all(max(_bits(signal)) >= size for signal in message.signals):
            raise CellError(f"contradicts itself: no signal fits into its {size} bits")
    except CellError as error:
        reason = str(error)
    else:
        reason = ""
        texts = {"name": message.name, "space": MESSAGES}
        place = SignalPlace(0, message.length * 8, "", message.is_extended_frame, direction)
        row = ListRow(0, identifier, names=(message.name,), texts=texts, kind=MESSAGE, space=MESSAGES, place=place)
        rows.add(line, cells, row)
    if reason:
        rows.refuse(line, cells, reason)
    used_bits: dict[int, str] = {}
    for signal in message.signals:
        own_line = lines.get((identifier, signal.name), line)
        signal_cells = {"Identifier": cells["Identifier"], **_signal_cells(signal)}
        if reason:
            rows.refuse(own_line, signal_cells, "belongs to a message that is not taken")
            continue
        rows.take(own_line, signal_cells, partial(_row, identifier, signal, message.length * 8, used_bits))


def _direction(message: Any, node: str) -> str:
    """`response` for what the device sends, `request` for what it receives. Raises CellError for any other message."""
    if not node or node in message.senders or not set(message.senders) - {_NOBODY}:
        return "response"
    if node in message.receivers:
        return "request"
    raise CellError(f"is neither sent nor received by {node}")


def _message_cells(message: Any) -> dict[str, str]:
    return {
        "Identifier": f"0x{message.frame_id:X}",
        "Name": message.name,
        "Length": str(message.length),
        "Senders": " ".join(message.senders),
        "Comment": message.comment or "",
        "Cycle time": f"{message.cycle_time} ms" if message.cycle_time else "",
        **_attributes(message),
    }


def _attributes(owner: Any) -> dict[str, str]:
    attributes = owner.dbc.attributes if owner.dbc is not None else {}
    used = ("GenMsgCycleTime", "GenSigStartValue")
    return {name: str(attribute.value) for name, attribute in attributes.items() if name not in used}


def _signal_cells(signal: Any) -> dict[str, str]:
    multiplexed = ", ".join(map(str, signal.multiplexer_ids or ()))
    return {
        "Name": signal.name,
        "Receivers": " ".join(signal.receivers),
        "Start": str(signal.start),
        "Size": str(signal.length),
        "Byte order": signal.byte_order,
        "Type": "real" if signal.is_float else "signed" if signal.is_signed else "unsigned",
        "Factor": str(signal.scale),
        "Offset": str(signal.offset),
        "Minimum": "" if signal.minimum is None else str(signal.minimum),
        "Maximum": "" if signal.maximum is None else str(signal.maximum),
        "Unit": signal.unit or "",
        "Values": "; ".join(f"{number} {name}" for number, name in (signal.choices or {}).items()),
        "Multiplexer": "multiplexer" if signal.is_multiplexer else multiplexed,
        "Comment": signal.comment or "",
        "Initial value": "" if signal.raw_initial is None else str(signal.raw_initial),
        **_attributes(signal),
    }


def _row(identifier: int, signal: Any, size: int, used_bits: dict[int, str]) -> ListRow:
    """The row of a signal in a message of some bits, of which others are in `used_bits`. Raises CellError."""
    if signal.multiplexer_ids:
        values = ", ".join(map(str, signal.multiplexer_ids[:5]))
        selector = signal.multiplexer_signal
        raise CellError(
            f"is multiplexed: it is there where {selector} is {values}, and a message has all fields always"
        )
    if signal.is_float and signal.length not in _REALS:
        raise CellError(f"is a real number of {signal.length} bits")
    numbers = [_exact(number) for number in (signal.scale, signal.offset, signal.minimum, signal.maximum)]
    scale, offset, low, high = numbers
    if scale is None or scale <= 0 or offset is None:
        raise CellError(f"has the factor {signal.scale} and the offset {signal.offset}")
    numbered = _bits(signal)
    if min(numbered) < 0 or max(numbered) >= size:
        raise CellError(f"does not fit into the {size} bits of its message")
    if other := next((used_bits[bit] for bit in numbered if bit in used_bits), ""):
        raise CellError(f"overlaps {other}, which is taken")
    used_bits |= dict.fromkeys(numbered, signal.name)
    name = _REALS[signal.length] if signal.is_float else "i64" if signal.is_signed else "u64"
    members = tuple((int(number), str(text)) for number, text in (signal.choices or {}).items())
    bounds = {"min": signal.minimum, "max": signal.maximum}
    is_stated = low is not None and high is not None
    return ListRow(
        0,
        identifier,
        names=(signal.name,),
        type=Typed(name),
        low=low if is_stated else None,
        high=high if is_stated else None,
        texts={key: str(bound) for key, bound in bounds.items() if bound is not None},
        kind=SIGNAL,
        space=MESSAGES,
        unit=signal.unit or "",
        scale=Fraction(scale),
        offset=offset,
        meanings=Meanings(members),
        in_unit=scale != 1 or bool(offset),
        place=SignalPlace(*_first_bit(signal), "big" if signal.byte_order == "big_endian" else "little"),
    )


def _bits(signal: Any) -> Sequence[int]:
    """The bits of a signal, counted from the least significant one of the first byte."""
    first, length = _first_bit(signal)
    bits = range(first, first + length)
    return [bit // 8 * 8 + 7 - bit % 8 for bit in bits] if signal.byte_order == "big_endian" else bits


def _first_bit(signal: Any) -> tuple[int, int]:
    """The first bit of a signal, and how many it has: counted from the most significant one of the data where the byte
    order is big, else from the least significant one of the first byte."""
    if signal.byte_order == "big_endian":
        return signal.start // 8 * 8 + 7 - signal.start % 8, signal.length
    return signal.start, signal.length


def _exact(number: float | None) -> Decimal | None:
    return None if number is None else decimal(repr(number))
