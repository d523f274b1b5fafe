"""The actions of rules, by their kind."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from decimal import Decimal

from fieldspec.behaviour.part import Part
from fieldspec.layout.values import Raw
from fieldspec.model.quantity import real_text
from fieldspec.model.registers import RegisterGroup
from fieldspec.simulator.operation import Operation
from fieldspec.simulator.refusal import Refusal


def _set(operation: Operation, action: Part) -> None:
    for cell in (cell for name in operation.cells.elements(action.subject) for cell in operation.cells.of(name)):
        cell.write(operation.raw(cell, action["to"]))


def _enter(operation: Operation, action: Part) -> None:
    if operation.states[action.subject] != action["state"]:
        operation.states[action.subject] = action["state"]
        operation.tell("state", f"{action.subject}: {action['state']}")


def _seconds(operation: Operation, action: Part, key: str) -> float:
    return max(0.0, float(operation.number(action.get(key, 0))))


def _move(operation: Operation, action: Part) -> None:
    kind, axis, now = action.subject, operation.axis, operation.now
    signed = float(operation.number(action["speed"]))
    speed = abs(signed)
    rise, fall = (
        _seconds(operation, action, key) / speed if speed else 0.0 for key in ("acceleration", "deceleration")
    )
    target = float(operation.number(action.get("to", 0)))
    operation.tell(
        "move", f"{kind} at {real_text(signed)}" + (f" to {real_text(target)}" if "to" in action.keys else "")
    )
    if kind == "endless":
        axis.run(now, signed, rise, fall, operation.limits())
    elif kind == "home":
        axis.home_position = target
        axis.homed = False
        axis.move(now, axis.machine_zero, speed, rise, fall, operation.limits(), "home")
    else:
        goal = target if kind == "absolute" else axis.position(now) + target
        axis.move(now, goal, speed, rise, fall, operation.limits(), "move")


def _stop(operation: Operation, action: Part) -> None:
    if not operation.axis.moving:
        return
    present = abs(operation.axis.speed(operation.now))
    fall = _seconds(operation, action, "deceleration") / present if present and action.subject == "decelerated" else 0.0
    operation.tell("move", "stop")
    operation.axis.stop(operation.now, fall)


def _place(operation: Operation, action: Part) -> None:
    operation.axis.place(operation.now, float(operation.number(action.subject)))


def _raise(operation: Operation, action: Part) -> None:
    operation.raise_event(action.subject, _seconds(operation, action, "after"))


def _load(operation: Operation, action: Part) -> None:
    number = round(operation.number(action["at"]))
    operation.element = _element(operation, action.subject, number)


def _element(operation: Operation, name: str, number: int) -> dict[str, Raw]:
    """The raw values of a record of a table or a collection. Raises Refusal where there is none."""
    table = operation.layout.tables.get(name)
    if table is None:
        collection = operation.behaviour.named("collection", name)
        key = collection.get("key") if collection is not None else None
        for record in operation.memory.lists.get(name, ()):
            if key is not None and record.get(key) == number:
                return dict(record)
        raise Refusal("value_invalid", f"{name} has no record {number}")
    if number not in table.table.indexes:
        raise Refusal("value_invalid", f"{name} has no record {number}")
    first = table.table.address(number)
    space = operation.layout.device.space_name(table.table.space)
    occupants = [
        (field.name, occupant)
        for field in table.record.fields
        for occupant in operation.memory.at(space, first + field.offset // 2)
        if occupant.fact is field.field and occupant.address == first + field.offset // 2
    ]
    if any(operation.memory.is_absent(occupant) for _, occupant in occupants):
        raise Refusal("value_invalid", f"{name} has no record {number} now")
    return {field: operation.memory.read(space, occupant) for field, occupant in occupants}


def _copy(operation: Operation, action: Part) -> None:
    words, to = operation.memory.words, action["to"]
    sources, targets = _addresses(operation, action.subject, to), _addresses(operation, to, action.subject)
    for (space, old), (_, new) in zip(sources, targets, strict=False):
        words[space, new] = words[space, old]
        operation.saved[space, new] = words[space, new]


def _addresses(operation: Operation, name: str, other: str) -> list[tuple[str, int]]:
    """The addresses of a table, or of the registers of a group that are in the other group too, in the same order."""
    device = operation.layout.device
    table = device.tables.get(name)
    if table is not None:
        words = operation.layout.tables[name].words
        return [
            (device.space_name(table.space), table.address(index) + word)
            for index in table.indexes
            for word in range(words)
        ]
    groups: dict[str, RegisterGroup] = {group.name: group for group in device.groups}
    own, its = groups[name], groups[other]
    pairs = {register.copy_of: register for register in (*own.registers, *its.registers) if register.copy_of}
    result = []
    for register in own.registers:
        original_name = register.copy_of or register.name
        if original_name in pairs:
            space = device.space_name(register.space)
            result += [(original_name, space, register.address + word) for word in range(register.width)]
    return [(space, address) for _, space, address in sorted(result)]


def _save(operation: Operation, action: Part) -> None:
    for (space, address), present in operation.memory.occupants.items():
        if any(occupant.access != "ro" and not occupant.trigger for occupant in present):
            operation.saved[space, address] = operation.memory.words[space, address]
    operation.saved_elements = dict(operation.memory.elements)


def _record(operation: Operation, action: Part) -> None:
    cells = operation.cells.of(action.subject)
    if not cells:
        return
    places = [operation.cells.of(name)[0] for name in operation.cells.elements(action.subject)]
    raw = operation.raw(cells[0], action["value"])
    old = [place.read() for place in places]
    if action["newest"] == "first":
        new = [raw, *old[:-1]]
    elif 0 in old:
        free = old.index(0)
        new = [*old[:free], raw, *old[free + 1 :]]
    else:
        new = [*old[1:], raw]
    for place, content in zip(places, new, strict=True):
        place.write(content)
        for address in range(place.occupant.address, place.occupant.address + place.occupant.words):  # type: ignore[attr-defined]
            key = (place.space, address)  # type: ignore[attr-defined]
            operation.saved[key] = operation.memory.words[key]


def _insert(operation: Operation, action: Part) -> None:
    carried = operation.memory.lists.get(action["of"], [])
    collection = operation.behaviour.named("collection", action.subject)
    key = collection.get("key") if collection is not None else None
    records = operation.memory.lists.setdefault(action.subject, [])
    for new in carried:
        records[:] = [record for record in records if key is None or record[key] != new[key]]
        records.append(dict(new))
    if key is not None:
        records.sort(key=lambda record: record[key])  # type: ignore[arg-type,return-value]


def _append(operation: Operation, action: Part) -> None:
    collection = operation.behaviour.named("collection", action.subject)
    records = operation.memory.lists.setdefault(action.subject, [])
    raw: dict[str, Raw] = {}
    for field, value in action["values"].items():
        number = operation.number(value)
        raw[field] = int(number) if isinstance(number, float | Decimal) else number
    records.insert(0, raw)
    maximum = collection.get("most") if collection is not None else None
    del records[maximum or len(records) :]


def _remove(operation: Operation, action: Part) -> None:
    collection = operation.behaviour.named("collection", action.subject)
    key = collection.get("key") if collection is not None else None
    records = operation.memory.lists.setdefault(action.subject, [])
    if key is None or action.get("at") is None:
        records.clear()
        return
    first = round(operation.number(action["at"]))
    numbers = range(first, first + round(operation.number(action.get("count", 1))))
    records[:] = [record for record in records if record[key] not in numbers]


def _restart(operation: Operation, action: Part) -> None:
    operation.power_on()


def _refuse(operation: Operation, action: Part) -> None:
    raise Refusal(action.subject)


ACTIONS: Mapping[str, Callable[[Operation, Part], None]] = {
    "set": _set,
    "enter": _enter,
    "move": _move,
    "stop": _stop,
    "place": _place,
    "raise": _raise,
    "load": _load,
    "copy": _copy,
    "save": _save,
    "record": _record,
    "insert": _insert,
    "append": _append,
    "remove": _remove,
    "restart": _restart,
    "refuse": _refuse,
}
