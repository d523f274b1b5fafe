"""The algorithm of a checksum: a name, or the parameters of one that has none."""

from __future__ import annotations

from fieldspec.foundation.classes import replace
from fieldspec.language.model.checksums import Checksum, algorithm_name, catalogue_name, checksum_named, preceded
from fieldspec.language.reading.building.codecs import checksum_codec_name
from fieldspec.language.reading.building.context import Entry

_OWNERS = {
    **dict.fromkeys(("polynomial", "reflect_in", "reflect_out", "final_xor"), (("crc",), "a CRC")),
    "complement": (("sum", "xor"), "a sum or an xor"),
    "modulus": (("fletcher",), "a Fletcher checksum"),
    "initial": (("crc", "sum", "xor", "fletcher"), "what the language computes"),
    "unit_size": (("crc", "sum", "xor", "fletcher"), "what the language computes"),
    "unit_order": (("crc", "sum", "xor", "fletcher"), "what the language computes"),
    "codec": (("codec",), "the method `codec`"),
}
"""The methods that have a parameter, and what these are called."""


def algorithm_of(entry: Entry, link_order: str) -> str:
    """The name of the algorithm that a part states; empty where it states none. `link_order` is that of the link."""
    parameters = entry.entry("algorithm")
    if parameters is None:
        name = entry.text("algorithm")
        return catalogue_name(name) if name else ""
    method, width = parameters.text("method") or "crc", parameters.integer("width") or 8
    for key in parameters.own:
        methods, owners = _OWNERS.get(key, ((method,), ""))
        if method not in methods:
            text = f"`{key}` has no effect on the method {method}"
            parameters.refuse("wrong_form", key, text, f"remove it: only {owners} has it")
    if method == "codec":
        return checksum_codec_name(parameters, width)
    if method == "crc" and parameters.integer("polynomial") is None:
        parameters.refuse("wrong_form", "width", "a CRC has a polynomial", "add `polynomial`")
    if method in ("sum", "xor") and width % 8:
        parameters.refuse("wrong_form", "width", f"the width of the method {method} is not whole bytes", "correct it")
        width = 8
    if method == "fletcher":
        width = _fletcher_width(parameters, width)
    for key in ("polynomial", "initial", "final_xor"):
        if (parameters.integer(key) or 0) >> width:
            text = f"`{key}` has more than {width} bits"
            help = "leave out the highest bit of the polynomial" if key == "polynomial" else "correct it or the width"
            parameters.refuse("wrong_form", key, text, help)
    order = entry.text("byte_order") or link_order
    return algorithm_name(_with_units(parameters, _checksum(parameters, method, width), order or "little"))


def _with_units(parameters: Entry, kind: Checksum, order: str) -> Checksum:
    """An algorithm with the order of the numbers that it takes; `order` is that of the checksum.

    A CRC takes the highest bit of each number first, or the lowest one: in one order of the bytes these come as they
    are on the wire.
    """
    unit_order = parameters.text("unit_order") or order
    size = parameters.integer("unit_size") or kind.unit_size
    if size == 1 and "unit_order" in parameters.own:
        text = "`unit_order` has no effect on single bytes"
        parameters.refuse("wrong_form", "unit_order", text, "state `unit_size`, or remove it")
    if kind.method != "crc":
        return replace(kind, unit_order=unit_order) if size > 1 and unit_order != order else kind
    if size > 1 and (unit_order == "little") == kind.reflect_in:
        other = "big" if kind.reflect_in else "little"
        text = f"`unit_size` has no effect on a CRC that takes the bytes of each number in the {unit_order} order"
        help = f"remove it, or state `unit_order: {other}` if the last byte of each number comes first"
        parameters.refuse("wrong_form", "unit_size", text, help)
    return replace(kind, unit_size=size)


