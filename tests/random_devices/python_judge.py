"""The generated Python as a judge: its module is imported, and asked by the names of the spec."""

from __future__ import annotations

import importlib
import sys
from keyword import iskeyword
from pathlib import Path
from types import ModuleType
from typing import Any

import python_package
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.part import PartLayout
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.foundation.names import Name
from fieldspec.language.model.value import Value
from fieldspec.targets.python.backend import files
from python_package import built, class_of, codec_error, link_of, raw, raws, record_class
from random_devices.queries import EXPONENT, Answer, Query, flat, flat_value, has_quantity, quantity_text, refused

_TAKEN = frozenset({"frame", "message", "request", "self", "unit_address"})
"""The parameters of the generated functions that are not parts of a header."""


def part_name(part: PartLayout) -> str:
    """The parameter of a part of a header; one whose name Python or the function takes ends in an underscore."""
    return part.name + "_" * (iskeyword(part.name) or part.name in _TAKEN)


def module_of_device(layout: DeviceLayout, number: int) -> ModuleType:
    """The module of a layout, in a subpackage with a number of its own; the one before it is forgotten."""
    package = python_package.package().__name__
    for name in [name for name in sys.modules if name.startswith(f"{package}.chance_")]:
        del sys.modules[name]
    texts = [text for path, text in files([layout]).items() if "__init__" not in path]
    codecs = [text for path, text in files([layout]).items() if "/_codec_" in path]
    name = f"{package}.chance_{number}.device"
    module = ModuleType(name)
    module.__package__ = f"{package}.chance_{number}"
    sys.modules[name] = module
    for text in (*codecs, texts[0]):
        exec(compile(text, f"chance_{number}.py", "exec"), module.__dict__)
    return module


