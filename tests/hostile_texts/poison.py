"""Texts that try to leave the place where an output has them: what ends comments, texts and markup in each language."""

from __future__ import annotations

import random
import re

FRAGMENTS: dict[str, tuple[str, ...]] = {
    "python": ('"""', "'''", '"', "'", "\\", "\\N{DOLLAR SIGN}", "# x", "{0.__class__}", "%(a)s", "\\x00", "f'{1/0}'"),
    "c": ("*/", "/*", "//", "??/", "??'", "\\", "??*??/", "#define int", "\\u0022", "*\\\n/", '"); abort(); ("'),
    "html": (
        "</script>",
        "<script>alert(1)</script>",
        "<!--",
        "-->",
        "]]>",
        "<img src=x onerror=alert(1)>",
        "&lt;",
        "&#0;",
    ),
    "attribute": (
        '" onmouseover="alert(1)',
        "' autofocus onfocus='alert(1)",
        "javascript:alert(1)",
        "</style>",
        "</title>",
    ),
    "javascript": (
        "${alert(1)}",
        "`",
        "\\u2028",
        "\u2028",
        "\u2029",
        "</script",
        "//# sourceMappingURL=x",
        "*/ alert(1) /*",
    ),
    "markdown": (
        "|",
        "`",
        "``` x",
        "*x*",
        "[a](javascript:alert(1))",
        "![x](y)",
        "# x",
        "- x",
        "1. x",
        "<b>",
        "---",
        "\\|",
        "> x",
        "~~~",
    ),
    "st": ("*)", "(*", "$'", "$", "'", "$N", "{attribute 'x'}", "END_VAR", "END_TYPE;", "//", '"', '$"'),
    "xml": ("]]>", "<a>", "&amp;", "&x;", "<?php", "<!DOCTYPE a>", "<![CDATA[", "\ufffd"),
    "csv": ("=1+1", "+1", "-1", "@SUM(A1)", "\t=1", ";", ",", '"', "=cmd|' /C calc'!A0", "\uff1d1"),
    "sql": ("'; DROP TABLE registers; --", "''", "\\'", "1 OR 1=1"),
    "lua": ("]]", "[[", "]=]", "--]]", "--[[", "\\z", "\\065", "os.exit()"),
    "yaml": (
        ": x",
        " #x",
        "- x",
        "!!python/object:os.system",
        "&a",
        "*a",
        "%YAML",
        "...",
        "---",
        "{",
        "[",
        "|",
        ">",
        "? x",
    ),
    "shell": ("$(reboot)", "`reboot`", "; reboot", "| reboot", "&& reboot", "\\", "!x", "${IFS}", "~", "*"),
    "terminal": (
        "\x1b[31m",
        "\x1b]0;x\x07",
        "\x9b31m",
        "\x08\x08",
        "\r",
        "\x7f",
        "\u202e",
        "\u2066",
        "\u200b",
        "\ufeff",
    ),
    "actions": ("\n::error file=a::pwned\n", "::error::pwned", "##[error]pwned", "%0A::error::pwned"),
    "template": ("{{ 7 * 7 }}", "{% raw %}", "{# x #}", "{%- endraw %}", "%s", "%n", "{n}", "{value:03X}"),
    "letters": ("伺服", "é", "🤖", "ß", "İ", "ﬁ", "e\u0301", "\u0130\u0307"),
}
"""By the language in which they mean something."""

ENDS = ("\\", '"', "'", "*", "`", "$", "-", "]", "?", "/", "<", "\\\\")


def poison(chance: random.Random) -> str:
    """A text of some fragments of any languages."""
    names = chance.sample(list(FRAGMENTS), chance.randint(1, 4))
    pieces = [chance.choice(FRAGMENTS[name]) for name in names]
    text = chance.choice(("", " ", "\n", "x")).join(pieces)
    return text + (chance.choice(ENDS) if chance.random() < 0.3 else "")


def harmless(text: str) -> str:
    """A text of the same form without meaning in any language: lines and spaces are where they were, and letters."""
    return re.sub(r"[^\x00-\x7f]", "é", re.sub(r"[!-~\x00-\x09\x0b-\x1f\x7f]", "x", text))
