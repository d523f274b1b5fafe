"""A C program that decodes each input line, prints the values, encodes them again, and prints the bytes."""

from __future__ import annotations

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.frame import LinkLayout, PartLayout
from fieldspec.codec.layout.record import CaseLayout, FieldLayout, RecordLayout
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.foundation.names import stem
from fieldspec.language.model.encoding import (
    Digits,
    Octets,
    Precision,
    Real,
    Text,
    Truth,
    Whole,
    is_array,
    is_octets,
    is_signed,
    is_text,
)
from fieldspec.language.model.value import Value
from fieldspec.targets.c.backend import headers
from fieldspec.targets.c.delimiters import is_wrapped
from fieldspec.targets.c.encoded_texts import text_capacity
from fieldspec.targets.c.fields import case_member, count_member, members
from fieldspec.targets.c.frames import header_parts
from fieldspec.targets.c.naming import Naming, frame_member, member
from fieldspec.targets.c.runtime_files import status_names
from fieldspec.targets.c.subcodes import shared_codes
from fieldspec.targets.c.values import accessed_type
from random_devices.c_quantities import FUNCTIONS as QUANTITY_FUNCTIONS
from random_devices.c_quantities import QuantityCases
from random_devices.inputs import is_computed
from random_devices.queries import shapes

REASONS = [name.removeprefix("err_") for name in status_names()]
_MAIN = """
static char name[512], text[131072];
static uint8_t data[65536], again[131072], buffer[131072];
static char line[131600];
static size_t length;
static int status, second;

static int hex(const char *digits, uint8_t *out)
{
    int size = 0;
    unsigned byte;
    while (sscanf(digits + 2 * size, "%2x", &byte) == 1) {
        out[size++] = (uint8_t)byte;
    }
    return size;
}

static void show(const uint8_t *bytes, size_t size)
{
    size_t at;
    for (at = 0; at < size; at++) {
        printf("%02x", bytes[at]);
    }
}

static void show_float(float number)
{
    uint32_t bits;
    memcpy(&bits, &number, 4);
    if (number != number) {
        printf("nan;");
    } else {
        printf("%08lx;", (unsigned long)bits);
    }
}

static void show_double(double number)
{
    uint64_t bits;
    memcpy(&bits, &number, 8);
    if (number != number) {
        printf("nan;");
    } else {
        printf("%016llx;", (unsigned long long)bits);
    }
}

FUNCTIONS

int main(void)
{
    while (fgets(line, sizeof line, stdin)) {
        int size = 0;
        text[0] = 0;
        length = 0;
        status = second = -1;
        if (sscanf(line, "%511s %131071s", name, text) >= 1) {
            size = hex(text, data);
        }
        memset(again, 0xAA, sizeof again);
        CASES
        printf(" %d %d ", status, second);
        if (second == 0) {
            show(again, length);
        }
        printf("\\n");
    }
    return 0;
}
"""


