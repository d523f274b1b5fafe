"""A value in a register of words has a whole number of words: a single byte is half a word, and a text has two bytes in
each word that the manual counts.

Why: the device sends whole words, and a value of one byte would occupy only the first byte of its word.

Example: a register of type `u8` at 0x2001, or a text with `length: 31` and `words: 16`.

Fix: State the word as `u16` or `i16`, with a `range` if it is known. State the length of all words of the text, and
its `characters`. If the value really is in the first byte, set `allow: {registers_fill_words: <reason>}`.
"""

from __future__ import annotations

from fieldspec.language.checks.finding import Findings, finding
from fieldspec.language.diagnostics import Severity
from fieldspec.language.model.address_space import WORD
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_array


def registers_fill_words(device: Device) -> Findings:
    for register in device.registers():
        if register.value.type.name in ("u8", "i8") and device.space(register.space).unit == WORD:
            text = f"the register {register.name} is {register.value.type.name}, half of its word"
            help = "state the whole word as u16 or i16, with a range if it is known"
            yield finding(register.place, "type", text, help, severity=Severity.WARNING)
        elif is_array(register.value.encoding) and 2 * (register.words or 0) == register.value.size + 1:
            text = f"{register.name} has {register.value.size} bytes, which do not fill its {register.words} words"
            help = "correct the length or the words"
            yield finding(register.place, "length", text, help, severity=Severity.WARNING)
