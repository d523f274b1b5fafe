"""Reads the types of lists: by the words that they use, or by what the words are made of."""

from __future__ import annotations

import re
import unicodedata
from decimal import Decimal
from enum import Enum

from fieldspec.foundation.classes import dataclass, replace
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.encoding import is_count, is_signed, is_truth
from fieldspec.language.model.primitives import PRIMITIVES, Primitive
from fieldspec.tools.lists.orders import joined_order
from fieldspec.tools.lists.words import folded, meaning, pattern

_WORD_BITS = 16
_LONGEST = 400
"""The most characters of a type with what its values mean; a longer text is a description."""

_COMPOSED = re.compile(
    r"(?P<sign>unsigned|uns|usigned|ui|u|signed|sgn|si|s|)(?P<base>integer|int|word|float|real|double|bcd|bitfield|bitmap|bits?|enum|hex|)"
    r"(?P<bits>8|16|24|32|48|64)(?P<late>u|s|i|)(?:bits?|flags?|t|)(?P<order>|abcd|cdab|dcba|badc|be|le|sw|swapped|msw|lsw|big|little|bigendian|littleendian)"
)
_BESIDE_SIZE = re.compile(r"([^0-9]*?)(8|16|24|32|48|64)(?:bits?|位|ビット)?([^0-9]*)")
_EARLY_BITS = re.compile(r"(8|16|32|64)(?:bits(?!igned)|bit|(?=u?int|float))(.*)")
_LENGTH = re.compile(
    r"\(\s*([0-9]{1,5})\s*\)|\[\s*([0-9]{1,5})\s*\]|[\s_x*\u00d7]([0-9]{1,5})\s*(?:chars?|characters|zeichen)?\s*$"
)
_SCALED = re.compile(r"(.+?)\s*([/÷:*\u00d7]\s*(?:0[.,][0-9]+|10+))")
_SIZED = re.compile(r"([0-9]{1,2})?\s*-?(byte|bit|word|register)s?", re.IGNORECASE)
_ORDERED = re.compile(
    r"(float|real|float32|f32|u?int32|[ui]32|dint|u?dint|dword|long|[us]_[dq]word|fp32)"
    r"[\s_-]*(sw|swap|swapped|swappedwords|inverse|rev|r)"
)
_ORDER_WORD = re.compile(
    r"[\s_(\[,-]+(abcd|cdab|dcba|badc|1234|2143|3412|4321|big[ -]?endian|little[ -]?endian|[ml]sw first|be|le)[)\]]*$",
    re.IGNORECASE,
)

_STRUCT = re.compile(r"([<>!=@])([bBhHiIlLqQfd])")
_OF_STRUCT = {"b": "i8", "h": "i16", "i": "i32", "l": "i32", "q": "i64", "f": "f32", "d": "f64"}
"""The types of the letters that Python packs numbers by: `>H`. A capital letter has no sign."""

_ARRAY = re.compile(r"\s+array$", re.IGNORECASE)
_OF_WORDS = re.compile(r"word|[lm]sw", re.IGNORECASE)


UNSIGNED = {1: "u16", 2: "u32", 4: "u64"}
"""The whole numbers without a sign by their words."""


class Loose(Enum):
    """The properties of a type in a list without its name."""

    WHOLE = "whole"
    TRUTH = "truth"

    def is_kind_of(self, primitive: Primitive) -> bool:
        """Whether a type is one of those."""
        match self:
            case Loose.WHOLE:
                return is_count(primitive.encoding)
            case Loose.TRUTH:
                return is_truth(primitive.encoding)
            case _:
                assert_never(self)


@dataclass(frozen=True, slots=True)
class Typed:
    """A type as a list has it: the name of a type, or its kind and perhaps whether it is signed.

    `bits` is its size where only that is said, `length` a number in brackets: of characters, or of elements. `order`
    is that of the bytes, such as `CDAB`, and empty if the type does not say it. `aside` are the words in brackets
    after it that say something else, `factor` is a scale after it, `digits` the representation of BCD.
    """

    name: str = ""
    kind: Loose | None = None
    signed: bool | None = None
    bits: int = 0
    length: int = 0
    order: str = ""
    aside: str = ""
    factor: str = ""
    digits: str = ""

    def fits(self, name: str) -> bool:
        """Whether the type with a name agrees."""
        primitive = PRIMITIVES.get(name)
        if primitive is None or name == self.name:
            return name == self.name
        if self.name:
            return False
        if self.bits:
            return self.bits == primitive.size * 8
        alike = self.kind is not None and self.kind.is_kind_of(primitive)
        return alike and self.signed in (None, is_signed(primitive.encoding))

    @property
    def size(self) -> int:
        """Its size in words where the type says it; 0 where it does not."""
        return (self.bytes + 1) // 2

    @property
    def bytes(self) -> int:
        """Its size in bytes where the type says it; 0 where it does not."""
        return PRIMITIVES[self.name].size if self.name else (self.bits + 7) // 8

    def of_words(self, words: int | None) -> str:
        """The name of the type; if the list has only its kind, that of the type with this number of words."""
        if self.name:
            return self.name
        if self.kind is Loose.TRUTH:
            return "bool16"
        name = UNSIGNED.get(words or self.size or 1, "bytes")
        return name.replace("u", "i") if self.signed else name


def with_sign(number: Decimal, primitive: Primitive) -> Decimal:
    """A number of a type; that of a signed one may be written as the bits that are sent."""
    is_wrapped = is_signed(primitive.encoding) and primitive.high < number < 1 << primitive.size * 8
    return number - (1 << primitive.size * 8) if is_wrapped else number


