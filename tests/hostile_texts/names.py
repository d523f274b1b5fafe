"""Names that try to be more than names, and judges of what is printed: a terminal, and the runner of actions."""

from __future__ import annotations

import random
import re
import unicodedata
from collections.abc import Iterator

from hostile_texts.poison import poison

COMMAND = "::error file=a,line=1::pwned"
NAMES = (
    f"x\n{COMMAND}",
    f"{COMMAND}\n",
    f"  {COMMAND}",
    "a\n##[add-mask]b",
    "\x1b]0;title\x07\x1b[31m\x9b2J\x08\r\x7f",
    "\u202egnp\u2066x\u2069\u200f\u061c",
    "\udcff\udc80",
    "line\u2028paragraph\u2029next\x85",
)
"""Names of files on Linux, each of another kind; those with lone surrogates are not UTF-8."""
BIDIRECTIONAL = {
    unicodedata.lookup(name)
    for name in (
        *("ARABIC LETTER MARK", "LEFT-TO-RIGHT MARK", "RIGHT-TO-LEFT MARK"),
        *(
            f"{way}-TO-{other} {kind}"
            for kind in ("EMBEDDING", "OVERRIDE", "ISOLATE")
            for way, other in (("LEFT", "RIGHT"), ("RIGHT", "LEFT"))
        ),
        *("POP DIRECTIONAL FORMATTING", "FIRST STRONG ISOLATE", "POP DIRECTIONAL ISOLATE"),
    )
}
"""The characters with the property Bidi_Control, as PropList.txt of Unicode has them."""


def random_names(seed: int, count: int) -> Iterator[str]:
    """Names of random fragments, which a file on Linux can have."""
    chance = random.Random(seed)
    for _ in range(count):
        text = poison(chance) + chance.choice(("", f"\n{COMMAND}", "\n##[error]x"))
        name = text.replace("/", "|").replace("\0", "").encode("utf-8", "surrogateescape")[:120]
        yield name.decode("utf-8", "surrogateescape") or "x"


def acting(text: str) -> set[str]:
    """The characters of an output that act on a terminal: controls but line feeds, and what changes the order."""
    return {char for char in text if unicodedata.category(char) in ("Cc", "Cs", "Zl", "Zp")} - {"\n"} | (
        BIDIRECTIONAL & {*text}
    )


_REGISTERED = (
    *("add-mask", "add-matcher", "add-path", "debug", "echo", "endgroup", "error", "group", "notice", "remove-matcher"),
    *("save-state", "set-env", "set-output", "stop-commands", "warning"),
)
_COMMAND = re.compile(r"\s*::(?P<name>[^ :]+)(?: (?P<properties>.*?))?::(?P<data>.*)")
_OLD_COMMAND = re.compile(r".*?##\[(?P<name>[^ \]]+)(?: (?P<properties>.*?))?\](?P<data>.*)")


def workflow_commands(text: str) -> list[tuple[str, dict[str, str], str]]:
    """The commands in a log as `ActionCommand.cs` of actions/runner reads them: names, properties and data."""
    commands = []
    for line in re.split("[\r\n]", text):
        match = _COMMAND.fullmatch(line) or _OLD_COMMAND.fullmatch(line)
        if match is not None and match["name"] in _REGISTERED:
            pairs = (pair.partition("=") for pair in (match["properties"] or "").split(",") if pair)
            properties = {key.strip(): _unescaped(value) for key, _, value in pairs}
            commands.append((match["name"], properties, _unescaped(match["data"])))
    return commands


def _unescaped(text: str) -> str:
    for escape, char in (("%0D", "\r"), ("%0A", "\n"), ("%3A", ":"), ("%2C", ","), ("%25", "%")):
        text = text.replace(escape, char)
    return text
