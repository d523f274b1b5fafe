"""The reference codec against the manuals' frames and against another Modbus stack."""

from __future__ import annotations

import pytest
from pymodbus.framer import FramerAscii, FramerRTU
from pymodbus.pdu import DecodePDU

from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.meaning import raw_values
from fieldspec.model.example import Example
from fieldspec.reference import CodecError, codec
from laid_out import MADE_UP, SPECS, all_layouts, newest

EXAMPLES = [
    pytest.param(layout, example, id=f"{layout.device.id}-{layout.device.version}-{example.id}")
    for layout in all_layouts()
    for example in layout.device.examples.values()
]
MODBUS = {"rtu": FramerRTU, "ascii": FramerAscii}


@pytest.mark.parametrize(("layout", "example"), EXAMPLES)
def test_an_example_decodes_to_its_meaning_or_is_refused_as_it_says(layout: DeviceLayout, example: Example) -> None:
    link = codec(layout).links[example.link]
    if example.refused:
        with pytest.raises(CodecError) as caught:
            link.decode(example.frame, example.direction, example.message)
        assert caught.value.reason == example.refused
        return
    decoded = link.decode(example.frame, example.direction, example.message)
    written = raw_values(layout, example)
    assert written.items() <= {**decoded.head, **decoded.values}.items() or _within(
        written, {**decoded.head, **decoded.values}
    )


def _within(written: object, decoded: object) -> bool:
    if isinstance(written, dict) and isinstance(decoded, dict):
        return all(name in decoded and _within(value, decoded[name]) for name, value in written.items())
    if isinstance(written, list) and isinstance(decoded, list):
        return len(written) == len(decoded) and all(map(_within, written, decoded))
    return written == decoded


def test_all_frames_of_both_manuals_are_examples() -> None:
    printed = {
        device: sum(example.origin == "printed" for example in newest(SPECS, device).device.examples.values())
        for device in ("tc100", "esc11")
    }
    assert printed["tc100"] == 13
    assert printed["esc11"] >= 80


@pytest.mark.parametrize(
    "example",
    [e for e in newest(SPECS, "tc100").device.examples.values() if e.message and not e.error],
    ids=lambda example: example.id,
)
def test_another_modbus_stack_reads_the_same_from_a_frame(example: Example) -> None:
    framer = MODBUS[example.link](DecodePDU(is_server=example.direction == "request"))
    used, pdu = framer.handleFrame(example.frame, 0, 0)
    assert used == len(example.frame)
    assert pdu is not None
    values = raw_values(newest(SPECS, "tc100"), example)
    assert (pdu.dev_id, pdu.address) == (values["station"], values["address"])
    if example.message == "read_registers":
        assert pdu.count == values["word_count"]
    else:
        assert pdu.registers == values.get("values", [values.get("value")])


@pytest.mark.parametrize("cut", [1, 2, 5])
def test_a_frame_that_is_cut_short_is_refused(cut: int) -> None:
    layout = newest(SPECS, "esc11")
    example = next(iter(layout.device.examples.values()))
    with pytest.raises(CodecError) as caught:
        codec(layout).links[example.link].decode(example.frame[:-cut], example.direction, example.message)
    assert caught.value.reason in ("incomplete", "wrong_length")


def test_the_made_up_devices_are_laid_out() -> None:
    assert MADE_UP.is_dir()
    assert {layout.device.id for layout in all_layouts()} >= {"tc100", "esc11", "widget"}
