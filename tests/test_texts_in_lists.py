"""Lists of records that end with a text whose bytes they count: codecs read them, and refuse them at the same byte."""

from __future__ import annotations

import json
import socket
import subprocess
from pathlib import Path
from typing import Any

import construct
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pymodbus.pdu.device import ModbusDeviceIdentification
from pymodbus.pdu.mei_message import ReadDeviceInformationResponse
from pymodbus.server import ModbusTcpServer
from pymodbus.simulator import DataType, SimData, SimDevice

from captures.bulk import Sent, decoded, verdicts
from external_tools import require_tool
from fieldspec.codec.explain.explanation import explained
from fieldspec.codec.reference import CodecError, codec
from fieldspec.command.pipeline import load
from fieldspec.tools.captures.decoding import Choices
from fieldspec.tools.evidence.redaction import Redaction
from fieldspec.tools.evidence.secrets import Secrets
from js_output.javascript import module_path
from layouts import SPECS, TEST_SPECS, layout_at, newest
from pymodbus_server import SECONDS, free_port, running
from python_package import codec_error, link_of, module_apart, module_of

FOLDER = Path(__file__).with_name("identified")
TEXTS = {0: "Nobody", 1: "N-1", 2: "1.0", 3: "https://example.org"}
"""The texts of the nameplate by number."""

LAYOUT = newest(TEST_SPECS, "weigher")
CODEC = codec(LAYOUT)
MODULE = module_of(LAYOUT)
BUS = link_of(MODULE, "bus")
HEADER = 2
"""The bytes before the data: station and function."""
WORDS = construct.Struct(
    "first" / construct.Int8ub, "words" / construct.GreedyRange(construct.PascalString(construct.Int8ub, "ascii"))
)
"""The request as another library has it."""
BODIES = {
    "00 01 00": [[], [""]],
    "02 01 0400 09 E282AC 63 0100 09 00 024142 00": [["\u20ac", ""], ["AB", ""]],
    "01 00 0700 09 414243444546 01 054142434445": [["ABCDEF"], ["ABCDE"]],
    "01 00 0800 09 41424344454647 01 00": ("wrong_measure", 2),
    "01 00 0000 09 01 00": ("wrong_measure", 2),
    "01 00 0300 09 4100 01 00": ("unknown_value", 5),
    "01 05 0300 09 4100 01 00": ("unknown_value", 5),
    "01 00 0300 09 E282 01 00": ("unknown_value", 5),
    "01 00 0300 08 4142 01 00": ("wrong_const", 4),
    "01 05 0300 09 4142 01 00": ("unknown_value", 1),
    "01 00 0300 09 4142 05 00": ("unknown_value", 7),
    "01 00 0300 09 4142 01 06414243444546": ("wrong_measure", 8),
    "01 00 0300 09 4142 01 02C441": ("unknown_value", 9),
    "01 00 0300 09 4142 01 024100": ("unknown_value", 9),
    "01 00 0300 09 4142 01 054142": ("incomplete", 11),
    "01 00 0300 09 4142 01": ("incomplete", 8),
    "00 01 00 00 00 00": ("wrong_length", 5),
    "04 01 00": ("wrong_measure", 0),
    "": ("incomplete", 0),
}
"""Data of a response: its texts, or why and at which byte it is refused."""
PROGRAM = """
import * as weigher from "%s";
const words = [{ letters: "AB" }];
const refusals = [
  { placards: [{ id: 5, caption: "A" }], state: 0, words },
  { placards: [{ id: 1, caption: "A" }], state: 5, words: [{ letters: "ABCDEF" }] },
  { placards: [{ id: 1, caption: "A" }], state: 1, words: [{ letters: "ABCDEF" }] },
].map((value) => {
  try {
    weigher.ReadWordsResponse.encode(value);
  } catch (error) {
    return error.reason;
  }
});
console.log(JSON.stringify(refusals));
"""


def frame_of(data: str, direction: str = "response") -> bytes:
    """A frame of the bus with the right checksum."""
    return CODEC.links["bus"].with_checksum(direction, bytes.fromhex(f"01 45 {data} 00 00"))


@pytest.mark.parametrize("data", BODIES)
def test_texts_of_lists_are_read_and_refused_alike(data: str) -> None:
    frame, wanted = frame_of(data), BODIES[data]
    reasons = explained(LAYOUT, "bus", "response", frame).reasons
    (verdict,) = verdicts(decoded(LAYOUT, [Sent(0, "response", frame)], Choices("bus", "")))
    assert verdict == (reasons[0] if reasons else "ok")
    if isinstance(wanted, list):
        values = CODEC.links["bus"].decode(frame, "response").values
        message = BUS.decode_response(frame).message
        assert [own["caption"] for own in values["placards"]] == [own.caption for own in message.placards] == wanted[0]
        assert [own["letters"] for own in values["words"]] == [own.letters for own in message.words] == wanted[1]
        assert [own["length"] for own in values["words"]] == [len(text) for text in wanted[1]]
        assert bytes(BUS.encode_response(1, message)) == frame
        assert CODEC.links["bus"].encode("response", "read_words", {"station": 1, **values}) == frame
        return
    reason, at = wanted
    with pytest.raises(CodecError) as expected:
        CODEC.links["bus"].decode(frame, "response")
    with pytest.raises(codec_error()) as refused:
        BUS.decode_response(frame)
    place = reason, HEADER + at
    assert (expected.value.reason, expected.value.offset) == place
    assert (refused.value.reason, refused.value.offset) == place
    assert reason in reasons


