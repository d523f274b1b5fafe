"""`fieldspec layout`: where a controller places the members of a record in memory."""

from __future__ import annotations

import argparse
from collections.abc import Iterator

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.command.console.streams import print_line
from fieldspec.command.console.terminal import print_blocks, print_findings
from fieldspec.command.console.usage import UsageError, unknown
from fieldspec.command.frames.frame_options import number_of
from fieldspec.command.rendering.memory import blocks
from fieldspec.command.sources import layout_cache
from fieldspec.language.model.fact import Fact
from fieldspec.targets.controllers.layout.fitting import misfit_findings
from fieldspec.targets.controllers.layout.images import Images, Naming, choices
from fieldspec.targets.controllers.layout.memory import MEMORIES, placed


def run(arguments: argparse.Namespace) -> int:
    """Prints the offsets as a table and a drawing. Exit code 1 where they differ from those on the wire.

    Raises UsageError.
    """
    if arguments.target not in MEMORIES:
        raise unknown("target", arguments.target, MEMORIES)
    memory = MEMORIES[arguments.target]
    layout = layout_cache.requested_layout(arguments)
    wrong = []
    for number, (record, fact, title) in enumerate(_matching_records(layout, arguments.record)):
        if number:
            print_line("")
        images = Images(layout, Naming(), packed=memory.bits)
        image = placed(images.of(record, "record", fact, title), memory, images.structs)
        print_blocks(blocks(image, title))
        wrong += misfit_findings(image)
    if wrong:
        print_line("")
        print_findings(wrong, "text", "")
    return 1 if wrong else 0


def _matching_records(layout: DeviceLayout, name: str) -> Iterator[tuple[RecordLayout, Fact, str]]:
    """The records that a name means, one for each case of a choice, with their titles. Raises UsageError."""
    known = list(_records(layout))
    number = number_of(name)
    matches = [candidate for candidate in known if name == candidate[0].name]
    matches = matches or [
        candidate for candidate in known if name in candidate[2] or (number is not None and str(number) in candidate[2])
    ]
    if not matches:
        raise unknown(f"record of {layout.device.id}", name, {word for candidate in known for word in candidate[2]})
    for record, fact, _ in matches:
        if record.spans:
            varying = next(span.name for span in record.spans if span.value is not None)
            raise UsageError(f"{record.name} has no layout: {varying} varies in width")
        optional = next((own.name for own in record.fields if own.field.presence is not None), "")
        if optional:
            raise UsageError(f"{record.name} has no layout: {optional} is optional")
        ended = next((own.name for own in record.fields if own.continuation is not None), "")
        if ended:
            raise UsageError(f"{record.name} has no layout: the elements of {ended} say which is the last")
        if record.inner_lists is not None:
            repeated_name = next(
                (own.name for own in record.inner_lists.lists if own.parts), record.inner_lists.lists[0].name
            )
            problem = (
                f"elements of {repeated_name} differ in size"
                if record.has_differing
                else f"{repeated_name} has packed numbers"
                if any(own.packing for own in record.inner_lists.lists)
                else f"fields follow {repeated_name}, which repeats"
            )
            raise UsageError(f"{record.name} has no layout: {problem}")
        for decided, chosen in choices(record):
            yield chosen, fact, f"{record.name}, {decided}" if decided else record.name


def _records(layout: DeviceLayout) -> Iterator[tuple[RecordLayout, Fact, set[str]]]:
    """All records, of tables and messages too, with the words that name them."""
    for record in layout.records.values():
        tables = {table.name for table in layout.tables.values() if table.record is record}
        yield record, record.record, {record.name, *tables}
    for message in layout.messages.values():
        model_message = message.message
        for data in message.bodies:
            if data.fields:
                number = {str(model_message.number)} if model_message.number is not None else set()
                yield data, model_message, {data.name, model_message.name, *number}
