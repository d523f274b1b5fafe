"""The texts of a workbook in a table of their own: programs are found that read no texts within cells."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

_INLINE = re.compile(r'<c r="([A-Z]+[0-9]+)"((?: s="[0-9]+")?) t="inlineStr"><is><t[^>]*>(.*?)</t></is></c>', re.DOTALL)
_MAIN = "http://schemas.openxmlformats.org/spreadsheetml/2006/main"
_RELATION = "http://schemas.openxmlformats.org/officeDocument/2006/relationships/sharedStrings"
_CONTENT = "application/vnd.openxmlformats-officedocument.spreadsheetml.sharedStrings+xml"
_ENDS = {
    "xl/_rels/workbook.xml.rels": (
        "</Relationships>",
        f'<Relationship Id="rIdStrings" Target="/xl/sharedStrings.xml" Type="{_RELATION}"></Relationship>',
    ),
    "[Content_Types].xml": (
        "</Types>",
        f'<Override ContentType="{_CONTENT}" PartName="/xl/sharedStrings.xml"></Override>',
    ),
}


def with_shared_strings(parts: Iterable[tuple[str, str]]) -> Iterator[tuple[str, str]]:
    """The parts of a workbook by name, canonical XML each, with its texts in `xl/sharedStrings.xml`."""
    places: dict[str, int] = {}
    uses = 0

    def shared(found: re.Match[str]) -> str:
        nonlocal uses
        uses += 1
        place, style, text = found.groups()
        return f'<c r="{place}"{style} t="s"><v>{places.setdefault(text, len(places))}</v></c>'

    for name, text in parts:
        end, more = _ENDS.get(name, ("", ""))
        if name.startswith("xl/worksheets/"):
            yield name, _INLINE.sub(shared, text)
        else:
            yield name, text.replace(end, more + end) if end else text
    items = "".join(f'<si><t xml:space="preserve">{text}</t></si>' for text in places)
    yield (
        "xl/sharedStrings.xml",
        f'<sst xmlns="{_MAIN}" count="{uses}" uniqueCount="{len(places)}">{items}</sst>',
    )
