"""The escapes of the reference codec: what is sent for some bytes, and back."""

from __future__ import annotations

from fieldspec.codec.reference.records import CodecError
from fieldspec.language.model.escape import CAN_DATA, CAN_HEADER, CAN_REMOTE, Escape


def escaped(escape: Escape, data: bytes) -> bytes:
    """The bytes that are sent for some bytes. Raises CodecError for an identifier that has no room for its parts."""
    if escape.method == "can":
        return _can_frame(escape, data)
    if escape.method == "replace":
        pairs = {byte: bytes(pair) for byte, *pair in escape.pairs}
        return b"".join(pairs.get(byte, bytes((byte,))) for byte in data)
    if escape.method == "add":
        return bytes((byte + escape.inserted) % 256 for byte in data)
    if escape.method == "insert":
        return data.replace(escape.pattern, escape.pattern + bytes((escape.inserted,)))
    blocks = []
    for block in data.split(b"\0"):
        full, rest = divmod(len(block), 254)
        blocks += [b"\xff" + block[254 * place : 254 * place + 254] for place in range(full)]
        blocks.append(bytes((rest + 1,)) + block[254 * full :])
    last = data.rpartition(b"\0")[2]
    if last and len(last) % 254 == 0:
        blocks.pop()  # a full block at the end needs no other one after it
    return b"".join(blocks)


def unescaped(escape: Escape, data: bytes, offset: int) -> bytes:
    """The bytes for which some bytes were sent; `offset` is the place of these. Raises CodecError."""
    if escape.method == "can":
        wrong = escape.wrong_header(data)
        if wrong is not None:
            raise CodecError("wrong_mark", escape.header_fault(data, wrong), offset + wrong)
        content = data[4:5] if escape.is_remote(data) else data[CAN_HEADER:]
        return escape.unpacked(int.from_bytes(data[:4], "big")) + content
    if escape.method == "add":
        return bytes((byte - escape.inserted) % 256 for byte in data)
    result = bytearray()
    rest = data
    while rest:
        place = offset + len(data) - len(rest)
        if escape.method == "replace":
            originals = {bytes(pair): byte for byte, *pair in escape.pairs}
            is_pair = any(rest[0] in (byte, first) for byte, first, _ in escape.pairs)
            if is_pair and rest[:2] not in originals:
                raise CodecError("wrong_mark", "bytes are escaped that need not be, or are not", place)
            result.append(originals[rest[:2]] if is_pair else rest[0])
            rest = rest[2:] if is_pair else rest[1:]
        elif escape.method == "insert":
            before, pattern, following = rest.partition(escape.pattern)
            result += before + pattern
            if pattern and following[:1] != bytes((escape.inserted,)):
                place += len(before) + len(pattern)
                raise CodecError("wrong_mark", f"{escape.inserted:#04x} is missing after the pattern", place)
            rest = following[1:]
        else:
            block = rest[1 : rest[0]]
            if not rest[0] or len(block) < rest[0] - 1 or 0 in block:
                raise CodecError("wrong_mark", f"the block of {rest[0]} bytes is not complete", place)
            result += block
            is_zero = rest[0] < 0xFF and len(rest) > rest[0]
            result += b"\0" * is_zero
            rest = rest[rest[0] :]
    if not data and escape.method == "cobs":
        raise CodecError("wrong_mark", "there is no block", offset)
    return bytes(result)


def _can_frame(escape: Escape, data: bytes) -> bytes:
    """A CAN frame: its identifier, the number of its data, three zeros, its data; none in a remote request."""
    identifier, content = escape.packed(data), data[escape.fields_size :]
    if identifier is None:
        raise CodecError("out_of_range", "a part has more bits than its place in the identifier")
    size = len(content)
    if identifier & CAN_REMOTE:
        size, content = content[0] if size == 1 else size, b""
    if size > CAN_DATA:
        raise CodecError("wrong_length", f"a CAN frame has at most {CAN_DATA} bytes of data, not {size}")
    return identifier.to_bytes(4, "big") + bytes((size, 0, 0, 0)) + content
