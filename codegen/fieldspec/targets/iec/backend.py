"""The files for Beremiz, OpenPLC and other compilers of IEC 61131-3."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import dataclass, replace
from fieldspec.foundation.names import stem
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.targets.controllers.adapters.programs import Source as ProgramSource
from fieldspec.targets.controllers.adapters.programs import standard
from fieldspec.targets.controllers.cache import cached
from fieldspec.targets.controllers.chosen import chosen_routines, trimmed
from fieldspec.targets.controllers.constants import ConstantList
from fieldspec.targets.controllers.declarations import Declarations, declarations
from fieldspec.targets.controllers.dialects import IEC, Spelling
from fieldspec.targets.controllers.literals import initial
from fieldspec.targets.controllers.routines.all_routines import routines
from fieldspec.targets.controllers.routines.printer import array_name, comment, comment_text, routine_text, type_text
from fieldspec.targets.controllers.routines.remarks import without_block
from fieldspec.targets.controllers.statements.expressions import ArrayType, Type
from fieldspec.targets.controllers.statements.routine import Routine
from fieldspec.targets.controllers.structs import Struct
from fieldspec.targets.controllers.structured.examples import examples
from fieldspec.targets.controllers.structured.program import about, newest


@dataclass(frozen=True, slots=True)
class Source:
    """The declarations and routines of a device, and the spelling of the compiler that they are for.

    `missing` are the tasks without a block, with the reasons.
    """

    declared: Declarations
    routines: tuple[Routine, ...]
    spelling: Spelling
    missing: tuple[tuple[str, str], ...]


def files(versions: Sequence[DeviceLayout]) -> dict[str, str]:
    """For a device's newest version: the types and functions as one source, and the constants for a configuration."""
    layout = newest(versions)
    name = stem(layout.device.id, layout.device.version)
    iec_source = source(layout)
    sources = standard(iec_source.declared.world, iec_source.spelling, iec_source.routines)
    return {
        f"{name}.st": text(iec_source),
        f"{name}_constants.st": constants(iec_source),
        **{f"{name}_{program.name}.st": program_text(iec_source, program) for program in sources},
    }


def refusals(versions: Sequence[DeviceLayout]) -> list[Diagnostic]:
    """Names that a compiler does not take, or takes for one."""
    return list(declarations(newest(versions), IEC).findings)


def program_text(iec_source: Source, program: ProgramSource) -> str:
    """A ready program, to be put after the types and functions."""
    return "\n".join([*_remarks([*about(iec_source.declared), "", *program.remarks]), "", program.text])


@cached
def source(layout: DeviceLayout) -> Source:
    """The source of a device that has passed the checks."""
    declared = declarations(layout, IEC)
    spelling = replace(IEC.spelling, array=IEC.spelling.array.format(declared.world.names.device, "{}"))
    all_blocks = routines(declared.world)
    wanted_routines = chosen_routines(declared.world, all_blocks.routines)
    return Source(trimmed(declared, wanted_routines, spelling), wanted_routines, spelling, all_blocks.missing)


def text(iec_source: Source) -> str:
    """The text of types, each after those that it uses, then of functions, each after those that it calls."""
    lines = _remarks([*about(iec_source.declared), "", *_guide(iec_source)])
    declared: set[str] = set()
    for struct in iec_source.declared.structs:
        for member in struct.members:
            lines += _arrays(member.type, iec_source.spelling, declared)
        lines += ["", *struct_lines(struct, iec_source.spelling)]
    for routine in iec_source.routines:
        for parameter in routine.declared:
            lines += _arrays(parameter.variable.type, iec_source.spelling, declared)
    for routine in iec_source.routines:
        lines += ["", *routine_text(routine, iec_source.spelling)]
    return "\n".join(lines) + "\n"


def _arrays(kind: object, spelling: Spelling, declared: set[str]) -> Iterator[str]:
    """The types of an array and of the arrays in it, as far as they are not declared yet."""
    if isinstance(kind, ArrayType):
        yield from _arrays(kind.of, spelling, declared)
        name, *lines = type_lines(kind, spelling)
        if name not in declared:
            declared.add(name)
            yield from ("", *lines)


def _guide(iec_source: Source) -> list[str]:
    return [
        "Each function returns a status, a number: see the constants. Unless that is 0, its outputs and what it was to",
        "fill must not be used. Arrays have named types, because an argument must have the type of the parameter.",
        *examples(iec_source.declared.world, iec_source.routines, iec_source.spelling),
        *without_block(iec_source.missing),
    ]


def _remarks(lines: Sequence[str]) -> list[str]:
    form = IEC.comment
    return [form.format(line.replace("(*", "( *").replace("*)", "* )")).rstrip() for line in lines]


def constants(iec_source: Source) -> str:
    """All constants, for the configuration: a program names those that it uses in VAR_EXTERNAL CONSTANT."""
    head = ["Put these lists into the CONFIGURATION. A program declares what it uses as VAR_EXTERNAL CONSTANT."]
    lines = _remarks([*about(iec_source.declared), "", *head])
    for constant_list in iec_source.declared.constants:
        lines += ["", *_constants(constant_list)]
    return "\n".join(lines) + "\n"


def _constants(constant_list: ConstantList) -> Iterator[str]:
    yield from comment(constant_list.title, form=IEC.comment)
    yield "VAR_GLOBAL CONSTANT"
    for constant in constant_list.constants:
        remark = comment_text(constant.remark)
        value = initial(constant.value, constant.type, constant.hexadecimal)
        yield f"    {constant.name} : {constant.type.name} := {value};" + (
            f" {IEC.comment.format(remark)}" if remark else ""
        )
    yield "END_VAR"


def struct_lines(struct: Struct, spelling: Spelling) -> list[str]:
    """The declaration of a STRUCT of values in Structured Text."""
    lines = [*comment(struct.title, form=spelling.comment), "TYPE", f"    {struct.name} : STRUCT"]
    for member in struct.members:
        remark = f" {spelling.comment.format(comment_text(member.remark))}" if comment_text(member.remark) else ""
        lines.append(f"        {member.name} : {type_text(member.type, spelling)};{remark}")
    if not struct.members:
        lines.append(f"        byNothing : BYTE; {spelling.comment.format('a struct must have a member')}")
    return [*lines, "    END_STRUCT;", "END_TYPE"]


def type_lines(kind: ArrayType, spelling: Spelling) -> list[str]:
    """The name of an array type, and after it the lines that declare it.

    An array of arrays states its initial value, because matiec has none for it and writes wrong C.
    """
    name = array_name(kind, spelling)
    bounds = f"ARRAY [{kind.low}..{kind.high}] OF {type_text(kind.of, spelling)}"
    initial = f" := {_zeros(kind)}" if isinstance(kind.of, ArrayType) else ""
    return [name, "TYPE", f"    {name} : {bounds}{initial};", "END_TYPE"]


def _zeros(kind: Type) -> str:
    """The value that the elements of an array have anyway: texts and bytes are the arrays that arrays are made of."""
    return f"[{kind.high - kind.low + 1}({_zeros(kind.of)})]" if isinstance(kind, ArrayType) else "0"
