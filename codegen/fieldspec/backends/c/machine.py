"""What a header makes of the compiler and the machine: how functions are inlined, bytes copied, numbers stored."""

from __future__ import annotations

from fieldspec.backends.c.naming import Naming
from fieldspec.backends.c.text import comment

OWN_MACROS = ("inline", "likely", "copy", "clear", "stores_at_once")

_AT_ONCE = "__x86_64__", "__i386__", "__aarch64__", "__ARM_FEATURE_UNALIGNED"


def machine_lines(naming: Naming) -> list[str]:
    """The macros that the rest of a header is written with."""
    inline, likely, copy, clear, at_once = (naming.own_macro(name) for name in OWN_MACROS)
    machines = " || ".join(f"defined({name})" for name in _AT_ONCE)
    return [
        "#ifdef __GNUC__",
        *comment("A call of these functions would take more than what they do, even where size counts."),
        f"#define {inline} static inline __attribute__((always_inline))",
        f"#define {likely}(test) __builtin_expect(!!(test), 1)",
        *comment(
            "Built in: without string.h, and without a call for a few bytes, where the compiler is a freestanding one."
        ),
        f"#define {copy}(to, from, size) __builtin_memcpy((to), (from), (size))",
        f"#define {clear}(to, size) __builtin_memset((to), 0, (size))",
        "#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__ && \\",
        f"    ({machines})",
        *comment(
            "Numbers are stored at once. The compiler turns loads byte by byte into one by itself, and stores too, but "
            "not where it knows that it may change their order: then it makes vectors, which take up to four times "
            "as long."
        ),
        f"#define {at_once}",
        "#endif",
        "#else",
        "#include <string.h>",
        f"#define {inline} static inline",
        f"#define {likely}(test) (test)",
        f"#define {copy}(to, from, size) memcpy((to), (from), (size))",
        f"#define {clear}(to, size) memset((to), 0, (size))",
        "#endif",
    ]


def copied(naming: Naming, target: str, source: str, size: str) -> str:
    """The statement that copies bytes from one place to another, which do not overlap."""
    return f"{naming.own_macro('copy')}({target}, {source}, {size});"


def cleared(naming: Naming, target: str, size: str) -> str:
    """The statement that fills bytes with zeros."""
    return f"{naming.own_macro('clear')}({target}, {size});"
