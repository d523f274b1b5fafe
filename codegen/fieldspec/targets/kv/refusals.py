"""The facts that a word map lacks: registers of bits and bytes, and links whose frames differ from their parts."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.omissions import Expressed, Omission, warning
from fieldspec.codec.layout.refusal import Refusal
from fieldspec.foundation.classes import replace
from fieldspec.language.diagnostics import LEAVE_OUT, Diagnostic
from fieldspec.language.model.address_space import WORD
from fieldspec.targets.kv.areas import frames_in_words, has_frame_areas


def register_refusals(layout: DeviceLayout) -> Iterator[Refusal]:
    """A refusal of each register in a space of bits or bytes; the registers of a group have one finding.

    Each register whose words are written in a different order from reads is refused too.
    """
    for group in layout.device.groups:
        space = layout.device.space(group.space)
        if space.unit == WORD:
            for register in group.registers:
                if register.value.write_word_order:
                    text = f"{register.name} is written in another order of words than a word map has, that of a read"
                    place = register.place["write_word_order"]
                    yield Refusal(register, Diagnostic("output_registers_words", text, place, help=LEAVE_OUT))
            continue
        text = (
            f"an address of the registers in {group.name} is a {space.unit}, and a word map has one register per word"
        )
        finding = Diagnostic("output_registers_words", text, group.place["group"], help=LEAVE_OUT)
        for register in group.registers:
            yield Refusal(register, finding)


def with_refused_links(remaining: Expressed) -> Expressed:
    """The expressed facts, with an omission and a warning for each link whose frames no word of the map has."""
    omissions, findings = [], []
    for link, messages, key, reason in _refused_links(remaining.layout):
        finding = Diagnostic("output_frames_words", reason, link.link.place[key])
        names = ", ".join(messages)
        findings.append(warning(finding, f"the frames of {names} on {link.name} are left out"))
        omissions.append(Omission(f"link {link.name}", f"{reason}: {names}"))
    return replace(
        remaining,
        omissions=(*remaining.omissions, *omissions),
        findings=(*remaining.findings, *findings),
    )


def _refused_links(layout: DeviceLayout) -> Iterator[tuple[LinkLayout, list[str], str, str]]:
    """Links with messages that no other link has in words: the names of these, the key that forbids it, the reason."""
    links = layout.links.values()
    present = {name for link in links if frames_in_words(link) for name in link.messages}
    for link in links:
        messages = [
            message.name
            for message in link.messages.values()
            if message.name not in present and has_frame_areas(layout, link, message)
        ]
        if frames_in_words(link) or not messages:
            continue
        if link.link.is_can:
            yield link, messages, "can", f"{link.name} is a CAN bus, whose frames are not words of a serial line"
        elif link.link.escape is not None:
            reason = f"{link.name} escapes bytes, so the words of its parts are not what is sent"
            yield link, messages, "escape", reason
        elif link.link.preamble is not None:
            reason = f"{link.name} has a preamble of varying length, so the words of its frames have no place"
            yield link, messages, "preamble", reason
        else:
            yield (
                link,
                messages,
                "transmission",
                f"{link.name} sends each byte as two characters, which a word map has not",
            )
