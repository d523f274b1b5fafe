"""Gives a simulated device the values of a dump."""

from __future__ import annotations

from fieldspec.tools.lists.dump import Dump, Entry
from fieldspec.tools.simulator.engine import Engine


def seed(engine: Engine, dump: Dump) -> tuple[int, int]:
    """Writes the words of a dump, also to nonvolatile values.

    Addresses are read in the way that leaves the fewest unknown; without registers they are numbers of parameters.
    Returns how many words or elements were written, and how many addresses the device does not have.
    """
    memory = engine.memory
    spaces = {space for space, _ in memory.occupants}
    first = engine.layout.device.space_name("")

    def unknown(base: str) -> int:
        return sum((first, entry.address) not in memory.occupants for entry in dump.entries(base))

    def says_no_base(entry: Entry) -> bool:
        addresses = range(entry.address, entry.address + len(entry.values))
        return not memory.has_base(entry.space if entry.space in spaces else first, addresses)

    base = min(dump.bases, key=unknown)
    count = unused = 0
    for entry in sorted(dump.entries(base), key=says_no_base):
        if not memory.occupants or (entry.space and entry.space not in spaces):
            elements = _seed_parameter(engine, entry)
            count, unused = count + elements, unused + (not elements)
            continue
        space = entry.space if entry.space in spaces else first
        address_place = memory.place(space, entry.address)
        present = memory.at(space, address_place)
        if not present:
            unused += 1
            continue
        number = entry.values[0]
        bit = next((o for o in present if o.value.type.name == "bit"), None)
        wide = next((o for o in present if o.address == address_place and o.words > 1), None)
        if len(entry.values) == 1 and wide is not None and (entry.words == wide.words or not 0 <= number <= 0xFFFF):
            memory.write(space, wide, number)
            words = wide.words
        elif bit is not None and len(entry.values) == 1:
            memory.write(space, bit, int(number != 0))
            words = 1
        else:
            words = len(entry.values)
            for address, word in enumerate(entry.values, entry.address):
                if (space, memory.place(space, address)) in memory.occupants:
                    memory.words[space, memory.place(space, address)] = word & 0xFFFF
        for address in (memory.place(space, entry.address + word) for word in range(words)):
            if (space, address) in memory.words:
                engine.saved[space, address] = memory.words[space, address]
        count += words
    engine.follow()
    engine.refresh()
    return count, unused


def _seed_parameter(engine: Engine, entry: Entry) -> int:
    """Gives a parameter the values of its elements: how many it has taken."""
    device = engine.layout.device
    known = dict.fromkeys(parameter_set.space for parameter_set in device.parameters.values())
    for space in [entry.space] if entry.space in known else known:
        match = device.parameter_at(space, entry.address)
        keys = [(match[0].name, match[1], index) for index in range(len(entry.values))] if match is not None else []
        own = [(key, raw) for key, raw in zip(keys, entry.values, strict=False) if key in engine.memory.elements]
        for key, raw in own:
            engine.memory.elements[key] = engine.saved_elements[key] = raw
        if own:
            return len(own)
    return 0
