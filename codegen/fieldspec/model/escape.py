"""How bytes within a frame are changed, so that they are not taken for its delimiters."""

from __future__ import annotations

from fieldspec.classes import dataclass


@dataclass(frozen=True, slots=True)
class Escape:
    """The method is `replace`, `insert` or `cobs`; it applies to the parts from `first` to `last`.

    `pairs` are for `replace`: a byte, and the two bytes that are sent for it. `insert` sends the byte `inserted` after
    each occurrence of `pattern`; the search begins anew behind it. Lengths and checksums among these parts are those
    of the original bytes, all others those of the bytes that are sent. Empty names are the first and the last part.
    """

    method: str
    pairs: tuple[tuple[int, int, int], ...]
    pattern: bytes
    inserted: int
    first: str
    last: str

    def most(self, size: int) -> int:
        """The most bytes that are sent for `size` bytes."""
        if self.method == "replace":
            return 2 * size
        return size + size // 254 + 1 if self.method == "cobs" else size + size // len(self.pattern)

    def text(self) -> str:
        """`C0 is sent as DB DC, DB is sent as DB DD`: what is sent, and for which parts where it is not for all."""
        first, last = self.first and f"from {self.first}", self.last and f"to {self.last}"
        where = " ".join(["", *(word for word in (first, last) if word)])
        if self.method == "cobs":
            return f"COBS{where}: no zero is sent, and each block begins with the distance to the next one"
        if self.method == "insert":
            return f"{self.inserted:02X} is sent after each {self.pattern.hex(' ').upper()}{where}"
        return (
            ", ".join(f"{byte:02X} is sent as {before:02X} {after:02X}" for byte, before, after in self.pairs) + where
        )
