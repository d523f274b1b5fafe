"""Commands to a simulation, as mappings: what a test or a person asks of it."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from fieldspec.codec.layout.value_texts import spec_text
from fieldspec.foundation.classes import TYPE_CHECKING
from fieldspec.language.behaviour.part import AXIS_PROPERTIES
from fieldspec.language.model.encoding import is_array
from fieldspec.language.model.text_form import text_fault
from fieldspec.tools.simulator.faults import FaultError, fault_of
from fieldspec.tools.simulator.simulation import Simulation

if TYPE_CHECKING:
    from typing import Any


class CommandError(ValueError):
    """A command that cannot be carried out. The message says why."""


def carried_out(simulation: Simulation, command: Mapping[str, Any]) -> dict[str, Any]:
    """Carries out a command and returns its result. Raises CommandError."""
    known = [name for name in command if name in COMMANDS]
    if len(known) != 1:
        raise CommandError(f"a command has one of {', '.join(COMMANDS)}, not {', '.join(command) or 'nothing'}")
    with simulation.lock:
        simulation.engine.advance(simulation.now())
        try:
            result = COMMANDS[known[0]](simulation, command)
        except FaultError as error:
            raise CommandError(str(error)) from None
        simulation.engine.refresh()
    return {"ok": True, **result}


def _get(simulation: Simulation, command: Mapping[str, Any]) -> dict[str, Any]:
    names = command["get"]
    if not isinstance(names, list):
        raise CommandError("`get` needs a list of signals")
    return {"values": {str(name): _value(simulation, str(name)) for name in names}}


def _value(simulation: Simulation, name: str) -> object:
    engine = simulation.engine
    scope, _, rest = name.partition("/")
    if scope == "axis" and rest in AXIS_PROPERTIES:
        number = engine.of_axis(rest)
        return number if isinstance(number, bool | int) else float(number)
    if scope == "state" and rest in engine.states:
        return engine.states[rest]
    cells = engine.cells.of(name)
    if not cells:
        raise CommandError(engine.cells.names.unknown(str(name)))
    raw = cells[-1].read()
    return raw.rstrip(b"\0").decode("latin-1") if isinstance(raw, bytes) else raw


def _set(simulation: Simulation, command: Mapping[str, Any]) -> dict[str, Any]:
    values = command["set"]
    if not isinstance(values, Mapping):
        raise CommandError("`set` needs a mapping of signals and values")
    engine = simulation.engine
    for name, value in values.items():
        cells = engine.cells.of(str(name))
        if not cells:
            raise CommandError(engine.cells.names.unknown(str(name)))
        for cell in cells:
            if isinstance(value, str) and cell.value is not None and is_array(cell.value.encoding):
                fault = text_fault(cell.value, "big", value) if cell.value.text_form is not None else None
                if fault is not None:
                    raise CommandError(f"{name} {fault[1]}")
                cell.write(value if cell.value.text_form is not None else value.encode("ascii", "replace"))
                continue
            raw = engine.raw(cell, value)
            if isinstance(value, str) and not raw and engine.names_nothing(cell, value):
                raise CommandError(f"{name} has no value {spec_text(value)}")
            cell.write(raw)
    engine.follow()
    return {}


def _fault(simulation: Simulation, command: Mapping[str, Any]) -> dict[str, Any]:
    simulation.add_fault(fault_of(command))
    return {}


def _clear(simulation: Simulation, command: Mapping[str, Any]) -> dict[str, Any]:
    simulation.faults.clear()
    simulation.engine.overridden.clear()
    return {}


def _power(simulation: Simulation, command: Mapping[str, Any]) -> dict[str, Any]:
    if command["power"] != "cycle":
        raise CommandError("`power` can be `cycle`")
    simulation.engine.power_on()
    return {}


def _state(simulation: Simulation, command: Mapping[str, Any]) -> dict[str, Any]:
    engine = simulation.engine
    axis = {name: _value(simulation, f"axis/{name}") for name in AXIS_PROPERTIES}
    return {
        "time": simulation.now(),
        "states": dict(engine.states),
        "axis": axis,
        "faults": dict(simulation.faults.struck),
    }


def _assumptions(simulation: Simulation, command: Mapping[str, Any]) -> dict[str, Any]:
    assumed = {part.name: part.assumed for part in simulation.behaviour.assumptions()}
    reported = simulation.engine.reported_version
    return {"assumptions": assumed | ({"version": reported.text} if reported is not None else {})}


COMMANDS: Mapping[str, Callable[[Simulation, Mapping[str, Any]], dict[str, Any]]] = {
    "get": _get,
    "set": _set,
    "fault": _fault,
    "clear": _clear,
    "power": _power,
    "state": _state,
    "assumptions": _assumptions,
}