def avoiding(entry: Entry, algorithm: str) -> str:
    """The algorithm of a part with its replacements for the bytes that must not occur."""
    stated = entry.entry("avoids")
    if stated is None:
        return algorithm
    avoided, replacements = (bytes.fromhex(stated.text(key)) for key in ("bytes", "replacements"))
    if entry.text("digits"):
        text = "`avoids` has no effect on digits, which are not bytes of the number"
        entry.refuse("wrong_form", "avoids", text, "remove `avoids` or `digits`")
    if len(avoided) != len(replacements):
        text = f"the number of replacements is {len(replacements)}, but that of the bytes {len(avoided)}"
        stated.refuse("wrong_form", "replacements", text, "state one for each of the `bytes`, in their order")
        return algorithm
    if len(set(avoided)) < len(avoided) or set(avoided) & set(replacements):
        text = "a byte that must not occur is there twice, or among the replacements"
        stated.refuse("wrong_form", "replacements", text, "correct `bytes` and `replacements`")
        return algorithm
    return algorithm_name(replace(checksum_named(algorithm), avoided=avoided, replacements=replacements))


def surrounded_algorithm(entry: Entry, algorithm: str, order: str) -> str:
    """The algorithm of a part whose computation begins after its prefix and ends after its suffix."""
    prefix, suffix = bytes.fromhex(entry.text("prefix")), bytes.fromhex(entry.text("suffix"))
    kind = checksum_named(algorithm)
    if not prefix:
        return algorithm_name(replace(kind, suffix=suffix)) if suffix else algorithm
    if len(prefix) % kind.unit_size:
        text = f"the prefix has {len(prefix)} bytes, but the algorithm takes {kind.unit_size} at a time"
        entry.refuse("wrong_form", "prefix", text, f"fill it up to a multiple of {kind.unit_size} bytes")
        return algorithm
    return algorithm_name(replace(preceded(kind, prefix, order), suffix=suffix))


def _fletcher_width(parameters: Entry, width: int) -> int:
    """The width of a Fletcher checksum, whose sums have half of it each and are less than its modulus."""
    if width % 16:
        text = f"the width of the method fletcher is {width} bits, but it has two sums of whole bytes"
        parameters.refuse("wrong_form", "width", text, "state 16, 32, 48 or 64: the bits of both sums")
        return 16
    half = width // 2
    if 8 * (parameters.integer("unit_size") or 1) > half:
        text = f"a number of {parameters.integer('unit_size')} bytes has more than the {half} bits of a sum"
        parameters.refuse("wrong_form", "unit_size", text, "correct it or the width, which has the bits of both sums")
    modulus, initial = parameters.integer("modulus"), parameters.integer("initial") or 0
    if modulus is not None and modulus > 1 << half:
        text = f"`modulus` is {modulus}, but a sum of {half} bits is less than {1 << half}"
        parameters.refuse("wrong_form", "modulus", text, "correct it or the width, which has the bits of both sums")
    elif max(divmod(initial, 1 << half)) >= (modulus or (1 << half) - 1):
        text = f"a sum begins with a number that is not less than the modulus {modulus or (1 << half) - 1}"
        parameters.refuse("wrong_form", "initial", text, f"correct it: each {half} bits of it are one sum's")
    return width


def _checksum(parameters: Entry, method: str, width: int) -> Checksum:
    mask = (1 << width) - 1
    initial = (parameters.integer("initial") or 0) & mask
    if method != "crc":
        usual_size = {"sum": 1, "xor": width // 8, "fletcher": width // 16}[method]
        modulus = (parameters.integer("modulus") or (1 << width // 2) - 1) if method == "fletcher" else 0
        return Checksum(
            method,
            width,
            initial=initial,
            complement=parameters.text("complement") if method != "fletcher" else "",
            unit_size=parameters.integer("unit_size") or usual_size,
            modulus=modulus,
        )
    return Checksum(
        method,
        width,
        (parameters.integer("polynomial") or 1) & mask,
        initial,
        parameters.flag("reflect_in"),
        parameters.flag("reflect_out"),
        (parameters.integer("final_xor") or 0) & mask,
    )
