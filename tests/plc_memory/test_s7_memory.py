"""Others agree where the members of the generated types lie: awlsim makes the bytes of a data block from values,
s7datablock reads the generated text, and snap7 reads such bytes from a server by the offsets of our table."""

from __future__ import annotations

import csv
import io
import random
import socket
import struct
import sys
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from s7_text import Member, blocks, step7, types

from external_tools import without
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.codec.reference import codec
from fieldspec.codec.reference.records import encoded
from fieldspec.foundation.names import Name, stem
from fieldspec.language.model.encoding import struct_letter
from fieldspec.targets.scl.backend import files
from layouts import SPECS, layouts
from shared_results import shared

TRIES = 3


def text(layout: DeviceLayout, kind: str) -> str:
    """One of the generated files."""
    name = stem(layout.device.id, layout.device.version)
    text = built_sources(layout.device.id)[f"{name}/{name}_{kind}"]
    assert isinstance(text, str)
    return text


@cache
def built_sources(device: str) -> dict[str, Any]:
    return shared(f"scl_{device}", lambda: dict(files(layouts(SPECS)[device])))


def name_of(layout: DeviceLayout, key: str) -> str:
    return f"type{Name.of(layout.device.id).pascal()}{Name.of(key).pascal()}Image"


def records(layout: DeviceLayout) -> dict[str, RecordLayout]:
    """The records that have an image in the generated text, by the names of these."""
    data = [side for message in layout.messages.values() for side in (message.request, message.response)]
    known = {name_of(layout, record.name): record for record in (*data, *layout.records.values())}
    return {name: known[name] for name in types(text(layout, "types.udt")) if name in known}


IMAGES = [
    pytest.param(versions[-1], name, id=name) for versions in layouts(SPECS).values() for name in records(versions[-1])
]


def drawn(layout: DeviceLayout, record: RecordLayout, chance: random.Random) -> tuple[dict[str, Any], bytes]:
    """Values of a record, and the bytes that the reference makes of them. Words of bits have every bit at random."""
    values: dict[str, Any] = {}
    for field in record.fields:
        value = field.value
        assert value is not None
        if field.field.reserved or value.const is not None:
            continue
        low, high = chance.choice(value.ranges.intervals if value.ranges else ((value.type.low, value.type.high),))
        enum = layout.device.enums.get(value.enum)
        if enum is not None and not enum.open:
            values[field.name] = chance.choice([member.value for member in enum.members if not member.unavailable])
        else:
            values[field.name] = chance.randint(low, high)
    return values, encoded(record, values, layout.device)


def by_path(
    members: dict[str, list[Member]], name: str, record: RecordLayout, values: dict[str, Any]
) -> dict[str, int]:
    """Values by the paths of an image's members; those of bits by the numbers that their comments tell."""
    result: dict[str, int] = {}
    for member, field in zip(members[name], record.fields, strict=True):
        value = field.value
        assert value is not None
        raw = values.get(field.name, value.const or 0)
        inner = members.get(member.type.strip('"'))
        if inner is None:
            result[member.name] = raw
            continue
        for bit in inner:
            number = int(bit.comment.split("bit ")[1].split(".")[0])
            result[f"{member.name}.{bit.name}"] = raw >> number & 1
    return result


def block_of_awlsim(lines: list[str]) -> bytes:
    """The bytes of a data block with some members."""
    # Its modules import each other, and work in this order alone.
    main, compiler = import_module("awlsim.core.main"), import_module("awlsim.awlcompiler")
    program = ["DATA_BLOCK DB 1", "STRUCT", *lines, "END_STRUCT;", "BEGIN", "END_DATA_BLOCK"]
    program += ["ORGANIZATION_BLOCK OB 1", "BEGIN", "BE", "END_ORGANIZATION_BLOCK", ""]
    parser = compiler.AwlParser()
    parser.parseText("\n".join(program))
    machine = main.AwlSim()
    machine.reset()
    machine.load(parser.getParseTree())
    machine.build()
    machine.startup()
    machine.runCycle()
    return bytes(machine.getCPU().getDB(1).structInstance.memory.getDataBytes())


def needed(module: str) -> None:
    """Skips where a judge is not installed, or fails in CI."""
    try:
        __import__(module)
    except ImportError:
        without(module)


@pytest.mark.parametrize(("layout", "name"), IMAGES)
def test_awlsim_makes_of_values_the_bytes_that_the_reference_makes(layout: DeviceLayout, name: str) -> None:
    needed("awlsim")
    value, record = types(text(layout, "types.udt")), records(layout)[name]
    chance = random.Random(name)
    for _ in range(TRIES):
        values, data = drawn(layout, record, chance)
        assert block_of_awlsim(step7(name, value, by_path(value, name, record, values))) == data


# It calls functions that pyparsing has renamed.
OLD_NAMES = pytest.mark.filterwarnings("ignore::DeprecationWarning")

