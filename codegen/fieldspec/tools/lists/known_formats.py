"""Files of other formats that have registers, which are refused by their names."""

from __future__ import annotations

import re

from fieldspec.tools.lists.formats import can_database, object_dictionary
from fieldspec.tools.lists.sheet import ListError

_LOOKED_AT = 1 << 16

_FORMATS = (
    (object_dictionary.SIGNS.pattern, "an electronic data sheet (EDS or DCF) of a bus with objects"),
    (can_database.SIGNS.pattern, "a database of CAN messages (DBC)"),
    (r"^[ \t]*(?:addrmap|regfile|reg)\b[^\n]*\{", "a description of registers in SystemRDL"),
    (r"\A(?:[ \t]*(?:[#;][^\n]*)?\n)*[ \t]*\[{1,2}[A-Za-z][\w. -]*\]{1,2}[ \t\r]*$", "a configuration in TOML or INI"),
    (r"^(?:poll|ref),[\w ]+,[0-9]+,", "a configuration of modpoll"),
    (r"^[ \t]*Bridge +\w+(?::[\w-]+){1,3} .*[\[{]", "a file of things of openHAB"),
    (r"^#\s*type \(r\[1-9\]", "a configuration of messages of an eBUS"),
    (r"^[ \t]*#[ \t]*(?:define|ifndef|include)[ \t]|^[ \t]*(?:typedef )?enum (?:class )?\w* ?\{", "source code in C"),
    (
        r"^(?:import [\w.]+(?: as \w+)?$|from \S+ import |class \w+[(:]|def \w+\()|^\w+ = [\[{(][ \t]*$",
        "source code in Python",
    ),
    (
        r"^(?:module\.exports|export (?:default|const|class|enum|type) |(?:const|let|var) \w+ =)",
        "source code in JavaScript",
    ),
    (r"<EtherCATInfo\b", "a description of an EtherCAT device (ESI)"),
    (r"<(?:spirit|ipxact|kactus2):", "a component in IP-XACT"),
    (r"<device\b[^>]*\bschemaVersion=|<peripherals>", "a description of a chip (CMSIS-SVD)"),
    (r"<ISO15745Profile", "a device description in XML (XDD)"),
    (r"\A\s*<\?xml|\A\s*<(?!br)[A-Za-z!][\w:-]*[\s>/]", "XML, or HTML without a table"),
)
_KEY = re.compile(r"[A-Za-z_][\w/]*:(?: |$)")
_SECTION = re.compile(r"(?:[A-Za-z_][\w/-]*|([\"'])[\w.-]+\1):\s*$|- [A-Za-z_]\w*:(?: |$)")
_REFUSED = "which is not read as a list; write its registers as CSV, XLSX or JSON, a row for each"


def refuse_known_format(text: str) -> None:
    """Raises ListError for a text of a known format that is not a table."""
    head = text[:_LOOKED_AT].removeprefix("\ufeff")
    for pattern, name in _FORMATS:
        if re.search(pattern, head, re.MULTILINE):
            raise ListError(f"is {name}, {_REFUSED}")


def is_yaml(text: str) -> bool:
    """Whether a text begins with a key of YAML, or with a list of objects."""
    head = text[:_LOOKED_AT].removeprefix("\ufeff")
    lines = [line for line in head.splitlines() if line.strip() and not line.lstrip().startswith(("#", "---"))][:2]
    is_pair = len(lines) == 2 and all(_KEY.match(line) and not re.search(r"[,;\t|]", line) for line in lines)
    return bool(lines) and (is_pair or _SECTION.match(lines[0].strip()) is not None)
