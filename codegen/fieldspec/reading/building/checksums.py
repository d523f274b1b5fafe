"""The algorithm of a checksum: a name, or the parameters of one that has none."""

from __future__ import annotations

from fieldspec.model.checksums import Checksum, algorithm_name, catalogue_name, checksum_named, preceded
from fieldspec.reading.building.context import Entry

_CRC_KEYS = ("polynomial", "reflect_in", "reflect_out", "final_xor")
_SUM_KEYS = ("complement", "unit_size")


def algorithm_of(entry: Entry) -> str:
    """The name of the algorithm that a part states; empty where it states none."""
    parameters = entry.entry("checksum")
    name = entry.text("algorithm")
    if parameters is None:
        return catalogue_name(name) if name else ""
    if name:
        entry.refuse("wrong_form", "checksum", "`algorithm` states the checksum already", "remove one of the two")
    method, width = parameters.text("method") or "crc", parameters.integer("width") or 8
    foreign, others = (_SUM_KEYS, "a sum or an xor") if method == "crc" else (_CRC_KEYS, "a CRC")
    for key in parameters.own:
        if key in foreign:
            text = f"`{key}` has no effect on the method {method}"
            parameters.refuse("wrong_form", key, text, f"remove it: only {others} has it")
    if method == "crc" and parameters.integer("polynomial") is None:
        parameters.refuse("wrong_form", "width", "a CRC has a polynomial", "add `polynomial`")
    if method != "crc" and width % 8:
        parameters.refuse("wrong_form", "width", f"the width of the method {method} is not whole bytes", "correct it")
        width = 8
    for key in ("polynomial", "initial", "final_xor"):
        if (parameters.integer(key) or 0) >> width:
            text = f"`{key}` has more than {width} bits"
            help = "leave out the highest bit of the polynomial" if key == "polynomial" else "correct it or the width"
            parameters.refuse("wrong_form", key, text, help)
    return algorithm_name(_checksum(parameters, method, width))


def preceded_algorithm(entry: Entry, algorithm: str, order: str) -> str:
    """The algorithm of a part whose computation begins behind its prefix."""
    prefix = bytes.fromhex(entry.text("prefix"))
    kind = checksum_named(algorithm)
    if not prefix:
        return algorithm
    if kind.method != "crc" and len(prefix) % kind.unit_size:
        text = f"the prefix has {len(prefix)} bytes, but the algorithm takes {kind.unit_size} at a time"
        entry.refuse("wrong_form", "prefix", text, f"fill it up to a multiple of {kind.unit_size} bytes")
        return algorithm
    return algorithm_name(preceded(kind, prefix, order))


def _checksum(parameters: Entry, method: str, width: int) -> Checksum:
    most = (1 << width) - 1
    initial = (parameters.integer("initial") or 0) & most
    if method != "crc":
        unit_size = parameters.integer("unit_size") or (1 if method == "sum" else width // 8)
        return Checksum(method, width, initial=initial, complement=parameters.text("complement"), unit_size=unit_size)
    return Checksum(
        method,
        width,
        (parameters.integer("polynomial") or 1) & most,
        initial,
        parameters.flag("reflect_in"),
        parameters.flag("reflect_out"),
        (parameters.integer("final_xor") or 0) & most,
    )
