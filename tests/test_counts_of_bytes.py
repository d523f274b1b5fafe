"""Fields that count the bytes of elements that differ in size: frames as others have published and written them."""

from __future__ import annotations

from typing import Any

import pytest
from pymodbus.pdu import file_message

from fieldspec.codec.reference import CodecError, codec
from layouts import TEST_SPECS, newest
from python_package import link_of, module_of

OBSERVER = newest(TEST_SPECS, "observer")
REFERENCE = codec(OBSERVER).links
MODULE = module_of(OBSERVER)

SEEN = "04 3E 2A 02 01 03 01 57 16 89 74 A5 F4 1E "
STRUCTURES = "02 01 06 03 03 AA FE 16 16 AA FE 10 EE 03 72 75 75 2E 76 69 2F 23 41 6A 77 59 41 4D 46 63 CD"
"""ttu, ruuvitag-sensor, test_ruuvitag_sensor: three structures, and the strength behind them."""


def heads(station: int = 1) -> dict[str, int]:
    return {"transaction": 7, "station": station}


def framed(function: int, data: bytes) -> bytes:
    body = bytes([1, function]) + data
    return b"\0\7\0\0" + len(body).to_bytes(2, "big") + body


def test_a_published_event_has_the_structures_that_its_bytes_have() -> None:
    frame = bytes.fromhex(SEEN + STRUCTURES)
    [report] = REFERENCE["radio"].decode(frame, "response").values["reports"]
    assert [(own["kind"], len(own["data"])) for own in report["structures"]] == [(1, 1), (3, 2), (0x16, 21)]
    assert (f"{report['address']:012X}", report["strength"]) == ("F4A574891657", -51)
    assert REFERENCE["radio"].encode("response", "advertising", {"reports": [report]}) == frame


@pytest.mark.parametrize("counts", [[1], [2, 2], [0, 3, 1], [120, 3]])
def test_responses_are_those_of_an_independent_library(counts: list[int]) -> None:
    parts = [[256 * part + index for index in range(count)] for part, count in enumerate(counts)]
    data = [b"".join(number.to_bytes(2, "big") for number in part) for part in parts]
    records = [file_message.FileRecord(record_data=own) for own in data]
    frame = framed(0x14, file_message.ReadFileRecordResponse(records=records).encode())
    values: dict[str, Any] = {"parts": [{"data": part} for part in parts]}
    assert REFERENCE["port"].encode("response", "read_files", {**values, **heads()}) == frame
    own = link_of(MODULE, "port")
    answer = own.decode_response(frame)
    assert [part.data for part in answer.message.parts] == parts
    assert own.encode_response(1, answer.message, transaction=7) == frame


def test_what_a_field_cannot_count_is_not_sent() -> None:
    values = {"parts": [{"data": [0] * 120}, {"data": [0] * 6}], **heads()}
    with pytest.raises(CodecError, match="out_of_range"):
        REFERENCE["port"].encode("response", "read_files", values)
    assert len(REFERENCE["port"].encode("response", "read_files", {**values, "parts": values["parts"][:1]})) == 251


@pytest.mark.parametrize(
    ("data", "reason"),
    [
        ("0B 05 06 0D FE 00 20 05 06 33 CD 00 40", "wrong_measure at byte 8"),  # less bytes than there are
        ("0C 05 06 0D FE 00 20 07 06 33 CD 00 40", "wrong_measure at byte 8"),  # an element goes beyond the bytes
        ("0C 05 06 0D FE 00 20 04 06 33 CD 00 40", "wrong_measure at byte 15"),  # an element has half a number
        ("00", "wrong_measure at byte 8"),  # at least one element is sent
    ],
)
def test_bytes_that_are_not_those_of_elements_are_refused(data: str, reason: str) -> None:
    with pytest.raises(CodecError, match=reason):
        REFERENCE["port"].decode(framed(0x14, bytes.fromhex(data)), "response")
