"""How programs use the generated JavaScript: code for registers, fields of tables, messages and parameters."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import partial

from fieldspec.codec.layout.carrying import carries
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.names import Name, version_word
from fieldspec.language.model.access import readable, writable
from fieldspec.language.model.value import Value
from fieldspec.targets.js.declaration import Declaration, Names
from fieldspec.targets.js.enums import member_keys
from fieldspec.targets.js.links import argument_keys
from fieldspec.targets.js.members import Member, members_of
from fieldspec.targets.js.module import declarations, remaining
from fieldspec.targets.js.naming import module_scope
from fieldspec.targets.js.registers import Access, accesses
from fieldspec.targets.js.units import unit_of
from fieldspec.targets.runtime_values import is_wide
from fieldspec.targets.usages import Usage, VersionUsages, sample_text, spelling

_IMPORT = 'import * as device from "fieldspec-devices/@folder@/@module@.js";\n'
_READ = "const [{ message, data }] = {functions}.readRequests(device.@0@);\n"
_EXCHANGE = """const frame = device.{link}.encodeRequest({header}, {message}, {data});
// Send the frame; answer is the frame that comes back.
const response = device.{link}.decodeResponse(answer);
"""
_VALUE = "const value = {functions}.readValue(device.@0@, response.data);\n"
_WRITE = """
const [command] = {functions}.writeRequests(device.@0@, {value});
const written = device.{link}.encodeRequest({header}, command.message, command.data);
"""
_DECLARED = re.compile(r"export const (\w+) = /\* @__PURE__ \*/ (table|link|parameterSet)\(")
_KEY = re.compile(r"  (\w+): ")


def usages(versions: Sequence[DeviceLayout]) -> dict[str, VersionUsages]:
    """The code for each version of a device, by the version."""
    result = {}
    for layout in (remaining(layout).layout for layout in versions):
        folder = Name.of(layout.device.id).snake().replace("_", "-")
        variables = {"folder": folder, "module": version_word(layout.device.version)}
        result[layout.device.version] = VersionUsages(
            "JavaScript", variables, spelling("js", layout, partial(_spell, layout))
        )
    return result


def _spell(layout: DeviceLayout) -> Iterator[Usage]:
    names = Names(layout, module_scope())
    return usage_rows(names, declarations(names, is_for_names=True))


def usage_rows(names: Names, rows: Sequence[Declaration]) -> Iterator[Usage]:
    """The code that reads or writes each fact, with the names of a module that declares these `rows`."""
    layout = names.layout
    declared: dict[str, list[tuple[str, list[str]]]] = {}
    for row in rows:
        for line in row.code:
            if match := _DECLARED.match(line):
                keys = [key[1] for inner in row.code[1:] if (key := _KEY.match(inner))]
                declared.setdefault(match[2], []).append((match[1], keys))
    carrying = [link for link in layout.links.values() if any(carries(link, m) for m in layout.messages.values())]
    links = {link.name: name for link, (name, _) in zip(carrying, declared.get("link", ()), strict=True)}
    return _Usages(names, links, declared).rows()


@dataclass(frozen=True, slots=True)
class _Usages:
    """The names of a module: of links by their names in the spec, of tables and sets in the order of the layout."""

    names: Names
    links: dict[str, str]
    declared: dict[str, list[tuple[str, list[str]]]]

    @property
    def layout(self) -> DeviceLayout:
        """The layout of the version."""
        return self.names.layout

    def rows(self) -> Iterator[Usage]:
        """The code that reads or writes each fact, for all facts of the version."""
        known = accesses(self.names)
        yield from self._registers(known)
        yield from self._tables(known)
        for message in self.layout.messages.values():
            yield from self._message(message)
        yield from self._parameters()

    def _registers(self, known: Sequence[Access]) -> Iterator[Usage]:
        for layout in self.layout.registers:
            register, value, name = layout.register, layout.register.value, self.names.registers[layout.name]
            if register.reserved:
                continue
            space = self._space(register.space)
            text, arguments = _IMPORT, [name + (f".at({register.index_from})" if layout.count > 1 else "")]
            read = self._access(known, space, "read", layout.words)
            if read is not None and readable(register.access):
                text += "\n" + self._reading(*read)
                has_quantity = unit_of(value) and not value.scale_by
                text += "const quantity = device.@0@.units.inUnit(value);\n" if has_quantity else ""
            write, sample = self._access(known, space, "write", layout.words), self._sample(value)
            if write is not None and sample and (writable(register.access) or register.trigger):
                text += self._writing(*write, "@1@")
                arguments.append(sample)
            if text != _IMPORT:
                yield Usage(register.place.path, text, tuple(arguments))

    def _tables(self, known: Sequence[Access]) -> Iterator[Usage]:
        for layout, (name, _) in zip(self.layout.tables.values(), self.declared.get("table", ()), strict=True):
            space = self._space(layout.table.space)
            read = self._access(known, space, "read", layout.words)
            write = self._access(known, space, "write", layout.words)
            if read is None or layout.table.base_by:
                continue
            start = f"{_IMPORT}\n{self._reading(*read)}".replace("const value", "const record")
            for member in members_of(layout.record):
                field = member.field
                if not member.key or field.value is None or field.is_list or field.field.reserved:
                    continue
                text, arguments = (
                    f"{start}const value = record.@1@;\n",
                    [f"{name}.at({layout.table.index_from})", member.key],
                )
                sample = self._sample(field.value)
                if write is not None and sample and writable(layout.access(field.field)):
                    text += f"\nrecord.@1@ = @2@;{self._writing(*write, 'record')}"
                    arguments.append(sample)
                yield Usage(field.field.place.path, text, tuple(arguments))

    def _message(self, message: MessageLayout) -> Iterator[Usage]:
        link = self._carrier(message)
        if link is None or message.name not in link.carried("request"):
            return
        name, own = self.names.messages[message.name], message.message
        if not link.request.header and not link.request.trailer and own.number is not None:
            yield from self._telegram(message)
            return
        rows = [(member.key, self._member(member)) for member in members_of(message.request) if member.key]
        if any(not sample for _, sample in rows):
            return
        data = f"{{ {', '.join(f'{key}: {sample}' for key, sample in rows)} }}" if rows else "{}"
        text = f"{_IMPORT}\n{self._exchange(link, 'device.@0@', '@1@')}"
        if message.name not in link.carried("response"):
            text = text.partition("// Send")[0]
        yield Usage(own.place.path, text, (name, data))

    def _telegram(self, message: MessageLayout) -> Iterator[Usage]:
        """The code for process data, and for each field of them."""
        for direction, body in zip(message.message.directions, message.bodies, strict=True):
            for member in members_of(body):
                sample = self._member(member)
                if not member.key or not sample:
                    continue
                arguments = [self.names.records[body.name], member.key]
                if direction == "response":
                    text = f"{_IMPORT}\n// data are the bytes that the device sends\n"
                    text += "const value = device.@0@.decode(data).@1@;\n"
                else:
                    text = f"{_IMPORT}\n// telegram has all properties of device.@0@\n"
                    text += "telegram.@1@ = @2@;\nconst data = device.@0@.encode(telegram);\n"
                    arguments.append(sample)
                yield Usage(member.field.field.place.path, text, tuple(arguments))

    def _parameters(self) -> Iterator[Usage]:
        for parameter_set, (name, keys) in zip(
            self.layout.device.parameters.values(), self.declared.get("parameterSet", ()), strict=True
        ):
            for row, key in zip(parameter_set.parameters, keys, strict=True):
                if row.reserved or row.count > 1:
                    continue
                text, arguments = f"{_IMPORT}\nconst parameter = device.@0@.parameters.@1@;\n", [name, key]
                if readable(row.access):
                    text += "const value = parameter.decode(bytes);  // the bytes of the value in an answer\n"
                sample = self._sample(row.value)
                if sample and writable(row.access):
                    text += "const bytesToWrite = parameter.encode(@2@);\n"
                    arguments.append(sample)
                if text.count("\n") > 3:
                    yield Usage(row.place.path, text, tuple(arguments))

    def _space(self, space: str) -> str:
        device = self.layout.device
        return device.space_name(space) if device.several_spaces else ""

    def _access(self, known: Sequence[Access], space: str, operation: str, words: int) -> tuple[str, LinkLayout] | None:
        """The object with the functions for a register of some words, and the first link that carries their message."""
        for access in known:
            if access.space == space and access.operation == operation and words <= access.most:
                if access.links[:1] != known[0].links[:1]:
                    name = access.links[0]
                    return f'device.registersOn("{name}")', self.layout.links[name]
                link = self.layout.links[access.links[0]] if access.links else self._carrier(access.message)
                if link is not None:
                    return "device", link
        return None

    def _reading(self, functions: str, link: LinkLayout) -> str:
        text = _READ + self._exchange(link, "message", "data") + _VALUE
        return text.replace("{functions}", functions)

    def _writing(self, functions: str, link: LinkLayout, value: str) -> str:
        return _WRITE.format(functions=functions, value=value, link=self.links[link.name], header=self._header(link))

    def _carrier(self, message: MessageLayout) -> LinkLayout | None:
        return next((link for link in self.layout.links.values() if carries(link, message)), None)

    def _header(self, link: LinkLayout) -> str:
        keys = [key for key in argument_keys(link.request.header) if key]
        return f"{{ {', '.join(f'{key}: 1' for key in keys)} }}" if keys else "{}"

    def _exchange(self, link: LinkLayout, message: str, data: str) -> str:
        return (
            _EXCHANGE.replace("{link}", self.links[link.name])
            .replace("{header}", self._header(link))
            .replace("{message}", message)
            .replace("{data}", data)
        )

    def _member(self, member: Member) -> str:
        field = member.field
        return "" if field.value is None or field.is_list or field.cases else self._sample(field.value)

    def _sample(self, value: Value) -> str:
        """An expression that may be written; empty where there is none."""
        return sample_text(
            value,
            self.layout.device,
            lambda enum, row: f"device.{self.names.enums[enum.name]}.{member_keys(enum)[row.name]}",
            lambda count: f"{count}n" if is_wide(value.encoding) else str(count),
        )
