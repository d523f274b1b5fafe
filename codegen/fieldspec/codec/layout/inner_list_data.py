"""The lists of records that have other fields after them, as programs in JavaScript have them."""

from __future__ import annotations

from fieldspec.codec.layout.continuation import continuation_data
from fieldspec.codec.layout.decision import Decision
from fieldspec.codec.layout.inner_lists import InnerList, InnerLists
from fieldspec.codec.layout.packing import packing_data
from fieldspec.codec.layout.presence import presence_data
from fieldspec.codec.layout.widths import order_data
from fieldspec.foundation.classes import TYPE_CHECKING

if TYPE_CHECKING:
    from typing import Any


def inner_lists_data(inner: InnerLists) -> dict[str, Any]:
    """The lists as programs in JavaScript have them."""
    return {"fixed": inner.fixed, "lists": [_inner_list_row(row) for row in inner.lists]}


def _inner_list_row(row: InnerList) -> dict[str, Any]:
    names = {"name": row.name} | ({"countName": row.count} if row.count else {})
    bounds = {"element": row.element, "least": row.least, "most": row.most}
    count = {"at": row.count_at, "length": row.count_size if row.count else 0, "unit": row.unit}
    plus = {"plus": row.plus} if row.plus else {}
    parts = {"parts": inner_lists_data(row.parts)} if row.parts is not None else {}
    decision = {"decision": _decision_row(row.decision)} if row.decision is not None else {}
    packing = {"packing": packing_data(row.packing)} if row.packing is not None else {}
    presence = {"presence": presence_data(row.presence)} if row.presence is not None else {}
    sent_plus = {"sentPlus": row.sent_plus} if row.sent_plus is not None else {}
    places = {"first": row.first, "room": row.room}
    continuation = {"more": continuation_data(row.continuation)} if row.continuation is not None else {}
    kinds = {**parts, **decision, **packing, **presence, **sent_plus, **continuation}
    return {**names, **places, **bounds, **count, **plus, **order_data(row.count_order), **kinds}


def _decision_row(row: Decision) -> dict[str, Any]:
    is_little = {"little": True} if row.order == "little" else {}
    mask = ({"mask": row.mask} if row.mask is not None else {}) | ({"marked": sorted(row.marked)} if row.marked else {})
    return {"name": row.name, "at": row.offset, "length": row.size, **is_little, **mask, "sizes": dict(row.sizes)}
