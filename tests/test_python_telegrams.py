"""Messages whose frames do not identify them, and the words of bits in them."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from example_counts import examples
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.reference import codec
from layouts import SPECS, TEST_SPECS, all_layouts, layouts, newest
from python_package import built, class_of, codec_error, link_of, module_of, outcome, package, record_class
from random_values import bytes_of, values_of

GLIDER = module_of(newest(TEST_SPECS, "glider-x"))
HIWIN = module_of(newest(SPECS, "hiwin-e"))
CodecError = codec_error()
CODELESS = [
    pytest.param(layout, link, id=f"{layout.device.id}-{layout.device.version}-{link.name}")
    for layout in all_layouts()
    for link in layout.links.values()
    if not link.request.header and link.messages
]


@pytest.mark.parametrize(("layout", "link"), CODELESS)
@examples(60)
@given(data=st.data())
def test_a_telegram_comes_back_by_its_class_its_name_and_its_number(
    layout: DeviceLayout, link: LinkLayout, data: st.DataObject
) -> None:
    module, message_layout = module_of(layout), data.draw(st.sampled_from(list(link.messages.values())))
    direction = data.draw(st.sampled_from(["request", "response"]))
    record, spoken = message_layout.data(direction), link_of(module, link.name)
    message = built(module, layout, record, data.draw(values_of(layout, record)))
    try:
        frame = getattr(spoken, f"encode_{direction}")(message)
    except CodecError:
        return
    known = [
        message_layout.name,
        record_class(module, message_layout.request),
        *([message_layout.message.number] if message_layout.message.number else []),
    ]
    for name in known:
        decoded = getattr(spoken, f"decode_{direction}")(frame, name).message
        assert getattr(spoken, f"encode_{direction}")(decoded) == frame
    assert type(message).decode(message.encode()).encode() == message.encode()


@pytest.mark.proof(4)
@pytest.mark.parametrize(("layout", "link"), CODELESS)
@examples(60)
@given(data=st.data())
def test_random_bytes_are_the_telegram_that_the_reference_finds(
    layout: DeviceLayout, link: LinkLayout, data: st.DataObject
) -> None:
    message_layout = data.draw(st.sampled_from(list(link.messages.values())))
    direction = data.draw(st.sampled_from(["request", "response"]))
    frame = data.draw(bytes_of(message_layout.data(direction)))
    spoken, reference = link_of(module_of(layout), link.name), codec(layout).links[link.name]
    actual = outcome(lambda: getattr(spoken, f"decode_{direction}")(frame, message_layout.name))
    expected = outcome(lambda: reference.decode(frame, direction, message_layout.name))
    assert actual[0] == expected[0]
    if actual[0]:
        assert actual == expected


def test_a_message_is_only_on_its_links() -> None:
    assert not hasattr(GLIDER.ReadParameterRequest, "_to_cyclic")
    assert not hasattr(GLIDER.Telegram3Request, "_to_channel")
    for name in ("read_parameter", 4, "telegram_4", ""):
        with pytest.raises(CodecError) as caught:
            GLIDER.cyclic.decode_request(bytes(6), name)
        assert caught.value.reason == "unknown_code"
        with pytest.raises(CodecError):
            GLIDER.cyclic.decode_response(bytes(6), name)


def test_the_response_of_a_telegram_is_known_by_the_request() -> None:
    frame = bytes.fromhex("0040 20000000")
    wanted = GLIDER.Telegram3Response(GLIDER.StatusWord(inhibited=True), 2**29)
    for request in (3, "telegram_3", GLIDER.Telegram3Request, GLIDER.Telegram3Request(GLIDER.ControlWord(), 0)):
        assert GLIDER.cyclic.decode_response(frame, request) == package().Response(0, wanted)
    assert wanted.encode() == frame


def test_a_telegram_knows_its_number_and_beside_which_it_is_sent() -> None:
    assert GLIDER.Telegram11Request.NUMBER == GLIDER.Telegram11Response.NUMBER == 11
    assert GLIDER.Telegram70Request.SUPPLEMENTS == ("telegram_3", "telegram_11")
    assert not hasattr(GLIDER.Telegram3Request, "SUPPLEMENTS")
    assert "Telegram 70. It is sent beside telegram_3 or telegram_11." in GLIDER.Telegram70Request.__doc__
    assert "the request (received)" in GLIDER.Telegram70Request.__doc__
    assert not hasattr(module_of(layouts(TEST_SPECS)["glider-x"][0]), "Telegram70Request")


def test_a_telegram_is_written_as_its_bytes() -> None:
    message = GLIDER.Telegram11Request(
        control=GLIDER.ControlWordPositioning(on=True, path=GLIDER.Path.NEGATIVE),
        target=-2,
        gain=1500,
        torque_reduction=0x2000,
    )
    assert GLIDER.cyclic.encode_request(message) == bytes.fromhex("0401 FFFFFFFE 000005DC 2000 0000")


def test_words_are_made_of_their_bits_by_name() -> None:
    word = GLIDER.ControlWord(on=True, no_off2=True, sign_of_life=15)
    assert word.raw == 0xF003
    assert GLIDER.ControlWord(word.raw, on=False, acknowledge=True).raw == 0xF082
    assert GLIDER.ControlWord(0x0F00, on=True, sign_of_life=0).raw == 0x0F01
    with pytest.raises(CodecError) as caught:
        GLIDER.ControlWord(sign_of_life=16)
    assert caught.value.reason == "out_of_range"
    with pytest.raises(TypeError, match="no bit of"):
        GLIDER.ControlWord(of=True)


def test_an_edge_is_told_of_its_bit() -> None:
    assert "rising edge" in GLIDER.ControlWord.acknowledge.__doc__


def test_a_state_is_what_its_bits_show() -> None:
    states = GLIDER.StatusWordState
    assert [GLIDER.StatusWord(raw).state for raw in (0x40, 0xF040, 0x03, 0x43, 0x01, 0)] == [
        states.INHIBITED,
        states.INHIBITED,
        states.RUNNING,
        None,
        None,
        None,
    ]
    assert all(states)


STATED = [
    pytest.param(layout, flags, id=f"{layout.device.id}-{layout.device.version}-{flags.name}")
    for layout in all_layouts()
    for flags in layout.device.flags.values()
    if flags.states
]


@pytest.mark.parametrize(("layout", "flags"), STATED)
@settings(deadline=None)
@given(raw=st.integers(0, 2**16 - 1))
def test_the_first_state_that_fits_is_that_of_the_spec(layout: DeviceLayout, flags: Any, raw: int) -> None:
    fitting = [state for state in flags.states if raw & flags.masked(state)[0] == flags.masked(state)[1]]
    state = class_of(module_of(layout), flags.name, "Flags")(raw).state
    assert state is None if not fitting else state.name == fitting[0].name.upper()


WORDS = [
    pytest.param(layout, flags, id=f"{layout.device.id}-{flags.name}")
    for root in (SPECS, TEST_SPECS)
    for versions in layouts(root).values()
    for layout in versions[-1:]
    for flags in layout.device.flags.values()
]


@pytest.mark.proof(27)
@pytest.mark.parametrize(("layout", "flags"), WORDS)
@examples(30)
@given(data=st.data())
def test_a_word_comes_back_from_its_bits(layout: DeviceLayout, flags: Any, data: st.DataObject) -> None:
    cls = class_of(module_of(layout), flags.name, "Flags")
    raw = data.draw(st.integers(0, flags.type.high))
    word = cls(raw)
    named = sum(bit.mask for bit in flags.bits if not bit.reserved)
    assert cls(**word.flags()).raw == raw & named
    assert cls(raw, **word.flags()) == word
    assert all(getattr(word, name) == bit for name, bit in word.flags().items())


def test_the_words_of_a_manual_are_made_by_their_bits() -> None:
    message = HIWIN.Telegram111Request.decode(bytes.fromhex("04BF 9100") + bytes(20))
    assert message.control_word_1 == HIWIN.ControlWord1Positioning(
        on=True,
        no_off2=True,
        no_off3=True,
        enable_operation=True,
        enable_traversing_task=True,
        no_intermediate_stop=True,
        acknowledge_alarm=True,
        control_by_plc=True,
    )
    assert message.positioning_control_word_1.mdi
    assert HIWIN.StatusWord1(0x40).state is HIWIN.StatusWord1State.SWITCHING_ON_INHIBITED
