"""How programs use the generated C: code for registers, parameters, messages and process data."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.names import stem
from fieldspec.language.model.access import readable, writable
from fieldspec.language.model.encoding import is_signed
from fieldspec.language.model.value import Value
from fieldspec.targets.c.fields import members
from fieldspec.targets.c.frames import header_parameters
from fieldspec.targets.c.naming import Naming, Noun, member
from fieldspec.targets.c.runtime_files import is_bit
from fieldspec.targets.c.values import WireValue, accessed_type
from fieldspec.targets.usages import Rows, Usage, VersionUsages, sample_text

_INCLUDE = '#include "@header@"\n'


def version_usages(layout: DeviceLayout, rows: Rows) -> VersionUsages:
    """The code for a version of a device."""
    return VersionUsages("C", {"header": f"{stem(layout.device.id, layout.device.version)}.h"}, rows)


def usage_rows(layout: DeviceLayout, naming: Naming) -> Iterator[Usage]:
    """The code that reads or writes each fact, with the names of the header of the version."""
    return _Usages(layout, naming).rows()


@dataclass(frozen=True, slots=True)
class _Usages:
    """A version with the names of its header."""

    layout: DeviceLayout
    naming: Naming

    def rows(self) -> Iterator[Usage]:
        """The code that reads or writes each fact, for all facts of the version."""
        for register in self.layout.registers:
            if not register.register.reserved and not is_bit(register):
                unit = "words" if register.register.unit_size > 1 else "bytes"
                address, words = (self.naming.macro("register", register.name, name) for name in ("address", unit))
                start = f"\n/* the bytes of {words} registers from {address} on */\nuint8_t bytes[2 * {words}];\n"
                if unit == "bytes":
                    start = f"\n/* the bytes from {address} on */\nuint8_t bytes[{words}];\n"
                start = start.replace(words, "@0@").replace(address, "@1@")
                fact, value = register.register, register.register.value
                wire = WireValue(value, register.order, register.swapped)
                access = fact.access, fact.trigger
                yield from self._value(
                    fact.place.path, "register", (register.name,), wire, access, start, [words, address]
                )
        for parameter_set in self.layout.device.parameters.values():
            for row in parameter_set.parameters:
                if not row.reserved:
                    names = parameter_set.name, row.name
                    number = self.naming.macro("parameter", *names, "number")
                    start = "\n/* the bytes of the value of parameter @0@ */\nuint8_t bytes[@1@];\n"
                    wire = WireValue(row.value, "big", False)
                    access = row.access, row.trigger
                    arguments = [number, str(row.value.size)]
                    yield from self._value(row.place.path, "parameter", names, wire, access, start, arguments)
        for message in self.layout.messages.values():
            yield from self._message(message)

    def _value(
        self,
        path: str,
        noun: Noun,
        names: tuple[str, ...],
        wire: WireValue,
        access: tuple[str, bool],
        start: str,
        arguments: list[str],
    ) -> Iterator[Usage]:
        """The code that converts a value. A register that starts an action answers with any number."""
        value, device = wire.value, self.layout.device
        if wire.is_array:
            return
        text, arguments = _INCLUDE + start, [*arguments]

        def argument(content: str) -> str:
            arguments.append(content)
            return f"@{len(arguments) - 1}@"

        used = False
        answer = value.as_answer(access[1])
        ok = self.naming.own_macro("ok")
        if readable(access[0]):
            kind = accessed_type(self.naming, device, answer)
            decode = self.naming.function(noun, *names, "decode")
            text += (
                f"{argument(kind)} value;\nif ({argument(decode)}(bytes, &value) == {ok}) {{\n    /* use value */\n}}\n"
            )
            used = True
        sample = self._sample(value)
        if sample and (writable(access[0]) or access[1]):
            encode = self.naming.function(noun, *names, "encode")
            text += f"if ({argument(encode)}({argument(sample)}, bytes) == {ok}) {{\n    /* send bytes */\n}}\n"
            used = True
        if used:
            yield Usage(path, text, tuple(arguments))

    def _message(self, message: MessageLayout) -> Iterator[Usage]:
        link = next((link for link in self.layout.links.values() if message.name in link.carried("request")), None)
        if link is None:
            return
        bare = not link.request.header and not link.request.trailer and message.message.number is not None
        if bare:
            yield from self._telegram(message)
        elif (request := self._struct(message.request)) is not None:
            yield Usage(message.message.place.path, *self._frame(message, link, request))

    def _frame(self, message: MessageLayout, link: LinkLayout, request: str) -> tuple[str, tuple[str, ...]]:
        header = [str(number + 1) for number, _ in enumerate(header_parameters(link.request))]
        struct = self.naming.type("record", message.request.name)
        function = self.naming.function("link", link.name, "encode", message.name, "request")
        passed = [*header, *(["&request"] if request else []), "frame", "sizeof frame", "&length"]
        declared = "const @1@ request = {@2@};\n" if request else ""
        text = (
            f"{_INCLUDE}\n{declared}uint8_t frame[{self._longest(link)}];\nsize_t length = 0;\n"
            f"if (@0@({', '.join(passed)}) == {self.naming.own_macro('ok')}) {{\n"
            "    /* send length bytes of frame */\n}\n"
        )
        return text, (function, struct, request) if request else (function,)

    def _longest(self, link: LinkLayout) -> int:
        """The bytes of the longest request of a link that the code needs."""
        longest_body = max(message.request.most or 0 for message in link.messages.values())
        parts = link.request.header_size + link.request.trailer_size + longest_body
        return (
            (2 if link.link.transmission == "hex_ascii" or link.request.escape else 1) * parts
            + len(link.request.start)
            + len(link.request.end)
        )

    def _telegram(self, message: MessageLayout) -> Iterator[Usage]:
        """The code for process data, and for each field of them."""
        ok = self.naming.own_macro("ok")
        for direction, data in zip(message.message.directions, message.bodies, strict=True):
            if not members(data):
                continue
            kind = self.naming.type("record", data.name)
            verb = "decode" if direction == "response" else "encode"
            function = self.naming.function("record", data.name, verb)
            if direction == "response":
                text = (
                    f"{_INCLUDE}\n/* length bytes of data are what the device sends */\n@0@ telegram;\n"
                    f"if (@1@(data, length, &telegram) == {ok}) {{\n    /* use telegram.@2@ */\n}}\n"
                )
            else:
                text = (
                    f"{_INCLUDE}\n/* telegram is a @0@ with all members */\ntelegram.@2@ = @3@;\n"
                    f"if (@1@(&telegram, data, sizeof data, &length) == {ok}) {{\n"
                    "    /* send length bytes of data */\n}\n"
                )
            for field in members(data):
                sample = self._sample(field.value) if field.value is not None and not field.is_list else ""
                if sample:
                    arguments = [kind, function, member(field.name)]
                    yield Usage(
                        field.field.place.path, text, tuple([*arguments, sample] if verb == "encode" else arguments)
                    )

    def _struct(self, record: RecordLayout) -> str | None:
        """The initializers of a struct; None where it has lists, records or choices."""
        rows = []
        for field in members(record):
            sample = self._field(field)
            if not sample:
                return None
            rows.append(f".{member(field.name)} = {sample}")
        return ", ".join(rows)

    def _field(self, field: FieldLayout) -> str:
        return "" if field.value is None or field.is_list or field.cases else self._sample(field.value)

    def _sample(self, value: Value) -> str:
        """An expression that may be written; empty where there is none."""
        suffix = "" if is_signed(value.encoding) else "u"
        return sample_text(
            value,
            self.layout.device,
            lambda enum, row: self.naming.macro("enum", enum.name, row.name),
            lambda count: f"{count}{suffix}" if abs(count) < 1 << 31 else f"{count}{suffix}ll",
        )
