"""Numbers and texts that identify a unit, in all encodings in which files may carry them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

_LEAST = 3
"""The length of the shortest secret that is searched: shorter byte sequences are in nearly every frame."""


class Secrets:
    """What must not be in any output. Bytes are learned while values are replaced, and texts come from the user."""

    def __init__(self, texts: Iterable[str] = ()) -> None:
        self._known: set[bytes] = set()
        for text in texts:
            self.add_text(text)

    def learn(self, data: bytes) -> None:
        """Adds the bytes of a value that identifies the unit, as they were on the wire."""
        stripped = data.strip(b"\0 ")
        for own in dict.fromkeys((data, data.lstrip(b"\0"), stripped)):
            self._add(own)
        number = int.from_bytes(data, "big")
        if len(data) <= 8 and number.bit_length() > 16:
            self._add(str(number).encode())

    def add_text(self, text: str) -> None:
        """Adds a number or a text as people write it, and what it means in decimal and hexadecimal digits."""
        own = text.strip()
        self._add(own.encode())
        if own.isdecimal():
            number = int(own)
            for size in (4, 8):
                if number.bit_length() <= 8 * size:
                    self._add(number.to_bytes(size, "big"))
            self._add(number.to_bytes((number.bit_length() + 7) // 8 or 1, "big"))
        digits = own.lower().removeprefix("0x")
        if len(digits) % 2 == 0 and digits and all(digit in "0123456789abcdef" for digit in digits):
            self._add(bytes.fromhex(digits))

    def _add(self, data: bytes) -> None:
        if len(data) >= _LEAST and len(set(data)) > 1:
            self._known.update(_encodings(data))

    def is_in(self, data: bytes) -> bool:
        """Whether some bytes have a secret in them."""
        return any(known in data for known in self._known)

    def places(self, data: bytes) -> Iterator[range]:
        """Where secrets are in some bytes."""
        for known in sorted(self._known):
            offset = data.find(known)
            while offset >= 0:
                yield range(offset, offset + len(known))
                offset = data.find(known, offset + 1)


def _encodings(data: bytes) -> Iterator[bytes]:
    """Bytes in both orders of bytes and of words, and as hexadecimal characters."""
    words = [data[offset : offset + 2] for offset in range(0, len(data), 2)]
    orders = (
        data,
        data[::-1],
        b"".join(reversed(words)),
        b"".join(word[::-1] for word in words),
    )
    for own in dict.fromkeys(orders):
        yield own
        yield own.hex().encode()
        yield own.hex().upper().encode()
