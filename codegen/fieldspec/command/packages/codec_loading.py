"""Loads the codecs of installed packages, judges them, and guards the compiler against what is wrong with them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import wraps
from random import Random
from threading import Thread
from typing import Any

from fieldspec.command.packages.plugin_loading import loaded
from fieldspec.command.packages.plugins import CODECS, FAILURES, Plugin, plugins
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.codecs import MOST_EXACT, ChecksumCodec, Codec, InstalledCodec, NumberCodec

_ROUNDS = 300
_LARGEST = 64
_SECONDS = 10.0
"""How long the judges may take; they need some milliseconds."""


def load_codecs() -> Mapping[str, InstalledCodec]:
    """The codecs of installed packages by name. Raises UsageError for a package that declares something else."""
    return {name: judged_codec(plugin) for name, plugin in plugins(CODECS, ()).items()}


def judged_codec(plugin: Plugin) -> InstalledCodec:
    """The codec that an entry point refers to, and what its judges find. Raises UsageError for something else."""
    codec = loaded(plugin)
    if not isinstance(codec, NumberCodec | ChecksumCodec):
        raise plugin.error(f"{plugin.value} is neither a NumberCodec nor a ChecksumCodec")
    texts = (codec.version, codec.python, codec.c, codec.javascript)
    if not all(isinstance(text, str) for text in texts) or not codec.version.isprintable():
        raise plugin.error("its version, of one line, and the texts of its targets are texts")
    functions: dict[str, Callable[..., object]] = {}
    fault = _bounds_fault(codec) or _within_time(lambda: _fault(plugin, codec, functions))
    guarded = {name: _guarded(plugin, function) for name, function in functions.items()}
    return InstalledCodec(codec, guarded, fault)


def _guarded(plugin: Plugin, function: Callable[..., object]) -> Callable[..., object]:
    """A function whose failures name its package. It has passed its judges, so this is a rare number."""

    @wraps(function)
    def call(argument: object) -> object:
        try:
            return function(argument)
        except FAILURES as error:
            raise plugin.failed(error) from error

    return call


def _bounds_fault(codec: Codec) -> str:
    match codec:
        case NumberCodec():
            numbers = (codec.low, codec.high, codec.size)
            is_bounded = all(type(number) is int for number in numbers) and 0 < codec.size <= _LARGEST
            if not is_bounded or not -MOST_EXACT <= codec.low <= codec.high <= MOST_EXACT:
                return f"it has no 1 to {_LARGEST} bytes, or no whole numbers `low` and `high` of at most 53 bits"
        case ChecksumCodec():
            if type(codec.size) is not int or not 0 < codec.size <= 8:
                return "it has no 1 to 8 bytes"
        case _:
            assert_never(codec)
    return ""


def _within_time(judgement: Callable[[], str]) -> str:
    """The result of a judgement; that it does not end is one too."""
    results: list[str] = []
    thread = Thread(target=lambda: results.append(judgement()), daemon=True)
    thread.start()
    thread.join(_SECONDS)
    return results[0] if results else f"it has not ended after {_SECONDS:.0f} seconds"


def _fault(plugin: Plugin, codec: Codec, functions: dict[str, Callable[..., object]]) -> str:
    """The fault of the Python of a codec, whose functions are added; empty if it has none."""
    random = Random(plugin.name)
    space: dict[str, Any] = {"__name__": f"{plugin.value}.python"}
    try:
        exec(compile(codec.python, f"<{plugin.name}>", "exec"), space)
        match codec:
            case NumberCodec():
                functions |= {name: space[name] for name in ("decode", "encode")}
                return _number_fault(codec, functions["decode"], functions["encode"], random)
            case ChecksumCodec():
                functions |= {"checksum": space["checksum"]}
                return _checksum_fault(codec, functions["checksum"], random)
            case _:
                assert_never(codec)
    except FAILURES as error:
        return f"{type(error).__name__}: {' '.join(str(error).split())}"


def _number_fault(
    codec: NumberCodec, decode: Callable[..., object], encode: Callable[..., object], random: Random
) -> str:
    numbers = [codec.low, codec.high, *(number for number in (-1, 0, 1) if codec.low <= number <= codec.high)]
    for _ in range(_ROUNDS):
        bits = random.randrange(1, 54)
        numbers.append(min(max(random.randrange(-1 << bits, 1 << bits), codec.low), codec.high))
        numbers.append(random.randint(codec.low, codec.high))
        read = decode(random.randbytes(codec.size))
        if read is None:
            continue
        if type(read) is not int or not codec.low <= read <= codec.high:
            return f"decode gives {read!r}, and not None or a whole number from {codec.low} to {codec.high}"
        if decode(_bytes(codec, encode(read))) != read:
            return f"decode gives {read}, and another number for the bytes that encode gives for it"
    for number in numbers:
        data = _bytes(codec, encode(number))
        read = decode(data)
        if read != number and not codec.rounds:
            return f"encode gives {data.hex(' ').upper()} for {number}, and decode {read} for these bytes"
        if read is None or decode(_bytes(codec, encode(read))) != read:
            return f"encode gives {data.hex(' ').upper()} for {number}, and no number keeps these bytes"
    return ""


def _bytes(codec: NumberCodec, data: object) -> bytes:
    if type(data) is not bytes or len(data) != codec.size:
        raise ValueError(f"encode gives {data!r}, and not {codec.size} bytes")
    return data


def _checksum_fault(codec: ChecksumCodec, checksum: Callable[..., object], random: Random) -> str:
    for size in range(_ROUNDS):
        data = random.randbytes(size % _LARGEST)
        number = checksum(data)
        if type(number) is not int or not 0 <= number < 1 << 8 * codec.size:
            return f"checksum gives {number!r}, and not a number of {codec.size} bytes"
        if checksum(data) != number:
            return f"checksum gives {number}, and another number for the same bytes"
    return ""
