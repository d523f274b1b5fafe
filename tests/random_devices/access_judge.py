"""Generated Python as a judge of what registers are for: requests, quantities, and many records at once."""

from __future__ import annotations

import random
from collections.abc import Iterator
from fractions import Fraction
from inspect import signature
from itertools import product
from pathlib import Path
from typing import Any

import pytest

from fieldspec.codec.layout.accepted import stated_numbers
from fieldspec.codec.layout.device import DeviceLayout, TableLayout
from fieldspec.codec.layout.exponents import exponent_of
from fieldspec.codec.layout.record import RecordLayout, RegisterLayout
from fieldspec.codec.reference import CodecError
from fieldspec.codec.reference.quantities import quantity as reference_quantity
from fieldspec.codec.reference.quantities import scale_of, special_number, state_name
from fieldspec.codec.reference.records import decoded
from fieldspec.foundation.names import Name
from fieldspec.language.model.encoding import is_count, is_real, is_signed
from fieldspec.language.model.record import Message
from fieldspec.language.model.value import Value
from python_package import built, link_of, record_class, runtime
from random_devices.inputs import is_computed, record_values, stored_fields
from random_devices.python_judge import Python
from random_devices.quantities import state_queries
from random_devices.queries import Answer, Query
from random_devices.reference_answers import Reference

SILENT = Answer(reason=None)


def _has_read_only(record: RecordLayout) -> bool:
    """Whether a field of a record, or of a record in it, can only be read."""
    return any(
        field.field.access == "ro" or (field.record is not None and _has_read_only(field.record))
        for field in record.fields
    )


def _has_characters(record: RecordLayout) -> bool:
    """Whether a record, or one in it, has digits, or texts in a form of their own, which have no columns."""
    return any(
        _has_characters(field.record)
        if field.record is not None
        else field.value is not None and bool(field.value.digits or field.value.text_form)
        for field in record.fields
    )


def _is_empty(record: RecordLayout) -> bool:
    """Whether a record, and every record in it, has reserved fields only, which have no columns."""
    return all(
        field.field.reserved or (field.record is not None and _is_empty(field.record)) for field in record.fields
    )


