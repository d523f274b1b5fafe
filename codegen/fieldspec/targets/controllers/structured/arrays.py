"""Arrays that routines receive by reference, as named types, because an argument must have exactly the bounds of its
parameter.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from fieldspec.targets.controllers.dialects import Spelling
from fieldspec.targets.controllers.routines.printer import array_name, comment, type_text
from fieldspec.targets.controllers.statements.expressions import ArrayType, Type
from fieldspec.targets.controllers.statements.routine import Routine
from fieldspec.targets.controllers.structured.objects import Item


def lent_arrays(routines: Iterable[Routine]) -> frozenset[ArrayType]:
    """The types of the arrays that routines have as VAR_IN_OUT."""
    declared = (declared for routine in routines for declared in routine.of_role("in_out"))
    return frozenset(item.variable.type for item in declared if isinstance(item.variable.type, ArrayType))


def named_arrays(kinds: Iterable[Type], spelling: Spelling, known: set[str]) -> Iterator[ArrayType]:
    """The arrays that have a name, as far as it is not known yet; each after those that lie in it."""
    for kind in kinds:
        if not isinstance(kind, ArrayType):
            continue
        yield from named_arrays([kind.of], spelling, known)
        if kind in spelling.named:
            name = array_name(kind, spelling)
            if name not in known:
                known.add(name)
                yield kind


def array_item(kind: ArrayType, spelling: Spelling) -> Item:
    """The declaration of an array type with a name."""
    title = "For arguments: the bounds of an array must equal the parameter's."
    bounds = f"ARRAY[{kind.low}..{kind.high}] OF {type_text(kind.of, spelling)}"
    lines = (*comment(title), f"TYPE {array_name(kind, spelling)} : {bounds};", "END_TYPE")
    return Item(array_name(kind, spelling), "type", "arrays", lines)
