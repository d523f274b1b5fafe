"""The findings of a behaviour."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from collections.abc import Mapping as Table

from fieldspec.language.behaviour.names import Names
from fieldspec.language.behaviour.part import (
    ACTION_KEYS,
    BUILT_IN_EVENTS,
    PART_KEYS,
    STATED_KEYS,
    Behaviour,
    Part,
    Product,
)
from fieldspec.language.behaviour.reading import SECTION, behaviour_of, kinds_of
from fieldspec.language.checks.finding import is_imported
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_count
from fieldspec.language.reading.findings import near, quoted
from fieldspec.language.reading.nodes import Mapping, Scalar, mappings
from fieldspec.language.reading.yaml_reader import key_span

_CLEAR = "behaviour_clear"
_RESOLVES = "behaviour_resolves"
_STATED = "behaviour_stated"

Kinds = Table[str, tuple[frozenset[str], frozenset[str]]]


def findings(device: Device, tree: Mapping) -> list[Diagnostic]:
    """The findings of the behaviour in the tree of a version."""
    if SECTION not in tree.values:
        return []
    unclear = list(_unclear(tree))
    if unclear:
        return unclear
    behaviour = behaviour_of(tree)
    return [*_unstated(behaviour), *_Resolution(device, behaviour).findings()]


def _unclear(tree: Mapping) -> Iterator[Diagnostic]:
    names: set[str] = set()
    for node in mappings(tree.values.get(SECTION)):
        name = node.values.get("name")
        if isinstance(name, Scalar):
            if name.text in names:
                text = f"two parts have the name {quoted(name.text)}"
                yield Diagnostic(_CLEAR, text, name.span, help="rename one of them")
            names.add(name.text)
        yield from _unclear_keys(node, PART_KEYS, STATED_KEYS, "part")
        event = node.values.get("when")
        if "refused" in node.values and isinstance(event, Mapping) and "receive" not in event.values:
            text = (
                "`refused` goes without `when`, or with the messages whose requests are refused, `when: {receive: ..}`"
            )
            yield Diagnostic(_CLEAR, text, key_span(node, "refused"), help="name the messages, or remove `when`")
        for action in mappings(node.values.get("rule")):
            yield from _unclear_keys(action, ACTION_KEYS, frozenset(), "action")


def _unclear_keys(node: Mapping, kinds: Kinds, always: Collection[str], subject: str) -> Iterator[Diagnostic]:
    stated_kinds = kinds_of(node, kinds)
    if len(stated_kinds) != 1:
        span = key_span(node, stated_kinds[1]) if stated_kinds else (node.values.get("name") or node).span
        words = ", ".join(f"`{kind}`" for kind in kinds)
        text = (
            f"this {subject} has the kinds `{stated_kinds[0]}` and `{stated_kinds[1]}`"
            if stated_kinds
            else f"this {subject} has no kind"
        )
        yield Diagnostic(_CLEAR, text, span, help=f"it has one of {words}")
        return
    required, possible = kinds[stated_kinds[0]]
    for key in sorted(required - node.values.keys()):
        text = f"this {subject} with `{stated_kinds[0]}` needs `{key}`"
        yield Diagnostic(_CLEAR, text, key_span(node, stated_kinds[0]), help=f"add `{key}`")
    for key in node.values:
        if key not in {stated_kinds[0], *required, *possible, *always}:
            text = f"`{key}` does not go with `{stated_kinds[0]}`"
            yield Diagnostic(_CLEAR, text, key_span(node, key), help="remove it")


def _unstated(behaviour: Behaviour) -> Iterator[Diagnostic]:
    for part in behaviour.parts:
        if part.kind == "unmodelled" and not part.sources:
            text = f"{part.name} does not say where the manual states it"
            yield Diagnostic(_STATED, text, part.place["name"], help="add `source`")
        elif not part.sources and not part.assumed and not part.standard:
            text = f"{part.name} cites no source and states no assumption"
            help = "add `source`, `standard`, or `assumed` with what the manual does not print"
            yield Diagnostic(_STATED, text, part.place["name"], help=help)


def _exceptions(device: Device) -> set[str]:
    """The members that exception responses have, in their data or in the part that marks them, by name."""
    marks = [(link, link.exception_response) for link in device.links.values()]
    in_parts = {
        member.name
        for link, mark in marks
        if mark is not None and mark.part
        for part in link.parts("response")
        if part.name == mark.part and part.value is not None and part.value.enum in device.enums
        for member in device.enums[part.value.enum].members
        if mark.normal is None or member.value not in mark.normal
    }
    return in_parts | {
        member.name
        for link in device.links.values()
        if link.exception_response is not None and link.exception_response.record in device.records
        for field in device.records[link.exception_response.record].fields
        if field.value is not None and field.value.enum in device.enums and field.value.const is None
        for member in device.enums[field.value.enum].members
    }


class _Resolution:
    """Looks up every name of a behaviour."""

    def __init__(self, device: Device, behaviour: Behaviour) -> None:
        self.device, self.behaviour = device, behaviour
        self.names = Names(device, behaviour)
        actions = [action for part in behaviour.of_kind("rule") for action in part.subject]
        self.events = {*BUILT_IN_EVENTS, *(action.subject for action in actions if action.kind == "raise")}
        self.limits = {limit.place.path for limit in device.limits}
        self.groups = {group.name for group in device.groups}
        self.exceptions = _exceptions(device)

    def findings(self) -> Iterator[Diagnostic]:
        """A finding for each name that does not exist."""
        if not self.exceptions:
            yield from self._no_exceptions()
        for part in self.behaviour.parts:
            yield from self._part(part)
            for action in part.subject if part.kind == "rule" else ():
                yield from self._action(action)

    def _part(self, part: Part) -> Iterator[Diagnostic]:
        if part.kind in ("show", "initial", "answer"):
            yield from self._signal(part, part.kind, part.subject)
        if part.kind in ("show", "initial"):
            for key in ("value", "otherwise"):
                yield from self._value(part, key, part.get(key), part.subject)
                yield from self._number_findings(part, key, part.get(key))
        for key in ("at", "start"):
            yield from self._value(part, key, part.get(key))
        for key, value in part.subject.items() if part.kind == "axis" else ():
            yield from self._value(part, "axis", value) if key != "start" else ()
        yield from self._condition(part)
        yield from self._event(part)
        if part.get("mark") is not None:
            yield from self._mark(part, part["mark"])
        if part.kind == "refuse" and self.exceptions and part.get("with", "") not in ("", *self.exceptions):
            yield self._unknown(part, "with", "member of the exception response", part["with"], self.exceptions)
        if part.kind == "timing" and part["limit"] not in self.limits:
            yield self._unknown(part, "limit", "limit", part["limit"], self.limits)
        if part.kind == "collection":
            yield from self._collection(part)
        if part.kind == "answer" and part["from"] not in self.names.collections:
            yield self._unknown(part, "from", "collection", part["from"], self.names.collections)

    def _no_exceptions(self) -> Iterator[Diagnostic]:
        """One finding of all parts that refuse requests with an exception, where the device has none."""
        parts = [part for part in self.behaviour.of_kind("refuse") if part.get("with") is not None]
        if parts:
            own = next((part.place["with"] for part in parts if not is_imported(part.place, self.device)), None)
            names = ", ".join(part.name for part in parts)
            text = f"no link of {self.device.id} has an exception response with members, but {names} refuse with one"
            help = "state `exception_response` at a link, or under `uses` the link of the protocol that has it"
            yield Diagnostic(_RESOLVES, text, own or self.device.place["id"], help=help)

    def _collection(self, part: Part) -> Iterator[Diagnostic]:
        record = self.device.records.get(part.subject)
        if record is None:
            yield self._unknown(part, "collection", "record", part.subject, self.device.records)
        elif part.get("key") is not None and record.named(part["key"]) is None:
            yield self._unknown(part, "key", "field", part["key"], {field.name for field in record.fields})

    def _event(self, part: Part) -> Iterator[Diagnostic]:
        event = part.get("when") or {}
        for kind, name in event.items():
            if kind == "event" and name not in self.events:
                yield self._unknown(part, "when", "event", name, self.events)
            elif kind == "receive":
                for message in part.received:
                    if not self.names.of_message(message):
                        known = {f"messages/{key}" for key in self.device.messages}
                        yield self._unknown(part, "when", "message", message, known)
            elif kind in ("write", "rises", "falls"):
                yield from self._signal(part, "when", name)

    def _condition(self, part: Part) -> Iterator[Diagnostic]:
        for name, expected in (part.get("if") or {}).items():
            yield from self._signal(part, "if", name)
            for value in expected if isinstance(expected, tuple) else (expected,):
                if isinstance(value, str) and self.names.is_known(name) and not self.names.has_member(name, value):
                    text = f"`{name}` has no value {quoted(value)}"
                    yield Diagnostic(_RESOLVES, text, part.place["if"], help="name a member, a state or a number")

    def _action(self, action: Part) -> Iterator[Diagnostic]:
        kind = action.kind
        if kind in ("set", "record"):
            yield from self._signal(action, kind, action.subject)
            key = "to" if kind == "set" else "value"
            yield from self._value(action, key, action[key], action.subject)
        if kind == "insert":
            yield from self._signal(action, "of", action["of"])
        if kind in ("insert", "append", "remove") and action.subject not in self.names.collections:
            yield self._unknown(action, kind, "collection", action.subject, self.names.collections)
        if kind == "load" and action.subject not in {*self.names.collections, *self.device.tables}:
            known = {*self.names.collections, *self.device.tables}
            yield self._unknown(action, kind, "table or collection", action.subject, known)
        if kind == "copy":
            for key in ("copy", "to"):
                if action[key] not in {*self.groups, *self.device.tables}:
                    known = {*self.groups, *self.device.tables}
                    yield self._unknown(action, key, "table or group", str(action[key]), known)
        if kind == "enter" and action["state"] not in self.names.machines.get(action.subject, ()):
            known = {f"{name}: {state}" for name, states in self.names.machines.items() for state in states}
            yield self._unknown(action, "state", "state", f"{action.subject}: {action['state']}", known)
        for key in ("speed", "acceleration", "deceleration", "after", "at", "count", "place"):
            yield from self._value(action, key, action.get(key))
        if kind == "move":
            yield from self._value(action, "to", action.get("to"))
        for value in action.get("values", {}).values():
            yield from self._value(action, "values", value)

    def _value(self, part: Part, key: str, value: object, signal: str = "") -> Iterator[Diagnostic]:
        terms = value.terms() if isinstance(value, Product) else (value,)
        for term in terms:
            if (
                not isinstance(term, str)
                or self.names.is_known(term)
                or (signal and self.names.has_member(signal, term))
            ):
                continue
            expected = f"signal, and no value of `{signal}`," if signal else "signal"
            yield self._unknown(part, key, expected, term, ())

    def _number_findings(self, part: Part, key: str, number: object) -> Iterator[Diagnostic]:
        """Whether what has the signal of a part can carry a number."""
        if not isinstance(number, int) or isinstance(number, bool):
            return
        for operand in self.names.of_signal(part.subject):
            value = operand.value
            is_whole = value is not None and is_count(value.encoding)
            own = operand.bit or (value if is_whole else None)
            if own is not None and not own.low <= number <= own.high:
                text = f"{operand.path} carries {own.low}..{own.high}, and not {number}"
                help = "state the number as it is sent, or another one that fits"
                yield Diagnostic(_RESOLVES, text, part.place[key], help=help)
                return

    def _mark(self, part: Part, name: str) -> Iterator[Diagnostic]:
        operands = self.names.of_signal(name)
        if not operands:
            yield from self._signal(part, "mark", name)
        elif any(operand.bit is None or operand.bit.width > 1 for operand in operands):
            text = f"{quoted(name)} is not a single bit, so it cannot mark a refusal"
            help = "name a bit, or state `exception_response: {part: ..}` at the link"
            yield Diagnostic(_RESOLVES, text, part.place["mark"], help=help)

    def _signal(self, part: Part, key: str, name: str) -> Iterator[Diagnostic]:
        if not self.names.is_known(name):
            yield self._unknown(part, key, "signal", name, self.names.like(name))

    def _unknown(self, part: Part, key: str, expected: str, name: str, known: Collection[str]) -> Diagnostic:
        help = near(name, known) if known else "name a role, a path, or a member"
        return Diagnostic(_RESOLVES, f"there is no {expected} {quoted(name)}", part.place[key], help=help)
