"""Links: parts of frames, unit addresses, serial settings, ports of a network."""

from __future__ import annotations

from decimal import Decimal
from typing import cast

from fieldspec.foundation.caches import ByIdentity
from fieldspec.foundation.classes import replace
from fieldspec.language.model.checksums import SIMPLE
from fieldspec.language.model.escape import CAN_BITS, Escape
from fieldspec.language.model.link import ExceptionResponse, Link, Network, Part, PartSpan, Serial, UnitAddresses
from fieldspec.language.model.preamble import Preamble
from fieldspec.language.model.ranges import Ranges
from fieldspec.language.model.value import Value
from fieldspec.language.reading.building.checksums import algorithm_of, avoiding, surrounded_algorithm
from fieldspec.language.reading.building.context import Entry, Reused, rows
from fieldspec.language.reading.building.escapes import escape
from fieldspec.language.reading.building.values import VALUE_KEYS, value

_LONGEST_PREAMBLE = 255
_VALUED = ("unit_address", "code", "length", "plain")
_NUMBER_KEYS = frozenset({"type", "byte_order", "digits", "length"})
_KEYS = {
    "unit_address": _NUMBER_KEYS | {"range"},
    "code": _NUMBER_KEYS,
    "length": _NUMBER_KEYS | {"range", "measures"},
    "body": frozenset[str](),
    "checksum": frozenset({"algorithm", "byte_order", "covers", "digits", "prefix", "suffix", "avoids"}),
    "plain": VALUE_KEYS
    - {"characters", "places", "sentinels", "parameter", "default", "unit_default"}
    - {"encoding", "padding", "align", "terminator", "varies"}
    | {"reserved", "same_as"},
}
"""The keys of a part by its role, except the keys of every fact."""
_SPECIFIC = VALUE_KEYS | {"algorithm", "covers", "measures", "prefix", "suffix", "avoids"}
_SPECIFIC |= {"reserved", "same_as"}
_UNIT_SIZES = {"bytes": 1, "words": 2}
_HELP = {
    "const": "remove `const`, or remove the `role` of the part",
    "offset": "a length takes `measures: {plus: ..}` instead; remove `offset`",
    "measures": "move it to the part with `role: length`",
    "covers": "move it to the part with `role: checksum`",
    "prefix": "move it to the part with `role: checksum`",
    "suffix": "move it to the part with `role: checksum`",
    "avoids": "move it to the part with `role: checksum`",
    "digits": "remove `digits`, and state them at the fields of messages",
    "flags": "remove `flags`; only a part without a `role` is a word of bits",
    "algorithm": "state its `algorithm`; other parts have none",
    "reserved": "move it to a part without a `role`",
    "same_as": "move it to a part without a `role`; a response always has the unit address of its request",
}


def link(entry: Entry, reused: Reused) -> Link:
    """The link that an entry states. `reused` has the parts and unit addresses of other versions."""
    exception, silence, names = (
        entry.entry("exception_response"),
        entry.entry("silence"),
        entry.entry("direction_names"),
    )
    escaping, can = entry.entry("escape"), entry.entry("can")
    order = entry.text("byte_order")

    def parts(direction: str) -> tuple[Part, ...]:
        path = f"{entry.path}/{direction}"
        return rows(entry, path, None, reused, lambda inner: _part(inner, order), order, key=direction)

    request, response = (own if can else _in_shared_bytes(own) for own in (parts("request"), parts("response")))
    delimiters, preamble = _delimiters(entry), _preamble(entry)
    if preamble is not None:
        delimiters |= {key: preamble.start + delimiters[key] for key in ("start", "response_start")}
    stated = (entry.entry("start"), entry.entry("end"), entry.entry("preamble"), escaping, can)
    cited = [*entry.sources, *(source for part in stated if part for source in part.sources)]
    return entry.built(
        Link,
        **{**entry.fact(), "sources": tuple(dict.fromkeys(cited))},
        transmission=entry.text("transmission") or "binary",
        start=delimiters["start"],
        end=delimiters["end"],
        response_start=delimiters["response_start"],
        response_end=delimiters["response_end"],
        request=request,
        response=response,
        message_name=entry.text("message_name") or "message",
        request_name=names.text("request") if names and names.text("request") else "request",
        response_name=names.text("response") if names and names.text("response") else "response",
        exception_response=_exception_response(exception) if exception else None,
        unit_addresses=_unit_addresses(entry, reused),
        serial=_serial(entry),
        network=_network(entry),
        is_default=entry.flag("default"),
        silence_characters=_silence(silence, "characters"),
        silence_milliseconds=_silence(silence, "milliseconds"),
        silence_sources=silence.citations("source") if silence else (),
        preamble=preamble,
        escape=_identifier(can, request, order) if can else escape(escaping) if escaping else None,
    )


