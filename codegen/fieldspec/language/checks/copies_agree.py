"""The registers of a copied block match the original block: the distance between the addresses, in decimal
too, the number of words, and the label.

Why: the manual prints both blocks row by row. If a row differs, one of the two is misprinted, and the other
shows the correct value.

Example: parameters in memory from 0x1388 and in flash from 0x1450; one of them is at 0x13BE and at 0x1488.

Fix: Correct the row in one of the blocks, and write an erratum if the manual prints it that way. Labels that
differ only in spaces are equal. If a label really differs, set `allow: {copies_agree: <reason>}` on the
register or on its group.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping

from fieldspec.foundation.line_text import plural
from fieldspec.language.checks.finding import Findings, finding, hexadecimal, label
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.device import Device
from fieldspec.language.model.registers import Register, RegisterGroup


def copies_agree(device: Device) -> Findings:
    registers = {register.name: register for register in device.registers()}
    for group in device.groups:
        yield from _of_group(group, registers, device.space(group.space).first_number)


def _of_group(group: RegisterGroup, registers: Mapping[str, Register], first_number: int) -> Findings:
    pairs = [(row, registers[row.copy_of]) for row in group.registers if row.copy_of in registers]
    if not pairs:
        return
    distance, _ = Counter(row.address - original.address for row, original in pairs).most_common(1)[0]
    for row, original in pairs:
        if row.address - original.address != distance:
            right = hexadecimal(original.address + distance)
            text = f"{row.name} is at {hexadecimal(row.address)}; as a copy of {original.name} it should be at {right}"
            yield _finding(row, original, "at", text, "correct one of the addresses")
        if row.decimal is not None and row.decimal != first_number + original.address + distance:
            right = str(first_number + original.address + distance)
            text = f"{row.name} is at {row.decimal} in decimal; as a copy of {original.name} it should be at {right}"
            yield _finding(row, original, "decimal", text, "correct one of the addresses")
        yield from _printed(row, original)


def _printed(row: Register, original: Register) -> Findings:
    words = original.words or original.width
    if row.words is not None and row.words != words:
        text = f"{row.name} is printed with {plural(row.words, 'word')}, but {original.name} has {words}"
        yield _finding(row, original, "words", text, "correct one of them")
    for key in ("label", "printed_name"):
        mine, theirs = getattr(row, key), getattr(original, key)
        if mine and theirs and "".join(mine.split()) != "".join(theirs.split()):
            text = f"{row.name} has the label `{mine}`, but {original.name} has `{theirs}`"
            yield _finding(row, original, key, text, "correct one of them, or allow it with a reason")


def _finding(row: Register, original: Register, key: str, text: str, help: str) -> Diagnostic:
    return finding(row.place, key, text, help, label(original.place, key, f"in {original.name}"))
