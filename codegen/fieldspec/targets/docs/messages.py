"""Messages byte by byte, process data word by word, signals and conversions."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.foundation.line_text import plural
from fieldspec.language.model.record import Message, Segments
from fieldspec.language.model.value import Conversion, Signal
from fieldspec.targets.docs.context import Context, cited, fact_row, names
from fieldspec.targets.docs.document import (
    Cell,
    DocumentTable,
    Facts,
    Line,
    Piece,
    Section,
    TableColumn,
    TableRow,
    cell,
    code,
    joined,
    label,
    styled,
    table,
    text_piece,
)
from fieldspec.targets.docs.links import FrameTable, length_text, separator
from fieldspec.targets.docs.sources import Inferences
from fieldspec.targets.docs.value_cells import VALUE_COLUMNS, meaning_cell, value_cells

DIRECTIONS = ("request", "response")


def messages(context: Context) -> Section:
    """All messages by code, those without a code by their numbers after them."""
    inner = tuple(
        _message(context, message_layout) for message_layout in sorted(context.layout.messages.values(), key=_by_code)
    )
    return Section("messages", (text_piece("Messages"),), (), inner)


def _by_code(message_layout: MessageLayout) -> tuple[bool, int]:
    code = message_layout.message.code
    return code is None, (message_layout.message.number if code is None else code) or 0


def _message(context: Context, message_layout: MessageLayout) -> Section:
    message = message_layout.message
    path = message.place.path
    blocks = context.opening(message)
    blocks.append(Facts(tuple(_facts(context, message_layout))))
    carrying_links = [link for link in context.layout.links.values() if message_layout.name in link.messages]
    for number, link in enumerate(carrying_links):
        for direction in (candidate for candidate in DIRECTIONS if message.name in link.carried(candidate)):
            blocks.append(_frame(context, message_layout, link, direction, "messages/" if number == 0 else ""))
    title = message.title or " ".join(message.name.split("_")).capitalize()
    code_pieces: Line = () if message.code is None else (code(_code(context, message, message.code)), text_piece(" "))
    return Section(path, (*code_pieces, *context.section_title(title, message)), tuple(blocks))


def _code(context: Context, message: Message, number: int) -> str:
    """A code of a message with the digits of the widest part that carries it."""
    links = context.layout.links.values()
    carriers = [link for link in links if message.name in link.messages]
    parts = [part for link in carriers for direction in DIRECTIONS if (part := link.frame(direction).role("code"))]
    widest = max(parts, key=lambda part: part.size if part.form else 2 * part.size, default=None)
    return f"0x{number:02X}" if widest is None else widest.number_text(number)


def _code_pieces(context: Context, message: Message, number: int) -> Line:
    """A code, and its number where that is not what the code looks like."""
    text = _code(context, message, number)
    return (code(text),) if text.isdecimal() else (code(text), text_piece(f" ({number})"))


def _frame(
    context: Context, message_layout: MessageLayout, link: LinkLayout, direction: str, anchored: str
) -> DocumentTable:
    anchor = f"{message_layout.message.place.path}/{link.name}-{direction}"
    record = message_layout.data(direction)
    title = link.link.direction_name(direction).capitalize()
    remote = message_layout.message.remote if direction == "request" else None
    length = _length(link, direction, record) if remote is None else f"a remote request for {plural(remote, 'byte')}"
    caption = f"{title} on {link.link.title or link.name}: {length}"
    return FrameTable(context, link, direction, anchor, anchored).table(
        caption, record, message_layout.message.printed_code(direction)
    )


def _length(link: LinkLayout, direction: str, record: RecordLayout) -> str:
    """The length of a frame, as its table counts: with its delimiters, and without the identifier of a CAN frame."""
    shape, escape = link.frame(direction), link.link.escape
    parts_size, marks = shape.header_size + shape.trailer_size, len(shape.further + shape.start) + len(shape.end)
    if link.link.transmission == "hex_ascii":
        text = f"{length_text(parts_size, record)}, as two characters each"
        return f"{text}, and {plural(marks, 'character')} as delimiters" if marks else text
    if escape is not None and link.link.is_can:
        return f"{length_text(parts_size - escape.fields_size, record)} of data"
    return length_text(parts_size + marks, record)


def _subcodes(context: Context, message_layout: MessageLayout) -> Iterator[tuple[str, tuple[Line, ...]]]:
    """The subcodes of the message, once for all links and directions where they are equal."""
    texts = dict.fromkeys(
        text
        for link in context.layout.links.values()
        for direction in DIRECTIONS
        for number, subcode in link.subcodes(direction).items()
        if number == message_layout.message.code_of(direction) and message_layout in subcode.messages.values()
        for text in subcode.texts_of(message_layout)
    )
    if texts:
        yield "Subcode", (joined((code(text),) for text in texts),)


def _steps(context: Context, message: Message) -> Iterator[Piece]:
    """The accesses of a message to registers, one after the other."""
    for number, step in enumerate(message.access_steps):
        verb = "changes bits of" if step.and_mask else f"{step.operation}s"
        yield text_piece(f"{', then ' if number else ''}{verb} ")
        if context.device.spaces:
            space = context.device.space(step.space)
            yield text_piece(space.title or space.name, f"#{space.place.path}")
        else:
            yield text_piece("registers", "#registers")
        if step.and_mask:
            yield from (text_piece(": "), code(step.and_mask), text_piece(" has those that stay, "))
            yield from (code(step.or_mask), text_piece(" the others"))


def _pieces(segments: Segments) -> Iterator[Piece]:
    """How the value of a message follows in pieces."""
    verb = "read" if segments.reads else "written"
    yield text_piece(f"the value is {verb} by ")
    yield code(segments.message, f"#messages/{segments.message}")
    if segments.when:
        yield text_piece(" where the response says ")
        yield from joined((code(name),) for name in segments.when)
    names = ("data", "counter", "unused", "last", "size")
    parts = [(name, getattr(segments, name)) for name in names if getattr(segments, name)]
    for name, field in parts:
        yield text_piece(f", {name} ")
        yield code(field)
    if segments.unsized:
        yield text_piece(" except with ")
        yield from joined((code(name),) for name in segments.unsized)
    abort = segments.abort
    if abort is not None:
        yield text_piece("; what does not follow is ended by ")
        yield code(abort.message, f"#messages/{abort.message}")
        yield text_piece(f" with the {abort.reason} ")
        yield from joined(((code(abort.counter),), (code(abort.size),)), " or ")


def _facts(context: Context, message_layout: MessageLayout) -> Iterator[tuple[str, tuple[Line, ...]]]:
    message = message_layout.message
    yield "Name", ((code(message.name),),)
    if message.number is not None:
        yield "Number", ((code(str(message.number)),),)
    if message.links:
        yield "Sent on", (joined((code(name, f"#links/{name}"),) for name in message.links),)
    if not message.is_requested:
        yield "Sent", ((text_piece("only by the device, of its own accord"),),)
    if message.answered_on is not None:
        answering_links = ((code(name, f"#links/{name}"),) for name in message.answered_on)
        yield (
            "Answered",
            ((text_piece("on "), *joined(answering_links)) if message.answered_on else (text_piece("never"),),),
        )
    if message.supplements:
        companions = joined((code(name, f"#messages/{name}"),) for name in message.supplements)
        yield "Sent beside", ((*companions, text_piece(", never alone")),)
    if message.group:
        yield "Group", ((text_piece(" ".join(message.group.split("_"))),),)
    if message.code is not None:
        yield "Code", (_code_pieces(context, message, message.code),)
    if message.remote is not None:
        yield "Request", ((text_piece(f"a remote request for {plural(message.remote, 'byte')}, without data"),),)
    if message.response_code is not None:
        yield "Code of the response", (_code_pieces(context, message, message.response_code),)
    if message.code is not None:
        yield from _subcodes(context, message_layout)
    separated = [body for body in message_layout.bodies if body.record.separator]
    for body in separated[:1]:
        yield from separator(body)
    printed = [
        f"{direction} {plural(length, 'byte')}"
        for direction, length in zip(DIRECTIONS, (message.request_length, message.response_length), strict=True)
        if length is not None
    ]
    if printed:
        yield "Frame length as printed", ((text_piece(", ".join(printed)),),)
    words = [
        f"{direction} {plural(number, 'word')}"
        for direction, number in zip(DIRECTIONS, (message.request_words, message.response_words), strict=True)
        if number is not None
    ]
    if words:
        yield "Data words as printed", ((text_piece(", ".join(words)),),)
    if message.broadcast is not None:
        text = "may be broadcast to all stations" if message.broadcast else "cannot be broadcast; encoders refuse it"
        yield "Broadcast", ((text_piece(text),),)
    if message.single_access is not None:
        verb, spaces = f"{message.single_access.operation}s", context.device.spaces
        if spaces:
            space = context.device.space(message.single_access.space)
            yield "Accesses", ((text_piece(f"{verb} {space.title or space.name}", f"#{space.place.path}"),),)
        else:
            yield "Accesses", ((text_piece(f"{verb} registers", "#registers"),),)
    if message.access_steps:
        yield "Accesses", (tuple(_steps(context, message)),)
    if message.segments is not None:
        yield "In pieces", (tuple(_pieces(message.segments)),)
    examples = [example for example in context.device.examples.values() if example.message == message.name]
    if examples:
        yield "Examples", (joined((text_piece(example.id, f"#{example.place.path}"),) for example in examples),)
    if message.sources:
        yield "Source", (cited(message.sources),)
    repeated = [citation for claim in message.restated for citation in claim.sources]
    if repeated:
        yield "Printed again", (cited(repeated),)


TELEGRAM_DIRECTIONS = ("request", "response")
MOST_WORDS = 64


def telegrams(context: Context) -> Section:
    """A table for each link whose frames are words of data only, with one column for each message and direction."""
    blocks = [words_table for link in context.layout.links.values() if (words_table := _table(link)) is not None]
    names = sorted({link.link.message_name for link in context.layout.links.values() if _has_process_data(link)})
    title = " and ".join(f"{name.capitalize()}s" for name in names) or "Telegrams"
    return Section("words", (text_piece(f"{title} word by word"),), tuple(blocks))


def _has_process_data(link: LinkLayout) -> bool:
    """Whether a link has messages that only their number distinguishes, all of whole words."""
    bare = all(
        not link.frame(direction).header and not link.frame(direction).trailer for direction in TELEGRAM_DIRECTIONS
    )
    numbered = [message for message in link.messages.values() if message.message.number is not None]
    return (
        bare
        and bool(numbered)
        and all(_words(message.data(d)) is not None for message in numbered for d in TELEGRAM_DIRECTIONS)
    )


def _words(record: RecordLayout) -> int | None:
    """The words of a record of whole words that is not too long to be shown."""
    whole = record.size is not None and all(field.offset % 2 == 0 for field in record.fields)
    words = (record.size or 0) // 2
    return words if whole and record.size == 2 * words and words <= MOST_WORDS else None


def _table(link: LinkLayout) -> DocumentTable | None:
    if not _has_process_data(link):
        return None
    columns = [TableColumn("Word", "number", unbroken=True)]
    records: list[RecordLayout] = []
    numbered = [message for message in link.messages.values() if message.message.number is not None]
    for message in sorted(numbered, key=lambda message: message.message.number or 0):
        for direction in TELEGRAM_DIRECTIONS:
            columns.append(TableColumn(_title(link, message, direction), unbroken=True))
            records.append(message.data(direction))
    word_count = max((_words(record) or 0 for record in records), default=0)
    rows = [
        TableRow((cell(str(word + 1)), *(_word_cell(record, word) for record in records))) for word in range(word_count)
    ]
    return table(f"Words of {link.link.title or link.name}", columns, rows)


def _title(link: LinkLayout, message: MessageLayout, direction: str) -> str:
    return f"{message.message.number} {link.link.direction_name(direction)}"


def _word_cell(record: RecordLayout, word: int) -> Cell:
    """The content of a word: the field that starts or continues there."""
    field = next(
        (candidate for candidate in record.fields if candidate.offset <= 2 * word < (candidate.end or 0)), None
    )
    if field is None:
        return Cell()
    if field.offset < 2 * word:
        return cell(styled("continued", "quiet"))
    if field.field.reserved:
        return cell(styled("reserved", "badge"))
    return _field_cell(field)


def _field_cell(field: FieldLayout) -> Cell:
    link = f"#{field.field.place.path}"
    printed = [(label(field.field.printed_name),)] if field.field.printed_name else []
    return cell((code(field.name, link),), *printed)


COLUMNS = (
    TableColumn("Name", unbroken=True),
    TableColumn("Direction", "short"),
    *VALUE_COLUMNS,
    TableColumn("Lies in"),
    TableColumn("Meaning", "wide"),
    TableColumn("Source", "source"),
)
SIGNAL_DIRECTIONS = {"request": "to the device", "response": "from the device", "": ""}


def signals(context: Context) -> Section:
    """The section of all signals in one table."""
    device = context.device
    marks = Inferences("signals")
    rows = [_signal(context, signal, marks) for signal in device.signals.values()]
    blocks = (table("Signals", COLUMNS, rows, marks.footnotes()),) if rows else ()
    return Section("signals", (text_piece("Signals"),), blocks)


def _signal(context: Context, signal: Signal, marks: Inferences) -> TableRow:
    kind, unit, bounds = value_cells(signal.value, signal.inferred, marks)
    return fact_row(
        signal,
        names(signal, signal.name, mark=marks.marks(signal.inferred)),
        cell(SIGNAL_DIRECTIONS[signal.direction]),
        kind,
        unit,
        bounds,
        _lies_in(context, signal),
        meaning_cell(context, signal, signal.value, *_converted(context, signal)),
    )


def _lies_in(context: Context, signal: Signal) -> Cell:
    """The messages that have a signal."""
    messages = [
        message
        for message in context.device.messages.values()
        if any(field.signal == signal.name for field in (*message.request.fields, *message.response.fields))
    ]
    return cell(joined((code(message.name, f"#messages/{message.name}"),) for message in messages))


def _converted(context: Context, signal: Signal) -> Iterator[Line]:
    for conversion in context.device.conversions.values():
        if signal.name in conversion.signals:
            yield (text_piece("Converted by "), code(conversion.name, f"#conversions/{conversion.name}"))


def conversions(context: Context) -> Section:
    """All conversions, one after the other."""
    inner = tuple(_conversion(context, conversion) for conversion in context.device.conversions.values())
    return Section("conversions", (text_piece("Conversions"),), (), inner)


def _conversion(context: Context, conversion: Conversion) -> Section:
    share = f"count / {conversion.full_scale}"
    formula = f"reference * (1 - {share})" if conversion.complement else f"reference * {share}"
    rows: list[tuple[str, tuple[Line, ...]]] = [("Formula", ((code(f"{conversion.name} = {formula}"),),))]
    rows.append(
        ("Whole reference", ((code(f"0x{conversion.full_scale:X}"), text_piece(f" ({conversion.full_scale})")),))
    )
    rows.append(("Type of the count", ((code(conversion.type.name),),)))
    if conversion.signals:
        links = joined((code(name, f"#signals/{name}"),) for name in conversion.signals)
        rows.append(("Count", (links,)))
    if conversion.references:
        rows.append(("Reference", (joined((context.link_to(path),) for path in conversion.references),)))
    if conversion.printed:
        rows.append(("As printed", ((code(conversion.printed),),)))
    if conversion.sources:
        rows.append(("Source", (cited(conversion.sources),)))
    title = context.section_title(conversion.title or conversion.name, conversion)
    return Section(conversion.place.path, title, (*context.opening(conversion), Facts(tuple(rows))))
