"""Every example lies, in each model of memory, where the model says, or the model says that it does not."""

from __future__ import annotations

import re
from collections import Counter
from typing import Any

import pytest

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.frame import original_parts
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.codec.reference import codec
from fieldspec.codec.reference.structs import value_construct
from fieldspec.language.model.encoding import is_odd, is_text
from fieldspec.language.model.texts import Example
from fieldspec.targets.controllers.declarations import declarations
from fieldspec.targets.controllers.dialects import DIALECTS
from fieldspec.targets.controllers.layout.fitting import misfit_findings, misfits
from fieldspec.targets.controllers.layout.images import Images, Naming
from fieldspec.targets.controllers.layout.memory import MEMORIES, Memory, Placed, placed
from fieldspec.targets.controllers.statements.expressions import (
    BOOL,
    BYTE,
    DINT,
    INT,
    LINT,
    ArrayType,
    StructType,
    Type,
)
from fieldspec.targets.controllers.structs import Struct, StructMember
from layouts import SPECS, TEST_SPECS, has_digits, layouts, newest

NEWEST = [versions[-1] for root in (SPECS, TEST_SPECS) for versions in layouts(root).values()]
LAYOUTS = [layout for layout in NEWEST if not has_digits(layout)]
PAIRS = [
    pytest.param(layout, memory, id=f"{layout.device.id}-{memory.name}")
    for layout in LAYOUTS
    for memory in MEMORIES.values()
    if layout.device.examples
]


def image(layout: DeviceLayout, record: RecordLayout, memory: Memory, packed: bool = False) -> Placed:
    images = Images(layout, Naming(), packed)
    return placed(images.of(record, "record", record.record, ""), memory, images.structs)


def body(layout: DeviceLayout, example: Example) -> bytes:
    """The bytes of an example between its head and its check."""
    link = layout.links[example.link]
    shape = link.frame(example.direction)
    data = example.frame[len(shape.start) : len(example.frame) - len(shape.end)]
    if link.link.transmission == "hex_ascii":
        data = bytes.fromhex(data.decode("ascii"))
    data = original_parts(shape, data)
    return data[shape.header_size : len(data) - shape.trailer_size]


def at_path(values: Any, path: str, element: int) -> Any:
    """What lies in nested values at `points[].mode`, in one of the elements; None where it is not there."""
    for step in re.findall(r"\w+|\[\]", path):
        if step == "[]":
            values = values[element] if element < len(values) else None
        else:
            values = values.get(step) if values is not None else None
    return values


def compared(placed_member: Placed, data: bytes, values: Any) -> int:
    """How many numbers of an example have been found in its bytes where the model has them; all must be right."""
    count = 0
    strides = {
        f"{path}[]": placed_member
        for path, _, placed_member in placed_member.rows()
        if placed_member.inner is not None and placed_member.is_array
    }
    for path, at, layout_row in placed_member.rows():
        value = layout_row.member.value
        if layout_row.inner is not None or value is None:
            continue
        outer = next((around for before, around in strides.items() if path.startswith(f"{before}.")), None)
        for element in range(outer.count if outer else 1):
            meant = at_path(values, path, element)
            for number, single in enumerate(meant if isinstance(meant, list) else [] if meant is None else [meant]):
                # A number of a width that no type has is an array of its bytes.
                stride = value.size if is_odd(value.encoding) else layout_row.stride
                first = at + (element * outer.stride if outer else 0) + number * stride
                raw = value_construct(value, layout_row.member.order, layout_row.member.swapped).parse(
                    data[first : first + value.size]
                )
                if is_text(value.encoding):
                    raw = raw.rstrip(b"\0").decode("ascii")
                if single == single:
                    assert raw == single, (path, element, number)
                else:  # one NaN is like another
                    assert raw != raw, (path, element, number)
                count += 1
    return count


@pytest.mark.parametrize(("layout", "memory"), PAIRS)
def test_the_bytes_of_every_example_hold_its_values_where_the_model_has_them(
    layout: DeviceLayout, memory: Memory
) -> None:
    seen: Counter[str] = Counter()
    reference = codec(layout)
    for example in layout.device.examples.values():
        if not example.message or example.exception_response or example.refused:
            continue
        data = body(layout, example)
        record = layout.messages[example.message].data(example.direction).of_data(data)
        assert record is not None
        placed_member = image(layout, record, memory)
        if any(True for _ in misfits(placed_member)):
            wire = [field.offset for field in record.fields]
            offsets = [member.at for member in placed_member.members]
            assert (offsets, placed_member.size, shifted(placed_member)) != (wire, record.size, False)
            seen["refused"] += 1
            continue
        values = reference.links[example.link].decode(example.frame, example.direction, example.message)
        seen["exact"] += 1
        seen["numbers"] += compared(placed_member, data, values.values)
    if memory.name == "tc3:1":
        assert seen["refused"] == 0
    assert seen["numbers"] >= seen["exact"] - empty(layout)


def empty(layout: DeviceLayout) -> int:
    """How many examples have no data."""
    examples = (example for example in layout.device.examples.values() if example.message and not example.refused)
    return sum(not body(layout, example) for example in examples)


def shifted(placed_member: Placed) -> bool:
    """Whether something within a member lies elsewhere, or its elements are further apart."""
    return any(
        (placed_member.inner is not None and any(True for _ in misfits(placed_member.inner)))
        or placed_member.stride != placed_member.size
        for placed_member in placed_member.members
    )


