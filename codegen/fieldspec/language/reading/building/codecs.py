"""The codecs of packages that a spec names."""

from __future__ import annotations

from fieldspec.language.model.checksums import Checksum, algorithm_name
from fieldspec.language.model.codecs import ChecksumCodec, NumberCodec, installed
from fieldspec.language.reading.building.context import Entry
from fieldspec.language.reading.findings import near

_RULE = "codec_usable"
_KINDS = {NumberCodec: "numbers", ChecksumCodec: "checksums"}


def number_codec_name(entry: Entry) -> str:
    """The name of the codec of a number; empty where it states none, or one that nothing can use."""
    codec = _usable(entry, NumberCodec) if entry.value("codec") is not None else None
    if not isinstance(codec, NumberCodec):
        return ""
    if "digits" in entry.own:
        entry.refuse("wrong_form", "digits", "`digits` has no effect beside `codec`", "remove one of the two")
    if entry.integer("length") not in (None, codec.size):
        text = f"the length is {entry.integer('length')}, but the codec {entry.text('codec')} has {codec.size} bytes"
        entry.refuse(_RULE, "length", text, f"write {codec.size}, or name the codec that is meant")
    return entry.text("codec")


def checksum_codec_name(parameters: Entry, width: int) -> str:
    """The name of the algorithm of a codec; that of a sum where nothing can use the codec."""
    if parameters.value("codec") is None:
        parameters.refuse("wrong_form", "method", "the method `codec` has the name of a codec", "add `codec`")
        return "sum8"
    codec = _usable(parameters, ChecksumCodec)
    if not isinstance(codec, ChecksumCodec):
        return "sum8"
    name = parameters.text("codec")
    if width != 8 * codec.size:
        text = f"the width is {width} bits, but the codec {name} has {8 * codec.size}"
        parameters.refuse(_RULE, "width", text, f"write {8 * codec.size}, or name the codec that is meant")
    return algorithm_name(Checksum("codec", 8 * codec.size, codec=name))


def _usable(entry: Entry, kind: type[NumberCodec] | type[ChecksumCodec]) -> NumberCodec | ChecksumCodec | None:
    """The codec that an entry names, if it is of a kind and nothing is wrong with it."""
    name, codecs = entry.text("codec"), installed()
    if name not in codecs:
        names = [known for known, codec in codecs.items() if isinstance(codec.codec, kind)]
        help = f"{near(name, names)} Or install" if names else "install"
        text = f"no installed package gives {_KINDS[kind]} a codec {name}"
        entry.refuse(_RULE, "codec", text, f"{help} the package that has it, or write one: docs/extend.md")
        return None
    codec = codecs[name]
    if not isinstance(codec.codec, kind):
        text = f"the codec {name} is one of {_KINDS[type(codec.codec)]}, not of {_KINDS[kind]}"
        entry.refuse(_RULE, "codec", text, "name another one")
        return None
    if codec.fault:
        entry.refuse(_RULE, "codec", f"the codec {name} cannot be used: {codec.fault}", "correct the package")
        return None
    return codec.codec
