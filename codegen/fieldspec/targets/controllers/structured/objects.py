"""The objects of a Structured Text project: types, lists of constants, size checks."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.foundation.classes import dataclass
from fieldspec.targets.controllers.constants import ConstantList
from fieldspec.targets.controllers.dialects import Spelling
from fieldspec.targets.controllers.enums import EnumDeclaration, TextTable
from fieldspec.targets.controllers.literals import initial, length, narrow, string
from fieldspec.targets.controllers.routines.printer import comment, comment_text, type_text
from fieldspec.targets.controllers.statements.expressions import DINT, LINT, Elementary
from fieldspec.targets.controllers.structs import Struct


@dataclass(frozen=True, slots=True)
class Item:
    """An object by its name. `kind` is type, list, function, block or program.

    `about` is what it belongs to, in a word or two. `declaration` and `implementation` are its lines; a function has no
    line for its end, since files of projects have none.
    """

    name: str
    kind: str
    about: str
    declaration: tuple[str, ...]
    implementation: tuple[str, ...] = ()

    @property
    def lines(self) -> list[str]:
        """The lines of the object's declaration and implementation."""
        ends = {"function": ["END_FUNCTION"], "block": ["END_FUNCTION_BLOCK"], "program": ["END_PROGRAM"]}
        end = ends.get(self.kind, [])
        return [*self.declaration, *self.implementation, *end]


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
    texts = [text for table in tables for text in table.texts]
    if not texts:
        return None
    wide = not all(narrow(text.text) for text in texts)
    code = DINT if all(DINT.low <= text.code <= DINT.high for text in texts) else LINT
    return TextForm(name, code, max(length(text.text, wide) for text in texts), wide)


def form_item(form: TextForm) -> Item:
    """The declaration of the struct of texts."""
    code, text = form.members
    lines = [*comment("A code and its meaning."), f"TYPE {form.name} :", "STRUCT"]
    lines += [f"    {code} : {form.code.name};", f"    {text} : {form.text_type};", "END_STRUCT;", "END_TYPE"]
    return Item(form.name, "type", "structs", tuple(lines))


def constants_item(constant_list: ConstantList) -> Item:
    """The declaration of a list of constants."""
    lines = [*_head(constant_list.title), _HEAD]
    for constant in constant_list.constants:
        remark = f" // {comment_text(constant.remark)}" if comment_text(constant.remark) else ""
        value = initial(constant.value, constant.type, constant.hexadecimal)
        lines.append(f"    {constant.name} : {constant.type.name} := {value};{remark}")
    return Item(constant_list.name, "list", "constants", (*lines, "END_VAR"))


def texts_item(name: str, tables: tuple[TextTable, ...], form: TextForm) -> Item:
    """The list of the texts of codes: an array for each enum, in the order of the numbers."""
    lines = [*_head("Texts of codes"), _HEAD]
    code, text = form.members
    for table in tables:
        lines += comment(table.title, "    ")
        lines.append(f"    {table.name} : ARRAY[0..{len(table.texts) - 1}] OF {form.name} := [")
        for position, entry in enumerate(table.texts, 1):
            mark = "," if position < len(table.texts) else ""
            lines.append(f"        ({code} := {entry.code}, {text} := {string(entry.text, form.wide)}){mark}")
        lines.append("    ];")
    return Item(name, "list", "constants", (*lines, "END_VAR"))


def _head(title: str) -> list[str]:
    return [*comment(title), *(f"{{attribute '{name}'}}" for name in LIST_ATTRIBUTES)]


ENUM_ATTRIBUTES = ("qualified_only", "strict")
"""Members are used with the name of their enum, and only members are assigned."""

PACK_MODE = 1


def enum_item(declared: EnumDeclaration) -> Item:
    """The declaration of a strict enum with its base type."""
    lines = [*comment(declared.title), *(f"{{attribute '{name}'}}" for name in ENUM_ATTRIBUTES)]
    lines += [f"TYPE {declared.name} :", "("]
    for position, member in enumerate(declared.members, 1):
        mark = "," if position < len(declared.members) else ""
        remark = f" // {comment_text(member.remark)}" if comment_text(member.remark) else ""
        lines.append(f"    {member.name} := {member.value}{mark}{remark}")
    return Item(declared.name, "type", "enums", (*lines, f") {declared.base.name};", "END_TYPE"))


def struct_item(struct: Struct, size: int, spelling: Spelling) -> Item:
    """The declaration of a struct of `size` bytes, without gaps between its members."""
    lines = comment(f"{struct.title} {size} bytes.".strip())
    lines += [f"{{attribute 'pack_mode' := '{PACK_MODE}'}}", f"TYPE {struct.name} :", "STRUCT"]
    for member in struct.members:
        remark = f" // {comment_text(member.remark)}" if comment_text(member.remark) else ""
        lines.append(f"    {member.name} : {type_text(member.type, spelling)};{remark}")
    if not struct.members:
        lines.append("    byNothing : BYTE; // a struct must have a member")
    return Item(struct.name, "type", "structs", (*lines, "END_STRUCT;", "END_TYPE"))


def sizes_item(name: str, sizes: Mapping[str, int]) -> Item:
    """The function that compares the sizes of structs with the layout, for a call at the start."""
    head = [
        *comment("Whether all structs are as large as their layout says. FALSE means that the compiler fills up gaps:"),
        *comment("then do not copy them as blocks of memory. The functions for words and bytes do not depend on it."),
        f"FUNCTION {name} : BOOL",
        "VAR",
        *(f"    st{number} : {struct};" for number, struct in enumerate(sizes, 1)),
        "END_VAR",
    ]
    body = [f"{name} := TRUE;"]
    for number, (struct, size) in enumerate(sizes.items(), 1):
        body.append(f"IF SIZEOF(st{number}) <> {size} THEN {name} := FALSE; END_IF; // {struct}")
    return Item(name, "function", "layout", tuple(head), tuple(body))
