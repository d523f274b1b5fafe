"""Queries: their columns, the reasons for which a codec refuses the data, and what an audit finds."""

from __future__ import annotations

from itertools import groupby

from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.foundation.classes import dataclass, field, replace
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_count, sign_of
from fieldspec.language.model.value import Value
from fieldspec.targets.queries.dialect import Body, Dialect, Slot
from fieldspec.targets.queries.values import Reader, ValueQuery


@dataclass(frozen=True, slots=True)
class Finding:
    """A finding of an audit: its condition, the column, the reason, and the raw number, or an empty text."""

    condition: str
    column: str
    reason: str
    raw: str


@dataclass(frozen=True, slots=True)
class Elements:
    """Elements of `size` bytes from an offset on; to the end of the data without a count."""

    offset: int
    size: int
    count: int | None


@dataclass(frozen=True, slots=True)
class Fault:
    """Something that a codec refuses in an element of a list: the condition, the offset in it, and the reason."""

    breaks: Reader
    offset: int
    reason: str


@dataclass(frozen=True, slots=True)
class Content:
    """The columns and findings of a query. Each of `levels` has columns by name, computed from the columns of the level
    before.

    `refusals` are in the order of a codec's tests. Each is a condition with its reason, or the expression of a reason.
    `exponents` has the expressions of the registers with exponents of scales, by their names.
    """

    device: Device
    dialect: Dialect
    enums: dict[str, str]
    columns: dict[str, str] = field(default_factory=dict)
    refusals: list[tuple[str, str] | str] = field(default_factory=list)
    findings: list[Finding] = field(default_factory=list)
    levels: list[dict[str, str]] = field(default_factory=list)
    exponents: dict[str, str] = field(default_factory=dict)
    _faults: list[Fault] = field(default_factory=list)
    """The faults of the elements of the list whose fields are being added."""

    @property
    def refusal(self) -> str:
        """The reason for which a codec refuses the payload, or null; empty where it refuses none."""
        reasons: list[str] = []
        for is_expression, refusals in groupby(self.refusals, lambda refusal: isinstance(refusal, str)):
            if is_expression:
                reasons += [refusal for refusal in refusals if isinstance(refusal, str)]
            else:
                reasons.append(self.dialect.reason([refusal for refusal in refusals if not isinstance(refusal, str)]))
        return self.dialect.first(*reasons) if len(reasons) > 1 else "".join(reasons)

    def add_record(self, record: RecordLayout, data: str) -> None:
        """The fields of a record. `data` is the name of the result with its bytes, or with null."""
        if record.selector is None:
            self.add_fields(record.fields, data)
            self._add_measures(record, data)
            return
        self._add_choices(record, record.selector, data)

    def add_fields(
        self,
        fields: tuple[FieldLayout, ...],
        data: str,
        base: int = 0,
        prefix: str = "",
        enclosing: Elements | None = None,
    ) -> None:
        """Fields from an offset of the data, or of each element of a list in it."""
        for own in fields:
            name, offset = prefix + own.name, base + own.offset
            if own.record is not None:
                inner = own.record.fields
                if own.count is None:
                    elements = Elements(offset, own.size, None)
                    self.add_fields(inner, data, 0, f"{name}_", elements)
                    self._add_faults(data, elements)
                    continue
                for number in range(own.count):
                    number_prefix = f"{name}_{number}_" if own.is_list else f"{name}_"
                    self.add_fields(inner, data, offset + number * own.size, number_prefix, enclosing)
                continue
            if own.value is None:
                continue
            query = ValueQuery(self.device, self.dialect, self.enums, own.value, own.order, own.swapped)
            query = self._by_exponent(query, own, fields)
            reserved = own.field.reserved
            if own.is_list and enclosing is None:
                elements = Elements(offset, own.size, own.count)
                self.add_value(name, query, data, 0, elements, reserved)
                self._add_faults(data, elements)
            elif own.is_list:
                for number in range(own.count or 0):
                    self.add_value(f"{name}_{number}", query, data, offset + number * own.size, enclosing, reserved)
            else:
                self.add_value(name, query, data, offset, enclosing, reserved)

    def _by_exponent(self, query: ValueQuery, own: FieldLayout, fields: tuple[FieldLayout, ...]) -> ValueQuery:
        """The query of a field with its scale, where a field beside it or a register has the exponent.

        The elements of a list stay counts.
        """
        if not query.value.scale_by or own.is_list:
            return query
        neighbour = next((other for other in fields if other.name == query.value.scale_by), None)
        if neighbour is not None and neighbour.value is not None and neighbour.value.ranges is not None:
            power = ValueQuery(
                self.device, self.dialect, self.enums, neighbour.value, neighbour.order, neighbour.swapped
            )
            distance = neighbour.offset - own.offset
            intervals = neighbour.value.ranges.intervals
            return replace(
                query, exponent=lambda data, offset: power.number(data, offset + distance), exponents=intervals
            )
        register = self.device.register(query.value.scale_by)
        number = self.exponents.get(query.value.scale_by, "")
        if register is None or register.value.ranges is None or not number:
            return query
        return replace(query, exponent=lambda _, __: number, exponents=register.value.ranges.intervals)

    def add_value(
        self,
        name: str,
        query: ValueQuery,
        data: str,
        offset: int,
        enclosing: Elements | None = None,
        reserved: bool = False,
    ) -> None:
        """A value at an offset of the data, or of each element of a list in it."""
        if reserved:
            if is_count(query.value.encoding):
                self._find(name, "reserved_bits", query, self._nonzero(query), data, offset, enclosing)
            return
        for column in query.columns():
            self.add_column(
                f"{name}_{column.suffix}" if column.suffix else name, self._spread(column.read, data, offset, enclosing)
            )
        for rule in query.faults():
            if enclosing is None:
                self.refusals.append((rule.breaks(data, offset), rule.reason))
            else:
                self._faults.append(Fault(rule.breaks, offset, rule.reason))
        for rule in query.findings():
            self._find(name, rule.reason, query, rule.breaks, data, offset, enclosing)

    def _add_faults(self, data: str, elements: Elements) -> None:
        """The refusal of the first wrong element of a list."""
        faults = tuple(self._faults)
        self._faults.clear()
        if not faults:
            return
        body: Body = lambda element: self.dialect.reason(  # noqa: E731
            [(fault.breaks(element, fault.offset), fault.reason) for fault in faults]
        )
        self.refusals.append(self.dialect.first_of(data, elements.offset, elements.size, elements.count, body))

    def add_column(self, name: str, expression: str) -> None:
        """A column. A name that is taken gets an underscore."""
        while name in self.columns:
            name += "_"
        self.columns[name] = expression

    def _nonzero(self, query: ValueQuery) -> Reader:
        return lambda data, offset: self.dialect.compared(query.word(data, offset), "<>", "0")

    def _find(
        self,
        name: str,
        reason: str,
        query: ValueQuery,
        breaks: Reader,
        data: str,
        offset: int,
        enclosing: Elements | None,
    ) -> None:
        if not breaks(data, offset):
            return
        raw = "" if enclosing is not None else query.raw(data, offset)
        self.findings.append(Finding(self._condition(breaks, data, offset, enclosing), name, reason, raw))

    def _spread(self, read: Reader, data: str, offset: int, enclosing: Elements | None) -> str:
        if enclosing is None:
            return read(data, offset)
        body: Body = lambda element: read(element, offset)  # noqa: E731
        return self.dialect.each(data, enclosing.offset, enclosing.size, enclosing.count, body)

    def _condition(self, breaks: Reader, data: str, offset: int, enclosing: Elements | None) -> str:
        if enclosing is None:
            return breaks(data, offset)
        body: Body = lambda element: breaks(element, offset)  # noqa: E731
        return self.dialect.some(data, enclosing.offset, enclosing.size, enclosing.count, body)

    def _add_measures(self, record: RecordLayout, data: str) -> None:
        """The refusal of a size that is not that of the field that it measures."""
        for own in record.fields:
            if own.bits_of:
                self._add_bit_count(record, own, data)
            measure = own.field.measures
            other = record.named(measure.field) if measure is not None else None
            if measure is None or other is None or own.value is None:
                continue
            if other.count is not None:
                items = other.count if other.is_list else 1
                measured = str(measure.number(items, other.size))
            else:
                measured = self.dialect.units(data, other.offset, measure.unit(other.size))
                measured = f"({measured} + {measure.plus})" if measure.plus else measured
            number = self.dialect.whole(data, _slot(own, own.value))
            self.refusals.append((self.dialect.compared(number, "<>", measured), "wrong_measure"))

    def _add_bit_count(self, record: RecordLayout, own: FieldLayout, data: str) -> None:
        """The refusal of a number of bits that takes another number of bytes than there are."""
        packed = record.named(own.bits_of)
        assert packed is not None
        assert own.value is not None
        number = self.dialect.whole(data, _slot(own, own.value))
        bits = f"({self.dialect.units(data, packed.offset, 1)} * 8)"
        for wrong in ((number, ">", bits), (number, "<", f"({bits} - 7)")):
            self.refusals.append((self.dialect.compared(*wrong), "wrong_measure"))

    def _add_choices(self, record: RecordLayout, selector: FieldLayout, data: str) -> None:
        """The fields of a record whose last field has the type that the selector decides."""
        assert selector.value is not None
        number = self.dialect.whole(data, _slot(selector, selector.value))
        known = sorted(record.chosen)
        self.refusals.append((self.dialect.negated(self.dialect.is_in(number, _points(known))), "unknown_value"))
        shapes: list[tuple[RecordLayout, list[int]]] = []
        for value, shape in record.chosen.items():
            same = next((numbers for other, numbers in shapes if other is shape), None)
            if same is None:
                shapes.append((shape, [value]))
            else:
                same.append(value)
        level: dict[str, str] = {}
        for place, (shape, numbers) in enumerate(shapes, 1):
            is_chosen = self.dialect.is_in(number, _points(sorted(numbers)))
            for wrong, reason in size_refusals(self.dialect, shape, data):
                self.refusals.append((self.dialect.both(is_chosen, wrong), reason))
            right = self.dialect.chosen(data, is_chosen)
            level[self.dialect.step(f"shape_{place}")] = self.dialect.sized(
                f"({right})", shape.least, shape.most, *tail_of(shape)
            )
        whole = self.dialect.step("whole")
        self.levels.extend([level, {whole: self.dialect.first(*level)}])
        self.add_fields(record.fields[:-1], whole)
        names = {number: case.name for case in record.fields[-1].cases for number in case.numbers}
        for (shape, numbers), step in zip(shapes, level, strict=True):
            last = shape.fields[-1]
            self.add_fields((replace(last, name=f"{last.name}_{names[numbers[0]]}"),), step)
            self._add_measures(shape, step)


def _slot(own: FieldLayout, value: Value) -> Slot:
    return Slot(own.offset, own.size, own.order, own.swapped, sign_of(value.encoding))


def _points(numbers: list[int]) -> list[tuple[int, int]]:
    return [(number, number) for number in numbers]


def tail_of(record: RecordLayout) -> tuple[int, int]:
    """The offset and the size of the elements that go on to the end of the data; 0 and 1 where there are none."""
    last = record.fields[-1] if record.fields else None
    return (last.offset, last.size) if last is not None and last.count is None and not last.cases else (0, 1)


def size_refusals(dialect: Dialect, record: RecordLayout, data: str) -> list[tuple[str, str]]:
    """The conditions for which a codec refuses the size of some data, in the order of its tests."""
    size, (offset, unit) = dialect.size(data), tail_of(record)
    refusals = [(dialect.compared(size, "<", str(record.least)), "incomplete")] if record.least else []
    if record.most is not None:
        refusals.append((dialect.compared(size, ">", str(record.most)), "wrong_length"))
    if unit > 1:
        rest = dialect.units(data, offset, 1)
        refusals.append((dialect.compared(f"({rest} % {unit})", "<>", "0"), "wrong_length"))
    return refusals
