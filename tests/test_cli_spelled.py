"""Bytes are read in every common notation, also within lines of logs."""

from __future__ import annotations

import time
from contextlib import suppress

import pytest

from fieldspec.codec.explain.lines import LogLine, Unreadable, log_line
from fieldspec.command.verbs.decode import LONGEST_LINE
from layouts import TEST_SPECS, newest
from proofs import IS_WHOLE

LINKS = [link.link for link in newest(TEST_SPECS, "widget").links.values()]
LADDER_LINKS = [link.link for link in newest(TEST_SPECS, "ladder").links.values()]
BYTES = bytes.fromhex("01 06 20 1E 00 03 A2 0D")
CHARACTERS = b":010310000002EA\r\n"

SPELLINGS = [
    "01 06 20 1E 00 03 A2 0D",
    "0106201E0003A20D",
    "0106 201E 0003 A20D",
    "01 06 20 1e 00 03 a2 0d",
    "01:06:20:1E:00:03:A2:0D",
    "01-06-20-1E-00-03-A2-0D",
    "01,06,20,1E,00,03,A2,0D",
    "1 6 20 1E 0 3 A2 D",
    "0x01 0x06 0x20 0x1E 0x00 0x03 0xA2 0x0D",
    "0x01,0x06,0x20,0x1E,0x00,0x03,0xA2,0x0D",
    "0x1 0x6 0x20 0x1E 0x0 0x3 0xA2 0xD",
    "0x0106201E0003A20D",
    "{0x01, 0x06, 0x20, 0x1E, 0x00, 0x03, 0xA2, 0x0D}",
    "[0x01, 0x06, 0x20, 0x1E, 0x00, 0x03, 0xA2, 0x0D]",
    '"01 06 20 1E 00 03 A2 0D"',
    r"b'\x01\x06\x20\x1e\x00\x03\xa2\x0d'",
    r"\x01\x06\x20\x1E\x00\x03\xA2\x0D",
    "01H+06H+20H+1EH+00H+03H+A2H+0DH",
    "01h 06h 20h 1Eh 00h 03h A2h 0Dh",
    "16#01, 16#06, 16#20, 16#1E, 16#00, 16#03, 16#A2, 16#0D",
    "&H01 &H06 &H20 &H1E &H00 &H03 &HA2 &H0D",
    "$01 $06 $20 $1E $00 $03 $A2 $0D",
    "01\t06  20 1E\u300000 03 A2 0D\r\n",
    "01 06 20 1E 00 03 A2 0D # written by hand",
    "01 06 20 1E 00 03 A2 0D // written by hand",
    "01 06 20 1E 00 03 A2 0D  [crc ok]",
    "12:00:01 01 06 20 1E 00 03 A2 0D",
    "12:00:01.123 01 06 20 1E 00 03 A2 0D",
    "[12:00:01.123] 01 06 20 1E 00 03 A2 0D",
    "2026-01-31 12:00:01,123 01 06 20 1E 00 03 A2 0D",
    "31.01.2026 12:00:01 01:06:20:1E:00:03:A2:0D",
    "1700000000.123456 01 06 20 1E 00 03 A2 0D",
    "0.25s; 01 06 20 1E 00 03 A2 0D",
    "COM3: 01 06 20 1E 00 03 A2 0D",
    "00000000  01 06 20 1e 00 03 a2 0d  |.. .....|",
    "00000000: 0106 201e 0003 a20d",
    "PC -> drive: 01 06 20 1E 00 03 A2 0D",
]

REQUESTS = [
    "TX: 01 06 20 1E 00 03 A2 0D",
    "TX:01 06 20 1E 00 03 A2 0D",
    "tx 0106201E0003A20D",
    "TX (8): 01 06 20 1E 00 03 A2 0D",
    "COM3 Tx [8 bytes]: 01 06 20 1E 00 03 A2 0D",
    "Tx:000042-01 06 20 1E 00 03 A2 0D",
    "12 TX: 01 06 20 1E 00 03 A2 0D",
    "0.001,TX,01 06 20 1E 00 03 A2 0D",
    "Send: 0x1 0x6 0x20 0x1e 0x0 0x3 0xa2 0xd",
    "Request=01 06 20 1E 00 03 A2 0D",
    "> 01 06 20 1E 00 03 A2 0D",
    ">> 01 06 20 1E 00 03 A2 0D",
    "-> 0106201E0003A20D",
    "2026-01-31T12:00:01.123Z > 01 06 20 1E 00 03 A2 0D",
    "[12:00:01] --> 01 06 20 1E 00 03 A2 0D",
    "[RTU]>Tx > 12:10:11:123 - 01  06  20  1E  00  03  A2  0D ",
    "[01][06][20][1E][00][03][A2][0D]",
]
RESPONSES = [
    "RX: 01 06 20 1E 00 03 A2 0D",
    "[12:00:01.123] RX: 01 06 20 1E 00 03 A2 0D",
    "[RTU]>Rx > 12:10:11:123 - 01  06  20  1E  00  03  A2  0D ",
    "Received: 01 06 20 1E 00 03 A2 0D",
    "< 01 06 20 1E 00 03 A2 0D",
    "<-- 01 06 20 1E 00 03 A2 0D",
    "<01><06><20><1E><00><03><A2><0D>",
    "<01> <06> <20> <1E> <00> <03> <A2> <0D>",
]


