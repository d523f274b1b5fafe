"""The code that shows a value: one function of Lua for each meaning that values have, without a look at a table.

A function gets the entry of a fact, the tree, the bytes in the packet, the bytes of the value, and options.
`options.index` is what follows the title, and `options.title` both with what stands before. `options.lenient` is set
for answers that need not be what was written, `options.is_write` for what is sent to the device, and `options.reason`
takes the place of the reason of a finding. It returns the item, the number, and the reason of a finding.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from fieldspec.foundation.classes import dataclass, field
from fieldspec.language.model.raw_numbers import byte_places
from fieldspec.targets.wireshark.text import literal

_HEAD = """\
-- How numbers are shown, a function for each meaning.

local byte, format = string.byte, string.format
"""

_EXACT = 10**15
"""The numbers below have all their decimals in a double."""

_DOUBLE, _NUMBER = 6, 4
"""The bytes of the widest whole number that a double holds, and of the widest one that an item takes as such."""
_LETTERS = ("a", "b", "c", "d", "e", "f")


@dataclass(frozen=True, slots=True)
class ValueFunctions:
    """The functions of the values of a device, each once. `enums` and `words` are the data of the dissector."""

    enums: Mapping[str, Any]
    words: Mapping[str, Any]
    numbers: dict[str, int] = field(default_factory=dict)

    def number(self, value: Mapping[str, Any], is_reserved: bool) -> int | None:
        """The number of the function that shows a value, counted from 1; None for texts and bytes, which share one."""
        if value["kind"] in ("text", "bytes"):
            return None
        text = "\n".join(f"    {line}" for line in _ValueCode(self, value, is_reserved).lines())
        return self.numbers.setdefault(text, len(self.numbers) + 1)

    def text(self) -> str:
        """All functions, as the list `values.shows`."""
        functions = (f"function(entry, tree, range, bytes, options)\n{text}\nend," for text in self.numbers)
        return "\n".join([_HEAD, "values.shows = {", *functions, "}", ""])


@dataclass(frozen=True, slots=True)
class _ValueCode:
    functions: ValueFunctions
    value: Mapping[str, Any]
    is_reserved: bool

    @property
    def _fits_double(self) -> bool:
        """Whether the number is a whole one that a double holds."""
        return bool(self.value["kind"] != "float" and self.value["size"] <= _DOUBLE)

    @property
    def _is_short(self) -> bool:
        """Whether a join of texts writes all digits of the number."""
        return self._fits_double and self.value["size"] <= _NUMBER

    @property
    def _has_key(self) -> bool:
        """Whether the number is needed as a text: as the key of a table, or where a join of texts cuts digits off."""
        return not self._is_short or bool(self.value.get("special")) or self._has_remarks

    @property
    def _has_remarks(self) -> bool:
        enum = self.functions.enums[self.value["enum"]] if self.value.get("enum") else {}
        return bool(enum.get("texts") or enum.get("errata"))

    def lines(self) -> Iterator[str]:
        value = self.value
        yield from self._load()
        yield f"local item = tree:add(entry.field, range, {self._of_item()})"
        if self._has_key:
            yield 'local key = format("%.0f", number)' if self._fits_double else "local key = numbers.text(number)"
        word, size = value.get("word"), value["size"]
        digits = "key" if self._has_key else "number"
        if word:
            digits = "digits"
            short = f'format("0x%0{2 * size}x", unsigned)'
            yield f"local digits = {short if self._is_short else 'numbers.hexadecimal(bytes, entry.value)'}"
        yield 'local title = options.title or entry.title .. (options.index or "")'
        if self.is_reserved:
            yield f'item:set_text(title .. ": " .. {digits} .. " (reserved)")'
            yield "if entry.errata then values.cite(item, entry.errata) end"
            yield "return item, number, nil"
            return
        judged = [*self._state(), *self._judged()]
        bits = list(self._bits(self.functions.words[word])) if word else []
        can_fail = any("reason, detail =" in line for line in (*judged, *bits))
        yield from (f"local {name}" for name, is_used in self._locals(can_fail) if is_used)
        yield from judged
        yield from self._quantity()
        yield f'item:set_text(title .. ": " .. {self._meaning(digits)})'
        yield from self._remarks()
        if "scale" in value:
            yield "if approximate and entry.quantity then"
            yield "    values.show_quantity(item, entry, range, quantity, approximate)"
            yield "end"
        yield from bits
        if can_fail:
            yield "if reason and not options.lenient then"
            yield "    reason = options.reason or reason"
            yield '    local name = entry.name .. (options.index or "")'
            yield f'    values.report(item, reason, name .. " is " .. {digits} .. ": " .. detail)'
            yield "end"
        yield "if entry.errata then values.cite(item, entry.errata) end"
        yield f"return item, number, {'not options.lenient and reason or nil' if can_fail else 'nil'}"

    @property
    def _has_states(self) -> bool:
        return bool(self.value.get("special") or self.value.get("special_ranges"))

    @property
    def _has_quantity(self) -> bool:
        return self.value.get("scale") is not None or bool(self.value.get("unit"))

    def _locals(self, can_fail: bool) -> Iterator[tuple[str, bool]]:
        """The names that statements below give a value, and whether there are such statements."""
        yield "state", self._has_states
        yield "name", self._has_states or bool(self.value.get("enum"))
        yield "reason, detail", can_fail

    def _meaning(self, digits: str) -> str:
        """The text of the item for the number: the name or the quantity before the digits, or only the digits."""
        if not self._has_states and not self.value.get("enum"):
            return f'quantity .. " (" .. {digits} .. ")"' if self._has_quantity else digits
        name = "(name or quantity)" if self._has_quantity else "name"
        return f'({name} and {name} .. " (" .. {digits} .. ")" or {digits})'

    def _load(self) -> Iterator[str]:
        """The number, and of a word of few bytes the same without a sign."""
        value = self.value
        size, order, swapped, sign = value["size"], value["order"], value["swapped"], value.get("signed")
        if not self._fits_double:
            if value["kind"] == "float" and size in (4, 8) and not swapped:
                form = (">" if order == "big" else "<") + ("f" if size == 4 else "d")
                yield f'local number = Struct.unpack("{form}", bytes)'
            else:
                yield "local number = numbers.of(bytes, entry.value)"
            return
        yield f"local {', '.join(_LETTERS[:size])} = byte(bytes, 1, {size})"
        places = byte_places(size, order, swapped)
        terms = [
            _LETTERS[place] + (f" * {1 << 8 * power}" if power else "")
            for place, power in zip(places, reversed(range(size)), strict=True)
        ]
        yield f"local unsigned = {' + '.join(terms)}"
        yield "local number = unsigned"
        if sign:
            above = f"number - {1 << 8 * size}" if sign is True else f"{1 << 8 * size - 1} - number"
            yield f"if {_LETTERS[places[0]]} > 127 then number = {above} end"

    def _of_item(self) -> str:
        is_long = self.value["kind"] != "float" and self.value["size"] > _NUMBER
        return "numbers.of_item(bytes, entry.value)" if is_long else "number"

    def _state(self) -> Iterator[str]:
        if self.value.get("special"):
            yield "state = entry.value.special[key]"
        for state in self.value.get("special_ranges") or ():
            yield f"if not state and {self._is_in(state['range'])} then state = {literal(state['name'])} end"

    def _judged(self) -> Iterator[str]:
        """The name, and the reason for which a codec refuses the number or people should look at it."""
        value = self.value
        branches: list[tuple[str, list[str]]] = []
        if value["kind"] == "boolean":
            branches.append(("number ~= 0 and number ~= 1", [_because("unknown_value", '"should be 0 or 1"')]))
        const = value.get("const")
        if const is not None:
            text = f'"should be " .. numbers.text({self._number(const)})'
            branches.append((f"number ~= {self._number(const)}", [_because("wrong_const", text)]))
        if self._has_states:
            branches.append(("state", ["name = state"]))
        rest = [*self._named(), *self._within()]
        for place, (condition, lines) in enumerate(branches):
            yield f"{'else' if place else ''}if {condition} then"
            yield from (f"    {line}" for line in lines)
        if branches and rest:
            yield "else"
        yield from (f"    {line}" if branches else line for line in rest)
        if branches:
            yield "end"

    def _named(self) -> Iterator[str]:
        name = self.value.get("enum")
        if not name:
            return
        enum = self.functions.enums[name]
        number = "number" if self._fits_double else "tonumber(key)"
        yield f"local enum = device.enums[{literal(name)}]"
        yield f"name = enum.names[{number}]"
        if not enum["open"]:
            unavailable = f" or enum.unavailable[{number}]" if enum["unavailable"] else ""
            text = literal(f"the closed enum {name} does not permit it")
            yield f"if not name{unavailable} then {_because('unknown_value', text)} end"

    def _within(self) -> Iterator[str]:
        """The judgement by the ranges, where nothing else has refused the number."""
        ranges, write_ranges = self.value.get("ranges"), self.value.get("write_ranges")
        if write_ranges is None:
            yield from self._outside("not reason", ranges)
            return
        yield from self._outside("not reason and options.is_write", write_ranges)
        yield from self._outside("not reason and not options.is_write", ranges)

    def _outside(self, condition: str, ranges: Sequence[Sequence[int | str]] | None) -> Iterator[str]:
        if ranges is not None and [self.value.get("low"), self.value.get("high")] not in [
            list(pair) for pair in ranges
        ]:
            text = literal(f"should be {_ranges_text(ranges)}{' counts' if 'scale' in self.value else ''}")
            yield f"if {condition} and not ({self._is_in(ranges)}) then {_because('out_of_range', text)} end"

    def _is_in(self, ranges: Sequence[Sequence[int | str]]) -> str:
        if not ranges:
            return "false"
        pairs = ((self._number(low), self._number(high)) for low, high in ranges)
        return " or ".join(f"number >= {low} and number <= {high}" for low, high in pairs)

    def _number(self, number: float | str) -> str:
        if isinstance(number, str):
            return f"numbers.bound({literal(number)}, entry.value)"
        return str(number)

    def _quantity(self) -> Iterator[str]:
        """The quantity, which a number that stands for a state has not got."""
        value = self.value
        unit = f" {value['unit']}" if value.get("unit") else ""
        scale = value.get("scale")
        if not self._has_quantity:
            return
        yield "local quantity, approximate"
        if scale is None:
            lines = [f"quantity = {'key' if self._has_key else 'number'} .. {literal(unit)}"]
        else:
            lines = [*self._scaled(scale), *([f"quantity = quantity .. {literal(unit)}"] if unit else ())]
        yield from (["if not state then", *(f"    {line}" for line in lines), "end"] if self._has_states else lines)

    def _scaled(self, scale: Mapping[str, int]) -> Iterator[str]:
        factor, shift, divisor, places = (scale[key] for key in ("factor", "shift", "divisor", "places"))
        above = "number" if factor == 1 else f"number * {factor}"
        above += f" + {shift}" if shift else ""
        is_exact = self._fits_double and _most(self.value, factor, shift) < _EXACT
        if not is_exact or 10**places % divisor:
            count = "number" if self.value["kind"] == "float" or self._fits_double else "numbers.double(number)"
            yield f"quantity, approximate = numbers.fraction({count}, entry.value.scale)"
            return
        yield f"local above = {above}"
        yield f"approximate = above / {divisor}"
        yield f'quantity = format("%.{places}f", approximate)'

    def _remarks(self) -> Iterator[str]:
        if self._has_remarks:
            yield f"if name then values.remark(item, device.enums[{literal(self.value['enum'])}], key) end"

    def _bits(self, word: Sequence[Mapping[str, Any]]) -> Iterator[str]:
        is_short = self._fits_double
        lines = [_bit_texts(self.functions.enums, bit) for bit in word]
        if not is_short or None in lines:
            yield "local ordered = numbers.significant(bytes, entry.value)"
        yield f"local list, fields, inner = device.words[{literal(self.value['word'])}], entry.bit_fields"
        for place, bit in enumerate(word, 1):
            texts = lines[place - 1]
            if texts is None or not is_short:
                yield f"values.show_bits(item, range, list[{place}], fields[{place}], ordered)"
                continue
            condition = f"unsigned % {2 << bit['first']} >= {1 << bit['first']}"
            yield f"if {condition} then"
            yield f"    inner = item:add(fields[{place}], range, true)"
            yield f"    inner:set_text({literal(texts[1])})"
            yield "else"
            yield f"    inner = item:add(fields[{place}], range, false)"
            yield f"    inner:set_text({literal(texts[0])})"
            yield "end"
            if bit["errata"]:
                yield f"values.cite(inner, list[{place}].errata)"
        if self.value.get("const") is None:
            for place, bit in enumerate(word, 1):
                if bit["ranges"]:
                    yield f"if not reason then reason, detail = values.judged_bits(list[{place}], ordered) end"


def _bit_texts(enums: Mapping[str, Any], bit: Mapping[str, Any]) -> tuple[str, str] | None:
    """The lines of a single bit where it is 0 and where it is 1; None for other fields of bits, and for quantities."""
    if bit["width"] > 1 or bit["signed"] or bit["unit"] or bit["scale"] or bit["ranges"]:
        return None
    names = enums[bit["enum"]]["names"] if bit["enum"] else {}
    head = f"Bit {bit['first']}, {bit['title']}: "
    texts = [names.get(number) or bit[word] for number, word in ((0, "zero"), (1, "one"))]
    lines = [f"{head}{text} ({number})" if text else f"{head}{number}" for number, text in enumerate(texts)]
    return lines[0], lines[1]


def _most(value: Mapping[str, Any], factor: int, shift: int) -> int:
    """The greatest size of a number times its factor, and with the summand."""
    bounds: tuple[int, int] = value["low"] * factor, value["high"] * factor
    return max(abs(bound + summand) for bound in bounds for summand in (0, shift))


def _because(reason: str, text: str) -> str:
    return f'reason, detail = "{reason}", {text}'


def _ranges_text(ranges: Sequence[Sequence[int | str]]) -> str:
    return ", ".join(str(low) if low == high else f"{low}..{high}" for low, high in ranges)