class Driver:
    """The source of the program that asks a header."""

    def __init__(self, layout: DeviceLayout) -> None:
        self.layout = layout
        self.naming = Naming(layout.device.id)
        self.quantities = QuantityCases(layout, self.naming, "".join(headers(layout, self.naming).values()))

    def source(self) -> str:
        """The source."""
        included = f'#include "{stem(self.layout.device.id, self.layout.device.version)}.h"\n'
        records = {record.name: record for record in self._records()}
        functions = "\n".join(self._show(record) for record in records.values() if members(record))
        cases = [self._record_case(name, record) for name, record in self.layout.records.items()]
        cases += [self._value_case(kind, path, shape) for kind, path, shape in shapes(self.layout)]
        for link in self.layout.links.values():
            for direction in ("request", "response"):
                guessed = [name for name in link.carried(direction) if link.is_guessed(direction, name)]
                coded = [""] if link.frame(direction).role("code") is not None else []
                cases += [self._frame_case(link, direction, message) for message in (*coded, *guessed)]
        cases += self.quantities.cases()
        text = _MAIN.replace("FUNCTIONS", QUANTITY_FUNCTIONS + functions).replace("CASES", "\n        ".join(cases))
        return f"{included}#include <stdio.h>\n#include <string.h>\n{text}"

    def _records(self) -> list[RecordLayout]:
        data = [body for message in self.layout.messages.values() for body in message.bodies]
        return [*self.layout.records.values(), *data]

    # Printing values

    def _show(self, record: RecordLayout) -> str:
        kind = self.naming.type("record", record.name)
        lines = []
        for field in record.fields:
            if is_computed(field):
                continue
            if field.cases:
                lines.append(self._show_cases(record, field))
            else:
                lines.append(self._show_field(record, field, f"in->{member(field.name)}", field.value))
        return f"static void show_{kind}(const {kind} *in)\n{{\n    {' '.join(lines)}\n}}\n"

    def _show_cases(self, record: RecordLayout, field: FieldLayout) -> str:
        selector = field.selector or record.selector
        assert selector is not None
        constant = selector.value.const if selector.value is not None else None
        chosen = str(constant) if constant is not None else f"in->{member(selector.name)}"
        chosen = chosen if field.deciding_bits is None else f"{chosen} & {field.deciding_bits}u"
        branches = []
        for case in field.cases:
            labels = " ".join(f"case {number}:" for number in sorted(case.numbers))
            branches.append(f"{labels} {{ {self._show_case(record, field, case)} break; }}")
        return f"switch ((int)({chosen})) {{ {' '.join(branches)} }}"

    def _show_case(self, record: RecordLayout, field: FieldLayout, case: CaseLayout) -> str:
        inside = case_member(case)
        place = f"in->{member(field.name)}.{inside}" if inside else f"({_literal(case.value)})"
        return self._show_field(record, field, place, case.value)

    def _show_field(self, record: RecordLayout, field: FieldLayout, place: str, value: Value | None) -> str:
        if field.record is not None and not members(field.record) and field.field.repeat is None:
            return f'printf("{_unset(field)}");'
        if not field.is_list:
            return self._show_element(field, place, value)
        count = f"in->{count_member(record, field)}" if field.field.repeat is not None else str(field.count)
        element = self._show_element(field, place if place.startswith("(") else f"{place}[at]", value)
        return f'{{ size_t at; printf("["); for (at = 0; at < {count}; at++) {{ {element} }} printf("]"); }}'

    def _show_element(self, field: FieldLayout, place: str, value: Value | None) -> str:
        if field.record is not None:
            inner = field.record
            if not members(inner):
                return f'printf("({_unset_record(inner)})");'
            return f'printf("("); show_{self.naming.type("record", inner.name)}(&{place}); printf(")");'
        assert value is not None
        return _show_value(value, place)

    # Cases of the program

    def _record_case(self, name: str, record: RecordLayout) -> str:
        inside = self._decode_record(record, "data", "(size_t)size", self._encode_record(record))
        return f'if (strcmp(name, "record.{name}") == 0) {{ {inside} }}'

    def _decode_record(self, record: RecordLayout, data: str, size: str, then: str) -> str:
        decode = self.naming.function("record", record.name, "decode")
        kind = self.naming.type("record", record.name)
        if not members(record):
            printing = f'printf("{_unset_record(record)}");'
            return f"status = (int){decode}({data}, {size}); if (status == 0) {{ {printing} {then} }}"
        declared = f"{kind} content; memset(&content, 0x55, sizeof content);"
        printing = f"show_{kind}(&content);"
        return f"{declared} status = (int){decode}({data}, {size}, &content); if (status == 0) {{ {printing} {then} }}"

    def _encode_record(self, record: RecordLayout) -> str:
        encode = self.naming.function("record", record.name, "encode")
        return f"second = (int){encode}({'&content, ' if members(record) else ''}again, sizeof again, &length);"

    def _value_case(self, kind: str, path: tuple[str, ...], shape: tuple[Value, str, bool, bool, int]) -> str:
        value, _, _, trigger, size = shape
        noun = "register" if kind == "register" else "parameter"
        decode = self.naming.function(noun, *path, "decode")  # type: ignore[arg-type]
        encode = self.naming.function(noun, *path, "encode")  # type: ignore[arg-type]
        array = is_array(value.encoding)
        call = "content" if array else "&content"
        argument, other = "content, ", ""
        decoded_type, encoded_type = (
            accessed_type(self.naming, self.layout.device, content) for content in (value.as_answer(trigger), value)
        )
        if decoded_type != encoded_type:
            # An answer that is not a number of the type is not a member either.
            other = f"if (({encoded_type})content != content) {{ second = {REASONS.index('unknown_value')}; }} else "
        if value.const is not None:
            argument, other = (
                "",
                f"if (content != {_literal(value)}) {{ second = {REASONS.index('wrong_const')}; }} else ",
            )
        return (
            f'if (strcmp(name, "{".".join((kind, *path))}") == 0) {{ {self._declared(value.as_answer(trigger))}'
            f" if (size != {size}) {{ status = size < {size} ? 1 : 2; }} else {{"
            f" status = (int){decode}(data, {call}); if (status == 0) {{ {_show_value(value, 'content')}"
            f" length = {size}; {other}second = (int){encode}({argument}again); }} }} }}"
        )

    def _declared(self, value: Value) -> str:
        """The variable that functions of a value take: one of a closed enum has the type of the enum."""
        if is_text(value.encoding):
            return f"char content[{text_capacity(value) + 1}];"
        if is_octets(value.encoding):
            return f"uint8_t content[{value.size}];"
        kind = accessed_type(self.naming, self.layout.device, value)
        return f"{kind} content = ({kind})0;"

    def _frame_case(self, link: LinkLayout, direction: str, message: str) -> str:
        frame = link.frame(direction)
        kind = self.naming.type("link", link.name, direction, "frame")
        call = self.naming.function("link", link.name, direction, "open")
        wrapped = is_wrapped(link)
        parts = header_parts(frame)
        printing = " ".join(_show_part(part, f"opened.{frame_member(part)}") for part in parts)
        heads = "".join(f"opened.{frame_member(part)}, " for part in parts)
        coded = frame.role("code") is not None
        error = link.link.exception_response if direction == "response" else None
        code = '"%llu", (unsigned long long)opened.code' if coded else '"None"'
        flag = "(int)opened.error" if error is not None else "0"
        printing += f' printf("|%d|", {flag}); printf({code}); printf("|");'
        bodies = []
        for name, layout_message in link.carried(direction).items():
            if message in ("", name) and (message or not link.is_guessed(direction, name)):
                record = layout_message.data(direction)
                encode = self.naming.function("link", link.name, "encode", name, direction)
                test = f"opened.code == {layout_message.message.code_of(direction)}u" if coded else "1"
                subcode = shared_codes(link, direction).get(layout_message.message.code_of(direction) or 0)
                if subcode is not None and layout_message in subcode.messages.values():
                    intervals = subcode.intervals_of(layout_message)
                    bounds = (f"({low}u <= opened.subcode && opened.subcode <= {high}u)" for low, high in intervals)
                    test += f" && ({' || '.join(bounds)})"
                if error is not None:
                    test += " && !opened.error"
                bodies.append(f"if ({test}) {{ {self._body(record, encode, heads)} }}")
        if error is not None:
            encode = self.naming.function("link", link.name, "encode", "exception_response")
            body = self._body(self.layout.records[error.record], encode, f"{heads}opened.code, " if coded else heads)
            bodies.append(f"if (opened.error) {{ {body} }}")
        if link.ambiguous_codes(direction):
            bodies.append(f"{{ status = {REASONS.index('unknown_code')}; }}")
        path = ".".join(filter(None, ("frame", link.name, direction, message)))
        return (
            f'if (strcmp(name, "{path}") == 0) {{ {kind} opened; memset(&opened, 0x55, sizeof opened);'
            f" status = (int){call}(data, (size_t)size, {'buffer, sizeof buffer, ' if wrapped else ''}&opened);"
            f" if (status == 0) {{ status = 99; {printing} {' else '.join(bodies)} }} }}"
        )

    def _body(self, record: RecordLayout, encode: str, heads: str) -> str:
        content = "&content, " if members(record) else ""
        then = f"second = (int){encode}({heads}{content}again, sizeof again, &length);"
        return self._decode_record(record, "opened.body", "opened.body_length", then)


