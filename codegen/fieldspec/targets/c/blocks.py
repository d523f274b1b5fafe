"""Blocks of declarations, and the text of each, which stays where a block follows from unchanged facts."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Sequence
from functools import partial

from fieldspec.foundation.classes import dataclass
from fieldspec.targets.c.declarations import Declaration, parted
from fieldspec.targets.c.naming import Naming
from fieldspec.targets.c.printer import Printer
from fieldspec.targets.pieces import piece

Block = Sequence[Declaration]
"""Declarations that belong together: an empty line parts them from others."""


@dataclass(frozen=True, slots=True)
class FactBlock:
    """The declarations of a fact, which depend on `facts` of the model, on `words`, and on names alone.

    Those of a few facts together are `blocks` of their own.
    """

    kind: str
    facts: tuple[object, ...]
    words: tuple[Hashable, ...]
    declare: Callable[[], Block] = tuple
    blocks: Callable[[], Iterable[FactBlock]] = tuple


def print_block(printer: Printer, naming: Naming, block: Block | FactBlock) -> tuple[str, str]:
    """The constants of declarations, and the rest of them, each after an empty line; empty where there is none."""
    if isinstance(block, FactBlock):
        make = partial(_print_blocks, printer, naming, block)
        return piece(f"c {block.kind}", block.facts, block.words, make, naming)
    constants, rest = parted(block)
    return _print_lines(printer, constants), _print_lines(printer, rest)


def _print_blocks(printer: Printer, naming: Naming, block: FactBlock) -> tuple[str, str]:
    """The same of a block as it declares it, with the blocks in it."""
    blocks: list[Block | FactBlock] = [block.declare(), *block.blocks()]
    pairs = [print_block(printer, naming, inner) for inner in blocks]
    return "".join([constants for constants, _ in pairs]), "".join([rest for _, rest in pairs])


def _print_lines(printer: Printer, declarations: Block) -> str:
    return "\n".join(["", *printer.print_declarations(declarations), ""]) if declarations else ""
