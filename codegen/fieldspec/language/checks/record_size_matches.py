"""The printed size of a record is the sum of its fields, and a table leaves enough room for each element.

Why: if the size differs from the sum, a field has the wrong width, is missing or is listed twice, and all
following addresses are wrong too.

Example: a record of 16 bytes with fields of 14 bytes, or elements of 14 words with a stride of 12 words.

Fix: Correct the width of a field, the printed size or the stride, and write an erratum.
"""

from __future__ import annotations

from fieldspec.foundation.line_text import plural
from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.record import Record
from fieldspec.language.model.registers import Table
from fieldspec.language.model.sizes import RecordSizes


def record_size_matches(device: Device) -> Findings:
    sizes = RecordSizes(device)
    for record in device.records.values():
        yield from _of_record(record, sizes)
    for table in device.tables.values():
        yield from _of_table(table, sizes, device.records.get(table.record))


def _of_record(record: Record, sizes: RecordSizes) -> Findings:
    size = sizes.named(record.name)
    fields = label(record.place, "fields", "the fields")
    for key, printed, noun, unit_size in (("size", record.size, "byte", 1), ("words", record.words, "word", 2)):
        if printed is None or record.name in sizes.endless:
            continue
        if size is None:
            text = f"{record.name} is printed with {plural(printed, noun)}, but its size is not fixed"
            yield finding(record.place, key, text, "remove the size or the repetition", fields)
        elif printed * unit_size != size:
            text = f"{record.name} is printed with {plural(printed, noun)}, but its fields have {plural(size, 'byte')}"
            yield finding(record.place, key, text, "correct a field or the size", fields)


def _of_table(table: Table, sizes: RecordSizes, record: Record | None) -> Findings:
    if record is None or record.name in sizes.endless:
        return
    size = sizes.named(record.name)
    if size is None:
        text = f"elements of {table.name} are {record.name}, whose size is not fixed"
        yield finding(table.place, "record", text, "a table holds records of a fixed size")
        return
    related_label = label(record.place, "fields", f"the fields have {plural(size, 'byte')}")
    if size % 2:
        text = f"elements of {table.name} have {plural(size, 'byte')}, which is not a whole number of words"
        yield finding(table.place, "record", text, "correct a field", related_label)
        return
    if table.words is not None and table.words != size // 2:
        text = f"elements of {table.name} are printed with {plural(table.words, 'word')}"
        text += f", but {record.name} has {size // 2}"
        yield finding(table.place, "words", text, "correct a field or the words", related_label)
    if table.count > 1 and table.stride < size // 2:
        text = f"elements of {table.name} have {plural(size // 2, 'word')}, but the stride is {table.stride}"
        yield finding(table.place, "stride", text, "correct a field or the stride", related_label)