TELEGRAMS = [
    pytest.param(layout, example.id, id=example.id)
    for layout in (layouts(SPECS)["hiwin-e"][-1],)
    for example in layout.device.examples.values()
    if example.link == "cyclic" and example.message
]


@pytest.mark.parametrize(("layout", "example_id"), TELEGRAMS)
def test_awlsim_makes_of_the_values_of_every_telegram_its_bytes(layout: DeviceLayout, example_id: str) -> None:
    needed("awlsim")
    example = layout.device.examples[example_id]
    record = layout.messages[example.message].data(example.direction)
    name = name_of(layout, record.name)
    value = types(text(layout, "types.udt"))
    values = codec(layout).links[example.link].decode(example.frame, example.direction, example.message).values
    assert block_of_awlsim(step7(name, value, by_path(value, name, record, values))) == example.frame


@cache
def parsed(layout_id: str, block: str) -> Any:
    """A generated block with the generated types, as s7datablock reads them; it takes no arrays and no strings."""
    if sys.version_info < (3, 11):
        pytest.skip("s7datablock needs a newer Python")
    needed("s7datablock")
    from s7datablock import S7DataBlock

    layout = layouts(SPECS)[layout_id][-1]
    udt = text(layout, "types.udt").removeprefix("\ufeff").replace("\r\n", "\n")
    pieces = [f'TYPE "{piece.partition("END_TYPE")[0]}END_TYPE' for piece in udt.split('\nTYPE "')[1:]]
    body = blocks(text(layout, "data.db"))[block]
    needed_text = f'DATA_BLOCK "{block}"\n{body}END_DATA_BLOCK\n'
    for piece in reversed(pieces):
        if f": {piece.split()[1]};" in needed_text:
            needed_text = f"{piece}\n{needed_text}"
    return S7DataBlock.from_definition_file(io.StringIO(needed_text), db_number=1)


def offsets(layout: DeviceLayout, struct_name: str) -> dict[str, dict[str, str]]:
    """The rows of the generated table for a struct, by member."""
    rows = csv.DictReader(io.StringIO(text(layout, "layout.csv").removeprefix("\ufeff")))
    return {row["member"]: row for row in rows if row["struct"] == struct_name}


@OLD_NAMES
@pytest.mark.parametrize(("layout", "example_id"), TELEGRAMS)
def test_the_generated_data_block_holds_every_telegram_as_s7datablock_reads_it(
    layout: DeviceLayout, example_id: str
) -> None:
    example = layout.device.examples[example_id]
    record = layout.messages[example.message].data(example.direction)
    name = name_of(layout, record.name)
    declared_types = types(text(layout, "types.udt"))
    values = codec(layout).links[example.link].decode(example.frame, example.direction, example.message).values
    block = parsed("hiwin-e", f"HiwinE{Name.of(example.message).pascal()}")
    member = "toDevice" if example.direction == "request" else "fromDevice"
    block.buffer[:] = bytes(len(block.buffer))
    for path, value in by_path(declared_types, name, record, values).items():
        actual = block.mapping[f"{member}.{path}"]
        if actual.struct_fmt == "h":  # it forgets the order of an Int
            struct.pack_into(">h", block.buffer, actual.offset, value)
        else:
            block[f"{member}.{path}"] = value
    start = 0 if member == "toDevice" else layout.messages[example.message].request.size
    assert start is not None
    assert bytes(block.buffer)[start : start + len(example.frame)] == example.frame


def test_snap7_reads_every_telegram_from_a_server_by_the_offsets_of_the_table() -> None:
    needed("snap7")
    from snap7 import Client, Server, SrvArea

    layout = layouts(SPECS)["hiwin-e"][-1]
    link = codec(layout).links["cyclic"]
    examples = [example for example in layout.device.examples.values() if example.link == "cyclic" and example.message]
    server, client = Server(), Client()
    port = free_port()
    for number, example in enumerate(examples, 1):
        server.register_area(SrvArea.DB, number, bytearray(example.frame))
    server.start(tcp_port=port)
    try:
        client.connect("127.0.0.1", 0, 0, port)
        for number, example in enumerate(examples, 1):
            record = layout.messages[example.message].data(example.direction)
            values = link.decode(example.frame, example.direction, example.message).values
            rows = offsets(layout, name_of(layout, record.name))
            for field in record.fields:
                row = rows[Name.of(field.name).camel()]
                read = client.db_read(number, int(row["byte"]), int(row["size"]))
                assert field.value is not None
                letter = struct_letter(field.value.encoding)
                assert struct.unpack(f">{letter}", bytes(read))[0] == values.get(field.name, 0), field.name
        client.disconnect()
    finally:
        server.stop()
        server.destroy()


def free_port() -> int:
    with socket.socket() as item:
        item.bind(("127.0.0.1", 0))
        return int(item.getsockname()[1])
