"""The actions of rules, by their kind."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from decimal import Decimal

from fieldspec.behaviour.part import Part
from fieldspec.classes import TYPE_CHECKING
from fieldspec.layout.values import Raw
from fieldspec.model.quantity import real_text
from fieldspec.model.registers import RegisterGroup
from fieldspec.simulator.refusal import Refusal
from fieldspec.simulator.registers import is_absent

if TYPE_CHECKING:
    from fieldspec.simulator.engine import Engine


def _set(engine: Engine, action: Part) -> None:
    for cell in (cell for name in engine.cells.elements(action.subject) for cell in engine.cells.of(name)):
        cell.write(engine.raw(cell, action["to"]))


def _enter(engine: Engine, action: Part) -> None:
    if engine.states[action.subject] != action["state"]:
        engine.states[action.subject] = action["state"]
        engine.tell("state", f"{action.subject}: {action['state']}")


def _seconds(engine: Engine, action: Part, key: str) -> float:
    return max(0.0, float(engine.number(action.get(key, 0))))


def _move(engine: Engine, action: Part) -> None:
    kind, axis, now = action.subject, engine.axis, engine.now
    signed = float(engine.number(action["speed"]))
    speed = abs(signed)
    rise, fall = (_seconds(engine, action, key) / speed if speed else 0.0 for key in ("acceleration", "deceleration"))
    target = float(engine.number(action.get("to", 0)))
    engine.tell("move", f"{kind} at {real_text(signed)}" + (f" to {real_text(target)}" if "to" in action.keys else ""))
    if kind == "endless":
        axis.run(now, signed, rise, fall, engine.limits())
    elif kind == "home":
        axis.home_position = target
        axis.homed = False
        axis.move(now, axis.machine_zero, speed, rise, fall, engine.limits(), "home")
    else:
        goal = target if kind == "absolute" else axis.position(now) + target
        axis.move(now, goal, speed, rise, fall, engine.limits(), "move")


def _stop(engine: Engine, action: Part) -> None:
    if not engine.axis.moving:
        return
    present = abs(engine.axis.speed(engine.now))
    fall = _seconds(engine, action, "deceleration") / present if present and action.subject == "decelerated" else 0.0
    engine.tell("move", "stop")
    engine.axis.stop(engine.now, fall)


def _place(engine: Engine, action: Part) -> None:
    engine.axis.place(engine.now, float(engine.number(action.subject)))


def _raise(engine: Engine, action: Part) -> None:
    engine.raise_event(action.subject, _seconds(engine, action, "after"))


def _load(engine: Engine, action: Part) -> None:
    number = round(engine.number(action["at"]))
    engine.element = _element(engine, action.subject, number)


def _element(engine: Engine, name: str, number: int) -> dict[str, Raw]:
    """The raw values of a record of a table or a collection. Raises Refusal where there is none."""
    table = engine.layout.tables.get(name)
    if table is None:
        collection = engine.behaviour.named("collection", name)
        key = collection.get("key") if collection is not None else None
        for record in engine.memory.lists.get(name, ()):
            if key is not None and record.get(key) == number:
                return dict(record)
        raise Refusal("value_invalid", f"{name} has no record {number}")
    if number not in table.table.indexes:
        raise Refusal("value_invalid", f"{name} has no record {number}")
    first = table.table.address(number)
    space = engine.layout.device.space_name(table.table.space)
    occupants = [
        (field.name, occupant)
        for field in table.record.fields
        for occupant in engine.memory.at(space, first + field.offset // 2)
        if occupant.fact is field.field and occupant.address == first + field.offset // 2
    ]
    if any(is_absent(engine, occupant) for _, occupant in occupants):
        raise Refusal("value_invalid", f"{name} has no record {number} now")
    return {field: engine.memory.read(space, occupant) for field, occupant in occupants}


def _copy(engine: Engine, action: Part) -> None:
    words, to = engine.memory.words, action["to"]
    sources, targets = _addresses(engine, action.subject, to), _addresses(engine, to, action.subject)
    for (space, old), (_, new) in zip(sources, targets, strict=False):
        words[space, new] = words[space, old]
        engine.saved[space, new] = words[space, new]


def _addresses(engine: Engine, name: str, other: str) -> list[tuple[str, int]]:
    """The addresses of a table, or of the registers of a group that are in the other group too, in the same order."""
    device = engine.layout.device
    table = device.tables.get(name)
    if table is not None:
        words = engine.layout.tables[name].words
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


def _save(engine: Engine, action: Part) -> None:
    for (space, address), present in engine.memory.occupants.items():
        if any(occupant.access != "ro" and not occupant.trigger for occupant in present):
            engine.saved[space, address] = engine.memory.words[space, address]
    engine.saved_elements = dict(engine.memory.elements)


def _record(engine: Engine, action: Part) -> None:
    cells = engine.cells.of(action.subject)
    if not cells:
        return
    places = [engine.cells.of(name)[0] for name in engine.cells.elements(action.subject)]
    raw = engine.raw(cells[0], action["value"])
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
            engine.saved[key] = engine.memory.words[key]


def _insert(engine: Engine, action: Part) -> None:
    carried = engine.memory.lists.get(action["of"], [])
    collection = engine.behaviour.named("collection", action.subject)
    key = collection.get("key") if collection is not None else None
    records = engine.memory.lists.setdefault(action.subject, [])
    for new in carried:
        records[:] = [record for record in records if key is None or record[key] != new[key]]
        records.append(dict(new))
    if key is not None:
        records.sort(key=lambda record: record[key])  # type: ignore[arg-type,return-value]


def _append(engine: Engine, action: Part) -> None:
    collection = engine.behaviour.named("collection", action.subject)
    records = engine.memory.lists.setdefault(action.subject, [])
    raw: dict[str, Raw] = {}
    for field, value in action["values"].items():
        number = engine.number(value)
        raw[field] = int(number) if isinstance(number, float | Decimal) else number
    records.insert(0, raw)
    maximum = collection.get("most") if collection is not None else None
    del records[maximum or len(records) :]


def _remove(engine: Engine, action: Part) -> None:
    collection = engine.behaviour.named("collection", action.subject)
    key = collection.get("key") if collection is not None else None
    records = engine.memory.lists.setdefault(action.subject, [])
    if key is None or action.get("at") is None:
        records.clear()
        return
    first = round(engine.number(action["at"]))
    numbers = range(first, first + round(engine.number(action.get("count", 1))))
    records[:] = [record for record in records if record[key] not in numbers]


def _restart(engine: Engine, action: Part) -> None:
    engine.power_on()


def _refuse(engine: Engine, action: Part) -> None:
    raise Refusal(action.subject)


ACTIONS: Mapping[str, Callable[[Engine, Part], None]] = {
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