def test_an_explanation_has_each_text_where_it_is_sent() -> None:
    rows = explained(LAYOUT, "bus", "response", frame_of([*BODIES][1])).rows
    places = {row.path: (row.offset - HEADER, row.length, row.number) for row in rows if row.kind == "field"}
    assert places["placards[0].caption"] == (5, 3, "\u20ac")
    assert places["placards[1].size"] == (9, 2, 1)
    assert places["words[0].letters"] == (14, 2, "AB")
    assert places["words[1].letters"] == (17, 0, "")


@pytest.mark.parametrize("data", [data for data, wanted in BODIES.items() if isinstance(wanted, list)])
def test_redaction_replaces_texts_of_lists_by_as_many_letters(data: str) -> None:
    frame = frame_of(data)
    read = CODEC.links["bus"].decode(frame, "response")
    clean = Redaction(LAYOUT, Secrets()).frame("bus", "response", frame, read, {})
    values = CODEC.links["bus"].decode(clean, "response").values
    for name, text in (("placards", "caption"), ("words", "letters")):
        sizes = [len(own[text].encode()) for own in read.values[name]]
        assert [own[text] for own in values[name]] == ["X" * size for size in sizes]
    assert [own["id"] for own in values["placards"]] == [own["id"] for own in read.values["placards"]]


@given(
    first=st.integers(0, 255),
    words=st.lists(st.text(st.characters(min_codepoint=1, max_codepoint=0x7F), max_size=5), max_size=3),
)
def test_construct_reads_the_texts_that_are_sent(first: int, words: list[str]) -> None:
    message: Any = MODULE.ReadWordsRequest(first=first, words=[MODULE.Word(letters=text) for text in words])
    frame = bytes(BUS.encode_request(1, message))
    values = {"station": 1, "first": first, "words": [{"letters": text} for text in words]}
    assert frame == CODEC.links["bus"].encode("request", "read_words", values)
    parsed = WORDS.parse(frame[HEADER:-2])
    assert (parsed.first, [*parsed.words]) == (first, words)
    assert WORDS.build({"first": first, "words": words}) == frame[HEADER:-2]


@pytest.mark.parametrize("text", ["ABCDEF", "A\0", "\u20ac"])
def test_a_text_that_would_be_read_as_another_is_not_sent(text: str) -> None:
    with pytest.raises(CodecError) as expected:
        CODEC.links["bus"].encode("request", "read_words", {"station": 1, "first": 0, "words": [{"letters": text}]})
    with pytest.raises(codec_error()) as refused:
        BUS.encode_request(1, MODULE.ReadWordsRequest(first=0, words=[MODULE.Word(letters=text)]))
    assert refused.value.reason == expected.value.reason


def test_javascript_refuses_the_first_field_that_is_wrong() -> None:
    program = PROGRAM % module_path(LAYOUT)
    command = [require_tool("node"), "--input-type=module", "--eval", program]
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    assert result.returncode == 0, result.stderr
    assert json.loads(result.stdout) == ["unknown_value", "unknown_value", "wrong_length"]


@pytest.fixture(scope="module")
def nameplate() -> Any:
    """The generated module of a nameplate whose objects are texts."""
    files = {path.relative_to(FOLDER).as_posix(): path.read_bytes() for path in FOLDER.rglob("*.yaml")}
    files |= {path.relative_to(SPECS).as_posix(): path.read_bytes() for path in SPECS.glob("protocols/*.yaml")}
    path = "nameplate/device.yaml"
    files[path] = files[path].replace(
        b"type: u8, repeat: 0..245", b"type: text, length: 245, encoding: latin_1, varies: true"
    )
    return module_apart(layout_at(load(files).devices["nameplate"], "1"), "nameplate_texts")


def test_pymodbus_sends_the_texts_that_are_read(nameplate: Any) -> None:
    identity = ModbusDeviceIdentification(info=TEXTS)
    device = SimDevice(1, simdata=[SimData(0, values=[0], datatype=DataType.REGISTERS)])
    link, port = link_of(nameplate, "tcp"), free_port()
    request = nameplate.ReadIdentificationRequest(category=2, first_object=0)
    with (
        running(lambda: ModbusTcpServer(device, identity=identity, address=("127.0.0.1", port))),
        socket.create_connection(("127.0.0.1", port), SECONDS) as connection,
    ):
        connection.sendall(link.encode_request(1, request, transaction=7))
        framer, frames = link.response_framer(), []
        while not frames:
            frames = framer.feed(connection.recv(1024))
    message = link.decode_response(frames[0], request).message
    assert {own.number: own.value for own in message.objects if own.value} == TEXTS
    assert link.encode_response(1, message, transaction=7) == frames[0]


def test_pymodbus_reads_the_texts_that_are_sent(nameplate: Any) -> None:
    objects = [nameplate.Object(number=number, value=text) for number, text in TEXTS.items()]
    response = nameplate.ReadIdentificationResponse(
        category=2, conformity=0x82, more_follows=0, next_object=0, objects=objects
    )
    peer = ReadDeviceInformationResponse()
    peer.decode(response.encode())
    assert peer.number_of_objects == len(TEXTS)
    assert peer.information == {number: text.encode("latin-1") for number, text in TEXTS.items()}