@pytest.mark.parametrize("memory", [MEMORIES[name] for name in ("tc3:1", "tc3:2", "s7")], ids=lambda item: item.name)
def test_every_telegram_is_as_long_as_it_is_configured(memory: Memory) -> None:
    layout = newest(SPECS, "hiwin-e")
    sizes = {}
    for message in layout.links["cyclic"].messages.values():
        for data in (message.request, message.response):
            placed_member = image(layout, data, memory, packed=memory.bits)
            assert list(misfits(placed_member)) == [], data.name
            sizes[data.name] = placed_member.size
    assert sizes["telegram_111_request"] == sizes["telegram_111_response"] == 24
    words = {name: message.message.request_words for name, message in layout.messages.items()}
    assert sizes == {name: size for name, size in sizes.items() if size == 2 * (words_of(layout, name) or 0)}
    assert words["telegram_111"] == 12


def words_of(layout: DeviceLayout, name: str) -> int | None:
    """The words that the manual prints for one direction of a telegram."""
    message, _, direction = name.rpartition("_")
    value = layout.messages[message].message
    return value.request_words if direction == "request" else value.response_words


@pytest.mark.parametrize("name", list(DIALECTS))
def test_telegram_111_has_24_bytes_in_the_images_of_every_dialect(name: str) -> None:
    declared = declarations(newest(SPECS, "hiwin-e"), DIALECTS[name])
    assert declared.findings == ()
    for direction in ("request", "response"):
        struct = declared.image(f"telegram_111_{direction}")
        assert struct is not None
        assert declared.placed(struct).size == 24


@pytest.mark.parametrize("name", ["tc3:4", "tc3:8", "codesys", "c"])
def test_natural_alignment_would_make_telegram_111_longer_and_is_refused(name: str) -> None:
    layout = newest(SPECS, "hiwin-e")
    placed_member = image(layout, layout.messages["telegram_111"].request, MEMORIES[name])
    assert placed_member.size == 28
    assert list(placed_member.gaps()) == [(10, 2), (26, 2)]
    refused = misfit_findings(placed_member)
    assert {finding.code for finding in refused} == {"plc_images_exact"}
    assert "mdi_target_position begins at byte 12, on the wire at byte 10" in refused[0].message
    assert f": {placed_member.struct.name} has 28 bytes, on the wire 24" in refused[-1].message


def struct(name: str, *kinds: Type) -> Struct:
    return Struct(
        name, name, "record", "", tuple(StructMember(f"m{n}", kind, "", None) for n, kind in enumerate(kinds))
    )


def sizes(members: tuple[Type, ...], inner: Struct | None = None) -> dict[str, int]:
    whole = struct("whole", *members)
    structs = {struct.name: struct for struct in (whole, *([inner] if inner else []))}
    return {name: placed(whole, memory, structs).size for name, memory in MEMORIES.items()}


# The numbers of TwinCAT are those of Beckhoff's page on pack_mode, those of S7 what TIA Portal shows as offsets.
PACKED = [
    pytest.param((BOOL, DINT), {"tc3:1": 5, "tc3:2": 6, "tc3:4": 8, "tc3:8": 8, "s7": 6}, id="bool-dint"),
    pytest.param((BOOL, INT, BYTE), {"tc3:1": 4, "tc3:2": 6, "tc3:4": 6, "tc3:8": 6, "s7": 6}, id="bool-int-byte"),
    pytest.param((BOOL, LINT), {"tc3:1": 9, "tc3:2": 10, "tc3:4": 12, "tc3:8": 16, "s7": 10}, id="bool-lint"),
    pytest.param((BOOL,) * 9, {"tc3:1": 9, "tc3:2": 9, "tc3:4": 9, "tc3:8": 9, "s7": 2}, id="nine-bools"),
    pytest.param((BYTE, BOOL, BYTE), {"tc3:1": 3, "tc3:2": 3, "tc3:4": 3, "tc3:8": 3, "s7": 4}, id="byte-bool-byte"),
    pytest.param((ArrayType(0, 2, BYTE), BYTE), {"tc3:1": 4, "tc3:8": 4, "s7": 6}, id="array-of-bytes"),
    pytest.param((ArrayType(0, 9, BOOL), BOOL), {"tc3:1": 11, "tc3:8": 11, "s7": 4}, id="array-of-bools"),
]


@pytest.mark.parametrize(("members", "expected"), PACKED)
def test_structs_have_the_sizes_that_the_makers_document(members: tuple[Type, ...], expected: dict[str, int]) -> None:
    assert {name: size for name, size in sizes(members).items() if name in expected} == expected


def test_structs_in_arrays_are_filled_up_to_their_alignment() -> None:
    inner = struct("inner", DINT, BYTE)
    memory_sizes = sizes((ArrayType(0, 3, StructType("inner")), BYTE), inner)
    assert (memory_sizes["tc3:1"], memory_sizes["tc3:2"], memory_sizes["tc3:4"], memory_sizes["s7"]) == (21, 26, 36, 26)


def test_bits_that_follow_each_other_share_bytes_where_the_controller_packs_them() -> None:
    value = placed(struct("bits", *(BOOL,) * 9, BYTE, INT), MEMORIES["s7"], {})
    assert [(placed_member.at, placed_member.bit) for placed_member in value.members[7:]] == [
        (0, 7),
        (1, 0),
        (2, None),
        (4, None),
    ]
