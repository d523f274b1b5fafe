"""A number in a register of words occupies whole words.

Why: an output would have to invent bytes that the manual does not print.

Example: a register of words of type `u24`, or five digits in a register of words.

Fix: State the whole words as `u32` or `u48`, or as `i32` or `i48` with a sign, with a `range` if it is known; for
digits, two in each word.
"""

from __future__ import annotations

from fieldspec.foundation.line_text import plural
from fieldspec.language.checks.facts import values
from fieldspec.language.checks.finding import Findings, finding
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_odd
from fieldspec.language.model.registers import Register


def widths_fit_place(device: Device) -> Findings:
    for fact, value in values(device):
        type_name = value.type.name
        if isinstance(fact, Register) and value.digits and value.size % 2:
            text = f"the register {fact.name} has {plural(value.size, 'byte')} of digits, which are not whole words"
            yield finding(fact.place, "length", text, "state the digits of whole words of two bytes")
        elif isinstance(fact, Register) and is_odd(value.encoding) and value.size % device.space(fact.space).unit_size:
            text = f"the register {fact.name} is {type_name}, which has no whole number of words"
            sign = value.type.name.rstrip("0123456789")
            help = f"state the words as {sign}32 or {sign}48, with a range if it is known"
            yield finding(fact.place, "type", text, help)
