"""Lists of global constants: numbers, and the texts of codes."""

from __future__ import annotations

from fieldspec.classes import dataclass
from fieldspec.plc.constants import ConstantList
from fieldspec.plc.routines.types import DINT, LINT, Elementary
from fieldspec.plc.routines.written import comment, plain
from fieldspec.plc.structured.item import Item
from fieldspec.plc.structured.literals import length, narrow, number, string
from fieldspec.plc.texts import TextTable

LIST_ATTRIBUTES = ("qualified_only",)
_HEAD = "VAR_GLOBAL CONSTANT"


@dataclass(frozen=True, slots=True)
class TextForm:
    """The struct of a code's text: its name, the type of the code, and the longest text. `wide` is for WSTRING."""

    name: str
    code: Elementary
    longest: int
    wide: bool

    @property
    def text_type(self) -> str:
        """The type of the text."""
        return f"{'WSTRING' if self.wide else 'STRING'}({self.longest})"

    @property
    def members(self) -> tuple[str, str]:
        """The members for the code and for the text."""
        return ("diCode" if self.code == DINT else "liCode"), ("wsText" if self.wide else "sText")


def text_form(tables: tuple[TextTable, ...], name: str) -> TextForm | None:
    """The struct that all tables of texts have; None where there are none."""
    texts = [one for table in tables for one in table.texts]
    if not texts:
        return None
    wide = not all(narrow(one.text) for one in texts)
    code = DINT if all(DINT.low <= one.code <= DINT.high for one in texts) else LINT
    return TextForm(name, code, max(length(one.text, wide) for one in texts), wide)


def form_item(form: TextForm) -> Item:
    """The declaration of the struct of texts."""
    code, text = form.members
    lines = [*comment("What a code means."), f"TYPE {form.name} :", "STRUCT"]
    lines += [f"    {code} : {form.code.name};", f"    {text} : {form.text_type};", "END_STRUCT;", "END_TYPE"]
    return Item(form.name, "type", "structs", tuple(lines))


def constants_item(listed: ConstantList) -> Item:
    """A list of numbers."""
    lines = [*_head(listed.title), _HEAD]
    for one in listed.constants:
        beside = f" // {plain(one.remark)}" if plain(one.remark) else ""
        lines.append(f"    {one.name} : {one.type.name} := {number(one)};{beside}")
    return Item(listed.name, "list", "constants", (*lines, "END_VAR"))


def texts_item(name: str, tables: tuple[TextTable, ...], form: TextForm) -> Item:
    """The list of all texts of codes: one array for each enum, by number."""
    lines = [*_head("Texts of codes"), _HEAD]
    code, text = form.members
    for table in tables:
        lines += comment(table.title, "    ")
        lines.append(f"    {table.name} : ARRAY[0..{len(table.texts) - 1}] OF {form.name} := [")
        for at, one in enumerate(table.texts, 1):
            mark = "," if at < len(table.texts) else ""
            lines.append(f"        ({code} := {one.code}, {text} := {string(one.text, form.wide)}){mark}")
        lines.append("    ];")
    return Item(name, "list", "constants", (*lines, "END_VAR"))


def _head(title: str) -> list[str]:
    return [*comment(title), *(f"{{attribute '{name}'}}" for name in LIST_ATTRIBUTES)]