def _identifier(entry: Entry, parts: tuple[Part, ...], order: str) -> Escape:
    """How the parts with bits become the identifier of a CAN frame."""
    fields = tuple(
        (part.value.size, part.value.byte_order or order or "big", part.bits[0], part.bits[1] - part.bits[0] + 1)
        for part in parts
        if part.bits is not None and part.value is not None
    )
    bits = entry.integer("identifier") or CAN_BITS[0]
    if bits not in CAN_BITS:
        entry.refuse("wrong_form", "identifier", f"no identifier has {bits} bits", "write 11 or 29")
    return Escape("can", (), b"\0", 0, "", "", fields, bits)


def _preamble(entry: Entry) -> Preamble | None:
    """The byte before each frame, and how often it is sent and may be received."""
    stated = entry.entry("preamble")
    if stated is None:
        return None
    number, count = stated.integer("sent") or 0, stated.whole_ranges("count")
    if count is None or len(count.intervals) > 1 or not 0 <= count.low <= number <= count.high <= _LONGEST_PREAMBLE:
        text = f"a preamble is received from a least to a greatest number of times, at most {_LONGEST_PREAMBLE},"
        entry.refuse("wrong_form", "preamble", f"{text} and is sent one of these", "state them as `count: 5..20`")
        count = Ranges(((number, number),))
    return Preamble(stated.integer("byte") or 0, count.low, count.high, number)


def _delimiters(entry: Entry) -> dict[str, bytes]:
    """The delimiters of both directions, which are stated once where they are the same."""
    delimiters = {}
    for key in ("start", "end"):
        by_direction = entry.entry(key)
        for direction, prefix in (("request", ""), ("response", "response_")):
            text = entry.text(key) if by_direction is None else by_direction.text(direction)
            delimiters[prefix + key] = bytes.fromhex(text)
    return delimiters


def _exception_response(entry: Entry) -> ExceptionResponse:
    marks = [key for key in ("flag", "code", "part", "field") if key in entry.own]
    if len(marks) != 1:
        text = f"an exception response has {len(marks)} marks" if marks else "nothing marks an exception response"
        entry.refuse(
            "wrong_form", marks[-1] if marks else "record", text, "state one of `flag`, `code`, `part` and `field`"
        )
    if ("normal" in entry.own) != ("part" in entry.own):
        key = "part" if "part" in entry.own else "normal"
        entry.refuse("wrong_form", key, "`part` and `normal` need each other", "add the other one, or remove both")
    part, field, code = entry.text("part"), entry.text("field"), entry.integer("code")
    return entry.built(
        ExceptionResponse,
        flag=(entry.integer("flag") or 0) if code is None and not part and not field else 0,
        code=None if part or field else code,
        part=part,
        normal=entry.whole_ranges("normal") if part else None,
        field=field,
    )


def _part(entry: Entry, link_order: str) -> Part:
    role = entry.text("role") or "plain"
    algorithm = algorithm_of(entry, link_order)
    if (role == "checksum") != bool(algorithm):
        entry.refuse("wrong_form", "role", "a checksum has an algorithm, other parts have none", _HELP["algorithm"])
        algorithm = algorithm or "sum8"
    order, digits = entry.text("byte_order"), entry.text("digits") if role == "checksum" else ""
    if role == "checksum" and algorithm not in SIMPLE:
        order = order or link_order
    if algorithm:
        algorithm = avoiding(entry, algorithm)
    if digits and entry.text("byte_order"):
        text = "`byte_order` has no effect on digits, which begin with the highest one"
        entry.refuse("wrong_form", "byte_order", text, "remove `byte_order`")
    for key in entry.own:
        if key in _SPECIFIC and key not in _KEYS[role] and key != "algorithm":
            text = f"`{key}` has no effect in a part with the role {role}"
            entry.refuse("wrong_form", key, text, _HELP.get(key, f"remove `{key}`"))
    measures, covers, bits = entry.entry("measures"), entry.entry("covers"), entry.bit_range("bits")
    span = measures if role == "length" else covers if role == "checksum" else None
    return entry.built(
        Part,
        role=role,
        value=_value(entry, bits) if role in _VALUED else None,
        algorithm=surrounded_algorithm(entry, algorithm, order) if role == "checksum" else algorithm,
        stated_algorithm=algorithm,
        prefix=bytes.fromhex(entry.text("prefix")) if role == "checksum" else b"",
        suffix=bytes.fromhex(entry.text("suffix")) if role == "checksum" else b"",
        byte_order=order,
        span=_span(span) if span is not None else PartSpan("", ""),
        unit_size=_UNIT_SIZES[span.text("in") or "bytes"] if span is not None else 1,
        plus=(span.integer("plus") or 0) if span is not None else 0,
        digits=digits,
        bits=bits,
    )


