"""Words of flags: their bits, and the states that bits show together."""

from __future__ import annotations

from fieldspec.backends.c.comments import told
from fieldspec.backends.c.naming import Naming
from fieldspec.backends.c.text import comment, hexadecimal, indented
from fieldspec.model.enums import Bit, Flags


def named_bits(word: Flags) -> list[tuple[str, Bit]]:
    """The bits that have a meaning, by names that differ: bits of one name under several conditions are numbered."""
    found: dict[str, Bit] = {}
    for bit in word.bits:
        if bit.reserved or any(other.mask == bit.mask and other.name == bit.name for other in found.values()):
            continue
        name, number = bit.name, 1
        while name in found:
            number += 1
            name = f"{bit.name}_{number}"
        found[name] = bit
    return list(found.items())


def flags_lines(naming: Naming, word: Flags) -> list[str]:
    """Masks, shifts, and a function for each bit or field of bits; then the states."""
    number = f"uint{8 * word.type.size}_t"
    lines = told(word, f"A word of {8 * word.type.size} bits.")
    lines.append(f"typedef {number} {naming.type('word', word.name)};")
    for name, bit in named_bits(word):
        lines += ["", *_bit_lines(naming, word, name, bit)]
    if word.states:
        lines += ["", *_state_lines(naming, word)]
    return lines


def _bit_lines(naming: Naming, word: Flags, name: str, bit: Bit) -> list[str]:
    size = word.type.size
    number = f"uint{8 * size}_t"
    levels = [f"{n}: {text}." for n, text in ((0, bit.zero), (1, bit.one)) if text]
    facts = [
        " ".join(levels),
        f"Its {bit.edge} edge counts." if bit.edge else "",
        "It is 0 while what its name says is so." if bit.active == "low" else "",
        f"See {bit.enum}." if bit.enum else "",
        f"When {bit.when}." if bit.when else "",
    ]
    mask, shift = naming.macro("bit", word.name, name, "mask"), naming.macro("bit", word.name, name, "shift")
    lines = told(bit, *facts)
    lines += [f"#define {mask} {hexadecimal(bit.mask, size)}", f"#define {shift} {bit.first}u"]
    get = naming.function("bit", word.name, name)
    if bit.width == 1:
        return [
            *lines,
            f"static inline bool {get}({number} word)",
            "{",
            f"    return (word & {mask}) != 0;",
            "}",
        ]
    return [
        *lines,
        f"static inline {number} {get}({number} word)",
        "{",
        f"    return ({number})((word & {mask}) >> {shift});",
        "}",
        f"static inline {number} {naming.function('bit', word.name, 'with', name)}({number} word, {number} value)",
        "{",
        f"    return ({number})((word & ({number})~{mask}) | (({number})(value << {shift}) & {mask}));",
        "}",
    ]


def _state_lines(naming: Naming, word: Flags) -> list[str]:
    """Masks and values of the states, an enum of them, and the function that tells the first one that holds."""
    size, name = word.type.size, naming.type("word", word.name, "state")
    none = naming.macro("word", word.name, "no_state")
    lines = []
    for state in word.states:
        mask, value = word.masked(state)
        lines += told(state)
        lines += [
            f"#define {naming.macro('state', word.name, 'state', state.name, 'mask')} {hexadecimal(mask, size)}",
            f"#define {naming.macro('state', word.name, 'state', state.name, 'value')} {hexadecimal(value, size)}",
        ]
    lines += [*comment("The states that the word shows."), f"typedef enum {name} {{", f"    {none} = 0,"]
    for at, state in enumerate(word.states, 1):
        comma = "," if at < len(word.states) else ""
        lines.append(f"    {naming.macro('state', word.name, 'state', state.name)} = {at}{comma}")
    lines += [
        f"}} {name};",
        *comment("The first state whose bits the word has, in the order above."),
        f"static inline {name} {naming.function('word', word.name, 'state_of')}(uint{8 * size}_t word)",
        "{",
    ]
    for state in word.states:
        ones, held = (naming.macro("state", word.name, "state", state.name, end) for end in ("mask", "value"))
        test = f"(word & {ones}) == {held}"
        constant = naming.macro("state", word.name, "state", state.name)
        lines += indented([f"if ({test}) {{", f"    return {constant};", "}"])
    return [*lines, f"    return {none};", "}"]
