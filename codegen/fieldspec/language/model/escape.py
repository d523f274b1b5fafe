"""How bytes within a frame are changed, so that they are not taken for its delimiters."""

from __future__ import annotations

from fieldspec.foundation.classes import dataclass, field

CAN_BITS = (11, 29)
"""The bits that identifiers of CAN frames have."""

CAN_EXTENDED, CAN_REMOTE = 1 << 31, 1 << 30
"""The flags of an identifier of 29 bits, and of a remote request; a request by one has this bit in its code too."""

SLIP = ((0xC0, 0xDB, 0xDC), (0xDB, 0xDB, 0xDD))
"""The pairs of SLIP: the byte that ends frames, and the one that begins an escape."""

CAN_HEADER, CAN_DATA = 8, 8
"""The bytes before the data of a CAN frame, and the most bytes of its data."""


@dataclass(frozen=True, slots=True)
class Escape:
    """The method is `replace`, `insert`, `add`, `cobs` or `can`; it applies to the parts from `first` to `last`.

    `can` packs the first parts into the identifier of a CAN frame, which has `bits` bits. `fields` has the size, the
    byte order, the first bit and the number of bits of each of these parts. The sent bytes are a frame as SocketCAN
    writes it in captures: the identifier in four bytes, the first bit set where it has 29 bits; the number of data
    bytes; three zeros; the data. Where there are remote requests, `remote` is the place of the code
    in `fields`, and the code of one has the bit `CAN_REMOTE`. It is sent without data,
    and its only byte of data is the requested number of data bytes.

    `pairs` are for `replace`: a byte, and the two bytes that are sent for it. `insert` sends the byte `inserted` after
    each occurrence of `pattern`; the search restarts after it. `add` sends each byte plus `inserted`, without the
    carry. Lengths and checksums among these parts apply to the original bytes, all others to the sent bytes. Empty
    names are the first and the last part.
    """

    method: str
    pairs: tuple[tuple[int, int, int], ...]
    pattern: bytes
    inserted: int
    first: str
    last: str
    fields: tuple[tuple[int, str, int, int], ...] = ()
    bits: int = 0
    remote: int | None = field(default=None, repr=False)

    @property
    def fields_size(self) -> int:
        """The bytes of the parts that are packed into the identifier."""
        return sum(size for size, _, _, _ in self.fields)

    @property
    def flags(self) -> int:
        """The bits of the four bytes of the identifier that are not its own."""
        return CAN_EXTENDED if self.bits > CAN_BITS[0] else 0

    def packed(self, data: bytes) -> int | None:
        """The four bytes of the identifier for the bytes of its parts; None for a number that has too many bits."""
        identifier, offset = self.flags, 0
        for row, (size, order, first, width) in enumerate(self.fields):
            number = int.from_bytes(data[offset : offset + size], "little" if order == "little" else "big")
            remote = number & CAN_REMOTE if row == self.remote else 0
            if (number ^ remote) >> width:
                return None
            identifier |= (number ^ remote) << first | remote
            offset += size
        return identifier

    def unpacked(self, identifier: int) -> bytes:
        """The bytes of the parts of an identifier."""
        remote = identifier & CAN_REMOTE
        numbers = (
            (identifier >> first & (1 << width) - 1 | (remote if row == self.remote else 0)).to_bytes(
                size, "little" if order == "little" else "big"
            )
            for row, (size, order, first, width) in enumerate(self.fields)
        )
        return b"".join(numbers)

    def is_remote(self, data: bytes) -> bool:
        """Whether the bytes of a frame are a remote request, if the link has any."""
        return self.remote is not None and bool(data[0] & CAN_REMOTE >> 24)

    def wrong_header(self, data: bytes) -> int | None:
        """The offset at which bytes are not a CAN frame with such an identifier; None where they are."""
        if len(data) < CAN_HEADER:
            return 0
        is_remote = self.is_remote(data)
        if int.from_bytes(data[:4], "big") & ~((1 << self.bits) - 1) != self.flags | CAN_REMOTE * is_remote:
            return 0
        if len(data) != CAN_HEADER + (0 if is_remote else data[4]) or data[4] > CAN_DATA:
            return 4
        return 5 if any(data[5:CAN_HEADER]) else None

    def header_fault(self, data: bytes, offset: int) -> str:
        """The fault of a CAN frame at an offset that `wrong_header` returns."""
        size = len(data) - CAN_HEADER
        if offset == 4 and size and self.is_remote(data):
            return f"a remote request has no data, but there are {size} bytes"
        if offset == 4 and data[4] != size and not self.is_remote(data):
            return f"byte 4 says {data[4]} bytes of data, but there are {size}"
        if offset == 4:
            return f"a CAN frame has at most {CAN_DATA} bytes of data, not {data[4]}"
        if offset == 5:
            return "the three bytes after the data length are not zero"
        return f"it is not a CAN frame with an identifier of {self.bits} bits"

    def byte_text(self, position: int) -> str:
        """`byte 4`, or `byte 2 of the data` of a CAN frame, for a position among the bytes of all parts."""
        return f"byte {position - self.fields_size} of the data" if self.method == "can" else f"byte {position}"

    def most(self, size: int) -> int:
        """The most bytes that are sent for `size` bytes."""
        if self.method == "can":
            return size - self.fields_size + CAN_HEADER
        if self.method == "add":
            return size
        if self.method == "replace":
            return 2 * size
        return size + size // 254 + 1 if self.method == "cobs" else size + size // len(self.pattern)

    def text(self) -> str:
        """`C0 is sent as DB DC, DB is sent as DB DD`: what is sent, and for which parts where it is not for all."""
        if self.method == "can":
            ends = ((first, first + width - 1) for _, _, first, width in self.fields)
            places = ", ".join(f"{first}..{last}" if first < last else str(first) for first, last in ends)
            return f"the first parts are the bits {places} of an identifier with {self.bits} bits"
        first, last = self.first and f"from {self.first}", self.last and f"to {self.last}"
        part_range = " ".join(["", *(word for word in (first, last) if word)])
        if self.method == "cobs":
            return f"COBS{part_range}: no zero is sent, and each block begins with the distance to the next one"
        if self.method == "add":
            return f"{self.inserted:02X} is added to each byte{part_range}"
        if self.method == "insert":
            return f"{self.inserted:02X} is sent after each {self.pattern.hex(' ').upper()}{part_range}"
        return (
            ", ".join(f"{byte:02X} is sent as {before:02X} {after:02X}" for byte, before, after in self.pairs)
            + part_range
        )


def can_frame_bytes(identifier: int, is_extended: bool, is_remote: bool, size: int, data: bytes) -> bytes:
    """A CAN frame as SocketCAN writes it: its identifier with its flags, the number of data bytes, zeros, the data."""
    flags = (CAN_EXTENDED if is_extended else 0) | (CAN_REMOTE if is_remote else 0)
    return (identifier | flags).to_bytes(4, "big") + bytes((size, 0, 0, 0)) + data