def _in_shared_bytes(parts: tuple[Part, ...]) -> tuple[Part, ...]:
    """Parts of some bits: neighbours have the same bytes, until all bits of their type have a part."""
    placed, free = [], 0
    for part in parts:
        if part.bits is None or part.value is None:
            placed.append(part)
            free = 0
            continue
        width = part.bits[1] - part.bits[0] + 1
        placed.append(replace(part, value=replace(part.value, packed_bits=width), is_shared=free > 0))
        free = (free if free > 0 else 8 * part.value.size) - width
    return tuple(placed)


def _span(entry: Entry) -> PartSpan:
    return PartSpan(entry.text("from"), entry.text("to"), entry.flag("before_escape"))


def _value(entry: Entry, bits: tuple[int, int] | None) -> Value:
    """The value of a part; one with bits, or sent as digits, has no greater number than these can hold."""
    own = value(entry)
    highest = (1 << bits[1] - bits[0] + 1) - 1 if bits is not None else own.high
    is_free = own.ranges is None and own.const is None and entry.text("role") not in ("code", "length")
    if highest >= own.type.high or not is_free:
        return own
    return replace(own, ranges=Ranges(((0, highest),)))


def _unit_addresses(entry: Entry, reused: Reused) -> UnitAddresses | None:
    addresses = entry.entry("unit_addresses")
    if addresses is None:
        return None
    by_node = reused.setdefault((addresses.path, addresses.section, addresses.sources), ByIdentity())
    if addresses.node in by_node:
        return cast("UnitAddresses", by_node[addresses.node])
    before = len(entry.findings)
    result = addresses.built(UnitAddresses, ranges=addresses.whole_ranges("range"))
    if len(entry.findings) == before:  # a finding is for every version
        by_node[addresses.node] = result
    return result


def _silence(silence: Entry | None, key: str) -> Decimal | None:
    """The silence between frames in the unit of a key; None where it is not stated in it."""
    time = silence.decimal(key) if silence is not None else None
    if silence is not None and time is not None and time <= 0:
        silence.refuse(
            "wrong_form", key, "no silence is between the frames", "state a time above 0, or remove `silence`"
        )
    return time


def _network(entry: Entry) -> Network | None:
    network = entry.entry("network")
    if network is None:
        return None
    ports = {key: network.integer(key) for key in ("tcp", "udp")}
    if not any(ports.values()):
        entry.refuse("wrong_form", "network", "a network has no port", "add `tcp` or `udp`, or remove `network`")
    return Network(**ports, sources=network.sources)


def _serial(entry: Entry) -> Serial | None:
    serial = entry.entry("serial")
    if serial is None:
        return None
    speeds, usual = serial.integers("baud"), serial.integer("default_baud")
    if usual is not None and speeds and usual not in speeds:
        text = f"the factory speed, {usual}, is not in the list of speeds"
        serial.refuse("wrong_form", "default_baud", text, "correct it, or add it to `baud`")
    for key, values, default in (
        ("data_bits", serial.integers("data_bits"), serial.integer("default_data_bits")),
        ("parity", serial.texts("parity"), serial.text("default_parity")),
    ):
        if default and values and default not in values:
            text = f"`default_{key}` is `{default}`, which is not in `{key}`"
            serial.refuse("wrong_form", f"default_{key}", text, f"correct it, or add it to `{key}`")
    return serial.built(Serial)
