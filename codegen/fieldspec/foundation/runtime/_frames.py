"""Frames: delimiters, characters, header, body and checksum."""

from __future__ import annotations

from binascii import Error as HexError
from binascii import hexlify, unhexlify
from struct import Struct

from ._checks import crc16_modbus, lrc, sum8
from ._error import CodecError, wrong_const
from ._record import Record
from ._typing import TYPE_CHECKING, Generic, M, R

if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any, ClassVar, Literal

    from ._digits import Digits
    from ._typing import Data

_CHECKS = {"crc16_modbus": (crc16_modbus, 2), "lrc": (lrc, 1), "sum8": (sum8, 1)}


class RequestOf(Record, Generic[R]):
    """The data of a request whose response has the data R."""

    __slots__ = ()
    CODE: ClassVar[int | None]
    _RESPONSE: ClassVar[type[Any]]

    @classmethod
    def response_type(cls) -> type[R]:
        """The class of the response."""
        return cls._RESPONSE


class Request(Record, Generic[M]):
    """A request to `unit_address`, which is 0 on links without addresses."""

    __slots__ = ("message", "unit_address")
    __match_args__ = ("unit_address", "message")

    def __init__(self, unit_address: int, message: M) -> None:
        self.unit_address, self.message = unit_address, message


class Response(Record, Generic[M]):
    """A response from `unit_address`, which is 0 on links without addresses."""

    __slots__ = ("message", "unit_address")
    __match_args__ = ("unit_address", "message")

    def __init__(self, unit_address: int, message: M) -> None:
        self.unit_address, self.message = unit_address, message


class ExceptionResponse(Record, Generic[M]):
    """An exception response: the code of the request, or the one that all exception responses have, and the reason.

    If the code of the usual response differs from the request's, `code` is the response's.
    """

    __slots__ = ("code", "exception", "unit_address")
    __match_args__ = ("unit_address", "code", "exception")

    def __init__(self, unit_address: int, code: int, exception: M) -> None:
        self.unit_address, self.code, self.exception = unit_address, code, exception


