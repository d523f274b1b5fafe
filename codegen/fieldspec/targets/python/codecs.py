"""The codecs of packages in Python: a module for each, with the text of the package, that a device registers."""

from __future__ import annotations

from hashlib import sha256

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.package_codecs import checksum_codecs, number_codecs
from fieldspec.language.model.codecs import Codec, installed
from fieldspec.targets.python.text import literal


def codec_key(name: str) -> str:
    """The key of a codec in the runtime: its name and a digest of its text, as devices may use two versions of it."""
    return f"codec_{name}_{sha256(installed()[name].codec.python.encode()).hexdigest()[:8]}"


def codec_modules(layout: DeviceLayout) -> dict[str, str]:
    """The text of the module of each codec that a device uses, by the name of the module."""
    numbers = {
        name: _text(codec, f"add_number({literal(codec_key(name))}, {codec.low}, {codec.high}, decode, encode)")
        for name, codec in number_codecs(layout).items()
    }
    checksums = {
        name: _text(codec, f"add_checksum({literal(codec_key(name))}, checksum)")
        for name, codec in checksum_codecs(layout).items()
    }
    return {f"_codec_{name}": text for name, text in (numbers | checksums).items()}


def _text(codec: Codec, call: str) -> str:
    function = call.partition("(")[0]
    return f"{codec.python.rstrip()}\n\n\nfrom .._codecs import {function}  # noqa: E402\n\n{call}\n"
