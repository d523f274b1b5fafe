"""Lists whose elements say which of them is the last: frames of others, and what independent libraries read in them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import meterbus
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scapy.contrib.ethercat import EtherCat, EtherCatLRW
from scapy.contrib.mpls import MPLS
from scapy.layers.inet6 import IPv6, IPv6ExtHdrDestOpt, IPv6ExtHdrHopByHop, IPv6ExtHdrRouting
from scapy.layers.l2 import Ether
from scapy.packet import Packet, Raw

from fieldspec.codec.reference import CodecError, codec
from layouts import TEST_SPECS, newest
from python_package import link_of, module_of

HEATMETER, COUPLER = newest(TEST_SPECS, "heatmeter"), newest(TEST_SPECS, "coupler")
BUS, ETHERNET = codec(HEATMETER).links["bus"], codec(COUPLER).links["ethernet"]
METERS, PACKETS = link_of(module_of(HEATMETER), "bus"), link_of(module_of(COUPLER), "ethernet")

PUBLISHED = {  # rscada, libmbus, test-frames
    "Engelmann WaterStar": (
        "68515168080B7254029904C51400060C27000004782E254C00046D0A0CCD1304134C01000044134B0100008401134C010000"
        "426CBF1C026CDF1C043B00000000143B160800000223A70401FD1700049028080000003F16"
    ),
    "EMU Professional 375": (
        "68F4F46808007229260300B5151002020000000C7829260300841003540500008420030000000084904003AE1E000084A040"
        "030000000004ABFF01FEFFFFFF04ABFF020000000004ABFF0300000000042BFEFFFFFF848040ABFF010E000000848040ABFF"
        "0200000000848040ABFF03000000008480402B0E00000002FDC8FF01D10802FDC8FF02000002FDC8FF03000022FDC8FF0152"
        "0722FDC8FF02000022FDC8FF03000012FDC8FF016A0912FDC8FF02000012FDC8FF03000003FDD9FF01BEFFFF03FDD9FF0200"
        "000003FDD9FF0300000003FD59BEFFFF01FFE1FF010D01FFE1FF020001FFE1FF030002FF52F40102FD60380001FD17007416"
    ),
    "Finder 7E.23": (
        "68383868081972076200232E192302920000008C1004682817008C11046828170002FDC9FF01E60002FDDBFF01060002ACFF"
        "0109008240ACFF01FDFF5B16"
    ),
    "GWF MTKcoder": "681B1B6808017207201800E61E35074C0000000C78072018000C16690200009616",
    "Saia-Burgess ALE3": (
        "6892926808287255000019434C1602BF0000008C1004930200008C1104930200008C2004060000008C21040600000002FDC9"
        "FF01DF0002FDDBFF01000002ACFF0100008240ACFF01000002FDC9FF02000002FDDBFF02000002ACFF0200008240ACFF0200"
        "0002FDC9FF03000002FDDBFF03000002ACFF0300008240ACFF03000002FF68000002ACFF0000008240ACFF00000001FF1400"
        "0A16"
    ),
    "Sensus PolluTherm": (
        "6841416808007289163524AE4C0B04541000000C07000000000C14000000000C3C000000000C2C00000000325A0000325E00"
        "0033600000000C78891635240CFD1089163524CE16"
    ),
    "Minol Minocal C2": (
        "68EFEF68080272845042314D6A81047327000004060300000002FD17000084046D0000E11184040603000000840506030000"
        "0004134A000000043B00000000543B2B000000546D1E086119042D0000000094012D1400000094016D1E0861190259170802"
        "5DF607046D2D0CCD138280016CC1138480010603000000C280016CC112C4800106030000008281016CC11184810106030000"
        "00C281016CA11CC4810106030000008282016CA11B8482010603000000C282016CA11AC4820106030000008283016CA11984"
        "83010603000000C283016CA118C4830106030000009280016CC1139480013B000000009480012D000000008F16"
    ),
    "Eastron SDM630": (
        "68909068080A727865342124400102550000000BFD475634120BFD475634120BFD475634120BFD475634120BFD475634120B"
        "FD475634120BFD595634120BFD595634120BFD595634120BFD595634120B2A5634120B2A5634120B2A5634120B2A5634120B"
        "FD3A5634120BFD3A5634120BFD3A5634120BFD3A5634120AFD3A00050AFD3A05000AFD3A05000AFD3A05000AFD3A50004D16"
    ),
    "EMH DIZ": "6821216808017202376200A8150002070000008C100409040000C4002A0000000001FD17008C16",
    "GMC EMMOD206": (
        "6891916808037278563412A31DE602020000008240FD486003828040FD48BF0382C040FD4820048240FD59BD03828040FD59"
        "1F0482C040FD597E0482402BE00082402B36FF84100494280000842004983A0000845004BF4E0000846004A8610000849040"
        "048B75000084A04004B888000084D040042D9D000084E04004C8AF000082412BE00082422B000082432B000082442BCA0042"
        "16"
    ),
    "Minol Minocal WR3": (
        "68CDCD68080072592780314D6A82042B000000040600000000041401000000042D00000000043C0000000002590000025D00"
        "0084040600000000C4046D0000811194012D0000000094016D1E0B8D11543C01000000546D1E0778138C4079000000008140"
        "FD090784401301000000C40413010000008C804079000000008480401301000000818040FD09078405130100000002FD1704"
        "00046D010C8D118280016C8111848001060000000084C001130100000084804113010000009280016C81119480013C000000"
        "009480012D00000000AA16"
    ),
    "OMS, example 3": (
        "683C3C6808FD727856341224232A04260000000C06270485020C13763470004C0619544401426CFF0C0B3B2701000B2A9732"
        "000A5A43040A5E510202FD170000C816"
    ),
    "Tecson": "681B1B6808007212345678A3501001010000000167090A14604592101488131816",
    "AMT Calec MB": (
        "6838386808C87209315403B405B004C910FFFF03229A0000052EA0C85146053EB4E3D742055B90D30743055F0EAAE7410563"
        "9CBCD542046D100905C57716"
    ),
}


def head_of(frame: bytes) -> Mapping[str, int]:
    """The parts of a frame that a program states."""
    return {"control": frame[4], "address": frame[5]}


def informations_of(records: list[dict[str, Any]]) -> list[tuple[list[int], list[int]]]:
    """The bytes about the value of each record: what it is sent as, and what it is."""
    return [([own["dif"], *own["dife"]], [own["vif"], *own["vife"]]) for own in records]


def judged(frame: bytes) -> list[tuple[list[int], list[int]]]:
    """The same as pyMeterBus reads it."""
    return [(own.dib.parts, own.vib.parts) for own in meterbus.load(frame).records]


def data_of(record: Any) -> object:
    """The number of a record as pyMeterBus decodes it, in the type that the low bits of its first byte select."""
    decoded = {"ENCODING_BCD": "decodeBCD", "ENCODING_REAL": "decodeReal", "ENCODING_INTEGER": "decodeInt"}
    return getattr(record.dataField, decoded[record.dib.length_encoding[1].name])


@pytest.mark.parametrize("name", PUBLISHED)
def test_published_frames_are_read_as_an_independent_library_reads_them(name: str) -> None:
    frame = bytes.fromhex(PUBLISHED[name])
    records = BUS.decode(frame, "response").values["records"]
    assert informations_of(records) == judged(frame)
    assert [own["data"] for own in records] == [data_of(own) for own in meterbus.load(frame).records]


@pytest.mark.parametrize("name", PUBLISHED)
def test_published_frames_are_written_again(name: str) -> None:
    frame = bytes.fromhex(PUBLISHED[name])
    values = BUS.decode(frame, "response").values
    assert BUS.encode("response", "variable_data", {**values, **head_of(frame)}) == frame
    assert METERS.encode_response(METERS.decode_response(frame).message, **head_of(frame)) == frame


def chain(first: int, others: list[int]) -> list[int]:
    """Bytes each of which says by its bit 7 that another one follows."""
    return [byte | 0x80 for byte in [first, *others][:-1]] + [[first, *others][-1] & 0x7F]


BYTES = st.integers(0, 0x7F)
VALUES = BYTES.filter(lambda byte: byte != 0x7C)
"""Whatever is measured, but not what texts say."""


@given(st.lists(st.tuples(st.lists(BYTES, max_size=10), VALUES, st.lists(BYTES, max_size=8)), max_size=9))
def test_chains_of_any_length_are_those_of_an_independent_library(
    drawn: list[tuple[list[int], int, list[int]]],
) -> None:
    records = []
    for extensions, value, others in drawn:
        (dif, *dife), (vif, *vife) = chain(0x02, extensions), chain(value, others)
        records.append({"dif": dif, "dife": dife, "vif": vif, "vife": vife, "data": 258})
    header = ("identification", "manufacturer", "version", "medium", "access_number", "status", "signature")
    values = {**dict.fromkeys(header, 0), "records": records, "control": 8, "address": 1}
    frame = BUS.encode("response", "variable_data", values)
    assert judged(frame) == informations_of(records)
    assert METERS.encode_response(METERS.decode_response(frame).message, **head_of(frame)) == frame


@pytest.mark.parametrize(
    ("dife", "detail"),
    [
        ([], "which says that dife is sent, but there are 0"),
        ([0x80], "dife is 128 in element 0 of dife, which says that another one follows"),
        ([0, 0], "dife is 0 in element 0 of dife, which says that none follows"),
        ([0x80] * 10, "dife is 128 in element 9 of dife, which says that another one follows"),
        ([0x80] * 10 + [0], "dife has 0..10 elements, not 11"),
    ],
)
def test_elements_that_contradict_their_list_are_not_written(dife: list[int], detail: str) -> None:
    frame = bytes.fromhex(PUBLISHED["EMH DIZ"])
    values = BUS.decode(frame, "response").values
    values["records"][0]["dife"] = dife
    with pytest.raises(CodecError, match=detail):
        BUS.encode("response", "variable_data", {**values, **head_of(frame)})
    message: Any = METERS.decode_response(frame).message
    message.records[0].dife = dife
    with pytest.raises(ValueError, match="wrong_"):
        METERS.encode_response(message, **head_of(frame))


@pytest.mark.parametrize(
    ("records", "reason"),
    [
        ("82", "incomplete at byte 20"),
        ("82 80", "incomplete at byte 21"),
        (f"82 {'80 ' * 10}00 03 01 00", "wrong_measure at byte 29"),
        (f"02 {'83 ' * 11}00 01 00", "wrong_measure at byte 30"),
        ("02 83 00 01", "incomplete at byte 23"),
    ],
)
def test_lists_that_do_not_end_are_refused_where_they_should(records: str, reason: str) -> None:
    body = bytes.fromhex("08 01 72" + "00" * 12 + records)
    frame = bytes([0x68, len(body), len(body), 0x68]) + body + bytes([sum(body) & 0xFF, 0x16])
    for decode in (lambda: BUS.decode(frame, "response"), lambda: METERS.decode_response(frame)):
        with pytest.raises(ValueError, match=reason):
            decode()


def sent(*layers: Packet) -> bytes:
    """A frame as scapy writes it."""
    packet = Ether(dst="01:02:03:04:05:06", src="0A:0B:0C:0D:0E:0F")
    for layer in layers:
        packet /= layer
    return bytes(packet)


def again(frame: bytes) -> tuple[dict[str, Any], bytes]:
    """The values of a frame, which Python writes again; its zeros at the end may be missing."""
    decoded = ETHERNET.decode(frame, "request")
    heads = {
        name: int.from_bytes(frame[start : start + 6], "big") for name, start in (("destination", 0), ("origin", 6))
    }
    data = PACKETS.encode_request(PACKETS.decode_request(frame).message, **heads)
    assert ETHERNET.encode("request", decoded.message.name, {**decoded.values, **heads}) == data
    return decoded.values, data


@given(st.lists(st.lists(st.integers(0, 255), max_size=60), min_size=1, max_size=6))
def test_records_end_where_a_bit_among_a_count_says_so(drawn: list[list[int]]) -> None:
    parts = [EtherCatLRW(idx=index, adr=0x10000 * index, data=data, wkc=3) for index, data in enumerate(drawn)]
    frame = sent(EtherCat(), *parts)
    size = 16 + sum(12 + len(data) for data in drawn)  # scapy fills short frames with zeros
    values, data = again(frame[:size])
    assert [own["data"] for own in values["datagrams"]] == drawn
    assert [own["length"] >> 15 for own in values["datagrams"]] == [1] * (len(drawn) - 1) + [0]
    assert data == frame[:size]


@given(st.lists(st.integers(0, 0xFFFFF), min_size=1, max_size=8))
def test_numbers_end_where_a_bit_is_one(labels: list[int]) -> None:
    stack = [MPLS(label=label, s=int(index == len(labels) - 1), ttl=64) for index, label in enumerate(labels)]
    frame = sent(*stack, Raw(b"\x00\x01"))
    values, data = again(frame)
    assert [number >> 12 for number in values["labels"]] == labels
    assert (values["packet"], data) == ([0, 1], frame)


@pytest.mark.parametrize("count", range(4))
def test_records_end_where_a_member_says_so(count: int) -> None:
    extensions = [IPv6ExtHdrHopByHop(), IPv6ExtHdrRouting(addresses=["::1"]), IPv6ExtHdrDestOpt()][:count]
    frame = sent(IPv6(src="::2", dst="::3"), *extensions, Raw(b"\x07"))
    values, data = again(frame)
    numbers = [own["next_header"] for own in values["extensions"]]
    assert numbers == [[], [59], [43, 59], [43, 60, 59]][count]
    assert (values["payload"], data) == ([7], frame)
