"""What messages do with registers and values in pieces, and when fields are sent, as texts that changes compare."""

from __future__ import annotations

from fieldspec.foundation.classes import replace
from fieldspec.language.changes.comparison import Comparison, fields_beside
from fieldspec.language.model.record import STEP_FIELDS, Field, Message, Presence


def segments_text(comparison: Comparison | None, message: Message) -> str:
    """How the value of a message follows in pieces; with the new names of a comparison."""
    pieces = message.segments
    if pieces is None:
        return ""
    name = comparison.renamed_to("messages", pieces.message) if comparison is not None else pieces.message
    rows = {
        "size": _renamed(comparison, message, pieces.size) if comparison is not None else pieces.size,
        "data": pieces.data,
        "counter": pieces.counter,
        "unused": pieces.unused,
        "last": pieces.last,
        "when": " and ".join(pieces.when),
        "unsized": " and ".join(pieces.unsized),
    }
    abort = pieces.abort
    if abort is not None:
        ended = comparison.renamed_to("messages", abort.message) if comparison is not None else abort.message
        rows["abort"] = f"{ended} with {abort.reason} {abort.counter} or {abort.size}"
    return f"in {name} with {', '.join(f'{word} as {key}' for key, word in rows.items() if word)}"


def access_text(comparison: Comparison | None, message: Message) -> str:
    """How a message accesses registers; with the new names of a comparison."""
    access = message.single_access
    if access is None:
        return ""
    words = [access.start, access.count, access.values]
    if comparison is not None:
        words = [_renamed(comparison, message, word) for word in words]
    text = ", ".join(
        f"{word} as {part}" for word, part in zip(words, ("start", "count", "values"), strict=True) if word
    )
    bits = "" if (access.set, access.clear) == (None, 0) else f", a bit as {access.set} or {access.clear}"
    return f"{access.operation} with {text}{bits}"


def steps_text(comparison: Comparison | None, message: Message) -> str:
    """The steps in which a message accesses registers; with the new names of a comparison."""
    texts = []
    for step in message.access_steps:
        words = {key: getattr(step, key) for key in STEP_FIELDS if getattr(step, key)}
        space = step.space
        if comparison is not None:
            words = {key: _renamed(comparison, message, word) for key, word in words.items()}
            space = comparison.renamed_to("spaces", space) if space else ""
        names = ", ".join(f"{word} as {key}" for key, word in words.items())
        texts.append(f"{step.operation}{f' {space}' if space else ''} with {names}")
    return ", then ".join(texts)


def _renamed(comparison: Comparison, message: Message, name: str) -> str:
    """The new name of a field of the request or of the response."""
    request_name = comparison.renamed_to(f"messages/{message.name}/request", name)
    return request_name if request_name != name else comparison.renamed_to(f"messages/{message.name}/response", name)


SUBJECTS_OF_BITS = {
    "present_if": "what says whether it is sent",
    "more_if": "what says whether another element follows",
}
"""The meaning of the bits under each key."""


def bits_text(comparison: Comparison | None, holder_path: str, field: Field, key: str) -> str:
    """The bits under a key of a field, with the names of the new state; empty where none are."""
    presence = field.presence if key == "present_if" else field.continuation
    if presence is None:
        return ""
    if key == "present_if":
        return _bits_text(comparison, holder_path, presence, fields_beside(field, comparison.old) if comparison else ())
    element = comparison.old.records.get(field.record) if comparison is not None else None
    fields = (replace(field, name=""),) if element is None else element.fields
    return _bits_text(comparison, f"records/{field.record}", presence, fields)


def _bits_text(comparison: Comparison | None, holder_path: str, presence: Presence, fields: tuple[Field, ...]) -> str:
    """The bits or members of one of some fields that say that something is sent."""
    name = presence.by if comparison is None else comparison.renamed_to(holder_path, presence.by)
    enum = next((own.value.enum for own in fields if own.name == presence.by and own.value is not None), "")
    path = f"enums/{enum}"
    members = [comparison.renamed_to(path, own) if comparison is not None else own for own in presence.when]
    renamed = replace(presence, by=name or "each element", when=tuple(sorted(members)))
    return f"{renamed.subject} if it is {renamed.state}"
