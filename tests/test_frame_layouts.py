"""What layouts of frames compute themselves: the bytes before they were escaped, the message of a request, bits."""

from __future__ import annotations

import pytest

from fieldspec.codec.layout.bits import packed_bits, packed_size, unpacked_bits
from fieldspec.codec.layout.frame import original_parts
from layouts import TEST_SPECS, newest

CALLER = newest(TEST_SPECS, "caller")


@pytest.mark.parametrize("count", range(18))
def test_bits_take_the_fewest_bytes(count: int) -> None:
    bits = [index % 3 % 2 for index in range(count)]
    assert packed_size(count) == (0, *[1] * 8, *[2] * 8, 3)[count]
    assert [*unpacked_bits(packed_bits(bits))][:count] == bits


def test_what_has_no_escape_is_sent_as_it_is() -> None:
    frame = CALLER.links["bus"].request
    assert frame.escape is None
    assert original_parts(frame, b"\x01\x08\xc0\xdb") == b"\x01\x08\xc0\xdb"


def test_a_request_is_known_by_its_code_or_else_by_its_name() -> None:
    link = CALLER.links["bus"]
    for name, message in link.carried("request").items():
        assert link.announced(message.message.code, b"", "") is message
        assert link.announced(None, b"", name) is message
    assert link.announced(None, b"", "nothing") is None
    assert link.announced(0x7F, b"", "reset") is None