class Access(Python):
    """Requests for registers, quantities of registers, and columns of records."""

    def __init__(self, layout: DeviceLayout, folder: Path, number: int) -> None:
        super().__init__(layout, folder, number)
        self.reference = Reference(layout)
        self.many = runtime("many")

    def answers(self, queries: list[Query]) -> list[Answer]:
        """Nothing about single queries; raises AssertionError where something is not as the layout says."""
        for register in self.layout.registers:
            for option, messages in self._messages(register, "read"):
                self._assert_readable(register, option, messages)
            for option, messages in self._messages(register, "write"):
                self._assert_writable(register, option, messages)
        for table in self.layout.tables.values():
            self._assert_table(table)
        for record in self.layout.records.values():
            self._assert_quantities(record)
            self._assert_states(record)
        for query in state_queries(self.layout, random.Random(len(queries))):
            self._assert_state(query)
        for query in queries:
            if query.kind in ("register", "parameter") and query.values is None:
                self._assert_quantity(query)
                self._assert_absent(query)
            if query.kind != "record" or query.values is not None:
                continue
            self._assert_read(query)
            if _has_characters(query.shape):
                continue
            if query.shape.size and query.shape.selector is None:
                self._assert_columns(query)
        return [SILENT] * len(queries)

    def _messages(self, register: RegisterLayout, operation: str) -> Iterator[tuple[dict[str, str], list[Message]]]:
        """The messages of each link that read or write the space of a register, and the argument for the link."""
        device = self.layout.device
        function = getattr(self.module, f"{operation}_requests", None)
        space = device.space_name(register.register.space)
        for link in self.layout.links.values() if function is not None else ():
            messages = [
                layout.message
                for layout in link.carried("response" if operation == "read" else "request").values()
                if (access := device.register_access(layout.message) or device.bit_access(layout.message)) is not None
                and access.operation == operation
                and device.space_name(access.space) == space
            ]
            if messages:
                yield {"link": link.name} if "link" in signature(function).parameters else {}, messages

    def _assert_readable(self, register: RegisterLayout, option: dict[str, str], messages: list[Message]) -> None:
        """A request for a register is the message that reads its space, with its address."""
        constant = next(iter(self._array(register.name)))
        try:
            requests = self.module.read_requests(constant, **option)
        except self.error as error:
            fits = error.reason in ("out_of_range", "wrong_length") and register.register.atomic
            if not fits and register.register.access != "wo":
                raise AssertionError(f"{register.name} cannot be read: {error}") from error
            return
        classes = [record_class(self.module, self.layout.messages[message.name].request) for message in messages]
        assert type(requests[0]) in classes, f"{register.name} is read by {type(requests[0]).__name__}"
        access = next(m.single_access for m, cls in zip(messages, classes, strict=True) if cls is type(requests[0]))
        assert access is not None
        address = getattr(requests[0], self._attribute(requests[0], access.start))
        assert address == register.address, f"{register.name} is read at {address}"

    def _assert_writable(self, register: RegisterLayout, option: dict[str, str], messages: list[Message]) -> None:
        """What cannot be written has no request, and what can be is written at its address."""
        value = register.register.value
        constant = next(iter(self._array(register.name)))
        if value.const is not None:
            number: Any = value.const
        elif value.type.name == "bit":
            number = True
        elif is_count(value.encoding) and not value.enum and not value.flags:
            number = value.writable_ranges.low if value.writable_ranges else 1
        else:
            return
        try:
            requests = self.module.write_requests(constant, number, **option)
        except self.error as error:
            fits = register.register.access == "ro" if error.reason == "read_only" else register.words > 1
            if not fits:
                raise AssertionError(f"{register.name} cannot be written: {error}") from error
            return
        assert register.register.access != "ro", f"{register.name} can only be read, and is written"
        classes = [record_class(self.module, self.layout.messages[message.name].request) for message in messages]
        assert type(requests[0]) in classes, f"{register.name} is written by {type(requests[0]).__name__}"

    def _assert_table(self, table: TableLayout) -> None:
        """An element is written where neither the table nor any of its fields is read only."""
        values = record_values(self.layout, table.record, random.Random(1))
        elements = link_of(self.module, table.name)
        element = next(iter(elements.at_base(table.table.base) if table.table.base_by else elements))
        if not hasattr(self.module, "write_requests"):
            return
        read_only = table.table.access == "ro" or _has_read_only(table.record)
        try:
            self.module.write_requests(element, built(self.module, self.layout, table.record, values))
        except self.error as error:
            if read_only != (error.reason == "read_only") and error.reason in ("", "read_only"):
                raise AssertionError(f"{table.name} can be written, and is not: {error}") from error
            return
        assert not read_only, f"{table.name} can only be read in part, and is written"

    def _attribute(self, message: Any, title: str) -> str:
        return next(name for name in (title, f"{title}_") if hasattr(message, name))

    def _assert_quantity(self, query: Query) -> None:
        """A count in its unit is exact, or None where it stands for an absent value."""
        value: Value = query.shape[0]
        if value.enum or value.flags or value.const is not None or not is_count(value.encoding):
            return
        raw = int.from_bytes(query.data[: value.size], "big", signed=is_signed(value.encoding))
        exponent = self.layout.device.register(value.scale_by) if value.scale_by else None
        intervals = (
            exponent.value.ranges.intervals if exponent is not None and exponent.value.ranges is not None else ()
        )
        powers = [(power,) for ends in intervals for power in ends] or [()]
        counts = (raw, *(number for sentinel in value.sentinels for number in sentinel.interval))
        holder = self._holder(query)
        if getattr(holder, "subindices", ()) and holder.subindex(0) is not None:
            return  # its quantities are those of its elements
        for count, power in product(counts, powers):
            quantity = holder.in_unit(count, *power)
            wanted = reference_quantity(value, count, *power)
            exact = None if wanted is None else float(wanted)
            same = quantity == exact or (
                quantity is not None and exact is not None and abs(quantity - exact) <= abs(exact) * 1e-12 + 1e-9
            )
            assert same, f"{query.path}: the count {count} is {quantity} in its unit, not {exact}"

    def _assert_absent(self, query: Query) -> None:
        """Each state has its name and its value, is not a quantity, and is the one for None if there is no other."""
        value: Value = query.shape[0]
        holder = self._holder(query)
        if value.const is not None or (getattr(holder, "subindices", ()) and holder.subindex(0) is not None):
            return
        absent = dict(holder.absent)
        assert list(absent) == [sentinel.name for sentinel in value.sentinels], f"{query.path} has {absent}"
        for sentinel in value.sentinels:
            number = special_number(value, sentinel.name)
            assert holder.state_of(number) == sentinel.name, f"{query.path}: {number} is {holder.state_of(number)}"
            assert holder.state_of(absent[sentinel.name]) == sentinel.name
            if not sentinel.is_nan:
                low, high = sentinel.interval
                assert holder.state_of(high) == holder.state_of((low + high) // 2) == sentinel.name
        if value.scale_by or value.enum or value.flags or not (is_count(value.encoding) or is_real(value.encoding)):
            return
        if len(absent) == 1:
            assert holder.state_of(holder.from_unit(None)) in absent, f"{query.path}: {holder.from_unit(None)}"
        else:
            with pytest.raises(self.error, match=".*".join(["None", *absent])):
                holder.from_unit(None)
        for sentinel in value.sentinels:
            if sentinel.is_nan:
                continue
            for number in sentinel.interval:
                with pytest.raises(self.error):
                    holder.from_unit(Fraction(number) * scale_of(value) + Fraction(value.offset))

    def _assert_state(self, query: Query) -> None:
        """A register, and a parameter or an element of it, has the state of each number that may be read."""
        kind, *names = query.path
        if kind == "record" or query.values is None:
            return
        holder = self._holder(Query(kind, tuple(names[:2])))
        raw, index = query.values["raw"], [holder.index(name) for name in names[2:]]
        wanted, have = query.shape.state(raw), holder.state_of(raw, *index)
        assert have == wanted, f"{query.path}: {raw} is {have}, not {wanted}"

    def _assert_read(self, query: Query) -> None:
        """A record that is read has the state of each of its values."""
        record = query.shape
        try:
            values = decoded(record, query.data, self.layout.device)
        except CodecError:
            return
        own = record_class(self.module, record).decode(query.data)
        for field in stored_fields(record, record.decided_by(values)):
            value = field.value
            if value is None or not (is_count(value.encoding) or is_real(value.encoding)) or value.const is not None:
                continue
            if not hasattr(own, f"{field.name}_state"):
                assert not value.sentinels, field.name
                assert stated_numbers(self.layout.device, value) is None, field.name
                continue
            items = values[field.name] if field.is_list else [values[field.name]]
            wanted: Any = [state_name(self.layout.device, value, item) or None for item in items]
            have = getattr(own, f"{field.name}_state")
            assert have == (wanted if field.is_list else wanted[0]), f"{record.name}.{field.name}: {items} is {have}"

    def _assert_states(self, record: RecordLayout) -> None:
        """A record has a constant for each state of its fields."""
        for field in record.fields:
            values = [(f"{field.name}_{case.name}", case.value) for case in field.cases]
            values += [(field.name, field.value)] if field.value is not None else []
            if field.field.reserved or any(value.const is not None for _, value in values):
                continue
            own = record_class(self.module, record)
            names = [(Name.of(name) + Name.of(s.name)).upper() for name, value in values for s in value.sentinels]
            missing = [name for name in names if not hasattr(own, name)]
            assert not missing, f"{record.name} has no {missing}"
            if names:
                assert hasattr(own, f"{field.name}_state"), f"{record.name} has no {field.name}_state"

    def _assert_quantities(self, record: RecordLayout) -> None:
        """A count of a field is exact in its unit, by an exponent in a field beside it or in a register."""
        for field in record.fields:
            exponent = exponent_of(field.value, self.layout.registers, record) if field.value is not None else None
            if field.value is None or exponent is None or exponent.value.ranges is None:
                continue
            unit = getattr(record_class(self.module, record), f"{Name.of(field.name).upper()}_UNIT")
            for power in (exponent.value.ranges.low, exponent.value.ranges.high):
                for count in (field.value.low, field.value.high, 1):
                    exact = reference_quantity(field.value, count, power)
                    wanted = None if exact is None else pytest.approx(float(exact), rel=1e-12)
                    assert unit.in_unit(count, power) == wanted, f"{record.name}.{field.name}: {count} by {power}"

    def _assert_columns(self, query: Query) -> None:
        """Many records at once are read or refused as one is."""
        if len(query.data) != query.shape.size or all(map(is_computed, query.shape.fields)) or _is_empty(query.shape):
            return
        single = self._result(lambda: record_class(self.module, query.shape).decode(query.data))
        many = self._result(lambda: self.many.arrays(record_class(self.module, query.shape), query.data))
        assert single == many, (
            f"{query.shape.name}: one record gives {single}, many give {many} for {query.data.hex(' ')}"
        )

    def _result(self, call: Any) -> Any:
        try:
            call()
        except self.error as error:
            return error.reason, error.offset
        return "", None
