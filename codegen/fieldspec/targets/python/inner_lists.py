"""The definition of the lists of a record that have other fields after them."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.codec.layout.continuation import Continuation
from fieldspec.codec.layout.decision import Decision
from fieldspec.codec.layout.inner_lists import InnerList, InnerLists
from fieldspec.codec.layout.packing import Packing
from fieldspec.codec.layout.presence import PresenceLayout
from fieldspec.targets.python.slots import Slots
from fieldspec.targets.python.text import filled, literal
from fieldspec.targets.python.writing import tuple_of


def inner_lists_lines(variable: str, name: str, lists: Sequence[Slots], inner: InnerLists, letters: str) -> list[str]:
    """The definition of the lists of a record, in the order of the wire; `letters` are the letters of
    all other fields.
    """
    by_name = {field.title: field for field in lists}
    rows = [_inner_list_row(own, by_name[own.name].letters) for own in inner.lists]
    return filled(f"{variable} = _InnerLists(", [literal(name), literal(letters), *rows], ")", 0)


def _inner_list_row(inner: InnerList, letters: str = "") -> str:
    """`_InnerList("H", 2, (0, 4), 2, 7)`: see the class."""
    bounds = (inner.least // inner.element, inner.most // inner.element)
    order = literal(inner.count_order)
    count = f", ({inner.count_at}, {inner.count_size}, {order}, {inner.unit}, {inner.plus})" if inner.count else ""
    parts = f", parts={_parts(inner.parts)}" if inner.parts is not None else ""
    decision = f", decision={_decision(inner.decision)}" if inner.decision is not None else ""
    packing = f", packing={_packing(inner.packing)}" if inner.packing is not None else ""
    presence = f", presence={_presence(inner.presence)}" if inner.presence is not None else ""
    sent_plus = f", sent_plus={inner.sent_plus}" if inner.sent_plus is not None else ""
    continuation = f", more={_more(inner.continuation)}" if inner.continuation is not None else ""
    places = f"{inner.first}, {inner.room}{count}"
    options = f"{parts}{decision}{packing}{presence}{sent_plus}{continuation}"
    return f"_InnerList({literal(letters)}, {inner.element}, {bounds}, {places}{options})"


def _more(continuation: Continuation) -> str:
    """`_More(0, 1, "big", 128, (128,))`: what an element says of the next one."""
    presence = continuation.presence
    place = f"{continuation.offset}, {continuation.size}, {literal(continuation.order)}"
    return f"_More({place}, {presence.mask}, {tuple_of(presence.numbers)})"


def _presence(presence: PresenceLayout) -> str:
    """`(8, (8,))`: the bits of a number that say whether the only element is sent, and with which numbers it is; none
    if the bits have the count.
    """
    return f"({presence.mask}, {tuple_of(presence.numbers)})"


def _packing(packing: Packing) -> str:
    """`_Packing(12, 2, "big")`: how the numbers of a list follow each other in bits."""
    signed = ", signed=True" if packing.number.sign.is_signed else ""
    return f"_Packing({packing.number.bits}, {packing.size}, {literal(packing.order)}{signed})"


def _decision(decision: Decision) -> str:
    """`_Decision("kind", 0, 1, "big", {1: 2})`: what decides the size of the only element."""
    place = f"{decision.offset}, {decision.size}, {literal(decision.order)}"
    mask = f", {decision.mask}" if decision.mask is not None else ""
    marked = f", marked={tuple_of(map(str, sorted(decision.marked)))}" if decision.marked else ""
    return f"_Decision({literal(decision.name)}, {place}, {dict(decision.sizes)}{mask}{marked})"


def _parts(parts: InnerLists) -> str:
    """`_Parts(3, _InnerList(...))`: what tells the size of an element."""
    return f"_Parts({', '.join([str(parts.fixed), *map(_inner_list_row, parts.lists)])})"
