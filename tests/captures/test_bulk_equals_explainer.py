"""Frames that are decoded in bulk have the values that the explainer finds in each of them."""

from __future__ import annotations

import random

import pytest

from captures.bulk import Sent, Value, decoded, expected, values, verdicts
from fieldspec.codec.explain.explanation import Explanation, explained
from fieldspec.codec.explain.row import ExplanationRow
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.reference import codec
from fieldspec.language.model.texts import Example
from fieldspec.tools.captures.decoding import Choices
from layouts import all_layouts

NEWEST = {layout.device.id: layout for layout in all_layouts() if layout.links}
LAYOUTS = {f"{layout.device.id}@{layout.device.version}": layout for layout in NEWEST.values()}
MOST = 40
"""The examples of a link that are damaged."""


def cases(layout: DeviceLayout, link: str, message: str) -> list[tuple[Example, bytes]]:
    """The examples of a link with the requests that they answer; those of one message where frames have no code."""
    examples = layout.device.examples
    own = [each for each in examples.values() if each.link == link and message in ("", each.message)]
    return [(each, examples[each.reply_to].frame if each.reply_to in examples else b"") for each in own]


def groups(layout: DeviceLayout) -> list[tuple[str, str]]:
    """Links, with each message of its own where the frames of the link have no code."""
    pairs = []
    for link in layout.links.values():
        if link.request.role("code") is None:
            pairs += [(link.name, message) for message in link.messages]
        else:
            pairs.append((link.name, ""))
    return pairs


@pytest.mark.parametrize("name", LAYOUTS)
def test_every_example_has_the_values_that_the_explainer_finds(name: str) -> None:
    layout = LAYOUTS[name]
    for link, message in groups(layout):
        compare(layout, link, message, cases(layout, link, message))


@pytest.mark.parametrize("name", LAYOUTS)
def test_damaged_frames_have_the_verdict_of_the_explainer(name: str) -> None:
    layout = LAYOUTS[name]
    chance = random.Random(7)
    for link, message in groups(layout):
        own = [
            (case, request, damaged(case.frame, chance)) for case, request in 3 * cases(layout, link, message)[:MOST]
        ]
        own = [(case, request, data) for case, request, data in own if request or case.direction == "request"]
        frames = [
            sent
            for stream, (case, request, data) in enumerate(own)
            for sent in (Sent(stream, "request", request), Sent(stream, case.direction, data))
            if sent.data
        ]
        if not frames:
            continue
        judged = verdicts(decoded(layout, frames, Choices(link, message)))
        ends = list({sent.stream: number for number, sent in enumerate(frames)}.values())
        for end, (case, request, data) in zip(ends, own, strict=True):
            explanation = explained(layout, link, case.direction, data, message or "", request)
            reasons = explanation.reasons
            if request and not message and is_from_another_unit(layout, link, explanation, case.frame):
                continue  # only the request of the same unit tells which message a response without a code is
            accepted = {"ok", "mismatch", "no_request"}
            if reasons:
                assert judged[end] not in accepted - {*reasons}, (case.id, data.hex(), judged[end], reasons)
            else:
                assert judged[end] in accepted, (case.id, data.hex(), judged[end])


def is_from_another_unit(layout: DeviceLayout, link: str, explanation: Explanation, frame: bytes) -> bool:
    """Whether a response without a code has another unit address than the frame that it was."""
    shape = layout.links[link].response
    part = shape.role("unit_address")
    if shape.role("code") is not None or part is None:
        return False
    original = explained(layout, link, "response", frame).values.get(part.name)
    return explanation.values.get(part.name, original) != original


def damaged(frame: bytes, chance: random.Random) -> bytes:
    data = bytearray(frame)
    kind = chance.randrange(3)
    place = chance.randrange(len(data))
    if kind == 0:
        data[place] ^= 1 << chance.randrange(8)
    elif kind == 1:
        del data[max(place, 1) :]
    else:
        data.insert(place, chance.randrange(256))
    return bytes(data)


