"""The printed number of data words of a message is the number of words of its fields.

Why: the manual prints this number in a different table from the fields. If they differ, a field is missing,
has the wrong width, or is listed twice.

Example: `data_words: {request: 5}` for a telegram with four words and one value of 32 bits.

Fix: Correct a field or the number, and write an erratum.
"""

from __future__ import annotations

from fieldspec.foundation.line_text import plural
from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.sizes import RecordSizes


def data_words_match(device: Device) -> Findings:
    sizes = RecordSizes(device)
    for message in device.messages.values():
        for direction, printed, data in (
            ("request", message.request_words, message.request),
            ("response", message.response_words, message.response),
        ):
            bounds = sizes.bounds(data)
            if printed is None or bounds is None or bounds == (2 * printed, 2 * printed):
                continue
            actual = plural(bounds[0], "byte") if bounds[0] == bounds[1] else f"{bounds[0]} to {bounds[1]} bytes"
            text = f"the {direction} of {message.name} is printed with {plural(printed, 'word')}, but it has {actual}"
            yield finding(
                message.place,
                "data_words",
                text,
                "correct a field or the number",
                label(message.place, direction, "the fields"),
            )
