"""Facts, values, enums and words of bits as data of the explainer."""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal

from fieldspec.codec.explain.errata import citations
from fieldspec.codec.explain.values import bit_text, member_list, member_notes, remark_on_bit_numbers, state_text
from fieldspec.codec.layout.needed_bits import needed_bits
from fieldspec.codec.layout.widths import value_form
from fieldspec.codec.program.lowering import places_of
from fieldspec.codec.program.operations import Places
from fieldspec.foundation.classes import TYPE_CHECKING
from fieldspec.language.model.digits import digits_text, has_sign, is_complement
from fieldspec.language.model.encoding import is_text
from fieldspec.language.model.enums import Bit, Enum, Flags, Member
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.ranges import Ranges
from fieldspec.language.model.text_form import encoding_title, text_form_title
from fieldspec.language.model.value import Value
from fieldspec.targets.explainer.codecs import constant_name, has_no_text
from fieldspec.targets.explainer.literals import Code, Data
from fieldspec.targets.runtime_values import kind_of, sign_data

if TYPE_CHECKING:
    from fractions import Fraction


def stated(data: Mapping[str, Data]) -> dict[str, Data]:
    """Data without what is None, false, or empty, which the explainer takes for absent; 0 stays."""
    return {key: value for key, value in data.items() if value or (value == 0 and value is not False)}


def fact_data(fact: Fact) -> dict[str, Data]:
    """The data of a fact that its row prints besides its value."""
    return stated(
        {
            "name": fact.name,
            "path": fact.place.path,
            "printed": fact.printed_name,
            "label": fact.label,
            "doc": fact.doc,
            "source": citations(fact.sources),
            "notes": [*fact.notes, *_notes_on_codec(getattr(fact, "value", None))],
        }
    )


def _notes_on_codec(value: Value | None) -> list[str]:
    if value is None or not has_no_text(value):
        return []
    return [f"These are the bytes of the codec {value.codec}, which has no JavaScript."]


def intervals(ranges: Ranges | None) -> Data:
    """Intervals as pairs; None without any."""
    return None if ranges is None else [list(interval) for interval in ranges.intervals]


def value_data(value: Value, order: str = "", swapped: bool = False) -> dict[str, Data]:
    """A value with the places of its bytes. Its keys are named like the attributes of `Value` with the same meaning."""
    turned = bool(value.write_word_order)
    parameter = value.parameter
    return stated(
        {
            "kind": "bytes" if has_no_text(value) else kind_of(value.encoding),
            "size": value.size,
            "signed": sign_data(value.encoding),
            "order": _order(places_of(value, order, swapped) if order else ()),
            "writePlaces": list(places_of(value, order, not swapped)) if turned else None,
            **_digits(value),
            **_text_form(value),
            "const": value.const,
            "enum": value.enum,
            "flags": value.flags,
            "ranges": intervals(value.ranges),
            "writeRanges": intervals(value.write_ranges),
            "sentinels": [
                stated(
                    {
                        "value": sentinel.value,
                        "last": sentinel.last,
                        "name": sentinel.name,
                        "doc": sentinel.doc,
                        "nan": sentinel.is_nan,
                    }
                )
                for sentinel in value.sentinels
            ],
            "unit": value.unit,
            "scaleBy": value.scale_by,
            "quantityUnit": value.quantity_unit if value.scale_by else "",
            **_scale(value.scale, value.offset),
            "isShare": "/" in value.scale_text,
            "parameter": [parameter.set, parameter.part, parameter.number] if parameter is not None else None,
            "default": value.default,
        }
    )


def _order(places: Places) -> Data:
    """The places of the bytes of a value, the most significant first; None where they are in this order."""
    return None if places == tuple(range(len(places))) else list(places)


def _digits(value: Value) -> dict[str, Data]:
    """The form of the digits that a number is sent as, what they are called, and their bounds."""
    if not value.digits or has_no_text(value):
        return {}
    return {
        **({"codec": Code(f"{constant_name(value.codec)}.codec")} if value.codec else {}),
        "digits": value.digits,
        "places": value.places,
        "hasSign": has_sign(value),
        "hasBlanks": value.has_blanks,
        "isLowFirst": value.is_low_first,
        "bits": 8 * value.type.size if is_complement(value) else 0,
        "form": digits_text(value),
        "low": value.low,
        "high": value.high,
    }


def _text_form(value: Value) -> dict[str, Data]:
    """The form of a text, and what people call it, also where it varies in width; empty for what is not a text."""
    if not is_text(value.encoding):
        return {}
    form = value.text_form
    data: dict[str, Data] = {
        "form": text_form_title(value) or encoding_title(value),
        "sentForm": value_form(value) if value.width else "",
    }
    if form is None:
        return data
    text_form: dict[str, Data] = {
        "encoding": form.encoding,
        "padding": form.padding,
        "isRight": form.is_right,
        "terminator": form.terminator,
        "isTurned": form.is_turned,
    }
    return {**data, "textForm": stated(text_form)}


def _scale(scale: Decimal | Fraction, offset: Decimal) -> dict[str, Data]:
    """The scale and the offset as texts with all their places, where a quantity differs from its count."""
    if scale == 1 and offset == 0:
        return {}
    text = f"{scale:f}" if isinstance(scale, Decimal) else f"{scale.numerator}/{scale.denominator}"
    return {"scale": text, "offset": f"{offset:f}"}


def enum_data(enum: Enum) -> dict[str, Data]:
    """An enum with its members as data of the explainer."""
    return {
        **stated({"name": enum.name, "path": enum.place.path, "open": enum.open}),
        **stated({"taken": "" if enum.open else member_list(enum)}),
        "members": [_member(enum, member) for member in enum.members],
    }


def _member(enum: Enum, member: Member) -> dict[str, Data]:
    return {
        "value": member.value,
        **stated(
            {
                "name": member.name,
                "path": member.place.path,
                "label": member.label,
                "problem": member.problem,
                "doc": member.doc,
                "notes": list(member_notes(enum, member)),
                "unavailable": member.unavailable,
                "aliases": list(member.aliases),
            }
        ),
    }


def word_data(word: Flags, enums: Mapping[str, Enum]) -> dict[str, Data]:
    """A word of flags with its bits and states as data of the explainer."""
    return stated(
        {
            "name": word.name,
            "path": word.place.path,
            "size": word.type.size,
            "remark": remark_on_bit_numbers(word) if word.bit_0 == "most" else "",
            "bits": [_bit(bit) for bit in word.bits],
            "needed": [
                [required.bit.name, required.reason, list(required.names)] for required in needed_bits(word, enums)
            ],
            "states": [
                stated(
                    {
                        "name": state.name,
                        "label": state.label,
                        "text": state_text(state),
                        "mask": word.masked(state)[0],
                        "value": word.masked(state)[1],
                    }
                )
                for state in word.states
            ],
        }
    )


def _bit(bit: Bit) -> dict[str, Data]:
    return {
        "first": bit.first,
        "width": bit.width,
        **stated(
            {
                "runs": [[run.first, run.width] for run in bit.runs] if bit.pieces else None,
                "name": bit.name,
                "label": bit.label,
                "text": bit_text(bit) if bit.width == 1 else bit.doc,
                "enum": bit.enum,
                "reserved": bit.reserved,
                "signed": bit.signed,
                "default": bit.default,
                "isNumber": bit.is_number,
                "unit": bit.unit,
                "ranges": intervals(bit.ranges if bit.is_bounded else None),
                **_scale(bit.scale, bit.offset),
            }
        ),
    }
