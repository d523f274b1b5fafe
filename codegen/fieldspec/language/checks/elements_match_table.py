"""The printed elements of a table have the addresses and words that follow from its base, stride and record.

Why: a manual often prints the first and the last element in full. They confirm base, stride and count, or
show that one of them is wrong.

Example: the second element is printed at 0x9020..0x902D with 12 words.

Fix: Correct the table or the element, and write an erratum if the manual prints it that way.
"""

from __future__ import annotations

from fieldspec.foundation.line_text import plural
from fieldspec.language.checks.finding import Findings, addresses, finding, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.registers import Table
from fieldspec.language.model.sizes import RecordSizes


def elements_match_table(device: Device) -> Findings:
    sizes = RecordSizes(device)
    for table in device.tables.values():
        size = sizes.named(table.record)
        yield from _of_table(table, table.words if size is None else size // 2)


def _of_table(table: Table, words: int | None) -> Findings:
    base = label(table.place, "base", "the first element")
    for element in table.elements:
        if element.index not in table.indexes:
            text = f"{table.name} has the elements {table.index_from} to {table.indexes[-1]}, not {element.index}"
            yield finding(element.place, "index", text, "correct the number or the count", base)
            continue
        first = table.address(element.index)
        if element.first is not None and element.first != first:
            text = f"element {element.index} is printed at {addresses(element.first, element.first)}"
            text += f", but it is at {addresses(first, first)}"
            yield finding(element.place, "at", text, "correct the table or the address", base)
        if words is None:
            continue
        last = first + words - 1
        if element.last is not None and element.last != last:
            text = f"element {element.index} is printed up to {addresses(element.last, element.last)}"
            text += f", but it ends at {addresses(last, last)}"
            yield finding(element.place, "at", text, "correct the record or the address", base)
        if element.words is not None and element.words != words:
            text = f"element {element.index} is printed with {plural(element.words, 'word')}, but it has {words}"
            yield finding(element.place, "words", text, "correct the record or the words", base)
