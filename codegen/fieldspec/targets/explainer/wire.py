"""Checksums and escapes as expressions of JavaScript, by functions of the runtime."""

from __future__ import annotations

import re

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import replace
from fieldspec.language.model.checksums import algorithm_name, checksum_named
from fieldspec.language.model.escape import Escape
from fieldspec.targets.explainer.codecs import constant_name
from fieldspec.targets.explainer.literals import literal

PURE = "/* @__PURE__ */"
"""Marks a call without effects, which a bundler drops where nothing uses its result."""

SHORT = {"crc16_modbus": "crc16", "lrc": "lrc", "sum8": "sum8"}
"""The functions of `checksums.js` by the names of the algorithms that have one of their own."""

_CALLED = re.compile(rf"\b[a-z]\w*(?=\()|\b(?:cobs|{'|'.join(SHORT.values())})\b")


def used_functions(layout: DeviceLayout) -> list[str]:
    """The functions of the runtime that the checksums and escapes of a device call, in the order of their names."""
    frames = [frame for link in layout.links.values() for frame in (link.request, link.response)]
    parts = [part for frame in frames for part in frame.checksums]
    expressions = [checksum_function(part.algorithm, part.order) for part in parts]
    expressions += [escape_object(frame.escape) for frame in frames if frame.escape is not None]
    return sorted({word for expression in expressions for word in _CALLED.findall(expression)})


def escape_object(escape: Escape | None) -> str:
    """The object that escapes bytes, or null."""
    if escape is None:
        return "null"
    if escape.method == "cobs":
        return "cobs"
    if escape.method == "can":
        fields = [[size, int(order == "little"), first, width] for size, order, first, width in escape.fields]
        remote = "" if escape.remote is None else f", {escape.remote}"
        return f"{PURE} canIdentifier({escape.bits}, {fields}{remote})"
    if escape.method == "add":
        return f"{PURE} adding({escape.inserted})"
    if escape.method == "insert":
        return f"{PURE} inserting({list(escape.pattern)}, {escape.inserted})"
    return f"{PURE} replacing({[list(pair) for pair in escape.pairs]})"


def checksum_function(algorithm: str, order: str) -> str:
    """The function that computes a checksum; `order` is that of the numbers which a sum or an xor combines."""
    short = SHORT.get(algorithm)
    if short is not None:
        return short
    kind = checksum_named(algorithm)
    if kind.codec:
        return constant_name(kind.codec)
    if kind.avoided:
        function = checksum_function(algorithm_name(replace(kind, avoided=b"", replacements=b"")), order)
        return f"{PURE} avoiding({function}, {kind.size}, {list(kind.avoided)}, {list(kind.replacements)})"
    if kind.suffix:
        function = checksum_function(algorithm_name(replace(kind, suffix=b"")), order)
        return f"{PURE} followedBy({function}, {list(kind.suffix)})"
    if kind.method == "crc" and kind.unit_size > 1:
        function = checksum_function(algorithm_name(replace(kind, unit_size=1)), order)
        return f"{PURE} swapping({function}, {kind.unit_size})"
    units = f'unitSize: {kind.unit_size}, order: "{kind.unit_order or order}"'
    if kind.method == "crc":
        register = f"width: {kind.width}, polynomial: 0x{kind.polynomial:X}n, initial: 0x{kind.initial:X}n"
        order_of_bits = f"reflectIn: {literal(kind.reflect_in)}, reflectOut: {literal(kind.reflect_out)}"
        return f"{PURE} crcOf({{ {register}, {order_of_bits}, finalXor: 0x{kind.final_xor:X}n }})"
    if kind.method == "fletcher":
        numbers = f"width: {kind.width}, initial: {kind.initial}n, modulus: {kind.modulus}n"
        return f"{PURE} fletcherOf({{ {numbers}, {units} }})"
    numbers = f'method: "{kind.method}", width: {kind.width}, initial: {kind.initial}n, complement: "{kind.complement}"'
    return f"{PURE} totalOf({{ {numbers}, {units} }})"