def typed(text: str) -> Typed | None:
    """The type that a text names, None if it names none that is known."""
    text = unicodedata.normalize("NFKC", text).strip().strip("`*").strip()
    if not text or len(text) > _LONGEST:
        return None
    text = _ARRAY.sub("", text)
    if known := _known(text):
        return known
    if letter := _STRUCT.fullmatch(text):
        name = _OF_STRUCT[letter[2].lower()]
        byte_order = {"<": "DCBA", ">": "ABCD", "!": "ABCD"}.get(letter[1], "")
        return Typed(f"u{name[1:]}" if letter[2].isupper() else name, order=byte_order)
    if order := _ORDER_WORD.search(text):
        inner = typed(text[: order.start()])
        return replace(inner, order=meaning("orders", order[1])) if inner else None
    if swapped := _ORDERED.fullmatch(text.casefold()):
        inner = _known(swapped[1])
        return replace(inner, order="CDAB") if inner else None
    bare, _, further_text = text.partition(",")
    if further_text and not {*"[("} & {*bare} and (inner := typed(bare)) and not inner.aside:
        stated, rest = _order_and_rest(further_text)
        return replace(inner, order=stated or inner.order, aside=rest)
    for blank in re.finditer(r"\s+", text) if not {*"[("} & {*text} else ():
        stated = meaning("orders", text[blank.end() :])
        if stated and (inner := typed(text[: blank.start()])) is not None:
            return replace(inner, order=stated)
    if text.casefold().endswith("bcd") and (inner := typed(text[:-3].rstrip(" _-"))) and inner.kind is not Loose.TRUTH:
        return replace(inner, digits="bcd")
    if (scaled := _SCALED.fullmatch(text)) and (inner := typed(scaled[1])) and inner.name != "text":
        return replace(inner, factor=scaled[2])
    length = _LENGTH.search(text)
    inner = typed(text[: length.start()]) if length else None
    is_bit = inner is not None and (inner.kind is Loose.TRUTH or inner.name == "bit")
    if length and inner is not None and not inner.length and not (is_bit and length[3]):
        return replace(inner, length=int(next(filter(None, length.groups()))))
    bare, _, aside = re.sub("[(]", "[", text).partition("[")
    inner = typed(bare) if aside else None
    if inner is None:
        return None
    sized = _known(aside.strip(" )]")) if inner.kind is Loose.WHOLE and not inner.size else None
    if sized is not None and sized.bits:
        return replace(inner, bits=sized.bits)
    stated, rest = _order_and_rest(aside.strip(" )]"))
    return replace(inner, order=stated or inner.order, aside=rest)


def _order_and_rest(aside: str) -> tuple[str, str]:
    """The order of bytes in words beside a type, such as `big endian, low word first`, and other words."""
    stated = [(piece.strip(), meaning("orders", piece)) for piece in re.split(r"[,;/]", aside)]
    rest = ", ".join(piece for piece, order in stated if piece and not order)
    of_words = [order for piece, order in stated if order and _OF_WORDS.search(piece)]
    of_bytes = [order for piece, order in stated if order and not _OF_WORDS.search(piece)]
    return joined_order("".join(of_bytes[:1]), "".join(of_words[:1])), rest


def described_order(text: str) -> str:
    """The order of two words that a text says: `low word first`; empty for none, and for an order of bytes."""
    phrase = pattern("word_first").search(text)
    return meaning("orders", phrase[0]) if phrase else ""


def _known(text: str) -> Typed | None:
    word = folded(text)
    if word in PRIMITIVES:
        return Typed(word)
    if name := meaning("types", word):
        return Typed(name)
    loose = meaning("loose_types", word)
    if loose == "boolean":
        return Typed("", Loose.TRUTH)
    if loose:
        return Typed("", Loose.WHOLE, loose == "signed")
    if word in ("bcd", "packedbcd"):
        return Typed(kind=Loose.WHOLE, digits="bcd")
    if sized := _SIZED.fullmatch(text):
        unit = {"byte": 8, "bit": 1}.get(sized[2].casefold(), _WORD_BITS)
        return Typed(kind=Loose.WHOLE, bits=int(sized[1] or 1) * unit)
    if early := _EARLY_BITS.fullmatch(word):
        word = early[2] + early[1] if early[2] else word
        if name := meaning("types", word):
            return Typed(name)
    return _composed(word) or _of_words(word)


def _of_words(word: str) -> Typed | None:
    """A type from its size beside a word for its kind, in any language: `Entero 32 bits`, `32位无符号整数`."""
    parts = _BESIDE_SIZE.fullmatch(word)
    kind = parts[1] + parts[3] if parts else ""
    letter = {"signed": "i", "unsigned": "u"}.get(meaning("loose_types", kind), "")
    letter = "f" if meaning("types", kind) == "f32" else letter
    return Typed(f"{letter}{parts[2]}") if parts and f"{letter}{parts[2]}" in PRIMITIVES else None


def _composed(word: str) -> Typed | None:
    """A type from the parts of its word: `unsigned32bit`, `int32u`, `u32be`."""
    parts = _COMPOSED.fullmatch(word)
    if parts is None or not (parts["sign"] or parts["base"] or parts["late"]):
        return None
    base, bits = parts["base"], parts["bits"]
    if base in ("float", "real", "double"):
        name = f"f{bits}"
    else:
        unsigned = parts["sign"].startswith(("u",)) or parts["late"] == "u"
        signed = parts["sign"].startswith("s") or parts["late"] in ("s", "i")
        if base in ("int", "integer") and not unsigned:
            signed = True
        name = f"{'i' if signed else 'u'}{bits}"
    order = meaning("orders", parts["order"]) if parts["order"] else ""
    digits = "bcd" if base == "bcd" else ""
    return Typed(name, order=order, digits=digits) if name in PRIMITIVES else None
