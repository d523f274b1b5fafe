"""Prints explained frames, one after the other, as text or as JSON."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence

from fieldspec.commands.output import print_blocks
from fieldspec.commands.readings import Read
from fieldspec.layout.device import DeviceLayout
from fieldspec.render import explanation as shown
from fieldspec.render.blocks import Block, Line


class FramePrinter:
    """Prints at once what it is given. Notes and errata that were printed once are not repeated."""

    def __init__(self, layout: DeviceLayout, form: str) -> None:
        self.layout, self.form = layout, form
        self.said: set[str] = set()
        self.first = True

    def explain(self, held: Read, remarks: Sequence[str], number: int = 0) -> None:
        """Prints one frame; `number` is that of its line in a log, 0 where there is no log."""
        if self.form == "json":
            self._json(held, remarks, number)
        else:
            self._text(held, remarks, number)
        sys.stdout.flush()

    def _json(self, held: Read, remarks: Sequence[str], number: int) -> None:
        import json

        from fieldspec.render.explanation_json import as_data

        data = as_data(self.layout, held.explanation, held.readings, held.chosen, remarks, held.wrong)
        if number:
            print(json.dumps({"line": number, **data}, ensure_ascii=False))
        else:
            print(json.dumps(data, ensure_ascii=False, indent=1))

    def _text(self, held: Read, remarks: Sequence[str], number: int) -> None:
        if not self.first:
            print()
        self.first = False
        print_blocks(self._blocks(held, remarks, number))

    def _blocks(self, held: Read, remarks: Sequence[str], number: int) -> Iterator[Block]:
        own = held.explanation
        where = f"line {number}: " if number else ""
        sure = all((link, direction) != (own.link, own.direction) for link, direction, _, _ in held.others)
        yield Line(where + shown.title(self.layout, own, sure), "bold")
        yield from (Line(remark, "red" if held.wrong else "yellow") for remark in remarks)
        yield shown.frame_table(self.layout, own)
        if own.registers:
            yield Line(shown.accessed(self.layout, own), "bold")
            yield shown.register_table(own)
        yield from (Line(fault, "red") for fault in shown.faults(own))
        yield from (Line(example, "dim") for example in shown.examples(self.layout, own))
        for line in shown.footnotes(self.layout, own):
            if line not in self.said:
                self.said.add(line)
                yield Line(line, "dim")
