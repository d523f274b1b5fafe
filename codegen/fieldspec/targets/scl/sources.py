"""SCL source files: types, functions and data blocks."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from fieldspec.language.diagnostics import Diagnostic
from fieldspec.targets.controllers.layout.fitting import direct
from fieldspec.targets.controllers.layout.memory import Placed
from fieldspec.targets.controllers.routines.printer import comment, comment_text, routine_text, type_text
from fieldspec.targets.controllers.routines.remarks import left_out, without_block
from fieldspec.targets.controllers.structs import Struct
from fieldspec.targets.fact_texts import manual_remark
from fieldspec.targets.scl.project import LONGEST_STRING, Project, TelegramBlock, TextBlock


def source(project: Project, objects: Iterable[list[str]]) -> str:
    """A source of several objects, each one its lines."""
    dialect = project.declared.dialect
    lines = list(head(project))
    for lines_of_object in objects:
        lines += ["", *lines_of_object]
    return dialect.byte_order_mark + "".join(line.rstrip() + dialect.line_end for line in lines)


def head(project: Project) -> list[str]:
    """The comment at the head of a file: its content, its spec, and how it is imported."""
    device = project.layout.device
    sources = [
        f"{project.stem}_types.udt",
        *([f"{project.stem}_data.db"] if project.blocks else []),
        f"{project.stem}_functions.scl",
    ]
    return [
        *comment(f"{device.name} ({device.vendor}), version {device.version}"),
        *comment(manual_remark(device.manual)),
        *comment(f"Identity of the layout: {project.layout.identity}"),
        *comment("Written by fieldspec. Do not edit: change the spec and build again."),
        "//",
        *comment(
            "Import: in the project tree of the PLC, External source files, Add new external file, then Generate "
            f"blocks from source: {', '.join(sources)}, in this order, and then one of the programs, if there are any. "
            "A block of the same name is overwritten."
        ),
        *comment(f"Constants: PLC tags, Show all tags, Import, {project.stem}_constants.xlsx."),
        *(f"// {line}".rstrip() for line in left_out(project.declared.omissions)),
        *(f"// {line}".rstrip() for line in without_block(project.missing)),
    ]


def types(project: Project) -> Iterator[list[str]]:
    """All types, each after those that it uses."""
    declared = project.declared
    for image in declared.images:
        yield _image(project, declared.placed(image))
    for struct in declared.structs:
        yield _values(project, struct)
    if project.texts:
        yield _texts(project)


def _image(project: Project, placed: Placed) -> list[str]:
    struct = placed.struct
    paragraphs = [
        f"{struct.title}. As on the wire: {placed.size} bytes in a block with standard access.",
        "Each member begins with its byte and bit.",
    ]
    members = []
    for member in placed.members:
        swapped = "" if direct(placed, member) else " Its bytes are not in the PLC's order."
        place = f"{member.at}.{member.bit or 0}"
        members.append(
            (member.member.name, _type(project, member.member.type), f"{place} {member.member.remark}{swapped}")
        )
    return _type_lines(project, struct.name, paragraphs, members)


def _values(project: Project, struct: Struct) -> list[str]:
    paragraphs = [
        f"{struct.title}. Values, for blocks with optimized access; functions convert them from and to the wire."
    ]
    return _type_lines(
        project,
        struct.name,
        paragraphs,
        [(member.name, _type(project, member.type), member.remark) for member in struct.members],
    )


def _texts(project: Project) -> list[str]:
    members = [
        ("code", project.code_type.name, "number of the code"),
        ("text", f"STRING[{project.text_length}]", "what it means"),
    ]
    return _type_lines(project, project.text_type, ["A code and its text."], members)


def _type(project: Project, kind: object) -> str:
    return type_text(kind, project.declared.dialect.spelling)  # type: ignore[arg-type]


def _type_lines(project: Project, name: str, paragraphs: list[str], members: list[tuple[str, str, str]]) -> list[str]:
    lines = [line for text in paragraphs for line in comment(text)]
    lines += [f'TYPE "{name}"', "VERSION : 0.1", "   STRUCT"]
    for member, kind, remark in members:
        suffix = f"   {project.declared.dialect.comment.format(comment_text(remark))}" if comment_text(remark) else ""
        lines.append(f"      {member} : {kind};{suffix}")
    return [*lines, "   END_STRUCT;", "", "END_TYPE"]


def functions(project: Project) -> Iterator[list[str]]:
    """All functions, each after those that it calls."""
    for routine in project.routines:
        yield routine_text(routine, project.declared.dialect.spelling)


def clashes(project: Project) -> Iterator[Diagnostic]:
    """Functions that have the name of another one."""
    names: set[str] = set()
    for routine in project.routines:
        if routine.name.lower() in names:
            yield Diagnostic(
                "plc_names_distinct",
                f"two functions of {project.layout.device.id} are {routine.name} in {project.declared.dialect.title}",
                project.layout.device.place["id"],
                help="give one of the two facts that they are about another name",
            )
        names.add(routine.name.lower())


_STANDARD, _OPTIMIZED = "FALSE", "TRUE"


def blocks(project: Project) -> Iterator[list[str]]:
    """The sources of all data blocks."""
    for telegram in project.telegrams:
        yield _images(telegram)
        yield _block_values(project, telegram)
    for texts in project.texts:
        yield _text_block(project, texts)


def _images(telegram: TelegramBlock) -> list[str]:
    members = []
    for member, image, _ in telegram.directions:
        members.append(f'      {member} : "{image.name}";   // {image.size} bytes')
    use = [
        *comment(f"{telegram.title}: what lies on the wire, for DPRD_DAT and DPWR_DAT, whose RECORD must be as long."),
        *comment("SCL, with the hardware identifier of the submodule as LADDR:"),
        *(f"//    {line}" for line in _calls(telegram.image, telegram, "")),
        *comment(
            "LAD: the boxes DPRD_DAT and DPWR_DAT with the same LADDR, and as RECORD "
            + " and ".join(f'"{telegram.image}".{member}' for member, _, _ in reversed(telegram.directions))
            + "."
        ),
    ]
    return [*use, *_block(telegram.image, _STANDARD, members)]


def _calls(block: str, telegram: TelegramBlock, before: str) -> list[str]:
    """The calls that exchange process data: those that read come before those that write."""
    calls = []
    for member, _, _ in reversed(telegram.directions):
        name = f"{before}{member[:1].upper()}{member[1:]}" if before else member
        read = member == "fromDevice"
        instruction, arrow = ("DPRD_DAT", "=>") if read else ("DPWR_DAT", ":=")
        calls.append(f'#status := {instruction}(LADDR := #laddr, RECORD {arrow} "{block}".{name});')
    return calls


def _block_values(project: Project, telegram: TelegramBlock) -> list[str]:
    world = project.declared.world
    members, use = [], []
    for member, image, struct in telegram.directions:
        bytes_name = f"bytes{member[:1].upper()}{member[1:]}"
        members.append(f'      {member} : "{struct.name}";')
        members.append(f"      {bytes_name} : ARRAY[0..{(image.size or 0) - 1}] OF BYTE;")
        call = world.routine("pack" if member == "toDevice" else "unpack", struct.key, "bytes")
        whole = f'"{telegram.values}"'
        use.append(f'#result := "{call}"(data := {whole}.{member}, bytes := {whole}.{bytes_name});')
    read_first = [*_calls(telegram.values, telegram, "bytes")]
    order = [read_first[0], *reversed(use), *read_first[1:]]
    return [
        *comment(f"{telegram.title}: values, and the bytes that they are made of. SCL, in this order:"),
        *(f"//    {line}" for line in order),
        *comment("Use the values only where the result of the function is 0."),
        *_block(telegram.values, _OPTIMIZED, members),
    ]


def _text_block(project: Project, texts: TextBlock) -> list[str]:
    table = texts.table
    count = len(table.texts)
    members = [
        f"      count : INT := {count};",
        f'      entries : ARRAY[0..{count - 1}] OF "{project.text_type}";',
    ]
    values = []
    for number, text in enumerate(table.texts):
        values.append(f"   entries[{number}].code := {text.code};")
        values.append(f"   entries[{number}].text := {string(text.text, project.text_length)};")
    heading = comment(f"{table.title}: the texts of its codes, the least code first.")
    return [*heading, *_block(texts.name, _OPTIMIZED, members, values)]


def _block(name: str, optimized: str, members: list[str], values: list[str] | None = None) -> list[str]:
    return [
        f'DATA_BLOCK "{name}"',
        f"{{ S7_Optimized_Access := '{optimized}' }}",
        "VERSION : 0.1",
        "NON_RETAIN",
        "   STRUCT",
        *members,
        "   END_STRUCT;",
        "",
        "BEGIN",
        *(values or []),
        "",
        "END_DATA_BLOCK",
    ]


def string(text: str, limit: int = LONGEST_STRING) -> str:
    """A literal of STRING, which has the printable characters of ASCII alone; others become question marks."""
    characters = "".join(char if " " <= char <= "~" else "?" for char in text)[:limit]
    return "'" + characters.replace("$", "$$").replace("'", "$'") + "'"