class Frames:
    """The frames of one link in one direction: start delimiter, header, body, checksum, end delimiter.

    `head` is the format of the Struct of the header; `code` and `length` are the places of these parts in it, -1 where
    there is none. The length counts all parts. `constants` are the constant header parts: place, name, value and offset
    of each. A `preamble` is a byte, how many of it `start` has, how many more are sent before these, and how many more
    are received at most. `forms` are the digits of header parts by the offsets of these.
    """

    __slots__ = (
        "algorithm",
        "check_order",
        "code",
        "code_offset",
        "constants",
        "end",
        "forms",
        "head",
        "head_size",
        "hexadecimal",
        "length",
        "length_name",
        "length_offset",
        "longest",
        "preamble",
        "start",
        "tail_size",
        "vanishes",
    )

    def __init__(
        self,
        head: str,
        check: str,
        *,
        check_order: Literal["big", "little"] = "little",
        code: int = -1,
        code_offset: int = 0,
        length: int = -1,
        length_offset: int = 0,
        length_name: str = "",
        longest: int = 0,
        start: bytes = b"",
        end: bytes = b"",
        hexadecimal: bool = False,
        preamble: tuple[int, int, int, int] | None = None,
        constants: tuple[tuple[int, str, int, int], ...] = (),
    ) -> None:
        self.head = Struct(head)
        self.head_size = self.head.size
        self.algorithm: Callable[[Data], int] | None
        self.algorithm, self.tail_size = _CHECKS.get(check, (None, 0))
        self.check_order: Literal["big", "little"] = check_order
        # Over data with their checksum, these are 0.
        self.vanishes = check == "lrc" or (check == "crc16_modbus" and check_order == "little")
        self.code, self.code_offset = code, code_offset
        self.length, self.length_offset, self.length_name, self.longest = length, length_offset, length_name, longest
        self.start, self.end, self.hexadecimal, self.constants = start, end, hexadecimal, constants
        self.preamble = preamble
        self.forms: dict[int, Digits] = {}

    def unmarked(self, frame: Data) -> Data:
        """A frame without its delimiters, as bytes instead of characters. Raises CodecError."""
        if self.preamble is not None:
            byte, minimum, _, spare = self.preamble
            run = len(frame) - len(bytes(frame).lstrip(bytes((byte,))))
            frame = frame[max(0, min(run - minimum, spare)) :]
        first, last = len(self.start), len(frame) - len(self.end)
        if frame[:first] != self.start:
            raise CodecError("wrong_mark", f"the frame does not start with {self.start.hex(' ')}", 0)
        if last < first or frame[last:] != self.end:
            raise CodecError("wrong_mark", f"the frame does not end with {self.end.hex(' ')}", len(frame))
        inner = frame[first:last]
        if not self.hexadecimal:
            return inner
        try:
            return unhexlify(inner)
        except HexError:
            for offset, byte in enumerate(inner):
                if byte not in b"0123456789ABCDEFabcdef":
                    text = f"byte {byte:#04x} is not a hexadecimal character"
                    raise CodecError("not_hex", text, first + offset) from None
            raise CodecError("wrong_length", "an odd number of characters", last) from None

    def marked(self, data: bytes) -> bytes:
        """Parts with the delimiters around them, as characters on links of characters."""
        inner = hexlify(data).upper() if self.hexadecimal else data
        further = bytes((self.preamble[0],)) * self.preamble[2] if self.preamble is not None else b""
        return further + self.start + inner + self.end

    @property
    def has_checksum(self) -> bool:
        """Whether frames have a checksum."""
        return self.algorithm is not None

    def agrees(self, data: Data) -> bool:
        """Whether the constants of the header and the checksum at the end of the parts are right."""
        if self.constants:
            head = self.head.unpack_from(data)
            if any(head[place] != const for place, _, const, _ in self.constants):
                return False
        algorithm = self.algorithm
        if algorithm is None:
            return True
        if self.vanishes:
            return not algorithm(data)
        offset = len(data) - self.tail_size
        return algorithm(data[:offset]) == int.from_bytes(data[offset:], self.check_order)

    def split(self, data: Data) -> tuple[tuple[int, ...], Data]:
        """The header and the body of the parts of a frame. Raises CodecError for a wrong length or checksum."""
        size = len(data)
        if size < self.head_size + self.tail_size:
            minimum = self.head_size + self.tail_size
            raise CodecError("incomplete", f"a frame has at least {minimum} bytes, not {size}", size)
        head = self.head.unpack_from(data)
        if self.length >= 0 and head[self.length] != size:
            text = f"{self.length_name} is {head[self.length]}, but the frame has {size} bytes"
            raise CodecError("wrong_length", text, self.length_offset)
        if self.algorithm is not None:
            check_offset = size - self.tail_size
            received, want = int.from_bytes(data[check_offset:], self.check_order), self.algorithm(data[:check_offset])
            if received != want:
                width = 2 * self.tail_size
                raise CodecError(
                    "wrong_checksum", f"the check is {received:0{width}X}, not {want:0{width}X}", check_offset
                )
        for place, name, const, offset in self.constants:
            if head[place] != const:
                raise wrong_const(name, head[place], const, offset)
        return head, data[self.head_size : size - self.tail_size]

    def joined(self, head: list[int], body: bytes) -> bytes:
        """The whole frame of a header and a body; it fills in the length. Raises CodecError."""
        if self.length >= 0:
            total = self.head_size + len(body) + self.tail_size
            if total > self.longest:
                raise CodecError("wrong_length", f"a frame of {total} bytes is too long for {self.length_name}")
            head[self.length] = total
        data = self.head.pack(*head) + body
        if self.algorithm is not None:
            data += self.algorithm(data).to_bytes(self.tail_size, self.check_order)
        return self.marked(data)

    def message(
        self, classes: dict[int, Any], code: int, body: Data, expected_code: int | None = None, answer: Any = None
    ) -> Any:
        """The data of the message with a code, which must be the `expected_code`, if any. Raises CodecError.

        Where several messages share the code, the class must be `answer`, if there is one.
        """
        message_class = classes.get(code)
        if message_class is None:
            raise CodecError("unknown_code", f"no message has the code {code:#04x}", self.code_offset)
        if expected_code is not None and expected_code != code:
            raise CodecError("unknown_code", f"the code {code:#04x} answers another request", self.code_offset)
        if not isinstance(message_class, type):
            message_class = message_class.of(body, self.head_size, self.code_offset, answer)
        return self.body(message_class, body)

    def named(self, classes: dict[int | str, Any], name: int | str) -> Any:
        """The class of the message with a number or a name. Raises CodecError."""
        message_class = classes.get(name)
        if message_class is None:
            raise CodecError("unknown_code", f"no message here is {name!r}")
        return message_class

    def body(self, record: Any, body: Data) -> Any:
        """The data of a known message. Raises CodecError."""
        try:
            return record.decode(body)
        except CodecError as error:
            raise error.shifted(self.head_size) from None
