"""In an address space of bits, every register has the type `bit`; no other value has this type. Only registers of words
have `words`.

Why: each address is one bit, which messages pack into bytes. A number needs words, and a record or a word has no
separate address for a bit.

Example: a register of type `bool16` in an address space of coils, or a `bit` among holding registers.

Fix: Use the type `bit` there, without `words`. Elsewhere, use `bool8`, `bool16` or `flags`.
"""

from __future__ import annotations

from fieldspec.language.checks.facts import values
from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.address_space import BIT, WORD
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.registers import Register


def types_fit_space(device: Device) -> Findings:
    for register in device.registers():
        space = device.space(register.space)
        if space.unit == WORD:
            continue
        related_label = label(space.place, "unit", "the unit of the space")
        if register.words is not None:
            text = f"{register.name} has `words`, but an address of {space.name} is a {space.unit}"
            yield finding(register.place, "words", text, "remove `words`", related_label)
        if space.unit != BIT:
            continue
        if register.value.type.name != BIT:
            text = f"{register.name} is {register.value.type.name}, but an address of {space.name} is a bit"
            yield finding(register.place, "type", text, "use the type `bit`", related_label)
    for fact, value in values(device):
        if value.type.name == BIT and not _in_bits(device, fact):
            text = f"{fact.name} is a bit, but it is not a register in a space of bits"
            help = "use `bool8` or `bool16`, or a bit of `flags`"
            yield finding(fact.place, "type", text, help)


def _in_bits(device: Device, fact: Fact) -> bool:
    return isinstance(fact, Register) and device.space(fact.space).unit == BIT
