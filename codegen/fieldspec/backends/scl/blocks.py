"""Data blocks: the process data of telegrams, and texts of codes."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.backends.scl.project import LONGEST_STRING, Project, TelegramBlock, TextBlock
from fieldspec.plc.routines.written import comment

_STANDARD, _OPTIMIZED = "FALSE", "TRUE"


def blocks(held: Project) -> Iterator[list[str]]:
    """All data blocks."""
    for telegram in held.telegrams:
        yield _images(telegram)
        yield _values(held, telegram)
    for texts in held.texts:
        yield _texts(held, texts)


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
    """The calls that exchange process data, what is read before what is written."""
    made = []
    for member, _, _ in reversed(telegram.directions):
        name = f"{before}{member[:1].upper()}{member[1:]}" if before else member
        read = member == "fromDevice"
        instruction, arrow = ("DPRD_DAT", "=>") if read else ("DPWR_DAT", ":=")
        made.append(f'#status := {instruction}(LADDR := #laddr, RECORD {arrow} "{block}".{name});')
    return made


def _values(held: Project, telegram: TelegramBlock) -> list[str]:
    world = held.declared.world
    members, use = [], []
    for member, image, struct in telegram.directions:
        bytes_name = f"bytes{member[:1].upper()}{member[1:]}"
        members.append(f'      {member} : "{struct.name}";')
        members.append(f"      {bytes_name} : ARRAY[0..{(image.size or 0) - 1}] OF BYTE;")
        call = world.routine("pack" if member == "toDevice" else "unpack", struct.key, "bytes")
        whole = f'"{telegram.values}"'
        use.append(f'#result := "{call}"(stData := {whole}.{member}, aBytes := {whole}.{bytes_name});')
    read_first = [*_calls(telegram.values, telegram, "bytes")]
    order = [read_first[0], *reversed(use), *read_first[1:]]
    return [
        *comment(f"{telegram.title}: values, and the bytes that they are made of. SCL, in this order:"),
        *(f"//    {line}" for line in order),
        *comment("Use the values only where the result of the function is 0."),
        *_block(telegram.values, _OPTIMIZED, members),
    ]


def _texts(held: Project, texts: TextBlock) -> list[str]:
    table = texts.table
    count = len(table.texts)
    members = [
        f"      count : INT := {count};",
        f'      entries : ARRAY[0..{count - 1}] OF "{held.text_type}";',
    ]
    values = []
    for number, one in enumerate(table.texts):
        values.append(f"   entries[{number}].code := {one.code};")
        values.append(f"   entries[{number}].text := {string(one.text, held.text_length)};")
    about = comment(f"{table.title}: the texts of its codes, the least code first.")
    return [*about, *_block(texts.name, _OPTIMIZED, members, values)]


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


def string(text: str, most: int = LONGEST_STRING) -> str:
    """A literal of STRING, which has the printable characters of ASCII alone; others become question marks."""
    plain = "".join(char if " " <= char <= "~" else "?" for char in text)[:most]
    return "'" + plain.replace("$", "$$").replace("'", "$'") + "'"
