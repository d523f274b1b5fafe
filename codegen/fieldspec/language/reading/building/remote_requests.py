"""Remote requests of CAN buses: the number of bytes that they ask for is the only field of the message."""

from __future__ import annotations

from fieldspec.language.reading.building.context import Entry
from fieldspec.language.reading.nodes import Mapping, Node, Scalar, Sequence


def with_remote_request(entry: Entry) -> Entry:
    """The entry of a message, whose request has the field of a remote request where it states one."""
    stated = entry.node.values.get("remote")
    if not isinstance(stated, Scalar) or entry.maybe("requested") is False:
        return entry
    for key in ("request", "accesses", "segments"):
        if key in entry.own:
            text = f"a remote request has no data, but the message has `{key}`"
            entry.refuse("wrong_form", key, text, f"remove `{key}`, or `remote`")
    for key in ("frame_length", "data_words"):
        lengths = entry.entry(key)
        if lengths is not None and "request" in lengths.own:
            text = f"a remote request has no data, but the `{key}` of the message has a request"
            entry.refuse("wrong_form", key, text, "remove the request there, or `remote`")
    values: dict[str, Node] = {
        key: Scalar(stated.file, stated.start, stated.end, str(value), False, value)
        for key, value in (("name", "dlc"), ("type", "u8"), ("const", stated.value))
    }
    values["remote"] = stated
    field = Mapping(stated.file, stated.start, stated.end, values, dict.fromkeys(values, stated))
    node = entry.node.with_value("request", Sequence(stated.file, stated.start, stated.end, (field,)))
    return Entry(node, entry.path, entry.findings, entry.section, entry.sources)
