"""The command line as a judge: `encode` writes a parameter within its range, and nothing beyond it."""

from __future__ import annotations

import io
import random
from collections.abc import Iterator
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from unittest.mock import patch

from fieldspec.cli import main
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.record import FieldLayout
from fieldspec.codec.reference.parameters import carries
from fieldspec.command.sources import layout_cache
from fieldspec.language.model.encoding import is_count
from fieldspec.language.model.registers import Parameter, ParameterSet
from random_devices.inputs import header_values, number_or_text
from random_devices.queries import Answer, Query


class Command:
    """Says nothing about queries; raises AssertionError where `encode` writes what it must not, or refuses others."""

    def __init__(self, layout: DeviceLayout, folder: Path, number: int) -> None:
        self.layout, self.folder = layout, folder
        self.dice = random.Random(1)

    def answers(self, queries: list[Query]) -> list[Answer]:
        """Nothing about single queries."""
        for link in self.layout.links.values():
            for message in link.messages.values():
                value = next((field for field in message.request.fields if _part(field) == "value"), None)
                number = next((field for field in message.request.fields if _part(field) == "number"), None)
                if value is not None and number is not None and len(message.request.fields) == 2:
                    self._assert_bounded(link, message.name, number, value)
        return [Answer(reason=None)] * len(queries)

    def _assert_bounded(self, link: LinkLayout, message: str, number: FieldLayout, value: FieldLayout) -> None:
        assert value.value is not None
        assert value.value.parameter is not None
        for parameter_set, parameter in self._parameters(value.value.parameter.set):
            kind = parameter.value
            ranges = kind.writable_ranges
            if ranges is None or kind.enum or kind.flags or kind.const is not None or not is_count(kind.encoding):
                continue
            for raw in (ranges.low, number_or_text(self.layout, kind, self.dice), ranges.high + 1, ranges.low - 1):
                fits = carries(value, kind.size) if value.carries_bytes else kind.size == value.size
                if not kind.type.low <= raw <= kind.type.high or not fits or raw < 0:
                    continue
                field_type = value.value.type if value.value is not None else kind.type
                if not value.carries_bytes and not field_type.low <= raw <= field_type.high:
                    continue  # the field has the number with the same bits, below zero
                allowed = raw in ranges or kind.sentinel(raw) is not None
                head = header_values(self.layout, link.name, link.request, random.Random(1))
                pairs = {**head, number.name: parameter_set.base + parameter.number, value.name: raw}
                code, text = self._encode(link.name, message, pairs)
                if code != 0 and f"out_of_range: {value.name} " not in text:
                    continue
                assert (code == 0) == allowed, f"{message}: {parameter.name} = {raw} gives {code}: {text}"

    def _parameters(self, name: str) -> Iterator[tuple[ParameterSet, Parameter]]:
        for parameter_set in self.layout.device.sets(name):
            for parameter in parameter_set.parameters:
                alone = parameter.count == 1 and not parameter.subindices
                if alone and not parameter.reserved and parameter.access != "ro":
                    yield parameter_set, parameter

    def _encode(self, link: str, message: str, values: dict[str, object]) -> tuple[int, str]:
        pairs = [f"{name}={value}" for name, value in values.items()]
        arguments = ["encode", "chance", message, "--link", link, "--direction", "request", *pairs]
        output = io.StringIO()
        with (
            patch.object(layout_cache, "requested_layout", lambda _: self.layout),
            redirect_stdout(output),
            redirect_stderr(output),
        ):
            code = main([*arguments, "--specs", str(self.folder)])
        return code, output.getvalue()


def _part(field: FieldLayout) -> str:
    """What a field is in an access to a parameter."""
    return field.value.parameter.part if field.value is not None and field.value.parameter is not None else ""
