"""How programs use the generated Python: code for registers, fields of tables, messages and parameters."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from typing import Any

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.access import readable, writable
from fieldspec.language.model.encoding import is_real, is_truth
from fieldspec.language.model.value import Value
from fieldspec.targets.python.device import device_view
from fieldspec.targets.python.enums import EnumView
from fieldspec.targets.python.links import Exchange, LinkView
from fieldspec.targets.python.naming import Scope, module_name, package_name
from fieldspec.targets.python.parameter_requests import ParameterMessageView
from fieldspec.targets.python.requests import AccessView, SpaceAccess
from fieldspec.targets.python.slots import Slots
from fieldspec.targets.python.text import literal
from fieldspec.targets.usages import Usage, VersionUsages, sample_count, spelling

_IMPORT = "from fieldspec_devices.@package@ import @module@ as @package@\n"
_EXCHANGE = """frame = @package@.{link}.encode_request({call})
# Send the frame; answer is the frame that comes back.
response = @package@.{link}.decode_response(answer, request)
"""
_SEND = "frame = @package@.{link}.encode_request({call})\n"
_REGISTER = "\nrequest = @package@.read_request(@package@.@0@{option})\n{exchange}"
_VALUE = "value = @package@.read_value(@package@.@0@, response.message{option})\n"
_QUANTITY = "quantity = @package@.@0@.in_unit(value)\n"
_WRITE = "\nrequest = @package@.write_request(@package@.@0@, {value}{option})\n{send}"
_EXTRA = re.compile(r"(\w+): [\w |]+(?=[,)])")


def usages(versions: Sequence[DeviceLayout]) -> dict[str, VersionUsages]:
    """The code for each version of a device, by the version."""
    scope = Scope(frozenset({"for_firmware", "latest"}))
    result = {}
    for layout in versions:
        package, module = package_name(layout.device.id), scope.take(module_name(layout.device.version))
        rows = spelling("python", layout, partial(_spell, layout))
        result[layout.device.version] = VersionUsages("Python", {"package": package, "module": module}, rows)
    return result


def _spell(layout: DeviceLayout) -> Iterator[Usage]:
    return usage_rows(layout, device_view(layout))


def usage_rows(layout: DeviceLayout, view: dict[str, Any]) -> Iterator[Usage]:
    """The code that reads or writes each fact, with the names in the view of the module of the version."""
    return _Usages(layout, view).rows()


@dataclass(frozen=True, slots=True)
class _Usages:
    """A version with the view of its module."""

    layout: DeviceLayout
    view: dict[str, Any]

    def rows(self) -> Iterator[Usage]:
        """The code that reads or writes each fact, for all facts of the version."""
        for number, register in enumerate(self.layout.registers):
            if not register.register.reserved:
                name = self.view["registers"][number].name
                text, arguments = self._register(number, name)
                if text:
                    yield Usage(register.register.place.path, _IMPORT + text, tuple(arguments))
        yield from self._tables()
        for exchange in self.view["exchanges"]:
            yield from self._message(exchange)
        yield from self._parameters()

    def _register(self, number: int, name: str) -> tuple[str, list[str]]:
        layout = self.layout.registers[number]
        register, value = layout.register, layout.register.value
        access = self._access(register.space)
        text, arguments = "", [name + (f"[{register.index_from}]" if layout.count > 1 else "")]
        if access is None:
            return text, arguments
        link, option = self._carrier(access, access.read), self._option(access)
        if (
            link is not None
            and access.read is not None
            and readable(register.access)
            and layout.words <= access.read.most
        ):
            text += _REGISTER.format(exchange=self._exchange(link), option=option) + _VALUE.format(option=option)
            text += _QUANTITY if value.scaled else ""
        writer = access.single if layout.words == 1 and access.single is not None else access.block
        if writer is None or not (writable(register.access) or register.trigger) or layout.words > writer.most:
            return text, arguments
        link, sample = self._carrier(access, writer), self._sample(value)
        if link is not None and sample:
            text += _WRITE.format(value="@1@", option=option, send=self._send(link))
            arguments.append(sample)
        return text, arguments

    def _tables(self) -> Iterator[Usage]:
        for layout, view in zip(self.layout.tables.values(), self.view["tables"], strict=True):
            access = self._access(layout.table.space) if not layout.table.base_by else None
            link = self._carrier(access, access.read) if access is not None else None
            if access is None or access.read is None or link is None or layout.words > access.read.most:
                continue
            exchange, option = self._exchange(link), self._option(access)
            reading = _IMPORT + _REGISTER.format(exchange=exchange, option=option)
            reading += _VALUE.format(option=option).replace("value =", "record =")
            writer = access.block if access.block is not None and layout.words <= access.block.most else None
            back = self._carrier(access, writer)
            element = f"{view.name}[{layout.table.index_from}]"
            for field in layout.record.fields:
                if field.value is None or field.field.reserved or field.value.const is not None or field.is_list:
                    continue
                text, arguments = f"{reading}value = record.@1@\n", [element, field.name]
                sample = self._sample(field.value)
                if back is not None and sample and writable(layout.access(field.field)):
                    text += "\nrecord.@1@ = @2@" + _WRITE.format(value="record", option=option, send=self._send(back))
                    arguments.append(sample)
                yield Usage(field.field.place.path, text, tuple(arguments))

    def _message(self, exchange: Exchange) -> Iterator[Usage]:
        message = exchange.message.message
        samples = [(slot.name, self._slot(slot)) for slot in exchange.request.stored]
        link = self._link(exchange.request_name)
        if link is None or link.request is None:
            return
        if not link.request.before and not link.request.head_parts and message.number is not None:
            yield from self._telegram(exchange)
            return
        if any(not sample for _, sample in samples):
            return
        arguments = ", ".join(f"{name}={sample}" for name, sample in samples)
        text = f"{_IMPORT}\nrequest = @package@.@0@(@1@)\n"
        if link.response is not None and exchange.response_name:
            text += (
                f"{self._exchange(link)}{'data = response.message' if exchange.response.stored else ''}".rstrip() + "\n"
            )
        else:
            text += self._send(link)
        yield Usage(message.place.path, text, (exchange.request_name, arguments))

    def _telegram(self, exchange: Exchange) -> Iterator[Usage]:
        """The code for process data, and for each field of them."""
        reading = f"{_IMPORT}\n# data are the bytes that the device sends\ntelegram = @package@.@0@.decode(data)\n"
        writing = (
            f"{_IMPORT}\n# request is a @package@.@0@ with all fields\nrequest.@1@ = @2@\ndata = request.encode()\n"
        )
        if exchange.response_name:
            yield Usage(exchange.message.message.place.path, reading, (exchange.response_name,))
            for slot in exchange.response.stored:
                arguments = exchange.response_name, slot.name
                yield Usage(slot.field.field.place.path, f"{reading}value = telegram.@1@\n", arguments)
        for slot in exchange.request.stored:
            sample = self._slot(slot)
            if sample:
                yield Usage(slot.field.field.place.path, writing, (exchange.request_name, slot.name, sample))

    def _parameters(self) -> Iterator[Usage]:
        spaces = {space.title: space for space in self.view["spaces"]}
        for parameter_set, view in zip(self.layout.device.parameters.values(), self.view["parameters"], strict=True):
            owner = spaces.get(parameter_set.space, view) if view.read is None and view.write is None else view
            reading = self._parameter_read(owner.read, owner.name)
            writing = self._parameter_write(owner.write, owner.name)
            for row, row_view in zip(parameter_set.parameters, view.rows, strict=True):
                name = f"{view.name}.{row_view.name}" + ("[0]" if row.count > 1 else "")
                text, arguments = "", [name]
                if reading and readable(row.access):
                    text += reading + (_QUANTITY if row.value.scaled else "")
                sample = self._sample(row.value)
                table = owner.write.table if owner.write is not None else []
                is_known = not table or any(line.lstrip().startswith(f'"{row.value.type.name}"') for line in table)
                if writing and sample and is_known and writable(row.access):
                    text += writing
                    arguments.append(sample)
                if text and not row.reserved:
                    yield Usage(row.place.path, _IMPORT + text, tuple(arguments))

    def _parameter_read(self, read: ParameterMessageView | None, owner: str) -> str:
        link = self._link(read.request) if read is not None else None
        if read is None or link is None:
            return ""
        start = f"\nrequest = @package@.{owner}.read_request(@package@.@0@{self._extra(read.head, read.request)})\n"
        return f"{start}{self._exchange(link)}value = @package@.{owner}.read_value(@package@.@0@, response.message)\n"

    def _parameter_write(self, write: ParameterMessageView | None, owner: str) -> str:
        link = self._link(write.request) if write is not None else None
        if write is None or link is None:
            return ""
        extra = self._extra(write.single_head or write.head, write.request)
        return f"\nrequest = @package@.{owner}.write_request(@package@.@0@, @1@{extra})\n{self._send(link)}"

    def _extra(self, head: Sequence[str], request: str) -> str:
        """The arguments that a method needs besides the parameter and the value."""
        names = _EXTRA.findall("".join(head).partition("*,")[2])
        exchange = next(exchange for exchange in self.view["exchanges"] if exchange.request_name == request)
        slots = {slot.name: slot for slot in exchange.request.stored}
        return "".join([f", {name}={self._slot(slots[name])}" for name in names if name in slots])

    def _access(self, space: str) -> SpaceAccess | None:
        device = self.layout.device
        name = device.space_name(space) if device.several_spaces else ""
        return next((access for access in self.view["accesses"] if access.space == name), None)

    def _option(self, access: SpaceAccess) -> str:
        """The argument that names the link; empty where the functions have its messages without it."""
        usual: Sequence[str] = self.view["register_links"][:1]
        return f", link={literal(access.links[0])}" if [*access.links[:1]] != usual else ""

    def _carrier(self, access: SpaceAccess, message: AccessView | None) -> LinkView | None:
        """The first link that accesses registers by a message."""
        if message is None:
            return None
        links: Mapping[str, LinkView] = self.view["links_by_name"]
        return links[access.links[0]] if access.links else self._link(message.request)

    def _link(self, request: str) -> LinkView | None:
        """The first link that carries a request."""
        links: Sequence[LinkView] = self.view["links"]
        candidates = ((link, link.request.exchanges) for link in links if link.request is not None)
        return next((link for link, rows in candidates if any(row.message == request for row in rows)), None)

    def _call(self, link: LinkView) -> str:
        assert link.request is not None, "the link has the request of a message"
        parts = [f"{part.name}=1" for part in link.request.head_parts]
        return ", ".join([*(["1"] if link.request.before else []), "request", *parts])

    def _exchange(self, link: LinkView) -> str:
        return _EXCHANGE.format(link=link.name, call=self._call(link))

    def _send(self, link: LinkView) -> str:
        return _SEND.format(link=link.name, call=self._call(link))

    def _slot(self, slot: Slots) -> str:
        """A value for a field; empty where it holds records, or where another field decides its type."""
        value = slot.field.value
        if value is None or slot.decided:
            return ""
        sample = self._sample(value) or ("0" if value.const is not None else "")
        if not slot.field.is_list or not sample:
            return sample
        repeat = slot.field.field.repeat
        count = max(repeat.low, 1) if repeat is not None else slot.field.count or 1
        return f"[{sample}] * {count}"

    def _sample(self, value: Value) -> str:
        """An expression that may be written; empty where there is none."""
        if value.const is not None:
            return ""
        if is_real(value.encoding):
            return "0.0" if value.ranges is None or 0 in value.ranges else str(float(value.ranges.low))
        if is_truth(value.encoding):
            return "True" if value.ranges is None or 1 in value.ranges else "False"
        count = sample_count(value, self.layout.device)
        if count is None:
            return ""
        if value.flags:
            number = [*self.layout.device.flags].index(value.flags)
            return f"@package@.{self.view['flags'][number].name}({count})"
        enum: EnumView | None = next((enum for enum in self.view["enums"] if enum.title == value.enum), None)
        members = enum.members if enum is not None else []
        name = next((member.name for member in members if int(member.value) == count), "")
        return f"@package@.{enum.name}.{name}" if enum is not None and name else str(count)