def _unset(field: FieldLayout) -> str:
    """What is printed for a record that users set nothing in."""
    assert field.record is not None
    element = f"({_unset_record(field.record)})"
    return f"[{element * (field.count or 0)}]" if field.is_list else element


def _unset_record(record: RecordLayout) -> str:
    return "".join(_unset(field) for field in record.fields if field.record is not None)


def _literal(value: Value) -> str:
    """The constant of a value in C, or bytes that there are none of."""
    if is_octets(value.encoding):
        return "in"
    if not is_signed(value.encoding):
        return f"{value.const}ull"
    return f"(int64_t)({(value.const or 0) + 1}ll - 1)"


def _show_part(part: PartLayout, place: str) -> str:
    if part.value is None or is_signed(part.value.encoding):
        return f'printf("%lld;", (long long){place});'
    return f'printf("%llu;", (unsigned long long){place});'


def _show_value(value: Value, place: str) -> str:
    encoding = value.encoding
    match encoding:
        case Text():
            return f'show((const uint8_t *){place}, strlen({place})); printf(";");'
        case Octets():
            arguments = f"{place}.data, {place}.count" if value.is_marked else f"(const uint8_t *){place}, {value.size}"
            return f'show({arguments}); printf(";");'
        case Real():
            return f"{_show_real(encoding.precision)}({place});"
        case Whole() | Digits() if not is_signed(encoding):
            return f'printf("%llu;", (unsigned long long){place});'
        case Whole() | Digits() | Truth():
            return f'printf("%lld;", (long long){place});'
        case _:
            assert_never(encoding)


def _show_real(precision: Precision) -> str:
    """The function that shows a number as the judges do: those of half precision as doubles."""
    match precision:
        case Precision.SINGLE:
            return "show_float"
        case Precision.HALF | Precision.DOUBLE:
            return "show_double"
        case _:
            assert_never(precision)