class Python:
    """The answers of generated Python."""

    def __init__(self, layout: DeviceLayout, folder: Path, number: int) -> None:
        self.layout = layout
        self.module = module_of_device(layout, number)
        importlib.invalidate_caches()
        self.error = codec_error()
        self.constants = {register.name.partition("[")[0]: register for register in self.module.REGISTERS}

    def answers(self, queries: list[Query]) -> list[Answer]:
        """The answer to each query."""
        return [self.answer(query) for query in queries]

    def answer(self, query: Query) -> Answer:
        """The answer to one query."""
        try:
            if query.kind == "frame" and query.values is not None:
                return self._encoded(query)
            if query.kind == "frame":
                return self._frame(query)
            if query.kind == "record":
                return self._record(query)
            return self._value(query)
        except self.error as error:
            if query.kind == "frame" and query.values is None:
                self._assert_refused(query)
            return refused(error)

    def _assert_refused(self, query: Query) -> None:
        """A response that is refused is refused as the answer to every request, too; that has code of its own."""
        link, direction, message = query.path
        if direction == "request" or message:
            return
        for layout_message in self.layout.links[link].carried("request").values():
            if self.layout.links[link].is_guessed("response", layout_message.name):
                continue  # it was not asked for, and nothing else refuses it
            request = record_class(self.module, layout_message.request)
            try:
                link_of(self.module, link).decode_response(query.data, request)
            except self.error:
                continue
            raise AssertionError(f"{query.data.hex(' ')} is refused, but not as the answer to {layout_message.name}")

    def _assert_answer(self, query: Query, content: Any) -> None:
        """A response is the same as the answer to its request."""
        link, direction, message = query.path
        if direction == "request" or message:
            return
        messages = self.layout.links[link].carried("response").values()
        own = next(m for m in messages if record_class(self.module, m.response) is type(content))
        if not own.message.is_requested:
            return
        answer = link_of(self.module, link).decode_response(query.data, record_class(self.module, own.request))
        same = answer.message == content or repr(answer.message) == repr(content)
        assert same, f"{query.data.hex(' ')} is {answer.message} as the answer to {own.name}, not {content}"

    def _message(self, record: RecordLayout, values: dict[str, Any]) -> Any:
        return built(self.module, self.layout, record, values)

    def _arguments(self, link: str, direction: str, head: dict[str, Any]) -> tuple[list[Any], dict[str, Any]]:
        """The arguments for the parts of a header: the unit address, and the others by name."""
        shape = self.layout.links[link].frame(direction)
        first, named = [], {}
        for part in shape.header:
            if not part.is_argument:
                continue
            value = head[part.name]
            if part.role == "unit_address":
                first.append(value)
                continue
            assert part.value is not None
            if part.value.flags:
                value = class_of(self.module, part.value.flags, "Flags")(value)
            named[part_name(part)] = value
        return first, named

    def _frame_of(self, path: tuple[str, ...], head: dict[str, Any], content: Any, error: bool, code: Any) -> bytes:
        link, direction, _ = path
        first, named = self._arguments(link, direction, head)
        line = link_of(self.module, link)
        if error:
            codes = () if code is None else (code,)
            return bytes(line.encode_exception_response(*first, *codes, content, **named))
        return bytes(getattr(line, f"encode_{direction}")(*first, content, **named))

    def _encoded(self, query: Query) -> Answer:
        assert query.values is not None
        link, direction, _ = query.path
        names = {part.name for part in self.layout.links[link].frame(direction).header}
        values = {name: value for name, value in query.values.items() if name not in names}
        content = self._message(query.shape, values)
        return Answer(again=self._frame_of(query.path, query.values, content, query.error, query.code).hex())

    def _frame(self, query: Query) -> Answer:
        link, direction, message = query.path
        shape, line = self.layout.links[link].frame(direction), link_of(self.module, link)
        asked: list[Any] = []
        if message:
            own = self.layout.messages[message]
            asked = [record_class(self.module, own.request) if own.message.is_requested else message]
        decoded = getattr(line, f"decode_{direction}")(query.data, *asked)
        head: dict[str, Any] = {}
        for part in shape.header:
            if part.is_argument:
                head[part.name] = raw(
                    decoded.unit_address if part.role == "unit_address" else getattr(decoded, part_name(part))
                )
        error = self.layout.links[link].link.exception_response
        refusal = error is not None and hasattr(decoded, "exception")
        content = decoded.exception if refusal else decoded.message
        record = (
            self.layout.records[error.record] if refusal and error is not None else self._record_of(direction, content)
        )
        if not refusal:
            self._assert_answer(query, content)
        code = None
        if shape.role("code") is not None:
            code = decoded.code if refusal else type(content).CODE
        text = "".join(f"{value};" for value in head.values()) + f"|{int(refusal)}|{code}|"
        text += flat(record, raws(content, record))
        try:
            again = self._frame_of(query.path, head, content, refusal, code).hex()
        except self.error as error_again:
            again = "!" + error_again.reason
        return Answer(values=text, again=again)

    def _record_of(self, direction: str, content: Any) -> RecordLayout:
        records = (m.data(direction) for link in self.layout.links.values() for m in link.carried(direction).values())
        return next(record for record in records if record_class(self.module, record) is type(content))

    def _record(self, query: Query) -> Answer:
        record: RecordLayout = query.shape
        if query.values is not None:
            return Answer(again=self._message(record, query.values).encode().hex())
        decoded = record_class(self.module, record).decode(query.data)
        try:
            again = decoded.encode().hex()
        except self.error as error:
            again = "!" + error.reason
        return Answer(values=flat(record, raws(decoded, record)), again=again)

    def _holder(self, query: Query) -> Any:
        """What decodes and encodes a register, a parameter or an element of one."""
        if query.kind == "register":
            return next(iter(self._array(query.path[0])))
        layout_set = self.layout.device.parameters[query.path[0]]
        row = next(row for row in layout_set.parameters if row.name == query.path[1])
        return link_of(self.module, query.path[0])[row.number]

    def _array(self, name: str) -> Any:
        constant = self.constants[name]
        return [constant] if hasattr(constant, "words") else constant

    def _value(self, query: Query) -> Answer:
        value = query.shape[0]
        holder = self._holder(query)
        if query.kind == "subindex":
            return Answer(reason=None)
        if query.values is not None:
            number = query.values[query.path[-1]]
            return Answer(again=holder.encode(self._typed(value, number)).hex())
        decoded = holder.decode(query.data)
        try:
            again = holder.encode(decoded).hex()
        except self.error as error:
            again = "!" + error.reason
        quantity = self._quantity(value, holder, decoded) if has_quantity(value) else None
        return Answer(values=flat_value(value, raw(decoded)), again=again, quantity=quantity)

    def _quantity(self, value: Value, holder: Any, decoded: Any) -> str | None:
        if getattr(holder, "subindices", ()) and holder.subindex(0) is not None:
            return None  # its quantities are those of its elements
        try:
            number = holder.in_unit(decoded, *((EXPONENT,) * bool(value.scale_by)))
        except self.error as error:
            number = "!" + error.reason
        return quantity_text(number, holder.state_of(decoded))

    def _typed(self, value: Any, number: Any) -> Any:
        return class_of(self.module, value.flags, "Flags")(number) if value.flags else number


def pascal(name: str) -> str:
    """A name as Python writes classes."""
    return Name.of(name).pascal()