def compare(layout: DeviceLayout, link: str, message: str, own: list[tuple[Example, bytes]]) -> None:
    frames: list[Sent] = []
    numbers = []
    for stream, (case, request) in enumerate(own):
        if request:
            frames.append(Sent(stream, "request", request))
        frames.append(Sent(stream, case.direction, case.frame))
        numbers.append(len(frames))
    if not frames:
        return
    batches = decoded(layout, frames, Choices(link, message))
    judged, rows = verdicts(batches), values(batches)
    for number, (case, request) in zip(numbers, own, strict=True):
        explanation = explained(layout, link, case.direction, case.frame, message or case.message, request)
        verdict = judged[number - 1]
        if verdict in ("no_request", "unknown_code") and case.direction == "response":
            assert not request
            continue
        if explanation.reasons:
            assert verdict in explanation.reasons, case.id
            continue
        assert verdict == "ok", (case.id, verdict)
        table = [(row.register, row.raw) for row in rows if row.frame == number and not is_head(row.register)]
        assert table == [(path, raw) for path, raw, _ in expected(explanation, layout)], case.id


def is_head(register: str) -> bool:
    """Whether a value is a part of the header, such as a status, and not a field of the body or a register."""
    return register in ("status", "error", "instruction", "function", "timer", "end_code")


READABLE = ("tc100@2.0", "ck10@1", "meter@1", "wattmeter@2")


@pytest.mark.parametrize("name", READABLE)
def test_words_of_random_reads_are_decoded_as_the_explainer_decodes_them(name: str) -> None:
    layout = LAYOUTS[name]
    chance = random.Random(11)
    pairs = [pair for _ in range(12) for pair in random_reads(layout, chance)]
    for link in dict.fromkeys(link for link, _, _ in pairs):
        own = [(request, response) for name, request, response in pairs if name == link]
        frames = [
            sent
            for stream, (request, response) in enumerate(own)
            for sent in (Sent(stream, "request", request), Sent(stream, "response", response))
        ]
        batches = decoded(layout, frames, Choices(link))
        assert set(verdicts(batches)) == {"ok"}
        table = values(batches)
        for stream, (request, response) in enumerate(own):
            explanation = explained(layout, link, "response", response, "", request)
            rows = {row.path: row for row in explanation.registers if row.fact and row.raw}
            mine = [row for row in table if row.frame == 2 * stream + 2 and row.verdict not in ("partial", "unlisted")]
            assert {row.register for row in mine} == set(rows)
            for row in mine:
                judge(layout, row, rows[row.register])


def judge(layout: DeviceLayout, row: Value, expected_row: ExplanationRow) -> None:
    """Compares the raw value, the quantity, the names and the verdict of a register."""
    number = expected_row.number
    if isinstance(number, int):
        assert row.raw == (int(number) if number < 2**63 else None)
    elif isinstance(number, float) and number == number and row.quantity is not None:
        assert row.quantity == number
    noted = row.verdict if row.verdict not in ("unlisted_member", "unlisted_bits") else "ok"
    assert noted == (expected_row.reason or "ok")
    names = [meaning.name for meaning in expected_row.meanings if meaning.name and meaning.kind != "state"]
    if names:
        assert row.text is not None
        assert [name for name in row.text.split("+") if not name.startswith("bit_")] == names
    if expected_row.value and row.quantity is not None and isinstance(number, int):
        text = expected_row.value.split(" ")[0]
        assert row.quantity == pytest.approx(float(text), rel=1e-5, abs=1e-9)


def random_reads(layout: DeviceLayout, chance: random.Random) -> list[tuple[str, bytes, bytes]]:
    """Reads of places in the map with random words, as the reference codec encodes request and response."""
    links = codec(layout).links
    result = []
    for link in layout.links.values():
        for message in link.messages.values():
            access = layout.device.register_access(message.message)
            if access is None or access.operation != "read" or not access.count:
                continue
            space = layout.device.space_name(access.space)
            starts = [r.address for r in layout.registers if layout.device.space_name(r.register.space) == space]
            starts += [t.table.base for t in layout.tables.values() if layout.device.space_name(t.table.space) == space]
            field = message.response.named(access.values)
            if not starts or field is None or field.field.repeat is None:
                continue
            count = chance.randrange(1, min(field.field.repeat.high, 60) + 1)
            words = [chance.choice((0, 1, 2, 0xFFFF, 0x8000, chance.randrange(0x10000))) for _ in range(count)]
            values_of = {access.start: max(0, chance.choice(starts) - chance.randrange(3)), access.count: count}
            asked = {part.name: 1 for part in link.request.header if part.is_argument}
            heads = {part.name: 1 for part in link.response.header if part.is_argument}
            request = links[link.name].encode("request", message.name, {**asked, **values_of})
            measures = {f.name: 2 * count for f in message.response.fields if f.field.measures}
            response = links[link.name].encode("response", message.name, {**heads, **measures, access.values: words})
            result.append((link.name, request, response))
    return result
