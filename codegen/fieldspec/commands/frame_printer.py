"""Prints explained frames, one after the other, as text or as JSON."""

from __future__ import annotations

import sys
from collections.abc import Sequence

from fieldspec.commands.output import print_line, print_table
from fieldspec.commands.readings import Read
from fieldspec.layout.device import DeviceLayout
from fieldspec.render import explanation as shown


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
        own = held.explanation
        if not self.first:
            print()
        self.first = False
        where = f"line {number}: " if number else ""
        sure = all((link, direction) != (own.link, own.direction) for link, direction, _, _ in held.others)
        print_line(where + shown.title(self.layout, own, sure), "bold")
        for remark in remarks:
            print_line(remark, "red" if held.wrong else "yellow")
        self._table(shown.frame_table(self.layout, own))
        if own.registers:
            print_line(shown.accessed(self.layout, own), "bold")
            self._table(shown.register_table(own))
        for fault in shown.faults(own):
            print_line(fault, "red")
        for example in shown.examples(self.layout, own):
            print_line(example, "dim")
        for line in shown.footnotes(self.layout, own):
            if line not in self.said:
                self.said.add(line)
                print_line(line, "dim")

    def _table(self, table: shown.Table) -> None:
        print_table(table.headings, table.rows, ["red" if wrong else "" for wrong in table.wrong])
