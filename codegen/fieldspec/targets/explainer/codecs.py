"""The codecs of packages in JavaScript, as constants that stand before whatever uses them."""

from __future__ import annotations

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.package_codecs import checksum_codecs, number_codecs
from fieldspec.language.model.codecs import Codec, number_codec
from fieldspec.language.model.value import Value


def constant_name(name: str) -> str:
    """The constant of a codec; no name of a device has small letters and `_`."""
    return f"codec_{name}"


def javascript(codec: Codec) -> str:
    """The text of a codec."""
    return codec.javascript


def has_no_text(value: Value) -> bool:
    """Whether a value has a codec without JavaScript."""
    return bool(value.codec) and not number_codec(value.codec).javascript


def codec_constants(layout: DeviceLayout) -> list[str]:
    """The lines that define the codecs of a device that have a text: the form of digits, and the function of checksums.

    What a package declares stays in the scope of a function.
    """
    numbers = number_codecs(layout)
    lines = []
    for name, codec in numbers.items():
        if codec.javascript:
            content = f'digits: "codec", codec: {{ decode, encode }}, low: {codec.low}, high: {codec.high}'
            lines += _constant(name, codec.javascript, f"{{ {content} }}")
    for name, checksum in checksum_codecs(layout).items():
        if checksum.javascript:
            function = "(bytes, start, stop) => checksum(bytes.subarray(start, stop))"
            lines += _constant(name, checksum.javascript, function)
    return lines


def _constant(name: str, text: str, result: str) -> list[str]:
    return [
        f"const {constant_name(name)} = /* @__PURE__ */ (() => {{",
        *text.strip().splitlines(),
        f"return {result};",
        "})();",
        "",
    ]
