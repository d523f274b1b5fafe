"""The explainer as a judge: it accepts and refuses what the reference does, and every byte has a row."""

from __future__ import annotations

from pathlib import Path

from fieldspec.codec.explain.explanation import explained
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.language.model.escape import CAN_REMOTE
from random_devices.queries import Answer, Query, flat


class Explainer:
    """The answers of the explainer: whether it accepts a frame, its reasons, and the values."""

    def __init__(self, layout: DeviceLayout, folder: Path) -> None:
        self.layout = layout

    def answers(self, queries: list[Query]) -> list[Answer]:
        """The answer to each query about a frame."""
        return [
            self.answer(query) if query.kind == "frame" and query.values is None else Answer(reason=None)
            for query in queries
        ]

    def answer(self, query: Query) -> Answer:
        """The answer to one query; the reasons are joined, as the explainer goes on after the first one."""
        link, direction, message = query.path
        explanation = explained(self.layout, link, direction, query.data, message)
        shape = self.layout.links[link].frame(direction)
        # Parts that share bytes have a row each, with all of these bytes.
        rows = {(row.offset, row.length): row for row in explanation.rows}.values()
        if shape.escape is not None:
            data = b"".join(query.data[row.offset : row.offset + row.length] for row in rows)
        else:
            data = b"".join(row.characters.encode("latin-1") or row.raw for row in rows)
        assert data == query.data, "the rows of an explanation do not cover the frame"
        if explanation.reasons:
            return Answer(" ".join(explanation.reasons))
        code = shape.role("code")
        head = "".join(f"{explanation.values[part.name]};" for part in shape.header if part.is_argument)
        number = explanation.values[code.name] if code is not None else None
        if shape.escape is not None and shape.escape.is_remote(query.data):
            assert isinstance(number, int)
            number |= CAN_REMOTE
        if explanation.error:
            error = self.layout.links[link].link.exception_response
            assert error is not None
            record = self.layout.records[error.record]
        else:
            record = self.layout.messages[explanation.message].data(direction)
        text = f"{head}|{int(explanation.error)}|{number}|{flat(record, explanation.values)}"
        return Answer(values=text)