@pytest.mark.parametrize(
    ("text", "direction"),
    [
        *((text, "") for text in SPELLINGS),
        *((text, "request") for text in REQUESTS),
        *((text, "response") for text in RESPONSES),
    ],
)
def test_bytes_are_read_in_every_notation(text: str, direction: str) -> None:
    assert log_line(text, LINKS) == LogLine(BYTES, direction)


@pytest.mark.parametrize(
    "text",
    [
        r":010310000002EA\r\n",
        ":010310000002EA\r\n",
        ":010310000002EA<CR><LF>",
        ":010310000002EA[CR][LF]",
        ":010310000002EACRLF",
        r":010310000002EA\x0D\x0A",
        ": 01 03 10 00 00 02 EA CR LF",
        r"RX: :010310000002EA\r\n",
        r"[12:00:01] > :010310000002EA\r\n  # a comment",
        r"':010310000002EA\r\n'",
        ":010310000002EA\\r\\n\r\n",
    ],
)
def test_a_frame_of_characters_is_read_as_it_stands(text: str) -> None:
    line = log_line(text, LINKS)
    assert line is not None
    assert (line.frame, line.remarks) == (CHARACTERS, ())


@pytest.mark.parametrize(
    ("text", "lacks"),
    [
        (":010310000002EA", "CR LF"),
        (":010310000002EA\n", "CR LF"),
        (":010310000002EA\\r", "LF"),
        (": 0103100000 02EA", "CR LF"),
    ],
)
def test_a_missing_end_delimiter_is_added_and_reported(text: str, lacks: str) -> None:
    line = log_line(text, LINKS)
    assert line == LogLine(
        CHARACTERS, "", (f"{lacks} is missing at the end of the text and is assumed to have been sent",)
    )


LADDER_CHARACTERS = [
    ("@10RD0010000157*\\r", b"@10RD0010000157*\r", ""),
    ("12:00:01 @10RD0010000157*<CR>", b"@10RD0010000157*\r", ""),
    ("'@10RD0010000157*\\r'", b"@10RD0010000157*\r", ""),
    ("@10RD0010000157*", b"@10RD0010000157*\r", "CR"),
    ("@10RD0010000157", b"@10RD0010000157*\r", "2A CR"),
    ("@1 RD0010000146*\\r", b"@1 RD0010000146*\r", ""),
    ("%0F0410703150107\\r", b"%0F0410703150107\r", ""),
]


@pytest.mark.parametrize(("text", "frame", "lacks"), LADDER_CHARACTERS)
def test_a_frame_whose_parts_are_digits_is_read_as_it_stands(text: str, frame: bytes, lacks: str) -> None:
    remarks = (f"{lacks} is missing at the end of the text and is assumed to have been sent",) if lacks else ()
    assert log_line(text, LADDER_LINKS) == LogLine(frame, "", remarks)


@pytest.mark.parametrize("text", ["", " \t\n", "# a comment", "   // a comment", "\r\n"])
def test_blank_lines_and_comments_hold_no_frame(text: str) -> None:
    assert log_line(text, LINKS) is None


@pytest.mark.parametrize(
    ("text", "direction"),
    [("RX:", "response"), ("> 2026/01/31 12:00:01.000123  length=8 from=0 to=7", "request")],
)
def test_a_line_may_state_only_the_direction_of_the_next_one(text: str, direction: str) -> None:
    assert log_line(text, LINKS) == LogLine(b"", direction)


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("hello", "there are no bytes in it"),
        ("01 06 ?? 1E", "`??` is not a byte in hexadecimal digits"),
        ("01 06 1G", "`1G` is not a byte in hexadecimal digits"),
        ("0106201", "`0106201` has an odd number of digits"),
        ("01 0", "at byte 1, `0` is one digit of two"),
        ("01 06 20 1E 00 03 A2 D", "at byte 7, `D` is one digit of two"),
        ("TX: 0106 2", "at byte 2, `2` is one digit of two"),
        ("TX: 01 0xx", "`0xx` is not a byte in hexadecimal digits"),
        ("0x", "there are no bytes in it"),
    ],
)
def test_an_unreadable_line_is_reported(text: str, why: str) -> None:
    with pytest.raises(Unreadable) as refused:
        log_line(text, LINKS)
    assert str(refused.value) == why


@pytest.mark.proof
@pytest.mark.parametrize(
    "piece", ["tx ", "[ ", "01 ", " ", "\\r", "(", ":", "01:", "<01>", "> ", "12:00:01 ", "0", "#", "=", "x:"]
)
def test_every_line_is_read_quickly(piece: str) -> None:
    longest = LONGEST_LINE if IS_WHOLE else LONGEST_LINE // 2
    line = (piece * longest)[: longest - 1]
    start = time.process_time()
    for text in (line, f"{line}!", f":{line}", f"01 {line}?"):
        with suppress(Unreadable):
            log_line(text, LINKS)
    assert time.process_time() - start < 5 * longest / LONGEST_LINE
